// HexFeatureWB - LGPL-2.1-or-later
#include <doctest/doctest.h>

#include <algorithm>

#include "fixtures.h"
#include "label/group_rules.h"
#include "label/labels.h"
#include "round_fixtures.h"

using namespace hexfeature;
using namespace fixtures;

namespace {
PaperLabelResult label(const SurfaceMesh& mesh, double h = 1) {
  Context context;
  LabelOptions options;
  options.size = h;
  return label_paper(mesh, options, {}, context);
}
int conditions_broken(const FeatureShape& shape, int condition) {
  int n = 0;
  for (const auto& v : check_paper_conditions(shape)) n += v.condition == condition;
  return n;
}
}  // namespace

TEST_CASE("polycubes keep their own labels and satisfy the paper's conditions") {
  for (const auto& v : {unit_box(), ell(), plate_with_hole(), plate_with_boss(), blind_pocket(), staircase()}) {
    const auto surface = voxel_surface(v);
    const auto r = label(surface.mesh);
    CHECK(r.surface.label == surface.label);
    CHECK(r.smoothing_rounds == 0);
    CHECK(check_paper_conditions(r.shape).empty());
    CHECK(r.validity.valid());
    CHECK(r.filled);
  }
}

TEST_CASE("round solids become boxes") {
  const auto cylinder = round_cylinder(24, 6, 1, 3);
  CHECK(label(cylinder->mesh, 0.5).shape.chart_count() == 6);
  CHECK(label(cylinder->mesh, 0.5).validity.valid());
  const auto sphere = round_sphere(24, 1, Eigen::AngleAxisd(0.3, Vec3(1, 2, 3).normalized()).toRotationMatrix());
  CHECK(label(sphere->mesh, 0.5).shape.chart_count() == 6);
  CHECK(label(sphere->mesh, 0.5).validity.valid());
}

TEST_CASE("rule 1: a patch with few neighbours joins the one with the longest shared border") {
  auto surface = voxel_surface(box({0, 0, 0}, {4, 4, 4}), 2);
  const auto exact = surface.label;
  // A strange patch in the middle of the top (one neighbour), and one astride an edge (two).
  for (int t = 0; t < surface.mesh.triangle_count(); ++t) {
    const Vec3 c = surface.mesh.centroid(t);
    if (surface.label[t] == 4 && (c - Vec3(2, 2, 4)).norm() < 0.8) surface.label[t] = 0;
    if ((c - Vec3(2, 0, 4)).norm() < 0.8) surface.label[t] = 1;
  }
  CHECK(surface.label != exact);
  std::vector<Vec3> adaptation;
  for (int t = 0; t < surface.mesh.triangle_count(); ++t) adaptation.push_back(surface.mesh.mean_normal(t));
  const auto done = correct_groups(surface.mesh, adaptation, 1, surface.label, Context{});
  CHECK(done.joined >= 2);
  CHECK(make_feature_shape(surface).chart_count() == 6);
}

TEST_CASE("rule 2: a wedge's opposite faces are parted by a strip on the third axis") {
  auto surface = voxel_surface(box({0, 0, 0}, {4, 6, 6}), 2);
  // Pinch the top: an edge along y where +X and -X meet.
  deform(surface.mesh, [](const Vec3& p) { return Vec3(2 + (p[0] - 2) * (1 - p[2] / 6.0 * 0.97), p[1], p[2]); });
  for (int t = 0; t < surface.mesh.triangle_count(); ++t)
    if (surface.label[t] == 4) surface.label[t] = surface.mesh.centroid(t)[0] < 2 ? 1 : 0;
  std::vector<Vec3> adaptation;
  for (int t = 0; t < surface.mesh.triangle_count(); ++t) adaptation.push_back(surface.mesh.mean_normal(t));
  CHECK(conditions_broken(make_feature_shape(surface), 2) == 1);
  CHECK(conditions_broken(make_feature_shape(surface), 1) == 1);
  const auto done = correct_groups(surface.mesh, adaptation, 1, surface.label, Context{});
  CHECK(done.divided == 1);
  const auto shape = make_feature_shape(surface);
  CHECK(shape.chart_count() == 6);
  CHECK(check_paper_conditions(shape).empty());
}

TEST_CASE("the paper's conditions 3 and 4") {
  auto surface = voxel_surface(box({0, 0, 0}, {4, 4, 4}), 2);
  for (int t = 0; t < surface.mesh.triangle_count(); ++t)
    if (surface.label[t] == 4 && (surface.mesh.centroid(t) - Vec3(2, 2, 4)).norm() < 0.8) surface.label[t] = 0;
  CHECK(conditions_broken(make_feature_shape(surface), 3) >= 1);
}

TEST_CASE("noise is smoothed away by equations (1) and (2)") {
  auto solid = round_sphere(40, 1);
  for (std::size_t i = 0; i < solid->mesh.points.size(); ++i)
    solid->mesh.points[i] *= 1 + 0.02 * std::sin(37.0 * static_cast<double>(i * i));
  const auto r = label(solid->mesh, 0.3);
  CHECK(r.validity.valid());
  CHECK(r.adaptation.size() == solid->mesh.triangles.size());
  for (const auto& p : r.adaptation) CHECK(p.norm() == doctest::Approx(1));
}
