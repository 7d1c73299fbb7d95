// HexFeatureWB - LGPL-2.1-or-later
// What a mesh lost of the part, and ways to bring it back.
#include <doctest/doctest.h>

#include <algorithm>
#include <set>

#include "fixtures.h"
#include "hex_fixtures.h"
#include "lattice/lattice.h"
#include "mesh/geometry.h"
#include "mesh/hex_element.h"
#include "recover/face_cover.h"
#include "recover/late_edges.h"
#include "recover/missing_lines.h"

using namespace hexfeature;
using namespace fixtures;

namespace {

Context context;
const Vec3 kSize(4, 4, 2);

/// A box whose top is two faces, 5 on x <= border and 7 beyond, that meet smoothly in edge 13.
struct SplitBox : BoxProjector {
  explicit SplitBox(double border_) : BoxProjector(kSize), border(border_) {
    faces.resize(7);
    for (int f : {5, 7}) faces[f - 1].kind = SurfaceKind::Other;
    edges.resize(13);
    for (int e = 0; e < 12; ++e) {
      const int a = e / 4, b = (a + 1) % 3, c = (a + 2) % 3;
      edges[e].sharp = true;
      edges[e].faces = {1 + 2 * b + ((e & 2) ? 0 : 1), 1 + 2 * c + ((e & 1) ? 0 : 1)};
    }
    edges[12].faces = {5, 7};
    edges[12].vertices = {9, 10};
    edges[12].t1 = edges[12].length = kSize.y();
    vertices.resize(10);
  }
  FacePoint project_to_face(int face, const Vec3& p, const Vec2* guess) const override {
    FacePoint r = BoxProjector::project_to_face(face == 7 ? 5 : face, p, guess);
    if (face == 5) r.point.x() = std::min(r.point.x(), border);
    if (face == 7) r.point.x() = std::max(r.point.x(), border);
    r.uv = face == 5 || face == 7 ? Vec2(r.point.x(), r.point.y()) : r.uv;
    return r;
  }
  CurvePoint project_to_edge(int edge, const Vec3& p, const double* guess) const override {
    return edge == 13 ? edge_point(13, std::clamp(p.y(), 0.0, kSize.y())) : BoxProjector::project_to_edge(edge, p, guess);
  }
  CurvePoint edge_point(int edge, double t) const override {
    if (edge != 13) return BoxProjector::edge_point(edge, t);
    return {Vec3(border, t, kSize.z()), Vec3::UnitY(), t};
  }
  Geometry geometry() const { return {&faces, &edges, &vertices, this}; }

  /// The CAD, sampled every quarter.
  SurfaceMesh surface() const {
    const std::array<int, 3> n{16, 16, 8};
    HexComplex fine = box_mesh(n, kSize);
    SurfaceMesh s;
    s.points = fine.points;
    s.place = fine.place;
    for (std::size_t q = 0; q < fine.quads.size(); ++q) {
      const auto& v = fine.quads[q];
      double x = 0;
      for (int k : v) x += 0.25 * fine.points[k].x();
      for (int k = 1; k <= 2; ++k) {
        s.triangles.push_back({v[0], v[k], v[k + 1]});
        s.triangle_face.push_back(fine.quad_face[q] == 5 && x > border ? 7 : fine.quad_face[q]);
      }
    }
    for (int v = 0; v < s.point_count(); ++v)
      if (s.place[v].dim == 2 && s.place[v].entity == 5 && s.points[v].x() > border) s.place[v].entity = 7;
    s.halfedge_edge.assign(3 * s.triangles.size(), 0);
    return s;
  }

  /// Unit cubes; the quads of the top beyond x = `from` have face 7.
  HexComplex mesh(double from) const {
    HexComplex c = box_mesh({4, 4, 2}, kSize);
    for (std::size_t q = 0; q < c.quads.size(); ++q)
      if (c.quad_face[q] == 5 && middle(c, q).x() > from) c.quad_face[q] = 7;
    for (int v = 0; v < c.point_count(); ++v)
      if (c.place[v].dim == 2 && c.place[v].entity == 5 && c.points[v].x() > border) c.place[v].entity = 7;
    return c;
  }
  static Vec3 middle(const HexComplex& c, std::size_t q) {
    Vec3 p = Vec3::Zero();
    for (int v : c.quads[q]) p += 0.25 * c.points[v];
    return p;
  }

  double border;
  std::vector<CadFace> faces;
  std::vector<CadEdge> edges;
  std::vector<CadVertex> vertices;
};

std::set<double> columns_of(const HexComplex& c, int face) {
  std::set<double> x;
  for (std::size_t q = 0; q < c.quads.size(); ++q)
    if (c.quad_face[q] == face) x.insert(SplitBox::middle(c, q).x());
  return x;
}

std::vector<int> points_at(const HexComplex& c, double x, double z) {
  std::vector<int> points;
  for (int v = 0; v < c.point_count(); ++v)
    if (c.points[v].x() == x && c.points[v].z() == z && c.place[v].dim == 2) points.push_back(v);
  return points;
}

}  // namespace

TEST_CASE("quads beside a smooth border go to the face that they cover best") {
  const SplitBox part(1.25);
  HexComplex c = part.mesh(2);
  CHECK(face_gaps(c, part.surface(), part.geometry(), 1, context)[7] == doctest::Approx(0.75));
  CHECK(cover_faces(c, part.surface(), part.geometry(), 1, context) == 4);
  CHECK(columns_of(c, 5) == std::set<double>{0.5});
  CHECK(columns_of(c, 7) == std::set<double>{1.5, 2.5, 3.5});
  const std::vector<double> gap = face_gaps(c, part.surface(), part.geometry(), 1, context);
  CHECK(gap[5] == doctest::Approx(0.25));
  CHECK(gap[7] == doctest::Approx(0));
  CHECK(cover_faces(c, part.surface(), part.geometry(), 1, context) == 0);
}

TEST_CASE("gaps of points are told wherever they are, in the same order for every mesh") {
  const SplitBox part(1.25);
  HexComplex c = part.mesh(2);
  const std::vector<PointGap> before = point_gaps(c, part.surface(), part.geometry(), 1, context);
  cover_faces(c, part.surface(), part.geometry(), 1, context);
  const std::vector<PointGap> after = point_gaps(c, part.surface(), part.geometry(), 1, context);
  REQUIRE(before.size() == after.size());
  double largest[2] = {0, 0};
  for (std::size_t i = 0; i < before.size(); ++i) {
    CHECK(before[i].point == after[i].point);
    largest[0] = std::max(largest[0], before[i].gap);
    largest[1] = std::max(largest[1], after[i].gap);
  }
  CHECK(largest[0] == doctest::Approx(0.75));
  CHECK(largest[1] == doctest::Approx(0.25));
}

TEST_CASE("quads along a followed sharp edge stay on its face") {
  const SplitBox part(1.25);
  HexComplex c = part.mesh(2);
  // The column's quads at y = 0 and y = 4 lie along sharp edges of the box.
  for (const auto& q : c.quads)
    for (int k = 0; k < 4; ++k) {
      const int a = q[k], b = q[(k + 1) % 4];
      if (a < b && c.place[a].dim < 2 && c.place[b].dim < 2 && c.points[a].y() == c.points[b].y() && c.points[a].z() == 2 &&
          c.points[b].z() == 2)
        c.feature_edges.push_back({a, b});
    }
  std::sort(c.feature_edges.begin(), c.feature_edges.end());
  c.feature_edges.erase(std::unique(c.feature_edges.begin(), c.feature_edges.end()), c.feature_edges.end());
  c.feature_edge_cad.assign(c.feature_edges.size(), 1);
  CHECK(cover_faces(c, part.surface(), part.geometry(), 1, context) == 2);
}

TEST_CASE("what lies far from a face's own quads is marked") {
  const SplitBox part(1.25);
  const SurfaceMesh surface = part.surface();
  const std::vector<char> marked = uncovered_points(part.mesh(2), surface, part.geometry(), 1, 0.5, context);
  int count = 0;
  for (int v = 0; v < surface.point_count(); ++v) {
    if (!marked[v]) continue;
    ++count;
    CHECK(surface.points[v].x() < 1.5);
    CHECK(surface.points[v].x() >= 1.25);
  }
  CHECK(count > 0);
}

TEST_CASE("points are drawn to a gap that no choice of faces closes") {
  const SplitBox part(1.5);
  HexComplex c = part.mesh(1);
  const SurfaceMesh surface = part.surface();
  const double before = face_gaps(c, surface, part.geometry(), 1, context)[5];
  CHECK(before == doctest::Approx(0.5));
  const std::vector<int> drawn = draw_to_gaps(c, surface, part.geometry(), 1, context);
  CHECK(!drawn.empty());
  for (int v : drawn) {
    CHECK(c.points[v].z() == 2);
    CHECK(c.points[v].x() > 1);
    CHECK(c.points[v].x() <= 1.5);
    CHECK(c.place[v].uv.x() == c.points[v].x());
  }
  for (const auto& hex : c.hexes) CHECK(scaled_jacobian(c.points, hex) > 0.5);
  // In the middle, where points may slide.
  const std::vector<char> marked = uncovered_points(c, surface, part.geometry(), 1, 0.45, context);
  for (int v = 0; v < surface.point_count(); ++v)
    if (marked[v]) CHECK((surface.points[v].y() < 1 || surface.points[v].y() > 3));
}

TEST_CASE("a run of mesh edges beside a smooth CAD edge is bound to it, in pieces when points are released") {
  const SplitBox part(1.3);
  HexComplex c = part.mesh(1);
  std::vector<LateRun> runs = runs_beside_edges(c, {13}, part.surface(), part.geometry(), 1, context);
  REQUIRE(runs.size() == 1);
  CHECK(runs[0].edge == 13);
  std::vector<int> nodes = runs[0].nodes;
  for (std::size_t i = 0; i < nodes.size(); ++i) CHECK(runs[0].t[i] == doctest::Approx(c.points[nodes[i]].y()));
  std::sort(nodes.begin(), nodes.end());
  CHECK(nodes == points_at(c, 1, 2));  // those at the box's edges may not leave these

  HexComplex bound = c;
  bind_points(bound, runs);
  for (int v : nodes) {
    CHECK(bound.place[v].dim == 1);
    CHECK(bound.place[v].entity == 13);
  }
  CHECK(bound.feature_edges.size() == 2);
  CHECK(bound.feature_edge_cad == std::vector<int>{13, 13});
  CHECK(bound.points == c.points);
  CHECK(runs_beside_edges(bound, {13}, part.surface(), part.geometry(), 1, context).empty());

  std::vector<char> marked(c.points.size(), 0);
  marked[runs[0].nodes[1]] = 1;
  CHECK(release(runs, marked));
  CHECK(runs.size() == 2);
  for (const LateRun& r : runs) {
    CHECK(r.nodes.size() == 1);
    CHECK(r.quads.empty());
  }
  CHECK(!release(runs, marked));

  // A piece keeps the quads beside its own mesh edges.
  std::vector<LateRun> rest = runs_beside_edges(c, {13}, part.surface(), part.geometry(), 1, context);
  const LateRun whole = rest[0];
  REQUIRE(whole.quads.size() == 4);
  std::fill(marked.begin(), marked.end(), 0);
  marked[whole.nodes[0]] = 1;
  CHECK(release(rest, marked));
  REQUIRE(rest.size() == 1);
  CHECK(rest[0].quads == std::vector<std::array<int, 2>>{whole.quads[2], whole.quads[3]});
}

TEST_CASE("points are taken off the CAD edges that they follow, off sharp ones only when asked") {
  const SplitBox part(1);
  HexComplex c = part.mesh(1);
  bind_points(c, runs_beside_edges(c, {13}, part.surface(), part.geometry(), 1, context));
  REQUIRE(c.feature_edges.size() == 2);
  const std::vector<char> all(c.points.size(), 1);
  std::vector<char> one(c.points.size(), 0);
  const int end = c.feature_edges[0][0];
  one[end] = 1;
  HexComplex loose = c;
  CHECK(loosen(loose, one, part.geometry(), false) == std::vector<int>{end});
  CHECK(loose.place[end].dim == 2);
  CHECK((loose.place[end].entity == 5 || loose.place[end].entity == 7));
  CHECK(loose.feature_edges.size() == 1);
  CHECK(loose.feature_edge_cad == std::vector<int>{13});
  loose = c;
  CHECK(loosen(loose, all, part.geometry(), false).size() == 3);
  CHECK(loose.feature_edges.empty());
  for (int v = 0; v < c.point_count(); ++v)
    if (c.place[v].dim != 1 || c.place[v].entity != 13) CHECK(loose.place[v].dim == c.place[v].dim);
  CHECK(loosen(loose, all, part.geometry(), false).empty());
  CHECK(loosen(loose, all, part.geometry(), true).size() > 0);
}

TEST_CASE("no run lies beside an edge that is too far") {
  const SplitBox part(2);
  HexComplex c = box_mesh({1, 4, 2}, kSize);
  CHECK(runs_beside_edges(c, {13}, part.surface(), part.geometry(), 1, context).empty());
}

namespace {

/// A plate of 3 x 3 x 1 in one element, stretched to `size`.
struct Plate {
  explicit Plate(const Vec3& size) {
    options.size = 3;
    lattice = build_lattice(surface.mesh, shape, options, context);
    REQUIRE(lattice.report.ok);
    REQUIRE(lattice.complex.hex_count() == 1);
    fitted = lattice.complex;
    for (Vec3& p : fitted.points) p = p.cwiseProduct(size);
  }
  std::vector<Separation> missing(const std::vector<int>& halfedges, double size) const {
    return missing_lines(halfedges, lattice, fitted, surface.mesh, shape, size, context);
  }
  const LabelledSurface surface = voxel_surface(box({0, 0, 0}, {3, 3, 1}), 1);
  const FeatureShape shape = make_feature_shape(surface);
  QuantizeOptions options;
  Lattice lattice;
  HexComplex fitted;
};

}  // namespace

TEST_CASE("a row of quads that a CAD edge runs along is to be a row more") {
  const Plate plate(Vec3(3, 3, 1));
  const SurfaceMesh& mesh = plate.surface.mesh;
  std::vector<int> along_y;
  for (int h = 0; h < 3 * mesh.triangle_count(); ++h) {
    const Vec3 &a = mesh.points[mesh.from(h)], &b = mesh.points[mesh.to(h)];
    if (h < mesh.opposite[h] && a.x() == 1 && b.x() == 1 && a.z() == 1 && b.z() == 1) along_y.push_back(h);
  }
  REQUIRE(along_y.size() == 3);
  CHECK(plate.missing({}, 3).empty());
  const auto finer = plate.missing(along_y, 3);
  REQUIRE(finer.size() == 1);
  CHECK(plate.shape.charts[finer[0].low].label == make_label(0, -1));
  CHECK(plate.shape.charts[finer[0].high].label == make_label(0, 1));
  CHECK(finer[0].gap == 2);
  CHECK(build_lattice(mesh, plate.shape, plate.options, context, finer).complex.hex_count() == 2);
}

TEST_CASE("rows much taller than the element size are to be several") {
  const auto wanted = Plate(Vec3(7, 1, 1)).missing({}, 1);
  REQUIRE(wanted.size() == 1);
  CHECK(wanted[0].gap == 3);
}
