// HexFeatureWB - LGPL-2.1-or-later
#include "polycube/polycube.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "fixtures.h"
#include "polycube/difference_lp.h"

using namespace hexfeature;
using namespace fixtures;

namespace {

Polycube solve(const LabelledSurface& surface, double size, int minimum = 1) {
  QuantizeOptions options;
  options.size = size;
  options.minimum_intervals = minimum;
  Context context;
  return quantize(surface.mesh, make_feature_shape(surface), options, {}, context);
}

}  // namespace

TEST_CASE("difference LPs: as good as a search over all integers, and never against a hard term") {
  std::mt19937 random(3);
  const auto below = [&](int n) { return static_cast<int>(random() % n); };
  for (int trial = 0; trial < 200; ++trial) {
    const int n = 4, range = 7;
    std::vector<DifferenceTerm> terms;
    for (int i = 0; i < 9; ++i) terms.push_back({below(n), below(n), below(7) - 3, 1 + below(20)});
    terms.push_back({0, 1, 1, kHardTerm});
    terms.push_back({1, 2, below(3), kHardTerm});
    const auto holds = [&](const std::vector<int>& x) {
      return std::all_of(terms.begin(), terms.end(),
                         [&](const DifferenceTerm& t) { return t.weight != kHardTerm || x[t.to] - x[t.from] >= t.gap; });
    };
    const auto solution = solve_differences(n, terms);
    REQUIRE(solution.cycle.empty());
    CHECK(holds(solution.x));
    std::int64_t best = -1;
    for (int code = 0; code < range * range * range; ++code) {
      // x[0] = 0: only differences matter.
      const std::vector<int> x{0, code % range - 0, code / range % range - 0, code / range / range - 3};
      for (int shift = -6; shift <= 6; shift += 3) {
        auto y = x;
        y[3] += shift;
        if (holds(y) && (best < 0 || difference_cost(terms, y) < best)) best = difference_cost(terms, y);
      }
    }
    CHECK(difference_cost(terms, solution.x) <= best);
  }
}

TEST_CASE("a positive cycle of hard terms is found and named") {
  const std::vector<DifferenceTerm> terms{
      {3, 0, 1, kHardTerm}, {0, 1, 1, kHardTerm}, {1, 2, 1, kHardTerm}, {2, 0, -1, kHardTerm}, {1, 3, 5, 7}};
  const auto solution = solve_differences(4, terms);
  REQUIRE(solution.cycle.size() == 3);
  auto cycle = solution.cycle;
  std::sort(cycle.begin(), cycle.end());
  CHECK(cycle == std::vector<int>{1, 2, 3});
  CHECK(solve_differences(1, {{0, 0, 1, kHardTerm}}).cycle.size() == 1);
}

TEST_CASE("convex terms add up to the cost at integers") {
  for (const double target : {0.3, 1.0, 2.5, 7.75})
    for (const int minimum : {-1000, 1, 3}) {
      std::vector<DifferenceTerm> terms;
      const auto cost = [&](int d) { return std::abs(d - target) + 0.5 * (d - target) * (d - target) / std::max(1.0, target); };
      add_convex_terms(terms, 0, 1, target, minimum, cost);
      for (int d = std::max(minimum, static_cast<int>(target) - 3); d < target + 4; ++d) {
        const auto step = difference_cost(terms, {0, d + 1}) - difference_cost(terms, {0, d});
        CHECK(step == doctest::Approx(kTermScale * (cost(d + 1) - cost(d))).epsilon(0.01));
      }
    }
}

TEST_CASE("a chart's coordinate is a voxel coordinate when h is a voxel") {
  for (const auto& v : {unit_box(), ell(), plate_with_hole(), plate_with_boss(), blind_pocket(), hollow_box(), staircase()}) {
    const auto surface = voxel_surface(v);
    const auto shape = make_feature_shape(surface);
    const auto polycube = solve(surface, 1);
    for (int c = 0; c < shape.chart_count(); ++c)
      CHECK(polycube.coordinate[c] == doctest::Approx(shape.charts[c].centroid[axis_of(shape.charts[c].label)]));
    for (int n = 0; n < shape.corner_count(); ++n)
      for (int k = 0; k < 3; ++k) CHECK(polycube.corners[n][k] == doctest::Approx(surface.mesh.points[shape.cells.nodes[n].vertex][k]));
  }
}

TEST_CASE("every arc gets the least number of intervals, whatever h") {
  for (const double size : {0.3, 1.7, 50.0})
    for (const int minimum : {1, 2}) {
      const auto surface = voxel_surface(plate_with_boss());
      const auto shape = make_feature_shape(surface);
      const auto polycube = solve(surface, size, minimum);
      for (int i = 0; i < shape.arc_count(); ++i) {
        const auto& e = shape.cells.edges[i];
        const int a = shape.arcs[i].axis;
        CHECK(shape.arcs[i].sign * (polycube.corners[e.end][a] - polycube.corners[e.start][a]) >= minimum);
      }
    }
}

TEST_CASE("mirrored features get equal counts where rounding is tied") {
  // Two bosses 1.5 h wide, mirrored: the tie must break the same way.
  auto surface = voxel_surface(unite(box({0, 0, 0}, {9, 3, 1}), unite(box({1, 1, 1}, {2, 2, 2}), box({7, 1, 1}, {8, 2, 2}))));
  const auto shape = make_feature_shape(surface);
  for (const double size : {2.0 / 3, 0.4, 0.8}) {
    const auto polycube = solve(surface, size);
    std::vector<int> tops;
    for (int c = 0; c < shape.chart_count(); ++c)
      if (shape.charts[c].centroid.z() == 2) {
        int lo = 1000, hi = 0;
        for (int dart : shape.cells.parts[c].loops[0]) {
          lo = std::min(lo, polycube.corners[shape.cells.start_of(dart)][0]);
          hi = std::max(hi, polycube.corners[shape.cells.start_of(dart)][0]);
        }
        tops.push_back(hi - lo);
      }
    REQUIRE(tops.size() == 2);
    CHECK(tops[0] == tops[1]);
  }
}

TEST_CASE("a sharp arc gets a line where one of its CAD faces ends, unless a piece would be too short") {
  // The top of a cube, 1.25 h wide, is two CAD faces in one plane.
  for (const double border : {0.0, 0.75, 1.5}) {
    auto surface = voxel_surface(box({0, 0, 0}, {3, 3, 3}), 4);
    SurfaceMesh& mesh = surface.mesh;
    mesh.triangle_face.assign(mesh.triangle_count(), 0);
    for (int t = 0; t < mesh.triangle_count(); ++t) {
      Vec3 centre = Vec3::Zero();
      for (int v : mesh.triangles[t]) centre += mesh.points[v] / 3;
      const Label l = surface.label[t];
      mesh.triangle_face[t] = 1 + l + (l == 4 && centre.x() < border ? 6 : 0);
    }
    mesh.halfedge_edge.assign(3 * mesh.triangle_count(), 0);
    for (int h = 0; h < 3 * mesh.triangle_count(); ++h)
      if (std::abs(mesh.dihedral(h)) > 1) mesh.halfedge_edge[h] = 1;
    const auto shape = make_feature_shape(surface);
    const Polycube polycube = solve(surface, 2.4);
    std::array<int, 2> x{100, -100};
    for (const auto& corner : polycube.corners) x = {std::min(x[0], corner[0]), std::max(x[1], corner[0])};
    CHECK(x[1] - x[0] == (border == 1.5 ? 2 : 1));
  }
}

TEST_CASE("concentric rings: made even when that is not too dear, and left as they are when it is") {
  // Two rings, on both axes the unknowns 0..1 and 2..3; 7.2 and 8.1 intervals wide.
  const ConcentricUnknowns group{{0, 1}, {{{{0, 1}, {0, 1}}}, {{{2, 3}, {2, 3}}}}};
  const auto terms_for = [](double inner, double outer, bool fixed) {
    std::vector<DifferenceTerm> list;
    for (const auto& [low, high, width] : {std::make_tuple(0, 1, inner), std::make_tuple(2, 3, outer)}) {
      add_convex_terms(list, low, high, width, 1, [w = width](int d) { return std::abs(d - w); });
      if (!fixed) continue;
      list.push_back({low, high, static_cast<int>(std::lround(width)), kHardTerm});
      list.push_back({high, low, -static_cast<int>(std::lround(width)), kHardTerm});
    }
    list.push_back({2, 0, 0, 1});  // the outer ring holds the inner one
    list.push_back({1, 3, 0, 1});
    return list;
  };
  const auto solved = [&](double inner, double outer, bool fixed, double cost) {
    const auto list = terms_for(inner, outer, fixed);
    std::array<std::vector<DifferenceTerm>, 3> terms{list, list, {}};
    const auto x = solve_differences(4, list).x;
    std::array<std::vector<int>, 3> both{x, x, {}};
    make_concentric(group, std::llround(kTermScale * cost), terms, both);
    CHECK(both[0][3] - both[0][2] == both[1][3] - both[1][2]);
    return both[0];
  };
  const auto width = [](const std::vector<int>& x, int ring) { return x[2 * ring + 1] - x[2 * ring]; };
  const auto concentric = [](const std::vector<int>& x) { return x[0] + x[1] == x[2] + x[3]; };
  const auto free = solved(7.2, 8.1, false, 0);
  CHECK(width(free, 0) == 7);
  CHECK(width(free, 1) == 8);
  const auto even = solved(7.2, 8.1, false, 10);
  CHECK(concentric(even));
  CHECK(width(even, 0) == 8);  // cheaper than 7 and 9, 7 and 7 or 6 and 8
  CHECK(width(even, 1) == 8);
  const auto odd = solved(6.8, 7.6, false, 10);
  CHECK(concentric(odd));
  CHECK(width(odd, 0) == 7);
  CHECK(width(odd, 1) == 7);
  CHECK_FALSE(concentric(solved(7.2, 8.1, true, 10)));  // what must not change does not
}

TEST_CASE("cylinders on one axis get squares that lie inside each other or in the same planes") {
  // Radii 8, 12 and 9; with h = 1.75 their strips are 7.2, 10.8 and 8.1 h wide.
  const auto radius = [](const Vec3& p) { return std::max(std::abs(p[0]), std::abs(p[1])); };
  for (const double x : {0.0, 0.5}) {  // the last cylinder on the axis, and beside it
    auto surface =
        voxel_surface(unite(unite(box({-8, -8, 0}, {8, 8, 10}), box({-12, -12, 10}, {12, 12, 18})), box({-9, -9, 18}, {9, 9, 28})), 1);
    SurfaceMesh& mesh = surface.mesh;
    std::vector<Vec3> centre(mesh.points.size(), Vec3::Zero());
    for (int i = 0; i < mesh.point_count(); ++i)
      if (mesh.points[i][2] > 18.5 || (mesh.points[i][2] > 17.5 && radius(mesh.points[i]) < 9.5)) centre[i][0] = x;
    for (int i = 0; i < mesh.point_count(); ++i) {
      Vec3& p = mesh.points[i];
      const double r = std::hypot(p[0], p[1]);
      if (r > 0) p.head<2>() *= radius(p) / r;
      p += centre[i];
    }
    for (int t = 0; t < mesh.triangle_count(); ++t)
      for (int k = 0; k < 3; ++k) {
        const int v = mesh.triangles[t][k];
        if (axis_of(surface.label[t]) != 2)
          mesh.corner_normals[3 * t + k] = Vec3(mesh.points[v][0] - centre[v][0], mesh.points[v][1], 0).normalized();
      }
    const auto shape = make_feature_shape(surface);
    const auto groups = find_concentric(mesh, shape, 1.75);
    REQUIRE(groups.size() == 1);
    CHECK(groups[0].axis == 2);
    REQUIRE(groups[0].rings.size() == (x == 0 ? 3 : 2));
    if (x != 0) continue;
    const Polycube polycube = solve(surface, 1.75);
    const auto& rings = groups[0].rings;
    for (std::size_t i = 1; i < rings.size(); ++i)
      for (int k = 0; k < 2; ++k)
        CHECK(polycube.coordinate[rings[i].low[k]] + polycube.coordinate[rings[i].high[k]] ==
              polycube.coordinate[rings[0].low[k]] + polycube.coordinate[rings[0].high[k]]);
  }
}

TEST_CASE("the same input gives the same polycube") {
  auto surface = voxel_surface(staircase(), 3);
  deform(surface.mesh, [](const Vec3& p) { return Vec3(1.37 * p.x() + 0.1 * p.z(), 0.77 * p.y(), 1.21 * p.z()); });
  CHECK(solve(surface, 0.31).coordinate == solve(surface, 0.31).coordinate);
}

TEST_CASE("arcs that run in a circle are an error that names CAD faces") {
  const auto surface = voxel_surface(ell());
  auto shape = make_feature_shape(surface);
  for (auto& arc : shape.arcs)
    if (arc.axis == 0) {
      arc.sign = -arc.sign;
      break;
    }
  Context context;
  try {
    quantize(surface.mesh, shape, QuantizeOptions(), {}, context);
    FAIL("no error");
  } catch (const PolycubeError& error) {
    CHECK(error.kind == Failure::NoMesh);
    CHECK(error.step == "polycube");
    CHECK(!error.charts.empty());
    CHECK(!error.cad_faces.empty());
  }
}

TEST_CASE("orders: opposite walls through solid and gaps, inner loops inside outer ones") {
  const auto surface = voxel_surface(plate_with_hole());
  const auto shape = make_feature_shape(surface);
  Context context;
  const auto orders = chart_orders(surface.mesh, shape, sample_axis_rays(surface.mesh, 500, context), 1, context);
  const auto chart = [&](Label l, double at) {
    for (int c = 0; c < shape.chart_count(); ++c)
      if (shape.charts[c].label == l && shape.charts[c].centroid[axis_of(l)] == doctest::Approx(at)) return c;
    return -1;
  };
  const auto gap = [&](int low, int high) {
    for (const auto& o : orders)
      if (o.low == low && o.high == high) return o.gap;
    return -1.0;
  };
  CHECK(gap(chart(1, 0), chart(0, 5)) == doctest::Approx(5));  // outer walls
  CHECK(gap(chart(1, 0), chart(0, 2)) == doctest::Approx(2));  // outer wall to the hole, through solid
  CHECK(gap(chart(0, 2), chart(1, 3)) == doctest::Approx(1));  // across the hole
  CHECK(gap(chart(5, 0), chart(4, 1)) == doctest::Approx(1));
  for (const auto& o : orders) CHECK(o.gap > 0);
}

TEST_CASE("a ring one element wide gets a line for the sharp CAD edge that runs round inside it") {
  // A plate with a square hole whose rim is a funnel: the crease goes round the hole, inside the top's chart.
  auto surface = voxel_surface(plate_with_hole());
  auto& mesh = surface.mesh;
  const auto distance = [](const Vec3& p) { return std::max(std::abs(p.x() - 2.5), std::abs(p.y() - 2.5)); };
  for (const bool sharp : {false, true}) {
    if (sharp) {
      deform(mesh, [&](const Vec3& p) { return Vec3(p - Vec3(0, 0, p.z() > 0.9 ? 0.9 * std::max(0.0, 1 - distance(p)) : 0)); });
      for (int h = 0; h < 3 * mesh.triangle_count(); ++h)
        if (std::abs(mesh.dihedral(h)) > 0.5 && std::abs(distance(mesh.points[mesh.from(h)]) - 1) < 1e-9 &&
            std::abs(distance(mesh.points[mesh.to(h)]) - 1) < 1e-9 && mesh.points[mesh.from(h)].z() > 0.9)
          mesh.halfedge_edge[h] = 1;
    }
    const auto shape = make_feature_shape(surface);
    const Polycube polycube = solve(surface, 2);
    const auto at = [&](Label l, double place) {
      for (int c = 0; c < shape.chart_count(); ++c)
        if (shape.charts[c].label == l && shape.charts[c].centroid[axis_of(l)] == doctest::Approx(place)) return polycube.coordinate[c];
      return -1;
    };
    for (const int axis : {0, 1}) {
      const Label up = make_label(axis, 1), down = make_label(axis, -1);
      CHECK(at(up, 2) - at(down, 0) == (sharp ? 2 : 1));
      CHECK(at(up, 5) - at(down, 3) == (sharp ? 2 : 1));
    }
  }
}
