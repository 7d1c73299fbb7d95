// HexFeatureWB - LGPL-2.1-or-later
#include "quadratic/mesh_edges.h"

#include <algorithm>

#include "mesh/buckets.h"

namespace hexfeature {

int MeshEdges::find(int a, int b) const {
  int e = first[std::min(a, b)];
  while (nodes[e][1] != std::max(a, b)) ++e;
  return e;
}

MeshEdges number_edges(const HexComplex& complex, const Context& context) {
  MeshEdges edges;
  const int n = complex.point_count();
  const auto end_of = [&](int side, int which) { return complex.hexes[side / 12][kHexEdges[side % 12][which]]; };
  const Buckets by_node(n, 12 * complex.hex_count(), [&](int side) { return std::min(end_of(side, 0), end_of(side, 1)); });
  edges.first.assign(n + 1, 0);
  std::vector<int> others;
  for (int v = 0; v < n; ++v) {
    if (v % 8192 == 0) context.check();
    others.clear();
    for (int i = by_node.start[v]; i < by_node.start[v + 1]; ++i)
      others.push_back(std::max(end_of(by_node.item[i], 0), end_of(by_node.item[i], 1)));
    std::sort(others.begin(), others.end());
    others.erase(std::unique(others.begin(), others.end()), others.end());
    for (int other : others) edges.nodes.push_back({v, other});
    edges.first[v + 1] = edges.count();
  }
  edges.of_hex.resize(complex.hexes.size());
  for (std::size_t h = 0; h < complex.hexes.size(); ++h) {
    if (h % 16384 == 0) context.check();
    for (int e = 0; e < 12; ++e) edges.of_hex[h][e] = edges.find(complex.hexes[h][kHexEdges[e][0]], complex.hexes[h][kHexEdges[e][1]]);
  }
  edges.of_quad.resize(complex.quads.size());
  for (std::size_t q = 0; q < complex.quads.size(); ++q)
    for (int k = 0; k < 4; ++k) edges.of_quad[q][k] = edges.find(complex.quads[q][k], complex.quads[q][(k + 1) % 4]);
  return edges;
}

}  // namespace hexfeature
