// HexFeatureWB - LGPL-2.1-or-later
#include "sheet/shrink_set.h"

#include <lemon/preflow.h>
#include <lemon/smart_graph.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <numeric>
#include <set>

#include "sheet/edge_angle.h"

namespace hexfeature {
namespace {

constexpr long long kInnerCost = 100, kCoveredCost = 5, kBadExitCost = 3000, kClosingCost = 10000;
constexpr double kOneDirection = 0.87, kAcross = 0.71;  // cosines: 30 degrees, 45 degrees
constexpr int kConflictRounds = 6;
// Degrees: two hexahedra that share so much have a scaled Jacobian of 0.68 at most. Those that a sheet makes share a square edge have 0.71,
// and a sheet that turns inside instead is seldom better.
constexpr double kAcute = 85;

// Blocks numbered 0.. in the order of their ids; each hexahedron its own block beside a CAD edge inside a chart: that cuts blocks.
std::vector<int> dense_blocks(const HexComplex& complex, const SheetGroup& group, int& count) {
  if (group.cad_edge > 0) {
    std::vector<int> each(complex.hexes.size());
    std::iota(each.begin(), each.end(), 0);
    count = complex.hex_count();
    return each;
  }
  std::vector<int> ids = complex.hex_block;
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  std::vector<int> block(complex.hexes.size());
  for (std::size_t h = 0; h < block.size(); ++h)
    block[h] = static_cast<int>(std::lower_bound(ids.begin(), ids.end(), complex.hex_block[h]) - ids.begin());
  count = static_cast<int>(ids.size());
  return block;
}

struct Terminals {
  std::vector<char> source, sink;      // per block
  std::vector<std::array<int, 2>> by;  // (block, free chart) that made it a sink
};

class Chooser {
 public:
  Chooser(const HexComplex& complex, const HexTopology& topology, const SheetGroup& group, const SheetOptions& options,
          const std::vector<std::vector<int>>& together)
      : complex_(complex),
        topology_(topology),
        group_(group),
        options_(options),
        together_(together),
        block_(dense_blocks(complex, group, block_count_)) {
    int charts = 0;
    for (int c : complex.quad_chart) charts = std::max(charts, c + 1);
    covered_.assign(charts, 0);
    for (int c : group.charts) covered_[c] = 1;
  }

  ShrinkSet choose(Context& context) {
    ShrinkSet set;
    for (int round = 0; round <= kConflictRounds; ++round) {
      context.check();
      Terminals t = terminals();
      for (int rows = part_rows(t); rows > 0; rows = part_rows(t)) {
        set.rows += rows;
        context.check();
        t = terminals();
      }
      if (std::find(t.source.begin(), t.source.end(), 1) == t.source.end()) {
        set.refusal = "no block needs to shrink";
        return set;
      }
      std::vector<int> joining;
      for (const auto& [block, chart] : t.by)
        if (t.source[block] && chart >= 0) joining.push_back(chart);
      if (joining.empty()) {
        for (int b = 0; b < block_count_; ++b)
          if (t.source[b] && t.sink[b]) {
            set.refusal = "a block must both shrink and stay";
            return set;
          }
        cut(t, set);
        return set;
      }
      for (int c : joining) covered_[c] = 1;
    }
    set.refusal = "blocks must both shrink and stay, whatever charts join the group";
    return set;
  }

 private:
  // Of blocks that must both shrink and stay, the rows of hexahedra along the free charts concerned, as blocks of their own that stay:
  // where the sheet would otherwise wrap an acute edge, whose angle two hexahedra share badly. Returns how many.
  int part_rows(const Terminals& t) {
    int rows = 0;
    if (group_.cad_edge > 0) return rows;  // there every hexahedron is a block of its own
    for (const auto& [block, chart] : t.by) rows += t.source[block] && chart >= 0 && wraps_acute_edge(chart) && part_row(block, chart);
    return rows;
  }

  // Would it, if the chart were covered too?
  bool wraps_acute_edge(int chart) const {
    return std::any_of(topology_.edges.begin(), topology_.edges.end(), [&](const HexTopology::Edge& e) {
      if (e.count != 1) return false;
      const bool first = complex_.quad_chart[e.quads[0]] == chart && covered(e.quads[1]);
      const bool second = complex_.quad_chart[e.quads[1]] == chart && covered(e.quads[0]);
      return (first || second) && solid_angle(complex_, e) < kAcute;
    });
  }

  // Not a row at a smooth edge, which must shrink; nor a whole block.
  bool part_row(int block, int chart) {
    std::vector<char> row(block_.size(), 0);
    for (int q = 0; q < static_cast<int>(complex_.quads.size()); ++q)
      if (const int h = topology_.hex_of_quad(q); complex_.quad_chart[q] == chart && block_[h] == block) row[h] = 1;
    for (const auto& nodes : group_.smooth_edges)
      if (const auto* e = topology_.find_edge(nodes[0], nodes[1]))
        for (int i = 0; i < e->count; ++i)
          if (row[topology_.edge_hexes[e->first + i]]) return false;
    if (std::count(row.begin(), row.end(), 1) == std::count(block_.begin(), block_.end(), block)) return false;
    for (std::size_t h = 0; h < block_.size(); ++h)
      if (row[h]) block_[h] = block_count_;
    ++block_count_;
    return true;
  }

  bool covered(int quad) const { return complex_.quad_chart[quad] >= 0 && covered_[complex_.quad_chart[quad]]; }

  Terminals terminals() const {
    Terminals t{std::vector<char>(block_count_, 0), std::vector<char>(block_count_, 0), {}};
    for (const auto& nodes : group_.smooth_edges)
      if (const auto* e = topology_.find_edge(nodes[0], nodes[1]))
        for (int i = 0; i < e->count; ++i) t.source[block_[topology_.edge_hexes[e->first + i]]] = 1;
    for (const auto& e : topology_.edges) {
      if (covered(e.quads[0]) == covered(e.quads[1])) continue;
      const int free = covered(e.quads[0]) ? e.quads[1] : e.quads[0];
      if (e.count >= 3 || (e.count == 2 && solid_angle(complex_, e) > options_.smooth_angle)) sort_round(e, free, t);
    }
    for (std::size_t i = 0; i < group_.floor_edges.size(); ++i)
      if (const auto* e = topology_.find_edge(group_.floor_edges[i][0], group_.floor_edges[i][1]))
        sort_round_floor(*e, group_.floor_quads[i], t);
    std::sort(t.by.begin(), t.by.end());
    t.by.erase(std::unique(t.by.begin(), t.by.end()), t.by.end());
    return t;
  }

  // A foot: the free face's cell stays, the others shrink.
  void sort_round(const HexTopology::Edge& e, int free_quad, Terminals& t) const {
    const int stays = topology_.hex_of_quad(free_quad);
    for (int i = 0; i < e.count; ++i) {
      const int h = topology_.edge_hexes[e.first + i];
      if (h != stays) t.source[block_[h]] = 1;
    }
    t.sink[block_[stays]] = 1;
    t.by.push_back({block_[stays], complex_.quad_chart[free_quad]});
  }

  // A floor: its cell shrinks, the others stay.
  void sort_round_floor(const HexTopology::Edge& e, int floor_quad, Terminals& t) const {
    const int shrinks = topology_.hex_of_quad(floor_quad);
    for (int i = 0; i < e.count; ++i) {
      const int h = topology_.edge_hexes[e.first + i];
      (h == shrinks ? t.source : t.sink)[block_[h]] = 1;
    }
  }

  // The direction that the group's smooth edges run along, when they all do and its charts join all round, as those of a shaft; else zero.
  // A sheet along a part of the round alone has two rims that it would carry through the part.
  Vec3 run_of_walls() const {
    const auto direction = [&](const std::array<int, 2>& e) -> Vec3 {
      return (complex_.points[e[1]] - complex_.points[e[0]]).normalized();
    };
    std::set<std::array<int, 2>> joined;
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
    for (const auto& nodes : group_.smooth_edges) {
      spread += direction(nodes) * direction(nodes).transpose();
      const auto& quads = topology_.find_edge(nodes[0], nodes[1])->quads;
      const int a = complex_.quad_chart[quads[0]], b = complex_.quad_chart[quads[1]];
      joined.insert({a, b});
      joined.insert({b, a});
    }
    const bool round = std::all_of(group_.charts.begin(), group_.charts.end(), [&](int c) {
      return std::count_if(joined.begin(), joined.end(), [&](const auto& pair) { return pair[0] == c; }) > 1;
    });
    if (!round || joined.empty()) return Vec3::Zero();
    const Vec3 mean = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread).eigenvectors().col(2);
    const bool one = std::all_of(group_.smooth_edges.begin(), group_.smooth_edges.end(),
                                 [&](const auto& e) { return std::abs(direction(e).dot(mean)) > kOneDirection; });
    return one ? mean : Vec3::Zero();
  }

  bool is_across(int side, const Vec3& run) const {
    std::array<Vec3, 4> p;
    for (int k = 0; k < 4; ++k) p[k] = complex_.points[complex_.hexes[side / 6][kHexFaces[side % 6][k]]];
    return std::abs((p[2] - p[0]).cross(p[3] - p[1]).normalized().dot(run)) > kAcross;
  }

  void cut(const Terminals& t, ShrinkSet& set) const {
    const int source = block_count_, sink = block_count_ + 1;
    const long long infinite = kClosingCost * (static_cast<long long>(topology_.neighbour.size()) + 1);
    std::vector<CutArc> links;
    const Vec3 run = options_.run_through ? run_of_walls() : Vec3::Zero();
    for (int s = 0; s < static_cast<int>(topology_.neighbour.size()); ++s) {
      const int other = topology_.neighbour[s], b = block_[s / 6];
      if (other > s && block_[other / 6] != b) {
        const long long c = is_across(s, run) ? kClosingCost : kInnerCost;
        links.push_back({b, block_[other / 6], c});
        links.push_back({block_[other / 6], b, c});
      } else if (other < 0 && covered(-1 - other)) {
        links.push_back({b, sink, kCoveredCost});
      }
    }
    for (const auto& e : topology_.edges) discourage_bad_exit(e, links);
    for (const auto& hexes : together_)
      for (int h : hexes) {
        links.push_back({block_[hexes.front()], block_[h], infinite});
        links.push_back({block_[h], block_[hexes.front()], infinite});
      }
    for (int b = 0; b < block_count_; ++b) {
      if (t.source[b]) links.push_back({source, b, infinite});
      if (t.sink[b]) links.push_back({b, sink, infinite});
    }
    const std::vector<char> side = largest_minimum_cut(block_count_ + 2, links, source, sink);
    for (const CutArc& l : links)
      if (side[l.from] && !side[l.to]) set.cost += l.capacity;
    if (set.cost >= infinite) set.refusal = "hexahedra that belong together must both shrink and stay";
    set.inside.resize(block_.size());
    for (std::size_t h = 0; h < block_.size(); ++h) set.inside[h] = side[block_[h]];
    set.covered = covered_;
  }

  // A sheet that leaves at a concave edge between two free faces should do so on one of these two faces with one hexahedron of the
  // shrink set below it, as the sheet's own hexahedron takes that one's place. With a middle one inside and an end one outside, too
  // few hexahedra are left for the angle, and where the edge turns a corner of the lattice smoothly one of them is flat.
  void discourage_bad_exit(const HexTopology::Edge& e, std::vector<CutArc>& links) const {
    if (e.count < 3 || covered(e.quads[0]) || covered(e.quads[1])) return;
    const int ends[2] = {topology_.hex_of_quad(e.quads[0]), topology_.hex_of_quad(e.quads[1])};
    for (int i = 0; i < e.count; ++i) {
      const int h = topology_.edge_hexes[e.first + i];
      if (h == ends[0] || h == ends[1]) continue;
      for (int end : ends)
        if (block_[end] != block_[h]) links.push_back({block_[h], block_[end], kBadExitCost});
    }
  }

  const HexComplex& complex_;
  const HexTopology& topology_;
  const SheetGroup& group_;
  const SheetOptions& options_;
  const std::vector<std::vector<int>>& together_;
  int block_count_ = 0;
  std::vector<int> block_;     // per hexahedron
  std::vector<char> covered_;  // per chart
};

}  // namespace

std::vector<char> largest_minimum_cut(int node_count, std::vector<CutArc> arcs, int source, int sink) {
  std::sort(arcs.begin(), arcs.end(), [](const CutArc& x, const CutArc& y) { return x.from != y.from ? x.from < y.from : x.to < y.to; });
  using Graph = lemon::SmartDigraph;
  Graph graph;
  graph.reserveNode(node_count);
  for (int i = 0; i < node_count; ++i) graph.addNode();
  Graph::ArcMap<long long> room(graph);
  for (std::size_t i = 0; i < arcs.size();) {
    long long sum = 0;
    std::size_t j = i;
    for (; j < arcs.size() && arcs[j].from == arcs[i].from && arcs[j].to == arcs[i].to; ++j) sum += arcs[j].capacity;
    room[graph.addArc(Graph::nodeFromId(arcs[i].from), Graph::nodeFromId(arcs[i].to))] = sum;
    i = j;
  }
  lemon::Preflow<Graph, Graph::ArcMap<long long>> preflow(graph, room, Graph::nodeFromId(source), Graph::nodeFromId(sink));
  preflow.run();
  // The largest source side: all but the nodes from which the sink can still be reached.
  std::vector<char> inside(node_count, 1);
  std::vector<int> stack{sink};
  inside[sink] = 0;
  while (!stack.empty()) {
    const Graph::Node v = Graph::nodeFromId(stack.back());
    stack.pop_back();
    const auto visit = [&](Graph::Node u) {
      if (!inside[Graph::id(u)]) return;
      inside[Graph::id(u)] = 0;
      stack.push_back(Graph::id(u));
    };
    for (Graph::InArcIt a(graph, v); a != lemon::INVALID; ++a)
      if (preflow.flow(a) < room[a]) visit(graph.source(a));
    for (Graph::OutArcIt a(graph, v); a != lemon::INVALID; ++a)
      if (preflow.flow(a) > 0) visit(graph.target(a));
  }
  return inside;
}

ShrinkSet choose_shrink_set(const HexComplex& complex, const HexTopology& topology, const SheetGroup& group, const SheetOptions& options,
                            Context& context, const std::vector<std::vector<int>>& together) {
  return Chooser(complex, topology, group, options, together).choose(context);
}

}  // namespace hexfeature
