// HexFeatureWB - LGPL-2.1-or-later
#include "polycube/polycube.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>

namespace hexfeature {
namespace {

// Costs are relative to one interval too many or too few on an arc.
constexpr double kShortCost = 0.7;            // one interval too many; one too few costs 1 and more
constexpr double kGapCost = 0.2;              // a distance that samples saw off by one interval, per order ...
constexpr double kLineCost = 0.2;             // ... and per line of elements that runs there, at most ...
constexpr double kLineCostMost = 8;           // ... this much: large plates must not outweigh orders
constexpr double kOrderCost = 20;             // an order violated by one interval, one sample ...
constexpr double kOrderCostMany = 70;         // ... or many
constexpr double kSeparationCost = 1000;      // above anything else: the fill has shown that it is needed
constexpr double kIntervalWishCost = 20;      // an arc without the intervals its bends ask for
constexpr double kShortestPiece = 0.4;        // of an arc, in h, that a mesh edge of its own is wished for
constexpr double kShortestPieceAcross = 0.1;  // ... where faces end on both sides of it
constexpr double kPiecesCost = 20;            // a sharp CAD edge inside a chart without a line of its own
constexpr double kPositionCost = 0.02, kPositionCostLarge = 0.05;
constexpr double kUnevenCost = 10;      // a side of a round chart ring that lies otherwise to a concentric one than its other sides
constexpr double kTieBreak = 0.01;      // a target of n + 1/2 goes up everywhere
constexpr double kLargestTarget = 1e6;  // intervals; beyond, no lattice can be built anyway
constexpr int kNoMinimum = std::numeric_limits<int>::min() / 4;

/// The unknowns: classes of charts of one axis that meet at corners.
struct Classes {
  std::vector<int> of_chart;                  // per chart: unknown of its axis
  std::vector<std::array<int, 3>> of_corner;  // per corner and axis
  std::array<int, 3> count{0, 0, 0};
};

Classes merge_charts(const FeatureShape& shape) {
  const auto& cells = shape.cells;
  std::vector<int> parent(shape.chart_count());
  std::iota(parent.begin(), parent.end(), 0);
  const auto find = [&](int c) {
    while (parent[c] != c) c = parent[c] = parent[parent[c]];
    return c;
  };
  std::vector<std::array<int, 3>> chart_at(shape.corner_count(), {-1, -1, -1});
  for (int n = 0; n < shape.corner_count(); ++n) {
    for (int dart : cells.nodes[n].darts) {
      const int chart = cells.left_of(dart), axis = axis_of(shape.charts[chart].label);
      int& first = chart_at[n][axis];
      if (first < 0) first = chart;
      const int a = find(first), b = find(chart);
      parent[std::max(a, b)] = std::min(a, b);
    }
    if (*std::min_element(chart_at[n].begin(), chart_at[n].end()) < 0) {
      std::vector<int> charts;
      for (int dart : cells.nodes[n].darts) charts.push_back(cells.left_of(dart));
      throw PolycubeError("the charts at a corner leave one of its coordinates open", shape, std::move(charts));
    }
  }
  Classes classes;
  classes.of_chart.assign(shape.chart_count(), -1);
  for (int c = 0; c < shape.chart_count(); ++c) {
    const int root = find(c);  // never larger than c
    classes.of_chart[c] = root == c ? classes.count[axis_of(shape.charts[c].label)]++ : classes.of_chart[root];
  }
  for (const auto& charts : chart_at)
    classes.of_corner.push_back({classes.of_chart[charts[0]], classes.of_chart[charts[1]], classes.of_chart[charts[2]]});
  return classes;
}

/// Sharp CAD edges at every mesh point, by mesh edges.
std::vector<int> sharp_degrees(const SurfaceMesh& mesh) {
  std::vector<int> degree(mesh.point_count(), 0);
  for (int h = 0; h < 3 * mesh.triangle_count(); ++h) {
    if (h > mesh.opposite[h] || !on_sharp_edge(mesh, h)) continue;
    ++degree[mesh.from(h)];
    ++degree[mesh.to(h)];
  }
  return degree;
}

/// Least number of intervals that an arc's shape asks for: chords close to its curve, and nodes where it kinks at a CAD vertex
/// or where a sharp CAD edge joins or leaves it; and where one of its faces ends, since an edge of the mesh lies on one pair of faces
/// only, unless a piece would be too short: where faces end on both sides, a line that parts both charts needs a node to cross there.
int wished_intervals(const SurfaceMesh& mesh, const Partition::Edge& edge, const std::vector<int>& sharp_degree, double size,
                     double largest_sag) {
  const auto& vertices = edge.vertices;
  const Vec3 &a = mesh.points[vertices.front()], &b = mesh.points[vertices.back()];
  const Vec3 chord = b - a;
  double sag = 0, length = 0, left = 0;  // of the arc, and of its last piece so far
  for (std::size_t i = 0; i + 1 < vertices.size(); ++i) length += (mesh.points[vertices[i + 1]] - mesh.points[vertices[i]]).norm();
  int stops = 0;
  for (std::size_t i = 1; i + 1 < vertices.size(); ++i) {
    const Vec3& p = mesh.points[vertices[i]];
    const double s = chord.squaredNorm() > 0 ? std::clamp((p - a).dot(chord) / chord.squaredNorm(), 0.0, 1.0) : 0.0;
    sag = std::max(sag, (p - a - s * chord).norm());
    const Vec3 before = p - mesh.points[vertices[i - 1]], after = mesh.points[vertices[i + 1]] - p;
    const bool kink = mesh.place[vertices[i]].dim == 0 && before.dot(after) < std::cos(EIGEN_PI / 6) * before.norm() * after.norm();
    const int own = on_sharp_edge(mesh, edge.halfedges[i - 1]) + on_sharp_edge(mesh, edge.halfedges[i]);
    left += before.norm();
    length -= before.norm();
    const int h = edge.halfedges[i - 1], g = edge.halfedges[i];
    const int next_faces = (mesh.triangle_face[h / 3] != mesh.triangle_face[g / 3]) +
                           (mesh.triangle_face[mesh.opposite[h] / 3] != mesh.triangle_face[mesh.opposite[g] / 3]);
    const double shortest = (next_faces == 2 ? kShortestPieceAcross : kShortestPiece) * size;
    const bool ends = own == 2 && next_faces > 0 && left >= shortest && length >= shortest;
    if (!kink && own != 1 && sharp_degree[vertices[i]] <= own && !ends) continue;
    ++stops;
    left = 0;
  }
  // n chords have 1/n^2 of the sag of one.
  return std::max(stops + 1, static_cast<int>(std::ceil(std::sqrt(sag / largest_sag) - 0.05)));
}

/// The unknowns of an arc's lower and upper end along its axis.
std::pair<int, int> arc_ends(const FeatureShape& shape, const std::vector<std::array<int, 3>>& of_corner, int i) {
  const auto& arc = shape.arcs[i];
  const auto& edge = shape.cells.edges[i];
  if (arc.axis < 0 || arc.sign == 0 || edge.start < 0)
    throw PolycubeError("a feature line has no direction", shape, {edge.left, edge.right});
  const int start = of_corner[edge.start][arc.axis], end = of_corner[edge.end][arc.axis];
  return arc.sign > 0 ? std::make_pair(start, end) : std::make_pair(end, start);
}

/// How bad d intervals are on a length of t element sizes. Too long elements cost the logarithm of their size, length times
/// (t ln(t/d), convex); too short ones cost less, and more the farther from t, so that what rounding leaves spreads evenly.
/// The two balance where sizes do: from sqrt(2) on, t = 1.42 takes two intervals.
double interval_cost(double t, int d, double curvature) {
  if (d < t) return t * std::log(t / d);
  return kShortCost * ((d - t) + curvature * (d - t) * (d - t) / std::max(1.0, t));
}

/// A length in element sizes.
double target(double length, double size) { return std::clamp(length / size, -kLargestTarget, kLargestTarget) + kTieBreak; }

}  // namespace

PolycubeError::PolycubeError(std::string reason_, const FeatureShape& shape, std::vector<int> charts_)
    : MeshingError(Failure::NoMesh, "polycube", std::move(reason_), "try a smaller element size, or split the part"),
      charts(std::move(charts_)) {
  std::sort(charts.begin(), charts.end());
  charts.erase(std::unique(charts.begin(), charts.end()), charts.end());
  for (int c : charts) cad_faces.insert(cad_faces.end(), shape.charts[c].cad_faces.begin(), shape.charts[c].cad_faces.end());
  std::sort(cad_faces.begin(), cad_faces.end());
  cad_faces.erase(std::unique(cad_faces.begin(), cad_faces.end()), cad_faces.end());
}

ForcedOrders::ForcedOrders(const FeatureShape& shape) {
  const Classes classes = merge_charts(shape);
  std::array<int, 3> base{0, classes.count[0], classes.count[0] + classes.count[1]};
  count_ = base[2] + classes.count[2];
  for (int c = 0; c < shape.chart_count(); ++c) of_chart_.push_back(base[axis_of(shape.charts[c].label)] + classes.of_chart[c]);
  std::vector<std::vector<int>> above(count_);
  for (int i = 0; i < shape.arc_count(); ++i) {
    const auto [from, to] = arc_ends(shape, classes.of_corner, i);
    above[base[shape.arcs[i].axis] + from].push_back(base[shape.arcs[i].axis] + to);
  }
  reach_.assign(static_cast<std::size_t>(count_) * count_, false);
  std::vector<int> stack;
  for (int source = 0; source < count_; ++source) {
    stack.push_back(source);
    while (!stack.empty()) {
      const int node = stack.back();
      stack.pop_back();
      for (int next : above[node]) {
        auto seen = reach_[static_cast<std::size_t>(source) * count_ + next];
        if (seen) continue;
        seen = true;
        stack.push_back(next);
      }
    }
  }
}

int ray_count(const SurfaceMesh& mesh, const QuantizeOptions& options) {
  return std::min(options.rays, std::max(800, mesh.triangle_count() / 8));
}

Polycube quantize(const SurfaceMesh& mesh, const FeatureShape& shape, const QuantizeOptions& options,
                  const std::vector<Separation>& separations, Context& context) {
  const AxisRays rays = sample_axis_rays(mesh, ray_count(mesh, options), context);
  return Quantizer(mesh, shape, chart_orders(mesh, shape, rays, options.size, context), options).solve(separations, context);
}

Quantizer::Quantizer(const SurfaceMesh& mesh, const FeatureShape& shape, const std::vector<ChartOrder>& orders,
                     const QuantizeOptions& options)
    : shape_(shape), options_(options) {
  if (!(options.size > 0) || !std::isfinite(options.size))
    throw MeshingError(Failure::Usage, "polycube", "the element size must be a positive number");
  Classes classes = merge_charts(shape);
  unknown_ = std::move(classes.of_chart);
  corner_unknowns_ = std::move(classes.of_corner);
  count_ = classes.count;
  add_arcs(mesh);
  add_orders(orders);
  add_positions();
  add_concentric(mesh);
}

void Quantizer::add_arcs(const SurfaceMesh& mesh) {
  const auto sharp_degree = sharp_degrees(mesh);
  const int minimum = options_.minimum_intervals;
  for (int i = 0; i < shape_.arc_count(); ++i) {
    const auto& arc = shape_.arcs[i];
    const auto [from, to] = arc_ends(shape_, corner_unknowns_, i);
    auto& list = terms_[arc.axis];
    term_arc_[arc.axis].resize(list.size(), -1);
    term_arc_[arc.axis].push_back(i);
    list.push_back({from, to, minimum, kHardTerm});
    if (from == to) continue;
    const double t = target(arc.length, options_.size);
    add_convex_terms(list, from, to, t, std::max(1, minimum), [&](int d) { return interval_cost(t, d, options_.arc_curvature); });
    const int wished = wished_intervals(mesh, shape_.cells.edges[i], sharp_degree, options_.size, options_.largest_sag * options_.size);
    if (wished > minimum) list.push_back({from, to, wished, std::llround(kTermScale * kIntervalWishCost)});
  }
}

void Quantizer::add_orders(const std::vector<ChartOrder>& orders) {
  for (const auto& order : orders) {
    auto& list = terms_[axis(order.low)];
    const int from = unknown_[order.low], to = unknown_[order.high];
    if (from == to) continue;
    const double cost = kOrderCost + (kOrderCostMany - kOrderCost) * std::min(1.0, order.count / 8.0);
    const double lines = kLineCost * order.lines,
                 gap_cost = kGapCost * std::min(1.0, order.count / 4.0) + lines / (1 + lines / kLineCostMost);
    list.push_back({from, to, 1, std::llround(kTermScale * cost)});
    if (order.pieces > 1) list.push_back({from, to, order.pieces, std::llround(kTermScale * kPiecesCost)});
    const double t = target(order.gap, options_.size);
    add_convex_terms(list, from, to, t, 1, [&](int d) { return gap_cost * interval_cost(t, d, 0); });
  }
}

void Quantizer::add_positions() {
  const double h = options_.size;
  for (int c = 0; c < shape_.chart_count(); ++c) {
    const auto& chart = shape_.charts[c];
    const double weight = kPositionCost + (kPositionCostLarge - kPositionCost) * std::min(1.0, chart.area / (4 * h * h));
    const double t = target(chart.centroid[axis(c)], h);
    add_convex_terms(terms_[axis(c)], count_[axis(c)], unknown_[c], t, kNoMinimum, [&](int d) { return weight * std::abs(d - t); });
  }
}

void Quantizer::add_concentric(const SurfaceMesh& mesh) {
  for (const Concentric& found : find_concentric(mesh, shape_, options_.size)) {
    ConcentricUnknowns group{{(found.axis + 1) % 3, (found.axis + 2) % 3}, {}};
    for (const Ring& ring : found.rings) {
      group.rings.emplace_back();
      for (int k = 0; k < 2; ++k) group.rings.back()[k] = {unknown_[ring.low[k]], unknown_[ring.high[k]]};
    }
    concentric_.push_back(std::move(group));
  }
}

Polycube Quantizer::solve(const std::vector<Separation>& separations, Context& context) const {
  std::array<std::vector<DifferenceTerm>, 3> terms = terms_;
  for (const auto& s : separations)
    terms[axis(s.low)].push_back({unknown_[s.low], unknown_[s.high], s.gap, std::llround(kTermScale * kSeparationCost)});
  Polycube polycube;
  std::array<std::vector<int>, 3> u;
  for (int a = 0; a < 3; ++a) {
    context.check();
    auto solution = solve_differences(count_[a] + 1, terms[a]);
    if (!solution.cycle.empty()) {
      std::vector<int> charts;
      for (int t : solution.cycle) {
        const auto& edge = shape_.cells.edges[term_arc_[a][t]];
        charts.push_back(edge.left);
        charts.push_back(edge.right);
      }
      throw PolycubeError(std::string("the feature lines along the ") + "XYZ"[a] + " axis run in a circle", shape_, std::move(charts));
    }
    u[a] = std::move(solution.x);
  }
  for (const auto& group : concentric_) {
    context.check();
    make_concentric(group, std::llround(kTermScale * kUnevenCost), terms, u);
  }
  for (int a = 0; a < 3; ++a) {
    if (count_[a] == 0) continue;
    const int least = *std::min_element(u[a].begin(), u[a].begin() + count_[a]);
    for (int& x : u[a]) x -= least;
  }
  for (int c = 0; c < shape_.chart_count(); ++c) polycube.coordinate.push_back(u[axis(c)][unknown_[c]]);
  for (const auto& corner : corner_unknowns_) polycube.corners.push_back({u[0][corner[0]], u[1][corner[1]], u[2][corner[2]]});
  for (int i = 0; i < shape_.arc_count(); ++i) {
    const auto& edge = shape_.cells.edges[i];
    const int a = shape_.arcs[i].axis;
    const int intervals = std::abs(polycube.corners[edge.end][a] - polycube.corners[edge.start][a]);
    polycube.length_error += std::abs(intervals - shape_.arcs[i].length / options_.size) / shape_.arc_count();
  }
  return polycube;
}

}  // namespace hexfeature
