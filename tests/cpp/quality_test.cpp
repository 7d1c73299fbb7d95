// HexFeatureWB - LGPL-2.1-or-later
#include "quality/quality.h"

#include <doctest/doctest.h>

#include "hex_fixtures.h"
#include "quality/topology.h"

using namespace hexfeature;
using namespace fixtures;

namespace {

Context context;

MeshingError failure_of(const HexComplex& c, const Projector& projector) {
  try {
    certify(c, projector, 6, 1e-6, context);
  } catch (const MeshingError& e) {
    return e;
  }
  return MeshingError(Failure::Usage, "", "none");
}

std::string reason_of(const HexComplex& c, const Projector& projector) { return failure_of(c, projector).reason; }

/// The determinant of the trilinear map at (r, s, t), by its definition.
double determinant_at(const std::vector<Vec3>& x, double r, double s, double t) {
  const int grid[8][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  Mat3 m = Mat3::Zero();
  for (int k = 0; k < 8; ++k) {
    const double f[3] = {grid[k][0] ? r : 1 - r, grid[k][1] ? s : 1 - s, grid[k][2] ? t : 1 - t};
    for (int a = 0; a < 3; ++a) {
      double n = grid[k][a] ? 1 : -1;
      for (int b = 0; b < 3; ++b)
        if (b != a) n *= f[b];
      m.col(a) += n * x[k];
    }
  }
  return m.determinant();
}

const std::array<int, 8> kFirst{0, 1, 2, 3, 4, 5, 6, 7};
std::vector<Vec3> unit_cube() { return {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}; }

}  // namespace

TEST_CASE("a cube has scaled Jacobian 1, its Bernstein coefficients are its volume") {
  auto x = unit_cube();
  for (auto& p : x) p *= 3;
  CHECK(scaled_jacobian(x, kFirst) == 1.0);
  CHECK(bernstein_minimum(x, kFirst) == doctest::Approx(1));
  CHECK(hex_volume(x, kFirst) == doctest::Approx(27));
  std::swap(x[1], x[3]);
  std::swap(x[5], x[7]);
  CHECK(scaled_jacobian(x, kFirst) == -1.0);
  CHECK_FALSE(proves_positive(x, kFirst));
}

TEST_CASE("the 27 coefficients are those of the determinant") {
  auto x = unit_cube();
  std::mt19937 random(7);
  for (auto& p : x)
    for (int a = 0; a < 3; ++a) p[a] += 0.3 * (2.0 * random() / 4294967295.0 - 1);
  const auto b = jacobian_bernstein(x, kFirst);
  const auto basis = [](int i, double t) { return i == 0 ? (1 - t) * (1 - t) : i == 1 ? 2 * t * (1 - t) : t * t; };
  for (double r : {0.0, 0.3, 1.0})
    for (double s : {0.1, 0.5})
      for (double t : {0.0, 0.8}) {
        double sum = 0;
        for (int i = 0; i < 27; ++i) sum += b[i] * basis(i / 9, r) * basis(i / 3 % 3, s) * basis(i % 3, t);
        CHECK(sum == doctest::Approx(determinant_at(x, r, s, t)));
      }
}

TEST_CASE("halving proves elements whose coefficients alone do not decide, and never one with a negative corner") {
  std::mt19937 random(11);
  int undecided = 0, proved = 0;
  for (int trial = 0; trial < 4000; ++trial) {
    auto x = unit_cube();
    for (auto& p : x)
      for (int a = 0; a < 3; ++a) p[a] += 0.45 * (2.0 * random() / 4294967295.0 - 1);
    double least = 1e9;
    for (int i = 0; i < 125; ++i) least = std::min(least, determinant_at(x, i / 25 / 4.0, i / 5 % 5 / 4.0, i % 5 / 4.0));
    const bool ok = proves_positive(x, kFirst);
    if (ok) CHECK(least > 0);
    if (least > 0.05) CHECK(ok);
    if (least > 0 && bernstein_minimum(x, kFirst) <= 0) {
      ++undecided;
      proved += ok;
    }
  }
  CHECK(undecided > 5);
  CHECK(proved > undecided / 2);
}

TEST_CASE("a box is certified and measured") {
  HexComplex c = box_mesh({3, 4, 2}, Vec3(3, 4, 2));
  const BoxProjector box(Vec3(3, 4, 2));
  const QualityReport q = measure_quality(c, box, context);
  CHECK(q.min_sj == 1.0);
  CHECK(q.volume == doctest::Approx(24));
  CHECK(q.min_edge == doctest::Approx(1));
  CHECK(q.deviation < 1e-12);
  CHECK(q.histogram[19] == 24);
  CHECK(q.worst_hexes.size() == 10);
  CHECK(certify(c, box, 6, 1e-6, context).faces_without_quads.empty());
  CHECK(certify(c, box, 7, 1e-6, context).faces_without_quads == std::vector<int>{7});
}

TEST_CASE("the skin: lean, thickness and warp of what stands on the boundary") {
  HexComplex c = box_mesh({3, 3, 3}, Vec3(3, 6, 9));
  SkinReport skin = measure_skin(c);
  CHECK(skin.max_lean == doctest::Approx(0).epsilon(1e-6));
  CHECK(skin.max_warp == doctest::Approx(0).epsilon(1e-6));
  CHECK(skin.min_thickness == doctest::Approx(1));
  CHECK(skin.mean_thickness == doctest::Approx(2));  // of 1, 2 and 3, nine quads on either side each
  CHECK(skin.warped == 0);
  c.points[21] += Vec3(0.5, 0, 0);  // an inner point moves sideways: the edges to it lean, no quad bends
  skin = measure_skin(c);
  CHECK(skin.max_lean > 5);
  CHECK(skin.max_warp == doctest::Approx(0).epsilon(1e-6));
  c.points[5] += Vec3(0, 0, 1.5);  // (1, 1, 0), on the bottom
  CHECK(measure_skin(c).max_warp > 15);
  CHECK(measure_skin(c).warped > 0);
}

TEST_CASE("each fault has its error") {
  const BoxProjector box(Vec3(3, 3, 3));
  const HexComplex good = box_mesh({3, 3, 3}, Vec3(3, 3, 3));
  REQUIRE(reason_of(good, box) == "none");
  const int centre = 21;  // lattice point (1, 1, 1)
  SUBCASE("not a number") {
    HexComplex c = good;
    c.points[0][1] = std::nan("");
    CHECK(reason_of(c, box).find("not numbers") != std::string::npos);
  }
  SUBCASE("an index out of range") {
    HexComplex c = good;
    c.hexes[3][2] = 1000;
    CHECK(reason_of(c, box).find("do not exist") != std::string::npos);
  }
  SUBCASE("an unused point") {
    HexComplex c = good;
    c.points.push_back(Vec3(9, 9, 9));
    c.place.emplace_back();
    CHECK(reason_of(c, box).find("belong to no element") != std::string::npos);
  }
  SUBCASE("an element twice") {
    HexComplex c = good;
    c.hexes.push_back(c.hexes[13]);
    CHECK(reason_of(c, box).find("not shared by exactly two") != std::string::npos);
  }
  SUBCASE("a missing element") {
    HexComplex c = good;
    c.hexes.erase(c.hexes.begin() + 13);
    CHECK(reason_of(c, box).find("without a quad") != std::string::npos);
  }
  SUBCASE("a quad turned inside out") {
    HexComplex c = good;
    std::swap(c.quads[0][1], c.quads[0][3]);
    CHECK(reason_of(c, box).find("outward") != std::string::npos);
  }
  SUBCASE("a quad twice") {
    HexComplex c = good;
    c.quads.push_back(c.quads[0]);
    CHECK(reason_of(c, box).find("outward") != std::string::npos);
  }
  SUBCASE("a crack: a node doubled") {
    HexComplex c = good;
    c.points.push_back(c.points[centre]);
    c.place.push_back(c.place[centre]);
    for (int k = 0; k < 8; ++k)
      if (c.hexes[0][k] == centre) c.hexes[0][k] = c.point_count() - 1;
    CHECK(reason_of(c, box) != "none");
    CHECK(find_coincident_points(c.points, 1e-9, context).count == 1);
  }
  SUBCASE("an inverted element names the faces next to it") {
    HexComplex c = good;
    c.points[centre] = Vec3(-0.5, 1, 1);
    const MeshingError e = failure_of(c, box);
    CHECK(e.reason.find("not proved positive") != std::string::npos);
    CHECK(std::find(e.cad_faces.begin(), e.cad_faces.end(), 2) != e.cad_faces.end());
  }
  SUBCASE("a node off its face") {
    HexComplex c = good;
    c.points[1][2] += 0.01;
    CHECK(reason_of(c, box).find("off their CAD") != std::string::npos);
  }
}

TEST_CASE("solids that touch in an edge or a point are not manifold") {
  const auto cubes = [](const std::vector<Vec3>& corners) {
    HexComplex c;
    std::vector<std::array<int, 3>> seen;
    const int grid[8][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
    for (const Vec3& o : corners) {
      std::array<int, 8> h;
      for (int k = 0; k < 8; ++k) {
        const Vec3 p = o + Vec3(grid[k][0], grid[k][1], grid[k][2]);
        const auto it = std::find(c.points.begin(), c.points.end(), p);
        h[k] = static_cast<int>(it - c.points.begin());
        if (it == c.points.end()) c.points.push_back(p);
      }
      c.hexes.push_back(h);
    }
    finish(c);
    return c;
  };
  CHECK(check_topology(cubes({{0, 0, 0}, {1, 0, 0}}), context).count == 0);
  CHECK(check_topology(cubes({{0, 0, 0}, {1, 1, 0}}), context).reason.find("edges") != std::string::npos);
  CHECK(check_topology(cubes({{0, 0, 0}, {1, 1, 1}}), context).reason.find("touches itself") != std::string::npos);
}

TEST_CASE("coincident points are found across cells, distant ones are not") {
  std::vector<Vec3> x;
  std::mt19937 random(3);
  for (int i = 0; i < 2000; ++i) x.push_back(Vec3(random() % 100, random() % 100, i));
  const std::size_t n = x.size();
  for (std::size_t i = 0; i < n; i += 10) x.push_back(x[i] + Vec3(0.7e-6, 0.5e-6, -0.4e-6));
  CHECK(find_coincident_points(x, 1e-6, context).count == 200);
  CHECK(find_coincident_points(x, 1e-7, context).count == 0);
}
