// HexFeatureWB - LGPL-2.1-or-later
#include "quadratic/mesh_edges.h"

#include <algorithm>

namespace hexfeature {

int MeshEdges::find(int a, int b) const {
  const std::array<int, 2> key{std::min(a, b), std::max(a, b)};
  return static_cast<int>(std::lower_bound(nodes.begin(), nodes.end(), key) - nodes.begin());
}

MeshEdges number_edges(const HexComplex& complex) {
  MeshEdges edges;
  edges.nodes.reserve(12 * complex.hexes.size());
  for (const auto& h : complex.hexes)
    for (const auto& e : kHexEdges) edges.nodes.push_back({std::min(h[e[0]], h[e[1]]), std::max(h[e[0]], h[e[1]])});
  std::sort(edges.nodes.begin(), edges.nodes.end());
  edges.nodes.erase(std::unique(edges.nodes.begin(), edges.nodes.end()), edges.nodes.end());
  edges.of_hex.resize(complex.hexes.size());
  for (std::size_t h = 0; h < complex.hexes.size(); ++h)
    for (int e = 0; e < 12; ++e) edges.of_hex[h][e] = edges.find(complex.hexes[h][kHexEdges[e][0]], complex.hexes[h][kHexEdges[e][1]]);
  edges.of_quad.resize(complex.quads.size());
  for (std::size_t q = 0; q < complex.quads.size(); ++q)
    for (int k = 0; k < 4; ++k) edges.of_quad[q][k] = edges.find(complex.quads[q][k], complex.quads[q][(k + 1) % 4]);
  return edges;
}

}  // namespace hexfeature
