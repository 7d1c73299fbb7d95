// HexFeatureWB - LGPL-2.1-or-later
#include <algorithm>
#include <cmath>
#include <queue>
#include <string>
#include <tuple>

#include "fit/cad_edges.h"

namespace hexfeature {

namespace {

constexpr double kReach = 3.0;                               ///< lattice units that an end may move
constexpr double kSharpRms = 1.3, kSmoothRms = 0.9;          ///< root mean square distance of a path that is too dear
constexpr double kSharpLargest = 2.2, kSmoothLargest = 1.3;  ///< largest distance of a path that is too dear
/// With free turns: a quarter of a circle becomes two sides of a square, whose corner is far from it where it has many elements.
constexpr double kFreeRms = 4, kFreeLargest = 7, kFreeTurn = 2;
constexpr int kFreeTurns = 2;      ///< ... and a half circle three
constexpr int kInsistedTurns = 6;  ///< ... where no mesh without is faithful
/// A path may only turn where the curve turns at least so much within an element: the corner that the turn puts there opens to 180
/// degrees less that turn. Losing a sharp edge is worse than a poor corner.
constexpr double kSharpTurn = 14 * EIGEN_PI / 180, kSmoothTurn = 30 * EIGEN_PI / 180;
constexpr double kFlat = 150 * EIGEN_PI / 180;  ///< an angle between two followed edges that no quad corner should have

constexpr double kSkip = 3;  ///< curve length that one step may stand for, in its own lengths

struct PathEnd {
  int node;
  double cost;
};

/// Chain and vertex index of a chain through mesh vertex from(h); {-1, -1} when there is none.
std::array<int, 2> chain_through(const BoundaryFit& fit, int h) {
  int g = h;
  do {
    if (fit.border_of[g] >= 0) return {fit.border_of[g], fit.border_index[g]};
    g = fit.mesh.opposite[SurfaceMesh::prev(g)];
  } while (g != h);
  return {-1, -1};
}

/// Nodes where the curve may begin; h is the curve's halfedge that leaves the vertex (its own or an opposite one).
std::vector<PathEnd> possible_ends(const BoundaryFit& fit, int region, int h, const Vec2& q, const std::vector<int>& node_of_vertex) {
  const int v = fit.mesh.from(h);
  if (node_of_vertex[v] >= 0) return {{node_of_vertex[v], 0}};
  std::vector<PathEnd> ends;
  const auto [c, index] = chain_through(fit, h);
  if (c >= 0) {
    const Chain& chain = fit.chains[c];
    if (index == 0) return {{chain.nodes.front(), 0}};
    if (index + 1 == static_cast<int>(chain.vertices.size())) return {{chain.nodes.back(), 0}};
    int lo = 1, hi = chain.intervals() - 1, before = 0, after = 0;
    double x = -1;
    for (const Stop& stop : chain.stops) {
      if (stop.vertex < index) {
        ++before;
        if (stop.pinned) lo = stop.node + 1, before = 0;
        if (!stop.pinned && stop.importance < 3) --before;
      } else if (stop.vertex == index) {
        if (stop.node >= 0) x = stop.node;
      } else if (hi == chain.intervals() - 1) {
        if (stop.pinned)
          hi = stop.node - 1;
        else if (stop.importance >= 3)
          ++after;
      }
    }
    lo += before;
    hi -= after;
    if (x < 0) {
      const double s = chain.s[index];
      const auto it = std::upper_bound(chain.node_s.begin() + 1, chain.node_s.end() - 1, s);
      const long i = it - chain.node_s.begin() - 1;
      x = static_cast<double>(i) + (s - chain.node_s[i]) / std::max(1e-300, chain.node_s[i + 1] - chain.node_s[i]);
    }
    for (int j = lo; j <= hi; ++j)
      if (std::abs(j - x) <= kReach) ends.push_back({chain.nodes[j], 0.3 * (j - x) * (j - x)});
    return ends;
  }
  std::vector<char> seen;
  for (int quad : fit.regions[region].quads)
    for (int n : fit.net.quads[quad]) {
      if (fit.node_taken[n] > 0) continue;
      const double d2 = (fit.flatten(fit.regions[region].chart, fit.lattice[n]) - q).squaredNorm();
      if (d2 <= kReach * kReach) ends.push_back({n, d2});
    }
  std::sort(ends.begin(), ends.end(), [](const PathEnd& a, const PathEnd& b) { return a.node < b.node; });
  ends.erase(std::unique(ends.begin(), ends.end(), [](const PathEnd& a, const PathEnd& b) { return a.node == b.node; }), ends.end());
  return ends;
}

/// May a path leave (or come in) along quad halfedge g at node from(g)? Not when a quad beside it has another followed edge at that node
/// that runs on as the curve comes from. `direction`: of the curve, away from the node; `mesh_vertex_h`: a mesh halfedge from its vertex.
bool opens_flat(const BoundaryFit& fit, int g, const Vec3& direction, int vertex_h) {
  const int node = fit.net.from(g);
  const double reach = 0.5 * fit.options.size;
  for (const int neighbour : {fit.net.prev(g), fit.net.opposite[g] < 0 ? -1 : fit.net.next(fit.net.opposite[g])}) {
    if (neighbour < 0 || !fit.quad_cut[neighbour]) continue;
    const int other = fit.net.from(neighbour) == node ? fit.net.to(neighbour) : fit.net.from(neighbour);
    // The chain along node - other, seen from the mesh vertex.
    int h = vertex_h;
    do {
      const int c = fit.border_of[h];
      if (c >= 0) {
        const Chain& chain = fit.chains[c];
        const bool forward = chain.halfedges[std::min<std::size_t>(fit.border_index[h], chain.halfedges.size() - 1)] == h;
        const auto at = std::find(chain.nodes.begin(), chain.nodes.end(), node);
        const bool follows = at != chain.nodes.end() && (forward ? at + 1 != chain.nodes.end() && *(at + 1) == other
                                                                 : at != chain.nodes.begin() && *(at - 1) == other);
        if (follows && followed_edge(fit.mesh, fit.geometry, h)) {
          const double s = std::clamp(chain.s[fit.border_index[h]] + (forward ? reach : -reach), 0.0, chain.length());
          const int i = chain.segment_at(s);
          const double f = (s - chain.s[i]) / std::max(1e-300, chain.s[i + 1] - chain.s[i]);
          const Vec3 p = (1 - f) * fit.mesh.points[chain.vertices[i]] + f * fit.mesh.points[chain.vertices[i + 1]];
          const Vec3 d = (p - fit.mesh.points[fit.mesh.from(h)]).normalized();
          if (d.dot(direction) < std::cos(kFlat)) return true;
        }
      }
      h = fit.mesh.opposite[SurfaceMesh::prev(h)];
    } while (h != vertex_h);
  }
  return false;
}

}  // namespace

void report_given_up(const BoundaryFit& fit, const InnerCurve& curve, const std::string& why) {
  if (!fit.context.on_log) return;
  fit.context.log("fit: CAD edge " + std::to_string(followed_edge(fit.mesh, fit.geometry, curve.halfedges.front())) +
                  (curve.sharp ? " (sharp)" : " (tangent)") + " has no mesh edges of its own: " + why);
}

namespace {

/// Where a path may turn and set out.
enum class Turns {
  WithCurve,  ///< only as the curve does: no corner becomes flat
  Left,
  Right,  ///< to this side wherever: the quads there have flat corners
  Any     ///< to both
};

struct Path {
  std::vector<int> nodes;  ///< empty: none
  double cost = 0;
  std::string why;  ///< there is none
};

Path find_path(const BoundaryFit& fit, int region, const InnerCurve& curve, const std::vector<int>& node_of_vertex, Turns turns) {
  const bool any_turn = turns != Turns::WithCurve;
  const int most_turns = turns == Turns::WithCurve ? 0 : turns == Turns::Any ? kInsistedTurns : kFreeTurns;
  const QuadNet& net = fit.net;
  const FlatCurve flat(fit, curve);
  const auto give_up = [&](const std::string& why) { return Path{{}, 0, why}; };
  const int first_h = curve.halfedges.front(), last_h = fit.mesh.opposite[curve.halfedges.back()];
  const auto starts = possible_ends(fit, region, first_h, flat.points().front(), node_of_vertex);
  const auto ends = possible_ends(fit, region, last_h, flat.points().back(), node_of_vertex);
  if (starts.empty() || ends.empty()) return give_up("no node for an end");
  std::vector<double> end_cost(fit.node_taken.size(), -1);
  for (const PathEnd& e : ends) end_cost[e.node] = e.cost;

  const int chart = fit.regions[region].chart;
  const auto inside = [&](int g) {
    return !fit.quad_cut[g] && fit.region_of_quad[g / 4] == region && net.opposite[g] >= 0 &&
           fit.region_of_quad[net.opposite[g] / 4] == region;
  };
  // Distance in lattice units, or on the part in element sizes where the map is crowded: the lesser of the two.
  std::vector<double> known_distance(fit.node_taken.size(), -1), known_s(fit.node_taken.size(), 0);
  const auto on_part = [&](int node) {
    const RegionMap& map = fit.regions[region].map;
    return map.point_at(map.locate(fit.flatten(chart, fit.lattice[node])));
  };
  const auto distance = [&](int node, double& s) {
    if (known_distance[node] < 0) {
      const Vec2 q = fit.flatten(chart, fit.lattice[node]);
      double d2 = flat.distance2(q, known_s[node]);
      if (d2 > 0.25 && d2 < 25) {
        double s_part;
        const double part2 = flat.distance2_on_part(on_part(node), s_part) / (fit.options.size * fit.options.size);
        if (part2 < d2) {
          d2 = part2;
          known_s[node] = s_part;
        }
      }
      known_distance[node] = d2;
    }
    s = known_s[node];
    return known_distance[node];
  };
  const double largest = any_turn ? kFreeLargest : curve.sharp ? kSharpLargest : kSmoothLargest;

  // Dijkstra over directed edges, free turns counted (state = edge + count * edges); the cost of a node is its squared distance plus a
  // little for each step.
  constexpr double kStep = 0.02;
  const int edges = static_cast<int>(net.opposite.size());
  std::vector<double> cost((most_turns + 1) * net.opposite.size(), 1e300);
  std::vector<int> before(cost.size(), -1);
  using Item = std::pair<double, int>;
  std::priority_queue<Item, std::vector<Item>, std::greater<Item>> queue;
  const Vec3 start_direction = flat.direction_from(true), end_direction = flat.direction_from(false);
  // The path must run along the whole curve: no step may skip a part of it (a chord across a loop would).
  const auto skips = [&](int g, double s0, double s1) {
    const double jump = std::abs(s1 - s0);
    return jump > kSkip * fit.options.size && jump > kSkip * (on_part(net.to(g)) - on_part(net.from(g))).norm();
  };
  const auto ends_at = [&](int g, double s_before) {
    return end_cost[net.to(g)] >= 0 && !skips(g, s_before, curve.length) &&
           (any_turn || !opens_flat(fit, net.opposite[g], end_direction, last_h));
  };
  const auto relax = [&](int g, double c, int from, int count) {
    if (count > most_turns || !inside(g)) return;
    const int n = net.to(g);
    double s;
    const double d2 = distance(n, s);
    double s0 = 0;
    if (from >= 0) distance(net.from(g), s0);
    const bool may_end = ends_at(g, s0);
    if (!may_end && skips(g, s0, s)) return;
    if (!may_end && (fit.node_taken[n] > 0 || d2 > largest * largest)) return;
    c += kStep + (may_end ? 0 : d2);
    const int state = g + count * edges;
    if (c < cost[state]) {
      cost[state] = c;
      before[state] = from;
      queue.push({c, state});
    }
  };
  for (const PathEnd& start : starts)
    for (int i = net.out_begin[start.node]; i < net.out_begin[start.node + 1]; ++i)
      if (any_turn || !opens_flat(fit, net.out[i], start_direction, first_h)) relax(net.out[i], start.cost, -1, 0);

  int goal = -1;
  double goal_cost = 1e300;
  while (!queue.empty()) {
    const auto [c, state] = queue.top();
    queue.pop();
    if (c > cost[state] || c >= goal_cost) continue;
    const int g = state % edges, count = state / edges, n = net.to(g);
    double s_before = 0;
    if (before[state] >= 0) distance(net.from(g), s_before);
    if (ends_at(g, s_before) && c + end_cost[n] < goal_cost) {
      goal = state;
      goal_cost = c + end_cost[n];
    }
    if (fit.node_taken[n] > 0) continue;
    if (net.out_begin[n + 1] - net.out_begin[n] != 4) continue;
    const int left = net.next(g), straight = net.next(net.opposite[left]), right = net.opposite[net.prev(net.opposite[g])];
    relax(straight, c, state, count);
    double s = 0;
    distance(n, s);
    const double turn = flat.turn_at(s);
    const double price = any_turn ? kFreeTurn : 0.5 * std::max(0.0, 1.5708 - std::abs(turn));
    const double least_turn = curve.sharp ? kSharpTurn : kSmoothTurn;
    if (any_turn ? turns != Turns::Right : turn > least_turn) relax(left, c + price, state, count + any_turn);
    if (any_turn ? turns != Turns::Left : turn < -least_turn) relax(right, c + price, state, count + any_turn);
  }
  if (goal < 0) return give_up("no path without a flat corner");
  std::vector<int> path{net.to(goal % edges)};
  for (int state = goal; state >= 0; state = before[state]) path.push_back(net.from(state % edges));
  std::reverse(path.begin(), path.end());
  double sum = 0;
  std::vector<int> sorted(path);
  std::sort(sorted.begin(), sorted.end());
  if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end()) return give_up("the path meets itself");
  for (int n : path) {
    double s;
    sum += distance(n, s);
  }
  // Ends taken from another side than the search came from may still skip.
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    double s0 = 0, s1 = curve.length;
    if (i > 0) distance(path[i], s0);
    if (i + 2 < path.size()) distance(path[i + 1], s1);
    const double step = (on_part(path[i + 1]) - on_part(path[i])).norm();
    if (std::abs(s1 - s0) > kSkip * std::max(fit.options.size, step)) return give_up("the path would skip a part of it");
  }
  const double rms = std::sqrt(sum / static_cast<double>(path.size()));
  if (rms > (any_turn ? kFreeRms : curve.sharp ? kSharpRms : kSmoothRms)) return give_up("too far, " + std::to_string(rms));
  return {path, goal_cost, {}};
}

}  // namespace

Route route_open_curve(const BoundaryFit& fit, int region, const InnerCurve& curve, const std::vector<int>& node_of_vertex) {
  Path path = find_path(fit, region, curve, node_of_vertex, Turns::WithCurve);
  const std::string why = path.why;
  bool free_turns = false;
  const bool insisted = std::any_of(curve.halfedges.begin(), curve.halfedges.end(),
                                    [&](int h) { return is_insisted(fit, followed_edge(fit.mesh, fit.geometry, h)); });
  if (path.nodes.empty() && fit.options.free_turns && (curve.sharp || insisted)) {
    // A sheet beside the line takes the flat corners away; if it can be, all of them on one side.
    path = find_path(fit, region, curve, node_of_vertex, Turns::Left);
    Path other = find_path(fit, region, curve, node_of_vertex, Turns::Right);
    if (path.nodes.empty() || (!other.nodes.empty() && other.cost < path.cost)) path = std::move(other);
    if (path.nodes.empty() && insisted) path = find_path(fit, region, curve, node_of_vertex, Turns::Any);
    free_turns = !path.nodes.empty();
  }
  if (path.nodes.empty()) report_given_up(fit, curve, why);
  return {path.nodes, free_turns};
}

std::vector<int> route_closed_curve(const BoundaryFit& fit, int region, const InnerCurve& curve) {
  const FlatCurve flat(fit, curve);
  const auto& p = flat.points();
  double area2 = 0;
  Vec2 lo = p[0], hi = p[0];
  for (std::size_t i = 0; i + 1 < p.size(); ++i) {
    area2 += p[i].x() * p[i + 1].y() - p[i].y() * p[i + 1].x();
    lo = lo.cwiseMin(p[i]);
    hi = hi.cwiseMax(p[i]);
  }
  const Vec2 size = hi - lo, middle = 0.5 * (lo + hi);
  if (!(size.minCoeff() > 0)) return {};
  const double shrink = std::sqrt(std::clamp(0.5 * std::abs(area2) / (size.x() * size.y()), 0.25, 1.0));
  const Vec2 low = middle - 0.5 * shrink * size, high = middle + 0.5 * shrink * size;

  // The region's free nodes by lattice position, in a window one unit wider than the curve.
  const int chart = fit.regions[region].chart;
  const Eigen::Vector2i origin = (low.array() - 1).floor().cast<int>(), last = (high.array() + 1).ceil().cast<int>();
  const int width = last[0] - origin[0] + 1;
  std::vector<int> grid(static_cast<std::size_t>(width) * (last[1] - origin[1] + 1), -1);
  for (int quad : fit.regions[region].quads)
    for (int n : fit.net.quads[quad]) {
      const Vec2 q = fit.flatten(chart, fit.lattice[n]);
      const int i = static_cast<int>(std::lround(q[0])), j = static_cast<int>(std::lround(q[1]));
      if (i >= origin[0] && j >= origin[1] && i <= last[0] && j <= last[1] && fit.node_taken[n] == 0)
        grid[static_cast<std::size_t>(j - origin[1]) * width + i - origin[0]] = n;
    }
  const auto node_at = [&](int i, int j) { return grid[static_cast<std::size_t>(j - origin[1]) * width + i - origin[0]]; };
  const auto rectangle = [&](const Eigen::Vector2i& a, const Eigen::Vector2i& b) {
    std::vector<int> nodes;
    for (int i = a[0]; i < b[0]; ++i) nodes.push_back(node_at(i, a[1]));
    for (int j = a[1]; j < b[1]; ++j) nodes.push_back(node_at(b[0], j));
    for (int i = b[0]; i > a[0]; --i) nodes.push_back(node_at(i, b[1]));
    for (int j = b[1]; j > a[1]; --j) nodes.push_back(node_at(a[0], j));
    return nodes;
  };
  // Each side rounded either way: the free rectangle nearest to the ideal one.
  std::vector<int> loop;
  double least_cost = 1e300;
  for (int choice = 0; choice < 16; ++choice) {
    const auto side = [&](double x, int bit) { return static_cast<int>(choice >> bit & 1 ? std::ceil(x) : std::floor(x)); };
    const Eigen::Vector2i a(side(low[0], 0), side(low[1], 1)), b(side(high[0], 2), side(high[1], 3));
    if ((b - a).minCoeff() < 1) continue;
    const double cost = (a.cast<double>() - low).squaredNorm() + (b.cast<double>() - high).squaredNorm();
    if (cost >= least_cost) continue;
    std::vector<int> nodes = rectangle(a, b);
    if (std::find(nodes.begin(), nodes.end(), -1) != nodes.end()) continue;
    loop = std::move(nodes);
    least_cost = cost;
  }
  if (loop.empty()) {
    report_given_up(fit, curve, "no free loop of nodes");
    return {};
  }
  if (area2 < 0) std::reverse(loop.begin(), loop.end());
  // Begin at the node nearest to the curve's first point.
  std::size_t best = 0;
  double least = 1e300;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const double d = (fit.flatten(chart, fit.lattice[loop[i]]) - p[0]).squaredNorm();
    if (d < least) {
      least = d;
      best = i;
    }
  }
  std::rotate(loop.begin(), loop.begin() + static_cast<long>(best), loop.end());
  loop.push_back(loop.front());
  return loop;
}

}  // namespace hexfeature
