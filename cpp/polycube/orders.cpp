// HexFeatureWB - LGPL-2.1-or-later
#include "polycube/orders.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <tuple>

#include "mesh/triangle_tree.h"

namespace hexfeature {
namespace {

/// SplitMix64 (G. Steele, D. Lea, C. Flood, Fast Splittable Pseudorandom Number Generators, OOPSLA 2014): the standard
/// library's distributions differ between implementations, this does not.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  double unit() {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15ull);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
    return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1.0p-53;
  }

 private:
  std::uint64_t state_;
};

Vec3 random_point(const SurfaceMesh& mesh, int t, Random& random) {
  double u = random.unit(), v = random.unit();
  if (u + v > 1) {
    u = 1 - u;
    v = 1 - v;
  }
  const auto& c = mesh.triangles[t];
  return mesh.points[c[0]] + u * (mesh.points[c[1]] - mesh.points[c[0]]) + v * (mesh.points[c[2]] - mesh.points[c[0]]);
}

/// Call visit(triangle) `count` times, systematically by weight: one stratum each.
template <class Weight, class Visit>
void systematic(const std::vector<int>& triangles, int count, const Weight& weight, const Visit& visit) {
  double total = 0;
  for (int t : triangles) total += weight(t);
  if (!(total > 0)) return;
  double sum = 0, next = 0.5 * total / count;
  for (int t : triangles)
    for (sum += weight(t); next < sum; next += total / count) visit(t);
}

/// What a straight walk over the chart of a start point meets at its two ends.
struct Walk {
  int low = -1, high = -1;  // charts across the border, towards - and + of the axis
  double length = 0;
  int pieces = 1;  // between sharp CAD edges crossed on the way
};

/// From p in triangle t, along the curve in which the plane x[across] = p[across] cuts the surface, both ways until the chart
/// ends. Purely combinatorial (a point in the plane counts as above it), so it never gets lost.
Walk walk_chart(const SurfaceMesh& mesh, const std::vector<int>& chart_of, int t, const Vec3& p, int axis, int across) {
  Walk walk;
  const double level = p[across];
  const auto above = [&](int v) { return mesh.points[v][across] >= level; };
  const auto crossing = [&](int h) {
    const Vec3 &a = mesh.points[mesh.from(h)], &b = mesh.points[mesh.to(h)];
    const double d = b[across] - a[across];
    return Vec3(d != 0 ? Vec3(a + (level - a[across]) / d * (b - a)) : a);
  };
  int ends[2], found = 0;
  for (int k = 0; k < 3; ++k) {
    const int h = 3 * t + k;
    if (above(mesh.from(h)) != above(mesh.to(h)) && found < 2) ends[found++] = h;
  }
  if (found < 2) return walk;
  if (crossing(ends[0])[axis] > crossing(ends[1])[axis]) std::swap(ends[0], ends[1]);
  for (int side = 0; side < 2; ++side) {
    int h = ends[side];
    Vec3 at = p;
    for (int steps = mesh.triangle_count();; --steps) {
      const Vec3 q = crossing(h);
      walk.length += (q - at).norm();
      at = q;
      const int o = mesh.opposite[h], chart = chart_of[o / 3];
      if (chart != chart_of[t]) {
        (side == 0 ? walk.low : walk.high) = chart;
        break;
      }
      if (steps == 0) return {};  // a closed curve without border
      if (on_sharp_edge(mesh, h)) ++walk.pieces;
      const int n = SurfaceMesh::next(o);
      h = above(mesh.from(n)) != above(mesh.to(n)) ? n : SurfaceMesh::prev(o);
    }
  }
  return walk;
}

}  // namespace

bool on_sharp_edge(const SurfaceMesh& mesh, int halfedge) {
  constexpr double kSharp = 20 * EIGEN_PI / 180;
  return mesh.halfedge_edge[halfedge] > 0 && std::abs(mesh.dihedral(halfedge)) > kSharp;
}

AxisRays sample_axis_rays(const SurfaceMesh& mesh, int count, Context& context) {
  AxisRays rays;
  const int triangles = mesh.triangle_count();
  if (triangles == 0 || count <= 0) return rays;
  std::vector<int> all(triangles);
  double total = 0;
  for (int t = 0; t < triangles; ++t) {
    all[t] = t;
    total += mesh.area(t);
  }
  context.check();
  const TriangleTree tree(mesh, context);
  Random random(1);
  std::vector<RayHit> hits;
  int done = 0;
  const auto weight = [&](int t) { return mesh.area(t) / total + 1.0 / triangles; };  // all together 2
  const auto cosine = [&](int t, int axis) { return std::abs(mesh.area_normal(t).normalized()[axis]); };
  systematic(all, count, weight, [&](int t) {
    if (++done % 256 == 0) context.check();
    const Vec3 p = random_point(mesh, t, random);
    const double area = 2 * mesh.area(t) / (count * weight(t));  // of the surface that this sample stands for
    for (int axis = 0; axis < 3; ++axis) {
      if (cosine(t, axis) < 0.5) continue;
      tree.ray_hits(p, Vec3::Unit(axis), hits, -std::numeric_limits<double>::infinity());
      for (std::size_t i = 0; i + 1 < hits.size(); ++i) {
        const RayHit &low = hits[i], &high = hits[i + 1];
        if (low.entering == high.entering) continue;
        AxisRays::Crossing c{low.triangle, high.triangle, axis, 0, 0, low.entering};
        c.gap = (high.t - low.t) * 0.5 * (cosine(low.triangle, axis) + cosine(high.triangle, axis));
        // Only the solid behind the sample itself stands for its area, and that column is sampled from its other end too.
        if (c.solid && (c.low == t || c.high == t)) c.area = 0.5 * area * cosine(t, axis);
        rays.crossings.push_back(c);
      }
    }
  });
  return rays;
}

const AxisRays& AxisRayCache::rays(const SurfaceMesh& mesh, int count, Context& context) {
  if (count != count_ || mesh.triangles != triangles_ || mesh.points != points_) {
    count_ = 0;  // should sampling throw
    rays_ = sample_axis_rays(mesh, count, context);
    points_ = mesh.points;
    triangles_ = mesh.triangles;
    count_ = count;
  }
  return rays_;
}

std::vector<ChartOrder> chart_orders(const SurfaceMesh& mesh, const FeatureShape& shape, const AxisRays& rays, double size,
                                     Context& context) {
  const auto& chart_of = shape.cells.triangle_part;
  const auto label = [&](int chart) { return shape.charts[chart].label; };
  std::vector<ChartOrder> orders;
  for (const auto& c : rays.crossings) {
    const int low = chart_of[c.low], high = chart_of[c.high];
    // Through solid a line goes in at a chart that looks down the axis and out at one that looks up; through air the reverse.
    if (label(low) == make_label(c.axis, c.solid ? -1 : 1) && label(high) == make_label(c.axis, c.solid ? 1 : -1))
      orders.push_back({low, high, c.gap, 1, 1, c.area / (size * size)});
  }
  Random random(2);
  for (int chart = 0; chart < shape.chart_count(); ++chart) {
    context.check();
    const int own = axis_of(label(chart));
    const double area = shape.charts[chart].area;
    const int count = static_cast<int>(std::min(40.0, 8 + area / (size * size)));
    systematic(
        shape.cells.parts[chart].triangles, count, [&](int t) { return mesh.area(t); },
        [&](int t) {
          const Vec3 p = random_point(mesh, t, random);
          for (int axis = 0; axis < 3; ++axis) {
            if (axis == own) continue;
            const Walk walk = walk_chart(mesh, chart_of, t, p, axis, third_axis(axis, own));
            if (walk.low < 0 || walk.high < 0 || walk.low == walk.high) continue;
            if (axis_of(label(walk.low)) == axis && axis_of(label(walk.high)) == axis)
              orders.push_back({walk.low, walk.high, walk.length, 1, walk.pieces, area / count / std::max(walk.length, size) / size});
          }
        });
  }
  std::sort(orders.begin(), orders.end(), [](const ChartOrder& a, const ChartOrder& b) {
    return std::tie(a.low, a.high, a.gap, a.lines) < std::tie(b.low, b.high, b.gap, b.lines);
  });
  // One order a pair of charts.
  std::size_t kept = 0;
  for (std::size_t i = 0; i < orders.size();) {
    std::size_t j = i, median = i;
    ChartOrder order{orders[i].low, orders[i].high, 0, 0, 1, 0};
    for (; j < orders.size() && orders[j].low == order.low && orders[j].high == order.high; ++j) {
      order.lines += orders[j].lines;
      order.pieces = std::max(order.pieces, orders[j].pieces);
    }
    order.count = static_cast<int>(j - i);
    // Air weighs nothing by itself, but a little when there is nothing else.
    const double least = 1e-6, half = 0.5 * (order.lines + least * order.count);
    for (double sum = orders[i].lines + least; sum < half && median + 1 < j; sum += orders[median].lines + least) ++median;
    order.gap = orders[median].gap;
    orders[kept++] = order;
    i = j;
  }
  orders.resize(kept);
  return orders;
}

std::vector<ChartOrder> position_orders(const FeatureShape& shape, double tolerance) {
  std::vector<ChartOrder> orders;
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<int> charts;
    for (int c = 0; c < shape.chart_count(); ++c)
      if (axis_of(shape.charts[c].label) == axis) charts.push_back(c);
    const auto position = [&](int c) { return shape.charts[c].centroid[axis]; };
    std::stable_sort(charts.begin(), charts.end(), [&](int a, int b) { return position(a) < position(b); });
    for (std::size_t i = 0, j = 0; i < charts.size(); ++i) {
      while (j < charts.size() && position(charts[j]) - position(charts[i]) < tolerance) ++j;
      if (j < charts.size()) orders.push_back({charts[i], charts[j], position(charts[j]) - position(charts[i]), 1, 1, 0});
    }
  }
  return orders;
}

}  // namespace hexfeature
