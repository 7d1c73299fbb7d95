// HexFeatureWB - LGPL-2.1-or-later
#include "quadratic/quadratic.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

#include "hex_fixtures.h"
#include "quadratic/bows.h"
#include "quadratic/hex20.h"
#include "quadratic/unfold.h"

namespace {

using namespace hexfeature;
using fixtures::kPi;

/// The unit cube with mid-side nodes at the chords' middles.
Hex20 cube() {
  Hex20 x;
  constexpr int corner[8][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  for (int n = 0; n < 8; ++n) x[n] = Vec3(corner[n][0], corner[n][1], corner[n][2]);
  for (int e = 0; e < 12; ++e) x[8 + e] = 0.5 * (x[kHexEdges[e][0]] + x[kHexEdges[e][1]]);
  return x;
}

/// A quarter of a ring, numbered as the box of BoxProjector: x is the radius, y the angle.
class RingProjector : public Projector {
 public:
  static constexpr double kInner = 1, kOuter = 2, kHeight = 1;
  static Vec3 point(double r, double angle, double z) { return {r * std::cos(angle), r * std::sin(angle), z}; }
  FacePoint project_to_face(int face, const Vec3& p, const Vec2*) const override {
    FacePoint f;
    f.point = p;
    const double r = std::hypot(p[0], p[1]), angle = std::atan2(p[1], p[0]);
    switch (face) {
      case 1:
      case 2:
        f.point = point(face == 1 ? kOuter : kInner, angle, p[2]);
        f.uv = Vec2(angle, p[2]);
        f.normal = (face == 1 ? 1 : -1) * point(1, angle, 0);
        break;
      case 3:
      case 4:
        f.point = point(r, face == 3 ? kPi / 2 : 0, p[2]);
        f.uv = Vec2(r, p[2]);
        f.normal = face == 3 ? Vec3(-1, 0, 0) : Vec3(0, -1, 0);
        break;
      default:
        f.point[2] = face == 5 ? kHeight : 0;
        f.uv = p.head<2>();
        f.normal = Vec3(0, 0, face == 5 ? 1 : -1);
    }
    return f;
  }
  Vec3 face_point(int face, const Vec2& uv) const {
    if (face <= 2) return point(face == 1 ? kOuter : kInner, uv[0], uv[1]);
    if (face <= 4) return point(uv[0], face == 3 ? kPi / 2 : 0, uv[1]);
    return {uv[0], uv[1], face == 5 ? kHeight : 0};
  }
  CurvePoint project_to_edge(int edge, const Vec3& p, const double*) const override {
    const int axis = (edge - 1) / 4;
    return edge_point(edge, axis == 0 ? std::hypot(p[0], p[1]) : axis == 1 ? std::atan2(p[1], p[0]) : p[2]);
  }
  CurvePoint edge_point(int edge, double t) const override {
    const int axis = (edge - 1) / 4;
    const bool high_b = (edge - 1) & 2, high_c = (edge - 1) & 1;
    CurvePoint c;
    c.t = t;
    if (axis == 0) c.point = point(t, high_b ? kPi / 2 : 0, high_c ? kHeight : 0);
    if (axis == 1) c.point = point(high_c ? kOuter : kInner, t, high_b ? kHeight : 0);
    if (axis == 2) c.point = point(high_b ? kOuter : kInner, high_c ? kPi / 2 : 0, t);
    return c;
  }
  Vec3 vertex_point(int) const override { return Vec3::Zero(); }
};

/// Mesh edges between nodes of one CAD edge, or of it and a CAD vertex.
void find_feature_edges(HexComplex& c) {
  const MeshEdges edges = number_edges(c);
  std::vector<int> quads(edges.count(), 0), face(edges.count(), 0);
  for (std::size_t q = 0; q < c.quads.size(); ++q)
    for (int e : edges.of_quad[q]) {
      if (face[e] == 0) face[e] = c.quad_face[q];
      quads[e] += c.quad_face[q] != face[e];
    }
  for (int e = 0; e < edges.count(); ++e) {
    if (!quads[e]) continue;
    int cad = 0;
    for (int v : edges.nodes[e])
      if (c.place[v].dim == 1) cad = c.place[v].entity;
    REQUIRE(cad > 0);
    c.feature_edges.push_back(edges.nodes[e]);
    c.feature_edge_cad.push_back(cad);
  }
}

HexComplex ring(int n) {
  HexComplex c = fixtures::box_mesh({n, n, 2}, Vec3(1, 1, 1));
  find_feature_edges(c);
  for (Vec3& p : c.points) p = RingProjector::point(1 + p[0], p[1] * kPi / 2, p[2]);
  return c;
}

/// On the cylinders and inside nodes go astray, on edges they stay.
template <class Random>
HexComplex shaken_ring(Random& random) {
  std::uniform_real_distribution<double> shift(-0.48, 0.48);
  HexComplex c = fixtures::box_mesh({1, 2, 2}, Vec3(1, 1, 1));
  find_feature_edges(c);
  for (std::size_t v = 0; v < c.points.size(); ++v) {
    Vec3& p = c.points[v];
    if (c.place[v].dim >= 2 && p[1] > 0 && p[1] < 1 && p[2] > 0 && p[2] < 1) p += Vec3(0, shift(random), shift(random));
    p = RingProjector::point(1 + p[0], p[1] * kPi / 2, p[2]);
  }
  return c;
}

Hex20 element(const HexComplex& c, const QuadraticMesh& m, int h) {
  Hex20 x;
  for (int k = 0; k < 20; ++k) {
    const int v = m.hexes[h][k];
    x[k] = v < c.point_count() ? c.points[v] : m.mid_points[v - c.point_count()];
  }
  return x;
}

/// A plate, 2 x 2 x `thickness`, whose bottom is lifted: it may bulge through the top.
class Bulge : public fixtures::BoxProjector {
 public:
  using Height = std::function<double(double, double)>;
  Bulge(double thickness, Height height) : BoxProjector(Vec3(2, 2, thickness)), height_(std::move(height)) {}
  FacePoint project_to_face(int face, const Vec3& p, const Vec2* guess) const override {
    FacePoint f = BoxProjector::project_to_face(face, p, guess);
    if (face == 6) f.point[2] = height_(f.point[0], f.point[1]);
    return f;
  }

 private:
  Height height_;
};

/// Whether the straight-sided elements are good, as make_quadratic may ask.
bool valid_straight(const HexComplex& c) {
  for (const auto& hex : c.hexes) {
    Hex20 x;
    for (int k = 0; k < 8; ++k) x[k] = c.points[hex[k]];
    for (int e = 0; e < 12; ++e) x[8 + e] = 0.5 * (x[kHexEdges[e][0]] + x[kHexEdges[e][1]]);
    if (!proves_positive(x)) return false;
  }
  return true;
}

}  // namespace

TEST_CASE("a parallelepiped's 216 coefficients are its volume") {
  Mat3 m;
  m << 2, 0.3, 0.1, 0, 1.5, -0.4, 0.2, 0, 1;
  Hex20 x = cube();
  for (Vec3& p : x) p = m * p;
  for (double c : jacobian_bernstein(x)) CHECK(c == doctest::Approx(m.determinant() / 8));
  CHECK(least_jacobian(x) == doctest::Approx(1));
  CHECK(proves_positive(x));
}

TEST_CASE("the coefficients bound the determinant of bent elements, whose integral is their mean") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> shift(-0.06, 0.06);
  for (int trial = 0; trial < 50; ++trial) {
    Hex20 x = cube();
    for (Vec3& p : x) p += Vec3(shift(random), shift(random), shift(random));
    const auto b = jacobian_bernstein(x);
    const double least = *std::min_element(b.begin(), b.end());
    double mean = 0;
    for (double c : b) mean += c / 216;
    CHECK(mean > 0);
    CHECK(least <= least_jacobian(x) * 2 * mean);
    if (proves_positive(x)) CHECK(least_jacobian(x) > 0);
  }
}

TEST_CASE("a mid-side node at the quarter of its edge makes the determinant vanish at the corner") {
  for (double at : {0.3, 0.24}) {
    Hex20 x = cube();
    for (int n : {8, 10, 12, 14}) x[n][0] = at;
    CHECK(proves_positive(x) == (at > 0.25));
    CHECK((least_jacobian(x) > 0) == (at > 0.25));
  }
  Hex20 x = cube();
  x[3][1] = std::nan("");
  CHECK(!proves_positive(x));
}

TEST_CASE("mid-side nodes of a ring lie on its CAD, and inside on circles") {
  for (int n : {2, 4}) {
    const HexComplex c = ring(n);
    Context context;
    const QuadraticMesh m = make_quadratic(c, RingProjector(), context);
    CHECK(m.straightened.empty());
    CHECK(m.straightened_faces.empty());
    CHECK(m.deviation < 1e-12);
    CHECK(m.least_jacobian > 0.5);
    const MeshEdges edges = number_edges(c);
    const double sagitta = 1 - std::cos(kPi / (4 * n));
    for (int e = 0; e < edges.count(); ++e) {
      const Vec3 &a = c.points[edges.nodes[e][0]], &b = c.points[edges.nodes[e][1]], &mid = m.mid_points[e];
      const double ra = a.head<2>().norm(), rb = b.head<2>().norm();
      CHECK(std::abs(mid.head<2>().norm() - 0.5 * (ra + rb)) < 1e-3 * sagitta);
    }
  }
}

TEST_CASE("the coefficients' slopes tell exactly how they change when one node moves") {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> shift(-0.1, 0.1);
  Hex20 x = cube();
  for (Vec3& p : x) p += Vec3(shift(random), shift(random), shift(random));
  const auto before = jacobian_bernstein(x);
  for (int node : {0, 8, 13, 19}) {
    const auto slopes = jacobian_bernstein_slopes(x, node);
    const Vec3 d(0.3, -0.2, 0.4);
    Hex20 y = x;
    y[node] += d;
    const auto after = jacobian_bernstein(y);
    for (int c = 0; c < 216; ++c) CHECK(after[c] == doctest::Approx(before[c] + slopes[c].dot(d)).epsilon(1e-9));
  }
}

TEST_CASE("elements of a shaken ring that bending would fold are unfolded with every mid-side node on the CAD") {
  std::mt19937 random(5);
  int folded = 0, unfolded = 0;
  for (int trial = 0; trial < 600; ++trial) {
    const HexComplex c = shaken_ring(random);
    if (!valid_straight(c)) continue;
    const MeshEdges edges = number_edges(c);
    Context context;
    const RingProjector projector;
    Bows bows = place_mid_sides(c, edges, projector, context);
    std::vector<int> bad;
    for (int h = 0; h < c.hex_count(); ++h)
      if (!proves_positive(bent_element(c, edges, bows, h))) bad.push_back(h);
    if (bad.empty()) continue;
    ++folded;
    unfolded += unfold(c, edges, projector, bad, bows, context).empty();
    for (int e = 0; e < edges.count(); ++e) {
      const Vec3 p = bows.chord[e] + bows.bow[e];
      if (bows.place[e].dim == 1) CHECK((projector.project_to_edge(bows.place[e].entity, p, nullptr).point - p).norm() < 1e-12);
      if (bows.place[e].dim == 2) CHECK((projector.project_to_face(bows.place[e].entity, p, nullptr).point - p).norm() < 1e-12);
    }
  }
  CHECK(folded > 10);
  CHECK(unfolded == folded);
}

TEST_CASE("mid-side nodes carry the parameters of where they are, also after sliding along the CAD") {
  std::mt19937 random(5);
  int slid = 0;
  for (int trial = 0; trial < 600; ++trial) {
    const HexComplex c = shaken_ring(random);
    if (!valid_straight(c)) continue;
    Context context;
    const RingProjector projector;
    const Bows first = place_mid_sides(c, number_edges(c), projector, context);
    const QuadraticMesh m = make_quadratic(c, projector, context);
    for (std::size_t e = 0; e < m.mid_place.size(); ++e) {
      const CadPlace& place = m.mid_place[e];
      if (place.dim < 3 && (m.mid_points[e] - first.chord[e] - first.bow[e]).norm() > 1e-3) ++slid;
      if (place.dim == 1) CHECK((projector.edge_point(place.entity, place.uv[0]).point - m.mid_points[e]).norm() < 1e-12);
      if (place.dim == 2) CHECK((projector.face_point(place.entity, place.uv) - m.mid_points[e]).norm() < 1e-12);
    }
  }
  CHECK(slid > 10);
}

TEST_CASE("where the CAD's curve would fold its element, the mid-side node leaves the CAD and the report says where") {
  HexComplex c = fixtures::box_mesh({2, 2, 1}, Vec3(2, 2, 0.1));
  find_feature_edges(c);
  Context context;
  const Bulge projector(0.1, [](double x, double y) { return 0.5 * std::pow(std::sin(kPi * x) * std::sin(kPi * y / 2), 2); });
  const QuadraticMesh m = make_quadratic(c, projector, context);
  CHECK(!m.straightened.empty());
  double farthest = 0;
  for (int v : m.straightened) {
    const Vec3& p = m.mid_points[v - c.point_count()];
    farthest = std::max(farthest, (projector.project_to_face(6, p, nullptr).point - p).norm());
  }
  CHECK(farthest > 0.01);
  CHECK(m.deviation == doctest::Approx(farthest));
  CHECK(m.straightened_faces == std::vector<int>{6});
  CHECK(m.least_jacobian > 0);
  for (int h = 0; h < c.hex_count(); ++h) CHECK(proves_positive(element(c, m, h)));
  for (int v : m.straightened) CHECK(m.mid_place[v - c.point_count()].dim == 3);
}

TEST_CASE("whatever leaves the CAD, in the end every element is proved") {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> shift(-0.1, 0.1), where(0, 2), height(-1, 1);
  const Vec3 size(2, 2, 0.1);
  int left = 0;
  for (int trial = 0; trial < 60; ++trial) {
    std::array<Vec3, 3> bumps;  // place and height
    for (Vec3& b : bumps) b = Vec3(where(random), where(random), height(random));
    const Bulge projector(size[2], [&](double x, double y) {
      double z = 0;
      for (const Vec3& b : bumps) z += b[2] * std::exp(-4 * (Vec3(x, y, 0) - b).head<2>().squaredNorm());
      return z * std::sin(kPi * x / 2) * std::sin(kPi * y / 2);  // the plate's edges stay
    });
    HexComplex c = fixtures::box_mesh({2, 2, 1}, size);
    find_feature_edges(c);
    for (Vec3& p : c.points) {
      if (p[0] > 0 && p[0] < 2 && p[1] > 0 && p[1] < 2) p += Vec3(shift(random), shift(random), 0);
      if (p[2] == 0) p = projector.project_to_face(6, p, nullptr).point;
    }
    if (!valid_straight(c)) continue;
    Context context;
    const QuadraticMesh m = make_quadratic(c, projector, context);
    left += !m.straightened.empty();
    for (int h = 0; h < c.hex_count(); ++h) CHECK(proves_positive(element(c, m, h)));
  }
  CHECK(left > 10);
}
