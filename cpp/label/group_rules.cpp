// HexFeatureWB - LGPL-2.1-or-later
#include "label/group_rules.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "shape/partition.h"

namespace hexfeature {
namespace {

/// Surface-mesh groups and their common borders.
struct Groups {
  struct Border {
    int a, b;  ///< groups, a != b; both orders are listed
    double length;
    Vec3 along;  ///< sum of |component| of the border's mesh lines per axis
  };
  std::vector<int> of;  ///< per triangle
  std::vector<double> area;
  std::vector<Label> label;
  std::vector<Border> borders;  ///< sorted by (a, b)
  std::vector<int> first;       ///< per group: its first border; one more at the end

  int count() const { return static_cast<int>(area.size()); }
};

Groups make_groups(const SurfaceMesh& mesh, const std::vector<Label>& label) {
  Groups g;
  g.of = connected_components(mesh, std::vector<int>(label.begin(), label.end()));
  const int count = g.of.empty() ? 0 : 1 + *std::max_element(g.of.begin(), g.of.end());
  g.area.assign(count, 0);
  g.label.assign(count, kNoLabel);
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    g.area[g.of[t]] += mesh.area(t);
    g.label[g.of[t]] = label[t];
  }
  std::vector<Groups::Border> pieces;
  for (int h = 0; h < 3 * mesh.triangle_count(); ++h) {
    const int a = g.of[h / 3], b = g.of[mesh.opposite[h] / 3];
    if (a == b) continue;
    const Vec3 line = mesh.points[mesh.to(h)] - mesh.points[mesh.from(h)];
    pieces.push_back({a, b, line.norm(), line.cwiseAbs()});
  }
  std::stable_sort(pieces.begin(), pieces.end(), [](const auto& x, const auto& y) { return x.a != y.a ? x.a < y.a : x.b < y.b; });
  for (const auto& p : pieces) {
    if (g.borders.empty() || g.borders.back().a != p.a || g.borders.back().b != p.b) {
      g.borders.push_back(p);
      continue;
    }
    g.borders.back().length += p.length;
    g.borders.back().along += p.along;
  }
  g.first.assign(count + 1, 0);
  for (const auto& b : g.borders) ++g.first[b.a + 1];
  std::partial_sum(g.first.begin(), g.first.end(), g.first.begin());
  return g;
}

/// Rule 1 (for `least_neighbours` = 4) and tiny groups, small groups first; a group that took part is left alone until the next round.
int join_groups(const Groups& g, int least_neighbours, double size, std::vector<Label>& label) {
  std::vector<int> order(g.count());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int x, int y) { return g.area[x] < g.area[y]; });
  std::vector<char> busy(g.count(), 0);
  std::vector<Label> now = g.label;
  int joined = 0;
  for (int a : order) {
    const int neighbours = g.first[a + 1] - g.first[a];
    if (busy[a] || neighbours == 0 || (neighbours >= least_neighbours && g.area[a] > 0.02 * size * size)) continue;
    const auto longest = std::max_element(g.borders.begin() + g.first[a], g.borders.begin() + g.first[a + 1],
                                          [](const auto& x, const auto& y) { return x.length < y.length; });
    if (busy[longest->b]) continue;
    for (int i = g.first[a]; i < g.first[a + 1]; ++i) busy[g.borders[i].b] = 1;
    busy[a] = 1;
    now[a] = g.label[longest->b];
    ++joined;
  }
  if (joined > 0)
    for (std::size_t t = 0; t < label.size(); ++t) label[t] = now[g.of[t]];
  return joined;
}

/// A strip of whole triangles of group `a` along its border with `b`: those that touch the border, and those whose centre
/// is nearer to it than `width`.
std::vector<int> strip_along(const SurfaceMesh& mesh, const Groups& g, const std::vector<std::vector<int>>& triangles, int a, int b,
                             double width) {
  std::vector<Vec3> middles;
  std::vector<int> touched;
  for (int t : triangles[a])
    for (int h = 3 * t; h < 3 * t + 3; ++h)
      if (g.of[mesh.opposite[h] / 3] == b) {
        middles.push_back(0.5 * (mesh.points[mesh.from(h)] + mesh.points[mesh.to(h)]));
        touched.push_back(mesh.from(h));
        touched.push_back(mesh.to(h));
      }
  std::sort(touched.begin(), touched.end());
  std::vector<int> strip;
  for (int t : triangles[a]) {
    bool in = false;
    for (int v : mesh.triangles[t]) in |= std::binary_search(touched.begin(), touched.end(), v);
    const Vec3 c = mesh.centroid(t);
    for (std::size_t i = 0; !in && i < middles.size(); ++i) in = (middles[i] - c).squaredNorm() < width * width;
    if (in) strip.push_back(t);
  }
  return strip;
}

/// Rule 2.
int divide_groups(const SurfaceMesh& mesh, const Groups& g, double size, std::vector<char>& divided, std::vector<Label>& label) {
  std::vector<std::vector<int>> triangles(g.count());
  for (int t = 0; t < mesh.triangle_count(); ++t) triangles[g.of[t]].push_back(t);
  std::vector<char> busy(g.count(), 0);
  int count = 0;
  for (const auto& border : g.borders) {
    if (border.a > border.b || g.label[border.a] != opposite(g.label[border.b]) || busy[border.a] || busy[border.b]) continue;
    // The border's own axis is the one of the other two that it runs along the further.
    const int axis = axis_of(g.label[border.a]), p = (axis + 1) % 3, q = (axis + 2) % 3;
    const int strip_axis = border.along[p] < border.along[q] ? p : q;
    const std::vector<int> strips[2] = {strip_along(mesh, g, triangles, border.a, border.b, 0.8 * size),
                                        strip_along(mesh, g, triangles, border.b, border.a, 0.8 * size)};
    Vec3 normal[2] = {Vec3::Zero(), Vec3::Zero()};
    double area[2] = {0, 0};
    for (int i = 0; i < 2; ++i)
      for (int t : strips[i]) {
        normal[i] += 0.5 * mesh.area_normal(t);
        area[i] += mesh.area(t);
      }
    // Divide the group whose strip faces the new direction more; both look at one edge, so their sum gives a doubtful sign.
    const double lean[2] = {normal[0][strip_axis] / area[0], normal[1][strip_axis] / area[1]};
    const int side = std::abs(lean[0]) >= std::abs(lean[1]) ? 0 : 1;
    const double sign = std::abs(lean[side]) > 0.02 ? lean[side] : normal[0][strip_axis] + normal[1][strip_axis];
    const Label strip_label = make_label(strip_axis, sign < 0 ? -1 : 1);
    int changed = 0;
    for (int t : strips[side]) {
      if (divided[t]) continue;
      divided[t] = 1;
      label[t] = strip_label;
      ++changed;
    }
    if (changed == 0) continue;
    ++count;
    busy[border.a] = busy[border.b] = 1;
  }
  return count;
}

/// Even borders: flip triangles that stick out of their group, where the adaptation does not mind.
int even_borders(const SurfaceMesh& mesh, const std::vector<Vec3>& adaptation, std::vector<Label>& label) {
  constexpr double kIndifference = 0.25;
  int flips = 0;
  for (int round = 0; round < 4; ++round) {
    int now = 0;
    for (int t = 0; t < mesh.triangle_count(); ++t) {
      Label around[3];
      for (int k = 0; k < 3; ++k) around[k] = label[mesh.opposite[3 * t + k] / 3];
      const Label other = around[0] == around[1] || around[0] == around[2] ? around[0] : around[1] == around[2] ? around[1] : label[t];
      if (other == label[t] || adaptation[t].dot(direction(label[t])) - adaptation[t].dot(direction(other)) > kIndifference) continue;
      label[t] = other;
      ++now;
    }
    flips += now;
    if (now == 0) break;
  }
  return flips;
}

}  // namespace

GroupCorrections correct_groups(const SurfaceMesh& mesh, const std::vector<Vec3>& adaptation, double size, std::vector<Label>& label,
                                const Context& context) {
  GroupCorrections done;
  done.evened = even_borders(mesh, adaptation, label);
  std::vector<char> divided(mesh.triangle_count(), 0);
  // Islands (one or two neighbours) are noise and go first. Rule 2 comes before the rest of rule 1: the triangular end of a
  // wedge has three neighbours only until the wedge's two sides are parted.
  for (;;) {
    context.check();
    const Groups groups = make_groups(mesh, label);
    if (const int islands = join_groups(groups, 3, size, label)) {
      done.joined += islands;
    } else if (const int strips = divide_groups(mesh, groups, size, divided, label)) {
      done.divided += strips;
    } else if (const int joined = join_groups(groups, 4, size, label)) {
      done.joined += joined;
    } else {
      return done;
    }
  }
}

}  // namespace hexfeature
