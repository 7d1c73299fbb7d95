// HexFeatureWB - LGPL-2.1-or-later
#include "fit/fit.h"

#include <doctest/doctest.h>

#include "base/error.h"
#include "part_fixtures.h"

using namespace hexfeature;
using namespace fixtures;

namespace {
Vec3 straight(const Vec3& p) { return p; }
/// A quarter turn over a length of 8 about the y axis through x = 0, z = -8.
Vec3 bent(const Vec3& p) {
  const double a = p.x() / 8 * EIGEN_PI / 4, r = 8 + p.z();
  return {r * std::sin(a), p.y(), r * std::cos(a) - 8};
}
Vec3 twisted(const Vec3& p) {
  const double a = 0.15 * p.z(), c = std::cos(a), s = std::sin(a), x = p.x() - 2.5, y = p.y() - 2.5;
  return {c * x - s * y, s * x + c * y, p.z()};
}

struct Checks {
  int folded_quads = 0, wrong_entity = 0, faces_missing = 0;
  double deviation = 0, volume = 0;
};

Checks check(const VoxelPart& part, const HexComplex& mesh) {
  Checks c;
  std::vector<char> seen(part.faces.size() + 1, 0);
  for (std::size_t q = 0; q < mesh.quads.size(); ++q) {
    const auto& v = mesh.quads[q];
    seen[mesh.quad_face[q]] = 1;
    Vec3 centre = Vec3::Zero();
    for (int n : v) centre += 0.25 * mesh.points[n];
    const Vec3 normal = part.projector.project_to_face(mesh.quad_face[q], centre, nullptr).normal;
    for (int k = 0; k < 4; ++k) {
      const Vec3 a = mesh.points[v[(k + 1) % 4]] - mesh.points[v[k]], b = mesh.points[v[(k + 3) % 4]] - mesh.points[v[k]];
      if (a.cross(b).dot(normal) <= 0) {
        ++c.folded_quads;
        break;
      }
    }
    // Volume by the divergence theorem over two triangles.
    const Vec3 &p0 = mesh.points[v[0]], &p1 = mesh.points[v[1]], &p2 = mesh.points[v[2]], &p3 = mesh.points[v[3]];
    c.volume += (p0.dot(p1.cross(p2)) + p0.dot(p2.cross(p3))) / 6;
    for (int n : v) {
      const CadPlace& place = mesh.place[n];
      Vec3 on = mesh.points[n];
      if (place.dim == 0) on = part.projector.vertex_point(place.entity);
      if (place.dim == 1) on = part.projector.project_to_edge(place.entity, on, nullptr).point;
      if (place.dim == 2) on = part.projector.project_to_face(place.entity, on, nullptr).point;
      if (place.dim == 3) ++c.wrong_entity;
      c.deviation = std::max(c.deviation, (on - mesh.points[n]).norm());
    }
  }
  for (std::size_t f = 1; f < seen.size(); ++f) c.faces_missing += !seen[f];
  return c;
}

HexComplex fitted(const VoxelPart& part, double size) {
  HexComplex mesh = part.lattice;
  FitOptions options;
  options.size = size;
  Context context;
  fit_boundary(mesh, part.surface.mesh, part.shape, part.geometry(), options, context);
  return mesh;
}
}  // namespace

TEST_CASE("a straight part comes back as it was") {
  for (const auto& voxels : {unit_box(), ell(), plate_with_hole(), plate_with_boss(), blind_pocket(), staircase(), hollow_box()}) {
    VoxelPart part;
    make_part(part, voxels, 2, 3, straight);
    const HexComplex mesh = fitted(part, 1 / 3.);
    const Checks c = check(part, mesh);
    CHECK(c.folded_quads == 0);
    CHECK(c.wrong_entity == 0);
    CHECK(c.faces_missing == 0);
    CHECK(c.deviation < 1e-9);
    CHECK(c.volume == doctest::Approx(enclosed_volume(part.surface.mesh)));
    // Every arc is a sharp edge here, followed by mesh edges over its whole length.
    double length = 0, cad_length = 0;
    for (const auto& e : mesh.feature_edges) length += (mesh.points[e[0]] - mesh.points[e[1]]).norm();
    for (const auto& e : part.edges) cad_length += e.length;
    CHECK(length == doctest::Approx(cad_length));
  }
}

TEST_CASE("the plane pieces of a straight box are equally spaced, inside too") {
  VoxelPart part;
  make_part(part, unit_box(), 3, 4, straight);
  const HexComplex mesh = fitted(part, 0.25);
  for (int n = 0; n < mesh.point_count(); ++n) CHECK((mesh.points[n] - part.lattice.points[n] / 4).norm() < 1e-4);
}

TEST_CASE("bent and twisted parts fit without a fold") {
  for (const auto& voxels : {ell(), plate_with_hole(), plate_with_boss(), blind_pocket(), staircase()})
    for (const auto& bend : {bent, twisted}) {
      VoxelPart part;
      make_part(part, voxels, 4, 3, bend);
      const HexComplex mesh = fitted(part, 1 / 3.);
      const Checks c = check(part, mesh);
      CHECK(c.folded_quads == 0);
      CHECK(c.faces_missing == 0);
      CHECK(c.deviation < 1e-9);
      CHECK(c.volume == doctest::Approx(enclosed_volume(part.surface.mesh)).epsilon(0.02));
    }
}

namespace {
/// Length of mesh edges that follow CAD edges, over the length of the CAD edges.
double followed(const VoxelPart& part, const HexComplex& mesh) {
  double length = 0, cad_length = 0;
  for (const auto& e : mesh.feature_edges) length += (mesh.points[e[0]] - mesh.points[e[1]]).norm();
  for (const auto& e : part.edges) cad_length += e.length;
  return length / cad_length;
}
}  // namespace

TEST_CASE("a tangent CAD edge across charts gets a lattice line, and quads do not straddle it") {
  for (const double cut : {1.25, 1.5, 1.75, 2.0}) {
    VoxelPart part;
    // A line x = cut over the top and down both sides: six charts, eight CAD faces.
    make_part(part, box({0, 0, 0}, {4, 3, 2}), 4, 1, straight, [&](Label l, const Vec3& c) {
      const bool split = l == 4 || axis_of(l) == 1;
      return l + (split && c.x() > cut ? 10 : 0);
    });
    REQUIRE(part.faces.size() == 9);
    const HexComplex mesh = fitted(part, 1);
    const Checks c = check(part, mesh);
    CHECK(c.folded_quads == 0);
    CHECK(c.faces_missing == 0);
    CHECK(followed(part, mesh) == doctest::Approx(1));
    for (std::size_t q = 0; q < mesh.quads.size(); ++q)
      for (int n : mesh.quads[q]) {
        const Vec3 on = part.projector.project_to_face(mesh.quad_face[q], mesh.points[n], nullptr).point;
        CHECK((on - mesh.points[n]).norm() < 1e-9);
      }
  }
}

TEST_CASE("a tangent CAD edge aslant over the lattice is followed when the caller insists, with turns") {
  VoxelPart part;
  make_part(part, box({0, 0, 0}, {8, 8, 2}), 4, 1, straight,
            [](Label l, const Vec3& c) { return l + (l == 4 && c.y() > 2 + 0.5 * c.x() ? 10 : 0); });
  REQUIRE(part.faces.size() == 7);
  int inner = 0;  // the CAD edge between the two halves of the top
  for (std::size_t e = 0; e < part.edges.size(); ++e) {
    const auto& f = part.edges[e].faces;
    if (f[0] != f[1] && !part.edges[e].sharp) inner = static_cast<int>(e) + 1;
  }
  REQUIRE(inner > 0);
  const auto followed_by = [&](const std::vector<int>& insisted, int& turned) {
    HexComplex mesh = part.lattice;
    FitOptions options;
    options.size = 1;
    options.free_turns = true;
    options.insisted = insisted;
    Context context;
    turned = fit_boundary(mesh, part.surface.mesh, part.shape, part.geometry(), options, context);
    return std::count(mesh.feature_edge_cad.begin(), mesh.feature_edge_cad.end(), inner);
  };
  int turned = 0;
  CHECK(followed_by({}, turned) == 0);
  CHECK(turned == 0);
  CHECK(followed_by({inner}, turned) >= 8);
  CHECK(turned == 1);
}

TEST_CASE("a closed CAD edge inside a chart gets a loop of mesh edges") {
  VoxelPart part;
  make_part(part, box({0, 0, 0}, {6, 6, 2}), 4, 1, straight,
            [](Label l, const Vec3& c) { return l + (l == 4 && (c - Vec3(2.8, 3.1, 2)).norm() < 1.3 ? 10 : 0); });
  REQUIRE(part.faces.size() == 7);
  const HexComplex mesh = fitted(part, 1);
  const Checks c = check(part, mesh);
  CHECK(c.folded_quads == 0);
  CHECK(c.faces_missing == 0);
  int loop = 0;
  for (std::size_t e = 0; e < mesh.feature_edges.size(); ++e) {
    const auto& faces = part.edges[mesh.feature_edge_cad[e] - 1].faces;
    const auto& vertices = part.edges[mesh.feature_edge_cad[e] - 1].vertices;
    loop += vertices[0] == 0 && faces[0] != faces[1];
  }
  CHECK(loop >= 8);
}

TEST_CASE("quads beside a sharp edge lie on that edge's face, also next to a tangent edge that no mesh edge follows") {
  VoxelPart part;
  // A strip of the top narrower than an element: the nodes next to its sharp edge come to lie on the other face.
  make_part(part, box({0, 0, 0}, {6, 6, 2}), 4, 1, straight, [](Label l, const Vec3& c) { return l + (l == 4 && c.x() < 0.75 ? 10 : 0); });
  HexComplex mesh = part.lattice;
  FitOptions options;
  options.size = 1;
  options.smooth_edges = false;
  Context context;
  fit_boundary(mesh, part.surface.mesh, part.shape, part.geometry(), options, context);
  REQUIRE(!mesh.feature_edges.empty());
  int checked = 0;
  for (std::size_t q = 0; q < mesh.quads.size(); ++q) {
    int sides = 0;
    std::array<int, 2> faces{0, 0};
    for (int k = 0; k < 4; ++k) {
      std::array<int, 2> e{mesh.quads[q][k], mesh.quads[q][(k + 1) % 4]};
      std::sort(e.begin(), e.end());
      const auto at = std::lower_bound(mesh.feature_edges.begin(), mesh.feature_edges.end(), e);
      if (at == mesh.feature_edges.end() || *at != e) continue;
      ++sides;
      faces = part.edges[mesh.feature_edge_cad[at - mesh.feature_edges.begin()] - 1].faces;
    }
    if (sides != 1) continue;  // a corner of a chart may have sides on two faces
    ++checked;
    CHECK((mesh.quad_face[q] == faces[0] || mesh.quad_face[q] == faces[1]));
  }
  CHECK(checked > 20);
}

TEST_CASE("two corners on one CAD vertex are refused at once") {
  VoxelPart part;
  make_part(part, unit_box(), 3, 2, straight);
  const int a = part.shape.cells.nodes[0].vertex, b = part.shape.cells.nodes[1].vertex;
  REQUIRE(part.surface.mesh.place[a].dim == 0);
  part.surface.mesh.place[b] = part.surface.mesh.place[a];
  try {
    fitted(part, 0.5);
    FAIL("no error");
  } catch (const MeshingError& error) {
    CHECK(error.kind == Failure::NoMesh);
    CHECK(error.step == "fit");
    CHECK(!error.cad_faces.empty());
  }
}
