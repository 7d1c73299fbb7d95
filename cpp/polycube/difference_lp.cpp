// HexFeatureWB - LGPL-2.1-or-later
#include "polycube/difference_lp.h"

#include <lemon/network_simplex.h>
#include <lemon/smart_graph.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace hexfeature {
namespace {

/// Longest paths over the hard terms; the indices of a positive cycle's terms, or nothing.
std::vector<int> positive_cycle(int unknowns, const std::vector<DifferenceTerm>& terms) {
  std::vector<int> hard;
  for (int i = 0; i < static_cast<int>(terms.size()); ++i)
    if (terms[i].weight == kHardTerm) hard.push_back(i);
  std::vector<std::int64_t> x(unknowns, 0);
  std::vector<int> reached_by(unknowns, -1);
  int last = -1;
  for (int round = 0; round <= unknowns; ++round) {
    last = -1;
    for (int i : hard) {
      const auto& t = terms[i];
      if (x[t.from] + t.gap <= x[t.to]) continue;
      x[t.to] = x[t.from] + t.gap;
      reached_by[t.to] = i;
      last = t.to;
    }
    if (last < 0) return {};
  }
  for (int i = 0; i < unknowns; ++i) last = terms[reached_by[last]].from;  // now surely on the cycle
  std::vector<int> cycle;
  int node = last;
  do {
    cycle.push_back(reached_by[node]);
    node = terms[reached_by[node]].from;
  } while (node != last);
  std::reverse(cycle.begin(), cycle.end());
  return cycle;
}

/// Equal (from, to, gap) become one term; of hard terms between two unknowns the strongest is kept.
std::vector<DifferenceTerm> merged(std::vector<DifferenceTerm> terms) {
  std::sort(terms.begin(), terms.end(), [](const DifferenceTerm& a, const DifferenceTerm& b) {
    return std::make_tuple(a.from, a.to, -a.gap, a.weight) < std::make_tuple(b.from, b.to, -b.gap, b.weight);
  });
  std::size_t kept = 0;
  bool hard = false;  // a hard term of this pair and of at least this gap came before: the rest holds anyway
  for (const auto& t : terms) {
    if (t.from == t.to || t.weight == 0) continue;
    if (kept > 0 && terms[kept - 1].from == t.from && terms[kept - 1].to == t.to) {
      if (hard) continue;
      if (t.weight != kHardTerm && terms[kept - 1].gap == t.gap) {
        terms[kept - 1].weight += t.weight;
        continue;
      }
    }
    hard = t.weight == kHardTerm;
    terms[kept++] = t;
  }
  terms.resize(kept);
  return terms;
}

}  // namespace

DifferenceSolution solve_differences(int unknowns, const std::vector<DifferenceTerm>& terms) {
  DifferenceSolution solution;
  solution.cycle = positive_cycle(unknowns, terms);
  if (!solution.cycle.empty()) return solution;
  const auto arcs = merged(terms);
  solution.x.assign(unknowns, 0);
  if (arcs.empty()) return solution;

  using Graph = lemon::SmartDigraph;
  Graph graph;
  graph.reserveNode(unknowns);
  graph.reserveArc(static_cast<int>(arcs.size()));
  for (int i = 0; i < unknowns; ++i) graph.addNode();
  for (const auto& t : arcs) graph.addArc(graph.nodeFromId(t.from), graph.nodeFromId(t.to));
  Graph::ArcMap<std::int64_t> capacity(graph), cost(graph);
  std::int64_t total = 1;  // no optimal flow through a hard arc is larger than all soft capacities together
  for (const auto& t : arcs)
    if (t.weight > 0) total += t.weight;
  for (int i = 0; i < static_cast<int>(arcs.size()); ++i) {
    const auto arc = graph.arcFromId(i);
    capacity[arc] = arcs[i].weight == kHardTerm ? total : arcs[i].weight;
    cost[arc] = -arcs[i].gap;
  }
  lemon::NetworkSimplex<Graph, std::int64_t, std::int64_t> simplex(graph);
  simplex.upperMap(capacity).costMap(cost);
  simplex.run();  // always optimal: zero supplies, finite capacities
  for (int i = 0; i < unknowns; ++i) solution.x[i] = static_cast<int>(-simplex.potential(graph.nodeFromId(i)));
  return solution;
}

std::int64_t difference_cost(const std::vector<DifferenceTerm>& terms, const std::vector<int>& x) {
  std::int64_t cost = 0;
  for (const auto& t : terms)
    if (t.weight > 0) cost += t.weight * std::max(0, t.gap - (x[t.to] - x[t.from]));
  return cost;
}

void add_convex_terms(std::vector<DifferenceTerm>& terms, int from, int to, double target, int minimum,
                      const std::function<double(int)>& cost) {
  constexpr int kReach = 4;                                                                      // breakpoints on either side
  const auto slope = [&](int d) { return std::llround(kTermScale * (cost(d + 1) - cost(d))); };  // between d and d + 1
  const int floor = static_cast<int>(std::floor(target));
  const int first = std::max(minimum, floor - kReach), last = std::max(first, floor + 1 + kReach);
  std::int64_t before = first == minimum ? std::min<std::int64_t>(0, slope(first)) : slope(first - 1);
  for (int d = first; d <= last; ++d) {
    const std::int64_t after = slope(d);
    // The breakpoint's change of slope, split at zero: what is below becomes max(0, d - x), what is above max(0, x - d).
    const std::int64_t below = std::min<std::int64_t>(0, after) - std::min<std::int64_t>(0, before);
    const std::int64_t above = std::max<std::int64_t>(0, after) - std::max<std::int64_t>(0, before);
    if (below > 0) terms.push_back({from, to, d, below});
    if (above > 0) terms.push_back({to, from, -d, above});
    before = after;
  }
}

}  // namespace hexfeature
