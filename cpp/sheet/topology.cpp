// HexFeatureWB - LGPL-2.1-or-later
#include "sheet/topology.h"

#include <algorithm>
#include <string>

#include "base/error.h"

namespace hexfeature {
namespace {

[[noreturn]] void fail(const char* reason) {
  throw MeshingError(Failure::NoMesh, "sheet", reason, "the hexahedral complex is damaged; please report this part");
}

std::array<int, 2> ordered(int a, int b) { return a < b ? std::array<int, 2>{a, b} : std::array<int, 2>{b, a}; }

struct FaceKey {
  std::array<int, 4> nodes;  // sorted
  int item;                  // side, or quad
};

bool operator<(const FaceKey& a, const FaceKey& b) { return a.nodes != b.nodes ? a.nodes < b.nodes : a.item < b.item; }

std::vector<FaceKey> side_keys(const HexComplex& complex) {
  std::vector<FaceKey> keys(6 * complex.hexes.size());
  for (int h = 0; h < complex.hex_count(); ++h)
    for (int f = 0; f < 6; ++f) {
      FaceKey& k = keys[6 * h + f];
      for (int i = 0; i < 4; ++i) k.nodes[i] = complex.hexes[h][kHexFaces[f][i]];
      std::sort(k.nodes.begin(), k.nodes.end());
      k.item = 6 * h + f;
    }
  std::sort(keys.begin(), keys.end());
  return keys;
}

void match_faces(const HexComplex& complex, HexTopology& topology) {
  const std::vector<FaceKey> sides = side_keys(complex);
  std::vector<FaceKey> quads(complex.quads.size());
  for (std::size_t q = 0; q < quads.size(); ++q) {
    quads[q] = {complex.quads[q], static_cast<int>(q)};
    std::sort(quads[q].nodes.begin(), quads[q].nodes.end());
  }
  std::sort(quads.begin(), quads.end());
  topology.neighbour.assign(sides.size(), 0);
  topology.quad_side.assign(quads.size(), -1);
  std::size_t next_quad = 0;
  for (std::size_t i = 0; i < sides.size();) {
    std::size_t j = i + 1;
    while (j < sides.size() && sides[j].nodes == sides[i].nodes) ++j;
    if (j - i > 2) fail("a face belongs to more than two hexahedra");
    if (j - i == 2) {
      topology.neighbour[sides[i].item] = sides[i + 1].item;
      topology.neighbour[sides[i + 1].item] = sides[i].item;
    } else {
      if (next_quad >= quads.size() || quads[next_quad].nodes != sides[i].nodes) fail("the boundary quads are not the complex's boundary");
      topology.neighbour[sides[i].item] = -1 - quads[next_quad].item;
      topology.quad_side[quads[next_quad].item] = sides[i].item;
      ++next_quad;
    }
    i = j;
  }
  if (next_quad != quads.size()) fail("the boundary quads are not the complex's boundary");
}

void collect_edges(const HexComplex& complex, HexTopology& topology) {
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
  topology.edges.reserve(halves.size() / 2);
  for (std::size_t i = 0; i < halves.size(); i += 2) {
    if (i + 1 >= halves.size() || halves[i].nodes != halves[i + 1].nodes || !halves[i].forward || halves[i + 1].forward ||
        (i + 2 < halves.size() && halves[i + 2].nodes == halves[i].nodes))
      fail("the boundary is not an oriented manifold");
    topology.edges.push_back({halves[i].nodes, {halves[i].quad, halves[i + 1].quad}, 0, 0});
  }
  std::vector<char> on_boundary(complex.points.size(), 0);
  for (const auto& q : complex.quads)
    for (int v : q) on_boundary[v] = 1;
  struct Use {
    std::array<int, 2> nodes;
    int hex;
  };
  std::vector<Use> uses;
  for (int h = 0; h < complex.hex_count(); ++h)
    for (const auto& e : kHexEdges) {
      const int a = complex.hexes[h][e[0]], b = complex.hexes[h][e[1]];
      if (on_boundary[a] && on_boundary[b]) uses.push_back({ordered(a, b), h});
    }
  std::sort(uses.begin(), uses.end(), [](const Use& a, const Use& b) { return a.nodes != b.nodes ? a.nodes < b.nodes : a.hex < b.hex; });
  std::size_t u = 0;
  for (auto& e : topology.edges) {
    while (u < uses.size() && uses[u].nodes < e.nodes) ++u;
    e.first = static_cast<int>(topology.edge_hexes.size());
    for (; u < uses.size() && uses[u].nodes == e.nodes; ++u) topology.edge_hexes.push_back(uses[u].hex);
    e.count = static_cast<int>(topology.edge_hexes.size()) - e.first;
  }
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

bool same_cycle(const std::array<int, 4>& a, const std::array<int, 4>& b) {
  for (int s = 0; s < 4; ++s)
    if (a[0] == b[s] && a[1] == b[(s + 1) % 4] && a[2] == b[(s + 2) % 4] && a[3] == b[(s + 3) % 4]) return true;
  return false;
}

std::array<int, 4> side_nodes(const HexComplex& complex, int side) {
  std::array<int, 4> nodes;
  for (int i = 0; i < 4; ++i) nodes[i] = complex.hexes[side / 6][kHexFaces[side % 6][i]];
  return nodes;
}

}  // namespace

const HexTopology::Edge* HexTopology::find_edge(int a, int b) const {
  const std::array<int, 2> key = ordered(a, b);
  const auto it = std::lower_bound(edges.begin(), edges.end(), key, [](const Edge& e, const std::array<int, 2>& k) { return e.nodes < k; });
  return it != edges.end() && it->nodes == key ? &*it : nullptr;
}

HexTopology make_topology(const HexComplex& complex) {
  HexTopology topology;
  match_faces(complex, topology);
  collect_edges(complex, topology);
  return topology;
}

std::string check_complex(const HexComplex& complex) {
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
    topology = make_topology(complex);
  } catch (const MeshingError& e) {
    return e.reason;
  }
  for (int s = 0; s < static_cast<int>(topology.neighbour.size()); ++s) {
    const int other = topology.neighbour[s];
    auto mine = side_nodes(complex, s), theirs = other >= 0 ? side_nodes(complex, other) : complex.quads[-1 - other];
    if (other >= 0) std::reverse(theirs.begin(), theirs.end());
    if (!same_cycle(mine, theirs)) return other >= 0 ? "neighbouring hexahedra are oriented against each other" : "a quad faces inward";
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
