// HexFeatureWB - LGPL-2.1-or-later
#include <doctest/doctest.h>

#include "fixtures.h"
#include "shape/feature_shape.h"

using namespace hexfeature;
using namespace fixtures;

namespace {
int euler(const FeatureShape& s) {
  // Charts with k loops contribute 2 - k.
  int charts = 0;
  for (const auto& p : s.cells.parts) charts += 2 - static_cast<int>(p.loops.size());
  return s.corner_count() - s.arc_count() + charts;
}
}  // namespace

TEST_CASE("a box has 6 charts, 12 arcs, 8 corners") {
  const auto shape = make_feature_shape(voxel_surface(unit_box()));
  CHECK(shape.chart_count() == 6);
  CHECK(shape.arc_count() == 12);
  CHECK(shape.corner_count() == 8);
  CHECK(euler(shape) == 2);
  for (const auto& node : shape.cells.nodes) CHECK(node.darts.size() == 3);
  for (const auto& part : shape.cells.parts) {
    REQUIRE(part.loops.size() == 1);
    CHECK(part.loops[0].size() == 4);
  }
  for (const auto& arc : shape.arcs) CHECK(arc.dihedral == doctest::Approx(EIGEN_PI / 2));
}

TEST_CASE("darts: the part is on the left, loops are consecutive, node darts turn counter-clockwise") {
  for (const auto& v : {ell(), plate_with_hole(), plate_with_boss(), blind_pocket(), hollow_box(), staircase()}) {
    const auto shape = make_feature_shape(voxel_surface(v));
    const auto& c = shape.cells;
    for (int p = 0; p < static_cast<int>(c.parts.size()); ++p)
      for (const auto& loop : c.parts[p].loops)
        for (std::size_t i = 0; i < loop.size(); ++i) {
          CHECK(c.left_of(loop[i]) == p);
          CHECK(c.end_of(loop[i]) == c.start_of(loop[(i + 1) % loop.size()]));
        }
    for (int n = 0; n < static_cast<int>(c.nodes.size()); ++n)
      for (std::size_t i = 0; i < c.nodes[n].darts.size(); ++i) {
        const int d = c.nodes[n].darts[i], e = c.nodes[n].darts[(i + 1) % c.nodes[n].darts.size()];
        CHECK(c.start_of(d) == n);
        CHECK(c.left_of(d) == c.right_of(e));
      }
  }
}

TEST_CASE("Euler numbers") {
  CHECK(euler(make_feature_shape(voxel_surface(plate_with_hole()))) == 0);
  CHECK(euler(make_feature_shape(voxel_surface(hollow_box()))) == 4);
  CHECK(make_feature_shape(voxel_surface(plate_with_boss())).chart_count() == 11);
}

TEST_CASE("an arc's axis is the third one and its sign that of its displacement") {
  const auto shape = make_feature_shape(voxel_surface(ell()));
  for (const auto& arc : shape.arcs) {
    REQUIRE(arc.axis >= 0);
    CHECK(std::abs(arc.displacement[arc.axis]) == doctest::Approx(arc.length));
    CHECK(arc.sign == (arc.displacement[arc.axis] > 0 ? 1 : -1));
  }
}
