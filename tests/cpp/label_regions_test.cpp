// HexFeatureWB - LGPL-2.1-or-later
#include <doctest/doctest.h>

#include <algorithm>

#include "cad_shapes.h"
#include "fixtures.h"
#include "label/labels.h"
#include "label/regions.h"
#include "round_fixtures.h"
#include "shape/partition.h"
#include "surface_fixtures.h"

using namespace hexfeature;
using namespace fixtures;

namespace {

/// The invariants of a surface mesh that cutting must keep.
void check_mesh(const SurfaceMesh& mesh) {
  CHECK(mesh.place.size() == mesh.points.size());
  CHECK(mesh.triangle_face.size() == mesh.triangles.size());
  CHECK(mesh.corner_normals.size() == 3 * mesh.triangles.size());
  CHECK(mesh.halfedge_edge.size() == 3 * mesh.triangles.size());
  REQUIRE(mesh.opposite.size() == 3 * mesh.triangles.size());
  bool twins = true, edges = true, upright = true;
  for (int h = 0; h < 3 * mesh.triangle_count(); ++h) {
    const int o = mesh.opposite[h];
    twins &= mesh.opposite[o] == h && mesh.from(h) == mesh.to(o) && mesh.to(h) == mesh.from(o);
    edges &= mesh.halfedge_edge[h] == mesh.halfedge_edge[o];
    upright &= mesh.area_normal(h / 3).dot(mesh.mean_normal(h / 3)) > 0;
  }
  CHECK(twins);
  CHECK(edges);
  CHECK(upright);
  SurfaceMesh again = mesh;
  connect(again);
  CHECK(again.opposite == mesh.opposite);
}

void check_sites(const Regions& r) {
  check_mesh(r.mesh);
  const Partition cells = make_partition(r.mesh, r.site);
  CHECK(static_cast<int>(cells.parts.size()) == r.site_count());
  const auto components = connected_components(r.mesh, r.site);
  CHECK(1 + *std::max_element(components.begin(), components.end()) == r.site_count());
  for (int t = 0; t < r.mesh.triangle_count(); ++t) CHECK_EQ(r.site_face[r.site[t]], r.mesh.triangle_face[t]);
}

std::vector<double> areas(const Regions& r) {
  std::vector<double> a(r.site_count(), 0);
  for (int t = 0; t < r.mesh.triangle_count(); ++t) a[r.site[t]] += r.mesh.area(t);
  return a;
}

Mat3 turned(double degrees, const Vec3& axis) { return Eigen::AngleAxisd(degrees * EIGEN_PI / 180, axis.normalized()).toRotationMatrix(); }

Regions cut(const RoundSolid& s, double h) {
  Context context;
  RegionOptions options;
  options.size = h;
  return cut_regions(s.mesh, s.geometry(), options, context);
}

}  // namespace

TEST_CASE("a cylinder has four straight strips and two whole caps, whatever its phase") {
  for (double phase : {0.0, 0.1, double(EIGEN_PI) / 4, 0.77, 0.8}) {
    const auto solid = round_cylinder(24, 6, 1, 3, Mat3::Identity(), phase);
    const Regions r = cut(*solid, 0.4);
    check_sites(r);
    CHECK(r.site_count() == 6);
    // The borders of the strips are at 45 degrees exactly, and on the true cylinder.
    for (int h = 0; h < 3 * r.mesh.triangle_count(); ++h) {
      const int a = r.site[h / 3], b = r.site[r.mesh.opposite[h] / 3];
      if (a == b || r.site_face[a] != 1 || r.site_face[b] != 1) continue;
      const Vec3& p = r.mesh.points[r.mesh.from(h)];
      CHECK(std::abs(p[0]) == doctest::Approx(std::abs(p[1])));
      CHECK(std::hypot(p[0], p[1]) == doctest::Approx(1));
    }
  }
}

TEST_CASE("an oblique cylinder has straight strips along its axis, cut across at mid-length") {
  const auto solid = round_cylinder(20, 9, 1, 6, turned(40, Vec3(1, 0, 0)));
  const Regions r = cut(*solid, 0.5);
  check_sites(r);
  CHECK(r.site_count() == 10);
  const auto short_one = round_cylinder(20, 3, 1, 0.4, turned(40, Vec3(1, 0, 0)));
  CHECK(cut(*short_one, 0.5).site_count() == 6);
}

TEST_CASE("a narrow strip along a tangent edge is not cut off") {
  // A fillet of radius 2 turned by 30 degrees: the cut leaves 15 degrees of it, 0.52 wide, beside the plane.
  const auto model = cad_shapes::model_of(cad_shapes::turned(cad_shapes::rounded_block(10, 2, 6), 0, 0, -30));
  const auto sites_of_fillet = [&](double h) {
    Context context;
    RegionOptions options;
    options.size = h;
    const Regions r = cut_regions(cad_shapes::surface_of(*model, h), model->geometry(), options, context);
    check_sites(r);
    int count = 0;
    for (int face : r.site_face) count += model->faces[face - 1].kind == SurfaceKind::Cylinder;
    return count;
  };
  CHECK(sites_of_fillet(1) == 2);
  CHECK(sites_of_fillet(3) == 1);
}

namespace {

/// Sites of the faces round an axis, and the angles, mod 90 degrees, of the borders between two of them inside one face.
struct HoleSites {
  int cylinder = 0, cone = 0;
  double least = 90, most = 0;
};
HoleSites sites_of_hole(const TopoDS_Shape& shape, const Vec3& centre, double h) {
  const auto model = cad_shapes::model_of(shape);
  Context context;
  RegionOptions options;
  options.size = h;
  const Regions r = cut_regions(cad_shapes::surface_of(*model, h), model->geometry(), options, context);
  check_sites(r);
  HoleSites result;
  for (int f : r.site_face) {
    result.cylinder += model->faces[f - 1].kind == SurfaceKind::Cylinder;
    result.cone += model->faces[f - 1].kind == SurfaceKind::Cone;
  }
  for (int t = 0; t < 3 * r.mesh.triangle_count(); ++t) {
    const int a = r.site[t / 3], b = r.site[r.mesh.opposite[t] / 3];
    if (a == b || r.site_face[a] != r.site_face[b]) continue;
    const Vec3 p = r.mesh.points[r.mesh.from(t)] - centre;
    if (std::hypot(p[0], p[1]) < 0.5) continue;  // near an apex a cut takes vertices
    const double angle = std::fmod(std::atan2(p[1], p[0]) * 180 / EIGEN_PI + 360, 90);
    result.least = std::min(result.least, angle);
    result.most = std::max(result.most, angle);
  }
  return result;
}

}  // namespace

TEST_CASE("a hole in two halves: a strip ends at the line that parts them when the nearest node would be a strip's end") {
  const Vec3 centre(20, 15, 0);
  const auto plate = [&](double degrees) {
    const auto drill = cad_shapes::parted_drill(2.7, 20, degrees, 0);
    return cad_shapes::cut(cad_shapes::box(40, 30, 8), cad_shapes::moved(drill, 20, 15, -5));
  };
  for (double degrees : {30.0, 60.0}) {  // 15 degrees beside the diagonal
    const HoleSites turned = sites_of_hole(plate(degrees), centre, 2);
    CHECK(turned.cylinder == 4);
    CHECK(turned.least == doctest::Approx(degrees).epsilon(1e-4));
    CHECK(turned.most == doctest::Approx(degrees).epsilon(1e-4));
  }
  const HoleSites usual = sites_of_hole(plate(10), centre, 2);  // a node half way along a strip is nearer
  CHECK(usual.cylinder == 6);
  CHECK(usual.least == doctest::Approx(45).epsilon(1e-4));
  CHECK(usual.most == doctest::Approx(45).epsilon(1e-4));
  // With many elements round the hole a node stands near the line anyhow.
  CHECK(sites_of_hole(plate(30), centre, 0.5).least == doctest::Approx(45).epsilon(1e-4));
}

TEST_CASE("... not where the line runs on over a tip, which needs it between two ends") {
  const Vec3 centre(20, 15, 0);
  const auto block = [&](double degrees) {
    const auto drill = cad_shapes::parted_drill(2, 20, degrees, 1.2);
    return cad_shapes::cut(cad_shapes::box(40, 30, 12), cad_shapes::moved(drill, 20, 15, 6));
  };
  const HoleSites tip = sites_of_hole(block(57), centre, 2);  // 12 degrees, 0.2 h: narrow strips stay
  CHECK(tip.cylinder == 6);
  CHECK(tip.cone == 6);
  CHECK(tip.least == doctest::Approx(45).epsilon(1e-4));
  CHECK(tip.most == doctest::Approx(45).epsilon(1e-4));
  CHECK(sites_of_hole(block(57), centre, 1).cone == 4);  // three intervals have no middle: the usual turn
}

TEST_CASE("chamfers that meet in mitres go with the top, where the edges below them can be followed") {
  // Square to x, chamfer and wall could as well be one chart, whose border would leave no mesh edge for the edge between them.
  const double h = 1;
  const auto model = cad_shapes::model_of(cad_shapes::chamfered_hexagon(4.44, 3.85, 0.385));
  Context context;
  LabelOptions options;
  options.size = h;
  const LabelResult labels = label_regions(cad_shapes::surface_of(*model, h), model->geometry(), options, {}, context);
  CHECK(labels.validity.valid());
  const SurfaceMesh& mesh = labels.surface.mesh;
  int chamfers = 0;
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    const Vec3 n = mesh.mean_normal(t);
    if (n[2] < 0.5 || n[2] > 0.9) continue;
    ++chamfers;
    CHECK(labels.surface.label[t] == make_label(2, 1));
  }
  CHECK(chamfers > 0);
}

TEST_CASE("a sphere has six sites of equal area") {
  const auto solid = round_sphere(32, 1, turned(33, Vec3(1, 2, 3)));
  const Regions r = cut(*solid, 0.3);
  check_sites(r);
  REQUIRE(r.site_count() == 6);
  for (double a : areas(r)) CHECK(a == doctest::Approx(4 * EIGEN_PI / 6).epsilon(0.05));
}

TEST_CASE("a torus has sixteen sites") {
  const auto solid = round_torus(32, 16, 2, 0.6, turned(20, Vec3(1, 0.3, 0)));
  const Regions r = cut(*solid, 0.3);
  check_sites(r);
  CHECK(r.site_count() == 16);
}

TEST_CASE("the four strips of a cone meet at its apex, even one a hair off the axis") {
  auto solid = round_cylinder(24, 1, 1, 2);
  RoundSolid cone;
  cone.faces = solid->faces;
  cone.faces[0].kind = SurfaceKind::Cone;
  const int apex = cone.add_point(Vec3(3e-9, -2e-9, 2), 0, 1), middle = cone.add_point(Vec3::Zero(), 2, 2);
  for (int i = 0; i < 24; ++i) cone.add_point(solid->mesh.points[2 + i], 1, 1);
  for (int i = 0; i < 24; ++i) {
    cone.add_triangle(2 + i, 2 + (i + 1) % 24, apex, 1);
    cone.add_triangle(2 + (i + 1) % 24, 2 + i, middle, 2);
  }
  connect(cone.mesh);
  Context context;
  const Geometry geometry{&cone.faces, nullptr, nullptr, nullptr};
  RegionOptions options;
  options.size = 0.3;
  const Regions r = cut_regions(cone.mesh, geometry, options, context);
  check_sites(r);
  CHECK(r.site_count() == 5);
}

TEST_CASE("planes stay whole and an uncut mesh comes back as it was") {
  const auto box = voxel_surface(plate_with_hole());
  std::vector<CadFace> faces(*std::max_element(box.mesh.triangle_face.begin(), box.mesh.triangle_face.end()));
  for (auto& f : faces) f.kind = SurfaceKind::Plane;
  const Geometry geometry{&faces, nullptr, nullptr, nullptr};
  Context context;
  const Regions r = cut_regions(box.mesh, geometry, {}, context);
  check_sites(r);
  CHECK(r.site_count() == 10);
  CHECK(r.mesh.points == box.mesh.points);
}

namespace {

/// A box of 4 x 3 x 2 whose six faces are the sites.
Regions box_regions(int n) {
  const auto box_surface = voxel_surface(box({0, 0, 0}, {4, 3, 2}), n);
  Regions r;
  r.mesh = box_surface.mesh;
  for (int f : r.mesh.triangle_face) r.site.push_back(f - 1);
  for (int s = 0; s < 6; ++s) r.site_face.push_back(s + 1);
  return r;
}
int site_towards(const Regions& r, const Vec3& direction) {
  for (int t = 0; t < r.mesh.triangle_count(); ++t)
    if (r.mesh.mean_normal(t).dot(direction) > 0.99) return r.site[t];
  return -1;
}
/// Halfedges of `site` along its border with `other`.
std::vector<int> border(const Regions& r, int site, int other) {
  const Partition cells = make_partition(r.mesh, r.site);
  for (const auto& e : cells.edges) {
    if (e.left == site && e.right == other) return e.halfedges;
    if (e.left == other && e.right == site) {
      std::vector<int> back;
      for (auto h = e.halfedges.rbegin(); h != e.halfedges.rend(); ++h) back.push_back(r.mesh.opposite[*h]);
      return back;
    }
  }
  return {};
}

}  // namespace

TEST_CASE("a strip has its width, its own number, and leaves the others alone") {
  for (int n : {1, 2, 3}) {
    Regions r = box_regions(n);
    const int top = site_towards(r, Vec3::UnitZ()), side = site_towards(r, Vec3::UnitX());
    const auto chain = border(r, top, side);
    REQUIRE(!chain.empty());
    CHECK(strip_extent(r, top, chain) == doctest::Approx(4));
    REQUIRE(split_strip(r, {}, top, chain, 0.7, 0.1));
    check_sites(r);
    CHECK(r.site_count() == 7);
    const auto a = areas(r);
    CHECK(a[6] == doctest::Approx(0.7 * 3));
    CHECK(a[top] == doctest::Approx(3.3 * 3));
    CHECK(a[side] == doctest::Approx(6));
    CHECK(r.site_face[6] == r.site_face[top]);
  }
}

TEST_CASE("a strip along a part of a straight border ends squarely") {
  Regions r = box_regions(2);
  const int top = site_towards(r, Vec3::UnitZ()), side = site_towards(r, Vec3::UnitX());
  REQUIRE(split_across(r, {}, side, 1, 1.2, 0.1));
  const auto chain = border(r, top, side);
  const double length = (r.mesh.points[r.mesh.from(chain.front())] - r.mesh.points[r.mesh.to(chain.back())]).norm();
  REQUIRE(split_strip(r, {}, top, chain, 0.6, 0.1));
  check_sites(r);
  CHECK(areas(r)[7] == doctest::Approx(0.6 * length).epsilon(0.01));
}

TEST_CASE("a rim round a face falls apart at its corners and faces outward") {
  for (int n : {1, 2, 3}) {
    Regions r = box_regions(n);
    const int top = site_towards(r, Vec3::UnitZ());
    std::vector<int> outline;
    for (int h = 0; h < 3 * r.mesh.triangle_count(); ++h)
      if (r.site[h / 3] == top && r.site[r.mesh.opposite[h] / 3] != top) outline.push_back(h);
    std::vector<Label> labels;
    REQUIRE(split_rim(r, {}, top, outline, 2, 0.5, 0.1, labels));
    check_sites(r);
    REQUIRE(r.site_count() == 10);
    REQUIRE(labels.size() == 10);
    const auto a = areas(r);
    CHECK(a[top] == doctest::Approx(3 * 2).epsilon(0.05));
    CHECK(labels[top] == kNoLabel);
    std::vector<Label> seen;
    for (int s = 6; s < 10; ++s) {
      seen.push_back(labels[s]);
      CHECK(a[s] == doctest::Approx(axis_of(labels[s]) == 0 ? 0.5 * 2.5 : 0.5 * 3.5).epsilon(0.06));
      Vec3 middle = Vec3::Zero();
      for (int t = 0; t < r.mesh.triangle_count(); ++t)
        if (r.site[t] == s) middle += r.mesh.area(t) / a[s] * r.mesh.centroid(t);
      const double centre[3] = {2, 1.5, 0};
      const int axis = axis_of(labels[s]);
      CHECK(sign_of(labels[s]) * (middle[axis] - centre[axis]) > 1);
    }
    std::sort(seen.begin(), seen.end());
    CHECK(seen == std::vector<Label>{0, 1, 2, 3});
    for (int s = 0; s < 6; ++s) CHECK(labels[s] == kNoLabel);
  }
}

TEST_CASE("a rim along a part of the border goes round its ends") {
  Regions r = box_regions(2);
  const int top = site_towards(r, Vec3::UnitZ()), side = site_towards(r, Vec3::UnitX());
  REQUIRE(split_across(r, {}, side, 1, 1.2, 0.1));
  const auto chain = border(r, top, side);
  const double length = (r.mesh.points[r.mesh.from(chain.front())] - r.mesh.points[r.mesh.to(chain.back())]).norm();
  std::vector<Label> labels;
  REQUIRE(split_rim(r, {}, top, chain, 2, 0.6, 0.1, labels));
  check_sites(r);
  REQUIRE(labels.size() == 8);
  CHECK(labels[7] == 0);
  CHECK(areas(r)[7] == doctest::Approx(0.6 * length + 0.25 * EIGEN_PI * 0.36).epsilon(0.05));
  CHECK_FALSE(split_rim(r, {}, top, border(r, top, 7), 2, 0.01, 0.1, labels));
}

TEST_CASE("a cut across a frame axis") {
  Regions r = box_regions(2);
  const int top = site_towards(r, Vec3::UnitZ());
  REQUIRE(split_across(r, {}, top, 0, 1.3, 0.1));
  check_sites(r);
  const auto a = areas(r);
  CHECK(a[top] == doctest::Approx(2.7 * 3));
  CHECK(a[6] == doctest::Approx(1.3 * 3));
}

TEST_CASE("a split that leaves nothing says so and changes nothing") {
  Regions r = box_regions(2);
  const int top = site_towards(r, Vec3::UnitZ()), side = site_towards(r, Vec3::UnitX());
  const auto chain = border(r, top, side);
  const auto points = r.mesh.points;
  CHECK_FALSE(split_strip(r, {}, top, chain, 9, 0.1));
  CHECK_FALSE(split_strip(r, {}, top, chain, 0.01, 0.1));
  CHECK_FALSE(split_across(r, {}, top, 0, 7, 0.1));
  CHECK_FALSE(split_across(r, {}, top, 2, 2, 0.1));
  CHECK_FALSE(split_creases(r, top, 10, 0.1));
  CHECK(r.mesh.points == points);
  CHECK(r.site_count() == 6);
}

TEST_CASE("inner creases cut a site") {
  Regions r = box_regions(2);
  const int top = site_towards(r, Vec3::UnitZ()), side = site_towards(r, Vec3::UnitX());
  for (int& s : r.site)
    if (s == side) s = top;
  REQUIRE(split_creases(r, top, 10, 0.1));
  CHECK(areas(r)[top] == doctest::Approx(12));
  CHECK(areas(r)[6] == doctest::Approx(6));
}

TEST_CASE("a strip along the rim of a cylinder's wall stays on the cylinder") {
  const auto solid = round_cylinder(24, 6, 1, 3);
  Regions r = cut(*solid, 0.4);
  const int wall = site_towards(r, Vec3::UnitX());
  int cap = -1;
  for (int s = 0; s < r.site_count(); ++s)
    if (r.site_face[s] == 3) cap = s;
  REQUIRE(split_strip(r, solid->geometry(), wall, border(r, wall, cap), 0.5, 0.05));
  check_sites(r);
  CHECK(areas(r)[6] == doctest::Approx(0.5 * EIGEN_PI / 2).epsilon(0.02));
  for (int t = 0; t < r.mesh.triangle_count(); ++t)
    if (r.mesh.triangle_face[t] == 1)
      for (int v : r.mesh.triangles[t]) CHECK(r.mesh.points[v].head<2>().norm() == doctest::Approx(1));
}

TEST_CASE("holes that graze each other get a rim round their window") {
  // Two holes along x and z whose axes are nearer than the radii together: a window with a knife edge all round it, between a wall
  // towards -y and one towards +y.
  using cad_shapes::cylinder;
  for (double overlap : {0.5, 1.0, 2.0}) {
    const auto along_x = cad_shapes::moved(cad_shapes::turned(cylinder(6, 60), 0, 90, 0), -10, 14, 20);
    const auto along_z = cad_shapes::moved(cylinder(4, 60), 20, 24 - overlap, -10);
    const auto model = cad_shapes::model_of(cad_shapes::cut(cad_shapes::cut(cad_shapes::box(40, 40, 40), along_x), along_z));
    LabelOptions options;
    options.size = 4;
    Context context;
    const FillCheck fill = [](const SurfaceMesh&, const FeatureShape&, bool) { return FillOutcome{true, {}, {}}; };
    const LabelResult result = label_regions(cad_shapes::surface_of(*model, 4), model->geometry(), options, fill, context);
    CHECK(result.validity.valid());
    CHECK(result.filled);
    CHECK(result.expansions < 20);
    // The window has walls of its own towards +-x or +-z, on one of the two holes: only a rim faces along that hole's axis.
    double on_x[6] = {}, on_z[6] = {};
    for (int t = 0; t < result.surface.mesh.triangle_count(); ++t) {
      const Vec3 p = result.surface.mesh.centroid(t);
      const double from_x = std::hypot(p.y() - 14, p.z() - 20), from_z = std::hypot(p.x() - 20, p.y() - (24 - overlap));
      if (std::abs(from_x - 6) < 0.3) on_x[result.surface.label[t]] += result.surface.mesh.area(t);
      if (std::abs(from_z - 4) < 0.3) on_z[result.surface.label[t]] += result.surface.mesh.area(t);
    }
    CHECK(std::max(std::min(on_x[0], on_x[1]), std::min(on_z[4], on_z[5])) > 0.1);
  }
}
