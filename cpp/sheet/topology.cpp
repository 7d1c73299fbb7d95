// HexFeatureWB - LGPL-2.1-or-later
#include "sheet/topology.h"

#include <algorithm>
#include <string>
#include <utility>

#include "base/error.h"
#include "mesh/buckets.h"

namespace hexfeature {
namespace {

[[noreturn]] void fail(const char* reason) {
  throw MeshingError(Failure::NoMesh, "sheet", reason, "the hexahedral complex is damaged; please report this part");
}

std::array<int, 2> ordered(int a, int b) { return a < b ? std::array<int, 2>{a, b} : std::array<int, 2>{b, a}; }

void match_sides(const HexComplex& complex, HexTopology& topology, const Context& context) {
  constexpr const char* kNotTheBoundary = "the boundary quads are not the complex's boundary";
  FaceMates faces = match_faces(complex, context);
  topology.neighbour = std::move(faces.mate);
  topology.quad_side.assign(complex.quads.size(), -1);
  std::vector<int> boundary;
  for (int s = 0; s < static_cast<int>(topology.neighbour.size()); ++s) {
    if (topology.neighbour[s] == FaceMates::kCrowded) fail("hexahedra do not share a face in pairs, from opposite sides");
    if (topology.neighbour[s] == FaceMates::kBoundary) boundary.push_back(s);
  }
  if (boundary.size() != complex.quads.size()) fail(kNotTheBoundary);
  context.check();
  const auto least = [](const std::array<int, 4>& nodes) { return *std::min_element(nodes.begin(), nodes.end()); };
  const Buckets by_node(complex.point_count(), static_cast<int>(boundary.size()),
                        [&](int i) { return least(face_nodes(complex, boundary[i])); });
  for (int q = 0; q < static_cast<int>(complex.quads.size()); ++q) {
    const int key = least(complex.quads[q]);
    if (key < 0 || key >= complex.point_count()) fail(kNotTheBoundary);
    for (int k = by_node.start[key]; k < by_node.start[key + 1] && topology.quad_side[q] < 0; ++k) {
      const int side = boundary[by_node.item[k]];
      if (topology.neighbour[side] != FaceMates::kBoundary || !same_cycle(complex.quads[q], face_nodes(complex, side), 1)) continue;
      topology.neighbour[side] = -1 - q;
      topology.quad_side[q] = side;
    }
    if (topology.quad_side[q] < 0) fail(kNotTheBoundary);
  }
}

void collect_edges(const HexComplex& complex, HexTopology& topology, const Context& context) {
  struct Half {
    std::array<int, 2> nodes;
    int quad;
    bool forward;  // the quad runs smaller -> larger node
  };
  std::vector<Half> halves;
  halves.reserve(4 * complex.quads.size());
  for (int q = 0; q < static_cast<int>(complex.quads.size()); ++q)
    for (int i = 0; i < 4; ++i) {
      const int a = complex.quads[q][i], b = complex.quads[q][(i + 1) % 4];
      halves.push_back({ordered(a, b), q, a < b});
    }
  std::sort(halves.begin(), halves.end(),
            [](const Half& a, const Half& b) { return a.nodes != b.nodes ? a.nodes < b.nodes : a.forward > b.forward; });
  context.check();
  topology.edges.reserve(halves.size() / 2);
  topology.first_edge.assign(complex.points.size() + 1, 0);
  for (std::size_t i = 0; i < halves.size(); i += 2) {
    if (i + 1 >= halves.size() || halves[i].nodes != halves[i + 1].nodes || !halves[i].forward || halves[i + 1].forward ||
        (i + 2 < halves.size() && halves[i + 2].nodes == halves[i].nodes))
      fail("the boundary is not an oriented manifold");
    topology.edges.push_back({halves[i].nodes, {halves[i].quad, halves[i + 1].quad}, 0, 0});
    ++topology.first_edge[halves[i].nodes[0] + 1];
  }
  for (std::size_t v = 0; v < complex.points.size(); ++v) topology.first_edge[v + 1] += topology.first_edge[v];
  // The hexahedra round each, in their order: counted, then filled in.
  const auto for_each_use = [&](const auto& visit) {
    for (int h = 0; h < complex.hex_count(); ++h) {
      if (h % 32768 == 0) context.check();
      for (const auto& e : kHexEdges)
        if (const auto* edge = topology.find_edge(complex.hexes[h][e[0]], complex.hexes[h][e[1]])) visit(edge - topology.edges.data(), h);
    }
  };
  for_each_use([&](std::ptrdiff_t e, int) { ++topology.edges[e].count; });
  int total = 0;
  for (auto& e : topology.edges) {
    e.first = total;
    total += e.count;
    e.count = 0;
  }
  topology.edge_hexes.resize(total);
  for_each_use([&](std::ptrdiff_t e, int h) { topology.edge_hexes[topology.edges[e].first + topology.edges[e].count++] = h; });
}

// The quads round every boundary node must be one fan.
bool manifold_at_nodes(const HexComplex& complex, const HexTopology& topology) {
  const int n = 4 * static_cast<int>(complex.quads.size());
  std::vector<int> parent(n);
  for (int i = 0; i < n; ++i) parent[i] = i;
  const auto find = [&](int i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  };
  const auto corner = [&](int q, int v) {
    const auto& nodes = complex.quads[q];
    return 4 * q + static_cast<int>(std::find(nodes.begin(), nodes.end(), v) - nodes.begin());
  };
  for (const auto& e : topology.edges)
    for (int v : e.nodes) parent[find(corner(e.quads[0], v))] = find(corner(e.quads[1], v));
  std::vector<int> fan(complex.points.size(), -1);
  for (int i = 0; i < n; ++i) {
    int& f = fan[complex.quads[i / 4][i % 4]];
    if (f >= 0 && f != find(i)) return false;
    f = find(i);
  }
  return true;
}

}  // namespace

const HexTopology::Edge* HexTopology::find_edge(int a, int b) const {
  const std::array<int, 2> key = ordered(a, b);
  if (key[0] < 0 || key[0] + 1 >= static_cast<int>(first_edge.size())) return nullptr;
  for (int e = first_edge[key[0]]; e < first_edge[key[0] + 1]; ++e)
    if (edges[e].nodes[1] == key[1]) return &edges[e];
  return nullptr;
}

HexTopology make_topology(const HexComplex& complex, const Context& context) {
  HexTopology topology;
  match_sides(complex, topology, context);
  collect_edges(complex, topology, context);
  return topology;
}

std::string check_complex(const HexComplex& complex, const Context& context) {
  if (complex.quad_chart.size() != complex.quads.size() || complex.quad_face.size() != complex.quads.size())
    return "quads without a chart or CAD face entry";
  if (complex.place.size() != complex.points.size()) return "nodes without a CAD place entry";
  if (complex.hex_block.size() != complex.hexes.size() || complex.hex_solid.size() != complex.hexes.size())
    return "hexahedra without a block or solid entry";
  if (complex.feature_edge_cad.size() != complex.feature_edges.size()) return "feature edges without a CAD edge entry";
  for (auto nodes : complex.hexes) {
    std::sort(nodes.begin(), nodes.end());
    if (nodes.front() < 0 || nodes.back() >= complex.point_count()) return "a hexahedron with a node that does not exist";
    if (std::adjacent_find(nodes.begin(), nodes.end()) != nodes.end()) return "a hexahedron with a repeated node";
  }
  HexTopology topology;
  try {
    topology = make_topology(complex, context);
  } catch (const MeshingError& e) {
    if (e.kind == Failure::Cancelled) throw;
    return e.reason;
  }
  if (!manifold_at_nodes(complex, topology)) return "the boundary is not a manifold at a node";
  std::vector<char> use(complex.points.size(), 0);
  for (const auto& h : complex.hexes)
    for (int v : h) use[v] = 1;
  for (const auto& q : complex.quads)
    for (int v : q) use[v] = 2;
  for (int v = 0; v < complex.point_count(); ++v) {
    if (!use[v]) return "a node without a hexahedron";
    if ((use[v] == 2) != (complex.place[v].dim < 3)) return "CAD places and the boundary disagree";
    if (!complex.shape_place.empty() && (use[v] == 2) != (complex.shape_place[v].dim < 3)) return "shape places and the boundary disagree";
  }
  for (const auto& e : complex.feature_edges)
    if (e[0] >= e[1] || !topology.find_edge(e[0], e[1])) return "a feature edge that is no boundary edge";
  if (!std::is_sorted(complex.feature_edges.begin(), complex.feature_edges.end())) return "feature edges out of order";
  return {};
}

}  // namespace hexfeature
