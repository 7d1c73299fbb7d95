// HexFeatureWB - LGPL-2.1-or-later
#include <doctest/doctest.h>

#include <cmath>
#include <map>

#include "fixtures.h"
#include "shape/corner_table.h"
#include "shape/validity.h"

using namespace hexfeature;
using namespace fixtures;

namespace {

std::vector<Voxels> all_shapes() {
  return {unit_box(), ell(), plate_with_hole(), plate_with_boss(), blind_pocket(), staircase(), hollow_box()};
}

/// Relabel the triangles that `where` selects and check.
ValidityReport relabelled(LabelledSurface surface, const std::function<bool(const LabelledSurface&, int)>& where, Label label) {
  for (int t = 0; t < surface.mesh.triangle_count(); ++t)
    if (where(surface, t)) surface.label[t] = label;
  FeatureShape shape = make_feature_shape(surface);
  return check_validity(shape, 1);
}

bool has_condition(const ValidityReport& report, int condition) {
  for (const auto& v : report.violations)
    if (v.condition == condition) return true;
  return false;
}

}  // namespace

TEST_CASE("48 + 48 + 24 corners, none of valence 5") {
  const std::map<int, int> expected = {{3, 48}, {4, 48}, {5, 0}, {6, 24}};
  for (const auto& [valence, count] : expected) {
    int found = 0, total = 1;
    for (int i = 0; i < valence; ++i) total *= 6;
    for (int k = 0; k < total; ++k) {
      Label labels[6];
      for (int i = 0, q = k; i < valence; ++i, q /= 6) labels[i] = static_cast<Label>(q % 6);
      found += !corner_signs(labels, valence).empty();
    }
    CHECK(found == count);
  }
}

TEST_CASE("voxel shapes are valid, with the true signs") {
  for (const auto& voxels : all_shapes()) {
    FeatureShape shape = make_feature_shape(voxel_surface(voxels));
    std::vector<int> signs;
    for (const auto& arc : shape.arcs) signs.push_back(arc.sign);
    const ValidityReport report = check_validity(shape, 1);
    CHECK(report.valid());
    CHECK(report.cost == 0);
    CHECK(report.sign_cost == 0);
    for (int a = 0; a < shape.arc_count(); ++a) CHECK(shape.arcs[a].sign == signs[a]);
  }
}

TEST_CASE("signs are found by the corners where geometry says nothing") {
  // A box with one slanted side: two of its edges run almost square to their axis, and another is bent back.
  auto surface = voxel_surface(box({0, 0, 0}, {2, 2, 2}), 2);
  deform(surface.mesh, [](const Vec3& p) { return Vec3(p.x() + 0.55 * p.z() * (p.x() < 1 ? 1 : -1), p.y(), p.z()); });
  FeatureShape shape = make_feature_shape(surface);
  const ValidityReport report = check_validity(shape, 1);
  CHECK(report.valid());
  // The top is now upside down in x: its two x arcs run backwards, and the corners overrule that.
  CHECK(report.sign_cost > 0);
  for (int a = 0; a < shape.arc_count(); ++a) {
    const auto& arc = shape.arcs[a];
    const auto& e = shape.cells.edges[a];
    const Vec3 l = direction(shape.charts[e.left].label), r = direction(shape.charts[e.right].label);
    CHECK(arc.sign == std::lround(l.cross(r)[arc.axis]));  // every edge of a box is convex
  }
}

TEST_CASE("opposite labels that share a border: V1") {
  const auto report = relabelled(
      voxel_surface(unit_box()), [](const LabelledSurface& s, int t) { return s.label[t] == 2; }, 1);
  CHECK(has_condition(report, 1));
}

TEST_CASE("a boss without corners at its foot: V1") {
  // All four sides of the boss take +X: its top and its foot have closed borders without a corner.
  const auto surface = voxel_surface(plate_with_boss());
  const auto report = relabelled(
      surface, [](const LabelledSurface& s, int t) { return s.label[t] < 4 && s.mesh.centroid(t).z() > 1; }, 0);
  CHECK(has_condition(report, 1));
  bool loop = false;
  for (const auto& v : report.violations) loop = loop || v.reason.find("no corner") != std::string::npos;
  CHECK(loop);
}

TEST_CASE("a box whose side joins the top: V2 or V3, blaming what is near") {
  const auto report = relabelled(
      voxel_surface(unit_box()), [](const LabelledSurface& s, int t) { return s.label[t] == 0; }, 4);
  CHECK(!report.valid());
  CHECK((has_condition(report, 2) || has_condition(report, 3)));
}

TEST_CASE("a patch of another label inside a face: no corner on its border") {
  const auto report = relabelled(
      voxel_surface(unit_box(), 4),
      [](const LabelledSurface& s, int t) {
        const Vec3 c = s.mesh.centroid(t);
        return s.label[t] == 4 && c.x() > 0.25 && c.x() < 0.75 && c.y() > 0.25 && c.y() < 0.75;
      },
      0);
  REQUIRE(report.violations.size() == 1);
  CHECK(report.violations[0].condition == 1);
}

TEST_CASE("stairs that climb round a tower back to where they began: V4, naming the treads") {
  Voxels v = box({2, 2, 0}, {4, 4, 10});
  const std::array<std::array<int, 4>, 8> flights = {
      {{0, 2, 0, 3}, {2, 4, 0, 2}, {4, 6, 0, 2}, {4, 6, 2, 4}, {4, 6, 4, 6}, {2, 4, 4, 6}, {0, 2, 4, 6}, {0, 2, 3, 4}}};
  for (int k = 0; k < 8; ++k) v = unite(v, box({flights[k][0], flights[k][2], 0}, {flights[k][1], flights[k][3], k + 1}));
  const auto surface = voxel_surface(v, 1);
  FeatureShape stairs = make_feature_shape(surface);
  CHECK(check_validity(stairs, 1).valid());

  // The great riser between the last tread and the first faces the other way: every corner is still legal, every loop
  // turns as it should, but the first tread now lies one above the last.
  auto escher = surface;
  for (int t = 0; t < escher.mesh.triangle_count(); ++t) {
    const Vec3 c = escher.mesh.centroid(t);
    if (escher.label[t] == 3 && c.x() < 2 && c.y() > 2.9 && c.y() < 3.1) escher.label[t] = 2;
  }
  FeatureShape shape = make_feature_shape(escher);
  const auto report = check_validity(shape, 1);
  REQUIRE(report.violations.size() == 1);
  CHECK(report.violations[0].condition == 4);
  CHECK(report.violations[0].charts.size() == 8);
  for (int c : report.violations[0].charts) CHECK(shape.charts[c].label == 4);
}
