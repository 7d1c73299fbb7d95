// HexFeatureWB - LGPL-2.1-or-later
// Where a sheet is needed (experiments B1).
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "sheet/edge_angle.h"
#include "sheet/sheet.h"

namespace hexfeature {
namespace {

// Edges between the same two charts that hang together: one border.
struct Border {
  std::array<int, 2> charts;  // smaller first
  std::vector<int> edges;     // indices into HexTopology::edges
  int smooth = 0;
};

class Forest {
 public:
  explicit Forest(int n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0); }
  int find(int i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(int a, int b) {
    a = find(a), b = find(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<int> parent_;
};

// Borders of one hexahedron: this one would have to be flat when the border is smooth.
std::vector<Border> convex_borders(const HexComplex& complex, const HexTopology& topology) {
  struct Item {
    std::array<int, 2> charts;
    int edge;
  };
  std::vector<Item> items;
  for (int e = 0; e < static_cast<int>(topology.edges.size()); ++e) {
    const auto& edge = topology.edges[e];
    const int a = complex.quad_chart[edge.quads[0]], b = complex.quad_chart[edge.quads[1]];
    if (edge.count == 1 && a != b && a >= 0 && b >= 0) items.push_back({{std::min(a, b), std::max(a, b)}, e});
  }
  std::sort(items.begin(), items.end(),
            [](const Item& x, const Item& y) { return x.charts != y.charts ? x.charts < y.charts : x.edge < y.edge; });
  Forest forest(static_cast<int>(items.size()));
  std::map<int, int> at_node;  // node -> an item of the current pair of charts
  for (int i = 0; i < static_cast<int>(items.size()); ++i) {
    if (i > 0 && items[i].charts != items[i - 1].charts) at_node.clear();
    for (int v : topology.edges[items[i].edge].nodes) {
      const auto [it, fresh] = at_node.try_emplace(v, i);
      if (!fresh) forest.join(it->second, i);
    }
  }
  std::vector<Border> borders;
  std::vector<int> border_of(items.size(), -1);
  for (int i = 0; i < static_cast<int>(items.size()); ++i) {
    int& b = border_of[forest.find(i)];
    if (b < 0) {
      b = static_cast<int>(borders.size());
      borders.push_back({items[i].charts, {}, 0});
    }
    borders[b].edges.push_back(items[i].edge);
  }
  return borders;
}

// Pairs of CAD faces that share an edge: the least dihedral of their common edges, degrees without sign.
class FaceAngles {
 public:
  explicit FaceAngles(const Geometry& geometry) {
    if (!geometry.edges) return;
    for (const CadEdge& e : *geometry.edges) {
      if (e.degenerate || e.faces[0] == e.faces[1] || e.faces[0] <= 0 || e.faces[1] <= 0) continue;
      const double degrees = std::abs(e.dihedral) * 180 / EIGEN_PI;
      const auto [it, fresh] = least_.try_emplace({std::min(e.faces[0], e.faces[1]), std::max(e.faces[0], e.faces[1])}, degrees);
      if (!fresh) it->second = std::min(it->second, degrees);
    }
  }
  double operator()(int a, int b) const {
    const auto it = least_.find({std::min(a, b), std::max(a, b)});
    return it == least_.end() ? 0 : it->second;
  }

 private:
  std::map<std::array<int, 2>, double> least_;
};

// The CAD has the last word: a quad folded over at a sharp edge looks smooth and is not; nor is a chamfer, whose 135 degrees one
// hexahedron bears well.
bool is_smooth(const HexComplex& complex, const Geometry& geometry, const FaceAngles& angles, const HexTopology::Edge& edge,
               const SheetOptions& options) {
  if (solid_angle(complex, edge) <= options.smooth_angle) return false;
  const int cad = feature_of(complex, edge.nodes[0], edge.nodes[1]);
  const double crease = cad > 0 && geometry.edges ? std::abs(geometry.edge(cad).dihedral) * 180 / EIGEN_PI
                                                  : angles(complex.quad_face[edge.quads[0]], complex.quad_face[edge.quads[1]]);
  return crease < options.crease_angle;
}

// Border edges of a chart that are the foot of a wall, joined where they share a node, when the chart has on them a quad whose corner
// between two such edges is nearly straight: a round pocket's floor. Its wall needs no sheet (three hexahedra share 180 degrees
// there), the floor's own quads do.
void find_floors(const HexComplex& complex, const HexTopology& topology, double degrees, std::vector<SheetGroup>& groups) {
  const auto is_foot = [&](int q, const HexTopology::Edge& e) {
    return e.count >= 3 && complex.quad_chart[e.quads[0]] != complex.quad_chart[e.quads[1]] && complex.quad_chart[q] >= 0 &&
           feature_of(complex, e.nodes[0], e.nodes[1]) > 0;
  };
  std::vector<std::array<int, 2>> seeds;  // (chart, node)
  for (int q = 0; q < static_cast<int>(complex.quads.size()); ++q)
    for (int i = 0; i < 4; ++i) {
      const auto& n = complex.quads[q];
      if (is_foot(q, *topology.find_edge(n[i], n[(i + 1) % 4])) && is_foot(q, *topology.find_edge(n[(i + 3) % 4], n[i])) &&
          corner_angle(complex, q, i) > degrees)
        seeds.push_back({complex.quad_chart[q], n[i]});
    }
  std::sort(seeds.begin(), seeds.end());
  std::vector<char> reached(complex.points.size(), 0);
  for (std::size_t s = 0; s < seeds.size(); ++s) {
    const auto [chart, node] = seeds[s];
    if (s == 0 || chart != seeds[s - 1][0]) std::fill(reached.begin(), reached.end(), 0);
    if (reached[node]) continue;
    SheetGroup floor;
    floor.floor_chart = chart;
    std::vector<const HexTopology::Edge*> feet;
    for (const auto& e : topology.edges)
      for (int q : e.quads)
        if (complex.quad_chart[q] == chart && is_foot(q, e)) feet.push_back(&e);
    reached[node] = 1;
    for (bool grown = true; grown;) {
      grown = false;
      for (const auto*& e : feet)
        if (e && (reached[e->nodes[0]] || reached[e->nodes[1]])) {
          reached[e->nodes[0]] = reached[e->nodes[1]] = 1;
          floor.floor_edges.push_back(e->nodes);
          floor.floor_quads.push_back(complex.quad_chart[e->quads[0]] == chart ? e->quads[0] : e->quads[1]);
          e = nullptr;
          grown = true;
        }
    }
    groups.push_back(std::move(floor));
  }
}

// The edges of a CAD edge's mesh line, from (a, b) of quad q on, as long as q's side of the line shows more of them.
void walk_line(const HexComplex& complex, const HexTopology& topology, int q, int a, int b, bool forward, SheetGroup& floor) {
  const int cad = feature_of(complex, a, b), start = a;
  for (;;) {
    const auto* e = topology.find_edge(a, b);
    if (e->count < 2) return;
    floor.floor_edges.push_back(e->nodes);
    floor.floor_quads.push_back(q);
    if (b == start) return;
    // Round b, on the floor's side, to the next edge that follows a CAD edge.
    for (const auto* first = e;;) {
      const auto& n = complex.quads[q];
      const int at = static_cast<int>(std::find(n.begin(), n.end(), b) - n.begin());
      const int next = n[(at + (forward ? 1 : 3)) % 4];
      e = topology.find_edge(b, next);
      if (e == first) return;
      if (const int other = feature_of(complex, b, next)) {
        if (other != cad) return;
        a = b;
        b = next;
        break;
      }
      const int beyond = e->quads[0] == q ? e->quads[1] : e->quads[0];
      if (complex.quad_chart[beyond] != floor.floor_chart) return;
      q = beyond;
    }
  }
}

// Whether three nodes on one CAD edge follow each other as its parameter rises, by two of them that slide on it.
bool runs_along(const HexComplex& complex, int before, int middle, int after) {
  const auto slides = [&](int v) { return complex.place[v].dim == 1; };
  if (!slides(middle)) return !(slides(before) && slides(after)) || complex.place[before].uv[0] < complex.place[after].uv[0];
  if (slides(after)) return complex.place[middle].uv[0] < complex.place[after].uv[0];
  return !slides(before) || complex.place[before].uv[0] < complex.place[middle].uv[0];
}

// CAD edges inside a chart that mesh edges follow with turns: on the inner side of a turn one quad has both its edges on the curve, and a
// corner of nearly 180 degrees. The floor is that side.
void find_turns(const HexComplex& complex, const HexTopology& topology, double degrees, std::vector<SheetGroup>& groups) {
  const auto is_inner = [&](const HexTopology::Edge& e) { return complex.quad_chart[e.quads[0]] == complex.quad_chart[e.quads[1]]; };
  std::vector<std::array<int, 2>> settled;  // (quad, node), sorted
  for (int q = 0; q < static_cast<int>(complex.quads.size()); ++q)
    for (int i = 0; i < 4; ++i) {
      const auto& n = complex.quads[q];
      const int middle = n[i], after = n[(i + 1) % 4], before = n[(i + 3) % 4];
      if (!feature_of(complex, middle, after) || !feature_of(complex, before, middle)) continue;
      if (!is_inner(*topology.find_edge(middle, after)) && !is_inner(*topology.find_edge(before, middle))) continue;
      if (corner_angle(complex, q, i) <= degrees) continue;
      if (std::binary_search(settled.begin(), settled.end(), std::array<int, 2>{q, middle})) continue;
      SheetGroup floor;
      floor.floor_chart = complex.quad_chart[q];
      floor.cad_edge = feature_of(complex, middle, after);
      floor.left = runs_along(complex, before, middle, after);
      walk_line(complex, topology, q, middle, after, true, floor);
      walk_line(complex, topology, q, middle, before, false, floor);
      for (std::size_t k = 0; k < floor.floor_edges.size(); ++k)
        for (int v : floor.floor_edges[k]) settled.push_back({floor.floor_quads[k], v});
      std::sort(settled.begin(), settled.end());
      if (!floor.floor_edges.empty()) groups.push_back(std::move(floor));
    }
}

}  // namespace

std::vector<SheetGroup> find_sheet_groups(const HexComplex& complex, const HexTopology& topology, const Geometry& geometry,
                                          const SheetOptions& options, const Context& context) {
  std::vector<Border> borders = convex_borders(complex, topology);
  int chart_count = 0;
  for (int c : complex.quad_chart) chart_count = std::max(chart_count, c + 1);
  Forest charts(chart_count);
  const FaceAngles angles(geometry);
  for (Border& b : borders) {
    for (int e : b.edges) b.smooth += is_smooth(complex, geometry, angles, topology.edges[e], options);
    if (b.smooth > options.smooth_share * b.edges.size()) charts.join(b.charts[0], b.charts[1]);
  }
  std::vector<int> group_of(chart_count, -1);
  std::vector<SheetGroup> groups;
  for (const Border& b : borders) {
    if (b.smooth <= options.smooth_share * b.edges.size()) continue;
    int& g = group_of[charts.find(b.charts[0])];
    if (g < 0) {
      g = static_cast<int>(groups.size());
      groups.emplace_back();
      for (int c = 0; c < chart_count; ++c)
        if (charts.find(c) == charts.find(b.charts[0])) groups.back().charts.push_back(c);
    }
    for (int e : b.edges) groups[g].smooth_edges.push_back(topology.edges[e].nodes);
  }
  std::stable_sort(groups.begin(), groups.end(),
                   [](const SheetGroup& a, const SheetGroup& b) { return a.smooth_edges.size() > b.smooth_edges.size(); });
  context.check();
  find_floors(complex, topology, options.floor_angle, groups);
  context.check();
  find_turns(complex, topology, options.floor_angle, groups);
  return groups;
}

}  // namespace hexfeature
