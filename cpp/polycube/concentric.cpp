// HexFeatureWB - LGPL-2.1-or-later
#include "polycube/concentric.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <optional>

namespace hexfeature {
namespace {

constexpr double kSmoothArc = 20 * EIGEN_PI / 180;
constexpr double kOnLine = 0.05;  // element sizes: how near normals pass to a ring's line, and the lines of concentric rings to each other
constexpr int kWidthRounds = 20;  // of improving one ring's width after the other: an end, should ties go round in a circle

int find(std::vector<int>& parent, int i) {
  while (parent[i] != i) i = parent[i] = parent[parent[i]];
  return i;
}

struct PlacedRing {
  Ring ring;
  Vec2 centre;
};

/// The charts (one per label of the two axes a, b) as a ring, if their normals pass through one line along the third axis.
std::optional<PlacedRing> as_ring(const SurfaceMesh& mesh, const FeatureShape& shape, const std::array<int, 4>& charts, int a, int b,
                                  double size) {
  // Least squares over the mesh's corners: m . (p - centre) = 0, m across the normal.
  Eigen::Matrix2d lhs = Eigen::Matrix2d::Zero();
  Vec2 rhs = Vec2::Zero();
  double square = 0, area = 0;
  for (int c : charts)
    for (int t : shape.cells.parts[c].triangles)
      for (int k = 0; k < 3; ++k) {
        const Vec3 &p = mesh.points[mesh.triangles[t][k]], &n = mesh.corner_normals[3 * t + k];
        const double length = std::hypot(n[a], n[b]), w = mesh.area(t) / 3;
        if (!(length > 0)) continue;
        const Vec2 m(-n[b] / length, n[a] / length);
        const double d = m.dot(Vec2(p[a], p[b]));
        lhs += w * m * m.transpose();
        rhs += w * d * m;
        square += w * d * d;
        area += w;
      }
  if (!(lhs.determinant() > 1e-6 * area * area)) return std::nullopt;
  const Vec2 centre = lhs.inverse() * rhs;
  const double residual = std::max(0.0, square - rhs.dot(centre));
  if (residual > kOnLine * kOnLine * size * size * area) return std::nullopt;
  PlacedRing placed{{}, centre};
  for (int k = 0; k < 2; ++k) {
    const int axis = k == 0 ? a : b, up = charts[2 * k], down = charts[2 * k + 1];
    const bool swapped = shape.charts[up].centroid[axis] < shape.charts[down].centroid[axis];  // a hole
    placed.ring.low[k] = swapped ? up : down;
    placed.ring.high[k] = swapped ? down : up;
  }
  return placed;
}

std::int64_t term_cost(const DifferenceTerm& t, int from, int to) {
  const std::int64_t missing = std::max(0, t.gap - (to - from));
  if (t.weight != kHardTerm) return t.weight * missing;
  return missing > 0 ? std::numeric_limits<std::int64_t>::max() / 4096 : 0;
}

/// Rings as widths of one parity about a common centre, with the terms between them.
class Widths {
 public:
  Widths(const ConcentricUnknowns& group, const std::array<std::vector<DifferenceTerm>, 3>& terms) : group_(group) {
    // Rings that share an unknown have one width.
    const int rings = static_cast<int>(group.rings.size());
    variable_.resize(rings);
    std::iota(variable_.begin(), variable_.end(), 0);
    for (int k = 0; k < 2; ++k) {
      std::map<int, int> first;
      for (int i = 0; i < rings; ++i)
        for (int u : group.rings[i][k]) {
          const int j = first.try_emplace(u, i).first->second;
          const int p = find(variable_, i), q = find(variable_, j);
          variable_[std::max(p, q)] = std::min(p, q);
        }
    }
    for (int i = 0; i < rings; ++i) variable_[i] = find(variable_, i);
    for (int k = 0; k < 2; ++k) {
      std::map<int, int> end;  // unknown -> 2 * ring + high
      for (int i = 0; i < rings; ++i)
        for (int e = 0; e < 2; ++e) end.emplace(group.rings[i][k][e], 2 * i + e);
      for (const auto& t : terms[group.axes[k]]) {
        const auto from = end.find(t.from), to = end.find(t.to);
        if (from != end.end() && to != end.end()) terms_.push_back({from->second, to->second, t.gap, t.weight});
      }
    }
  }

  /// The cheapest widths of a parity, one ring after the other, from `start` on.
  std::vector<int> best(int parity, const std::vector<int>& start) const {
    std::vector<int> width = start;
    for (int& w : width) w += (w - parity) & 1;
    for (int& w : width)
      while (w < 1) w += 2;
    for (std::size_t i = 0; i < width.size(); ++i) width[i] = width[variable_[i]];
    std::int64_t least = cost(width);
    for (int round = 0; round < kWidthRounds; ++round) {
      bool better = false;
      for (std::size_t i = 0; i < width.size(); ++i) {
        if (variable_[i] != static_cast<int>(i)) continue;
        for (const int step : {2, -2}) {
          std::vector<int> other = width;
          for (std::size_t j = i; j < other.size(); ++j)
            if (variable_[j] == static_cast<int>(i)) other[j] += step;
          if (other[i] < 1) continue;
          const std::int64_t c = cost(other);
          if (c >= least) continue;
          least = c;
          width = std::move(other);
          better = true;
        }
      }
      if (!better) break;
    }
    return width;
  }

 private:
  std::int64_t cost(const std::vector<int>& width) const {
    const auto at = [&](int end) { return end % 2 == 0 ? -(width[end / 2] / 2) : (width[end / 2] + 1) / 2; };
    std::int64_t sum = 0;
    for (const auto& t : terms_) sum += term_cost(t, at(t.from), at(t.to));
    return sum;
  }

  const ConcentricUnknowns& group_;
  std::vector<int> variable_;  // per ring: the first ring of its width
  std::vector<DifferenceTerm> terms_;
};

/// Sides of pairs of rings that lie otherwise than the pair's other sides: in the same plane, inside or outside.
int uneven_sides(const ConcentricUnknowns& group, const std::array<std::vector<int>, 3>& x) {
  int uneven = 0;
  for (std::size_t i = 0; i < group.rings.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      std::array<int, 3> count{0, 0, 0};  // inside, same, outside
      for (int k = 0; k < 2; ++k)
        for (int e = 0; e < 2; ++e) {
          const auto& u = x[group.axes[k]];
          const int further = (u[group.rings[i][k][e]] - u[group.rings[j][k][e]]) * (e == 0 ? -1 : 1);
          ++count[further < 0 ? 0 : further == 0 ? 1 : 2];
        }
      uneven += 4 - *std::max_element(count.begin(), count.end());
    }
  return uneven;
}

}  // namespace

std::vector<Concentric> find_concentric(const SurfaceMesh& mesh, const FeatureShape& shape, double size) {
  std::vector<Concentric> found;
  for (int axis = 0; axis < 3; ++axis) {
    const int a = (axis + 1) % 3, b = (axis + 2) % 3;
    std::vector<int> parent(shape.chart_count());
    std::iota(parent.begin(), parent.end(), 0);
    for (int i = 0; i < shape.arc_count(); ++i) {
      if (shape.arcs[i].axis != axis || std::abs(shape.arcs[i].dihedral) > kSmoothArc) continue;
      const int p = find(parent, shape.cells.edges[i].left), q = find(parent, shape.cells.edges[i].right);
      parent[std::max(p, q)] = std::min(p, q);
    }
    std::map<int, std::array<int, 4>> largest;  // first chart -> of the labels +a, -a, +b, -b
    for (int c = 0; c < shape.chart_count(); ++c) {
      const Label l = shape.charts[c].label;
      if (axis_of(l) == axis) continue;
      int& best = largest.try_emplace(find(parent, c), std::array<int, 4>{-1, -1, -1, -1}).first->second[2 * (axis_of(l) == b) + l % 2];
      if (best < 0 || shape.charts[c].area > shape.charts[best].area) best = c;
    }
    std::vector<PlacedRing> rings;
    for (const auto& [first, charts] : largest) {
      if (*std::min_element(charts.begin(), charts.end()) < 0) continue;
      if (const auto ring = as_ring(mesh, shape, charts, a, b, size)) rings.push_back(*ring);
    }
    std::vector<char> taken(rings.size(), 0);
    for (std::size_t i = 0; i < rings.size(); ++i) {
      if (taken[i]) continue;
      Concentric group{axis, {}};
      for (std::size_t j = i; j < rings.size(); ++j) {
        if (taken[j] || (rings[j].centre - rings[i].centre).norm() > kOnLine * size) continue;
        taken[j] = 1;
        group.rings.push_back(rings[j].ring);
      }
      if (group.rings.size() > 1) found.push_back(std::move(group));
    }
  }
  return found;
}

void make_concentric(const ConcentricUnknowns& group, std::int64_t cost, std::array<std::vector<DifferenceTerm>, 3>& terms,
                     std::array<std::vector<int>, 3>& x) {
  const auto total = [&](const std::array<std::vector<int>, 3>& y) {
    return difference_cost(terms[group.axes[0]], y[group.axes[0]]) + difference_cost(terms[group.axes[1]], y[group.axes[1]]) +
           cost * uneven_sides(group, y);
  };
  if (uneven_sides(group, x) == 0) return;
  const Widths widths(group, terms);
  std::vector<int> start;
  for (const auto& ring : group.rings) start.push_back(x[group.axes[0]][ring[0][1]] - x[group.axes[0]][ring[0][0]]);
  std::int64_t least = total(x);
  std::array<std::vector<DifferenceTerm>, 3> best_terms = terms;
  for (const int parity : {0, 1}) {
    const std::vector<int> width = widths.best(parity, start);
    auto held = terms;
    auto y = x;
    for (int k = 0; k < 2; ++k) {
      auto& list = held[group.axes[k]];
      const auto hold = [&](int from, int to, int gap, std::int64_t weight) {
        list.push_back({from, to, gap, weight});
        list.push_back({to, from, -gap, weight});
      };
      const auto& first = group.rings.front()[k];
      for (std::size_t i = 0; i < group.rings.size(); ++i) {
        const auto& ring = group.rings[i][k];
        hold(ring[0], ring[1], width[i], cost);
        if (i == 0) continue;
        hold(first[0], ring[0], (width[0] - width[i]) / 2, cost);
        hold(first[1], ring[1], (width[i] - width[0]) / 2, cost);
      }
      auto solution = solve_differences(static_cast<int>(x[group.axes[k]].size()), list);
      y[group.axes[k]] = std::move(solution.x);
    }
    const std::int64_t c = total(y);
    if (c >= least) continue;
    least = c;
    best_terms = std::move(held);
    x = std::move(y);
  }
  terms = std::move(best_terms);
}

}  // namespace hexfeature
