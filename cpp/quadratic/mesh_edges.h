// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include <array>
#include <vector>

#include "mesh/hex_complex.h"

namespace hexfeature {

/// Every edge of a complex, once: each carries one mid-side node.
struct MeshEdges {
  std::vector<std::array<int, 2>> nodes;    ///< smaller node first, sorted
  std::vector<std::array<int, 12>> of_hex;  ///< edges of each hexahedron, in kHexEdges order
  std::vector<std::array<int, 4>> of_quad;  ///< edges of each boundary quad; edge k joins its corners k and k + 1
  std::vector<int> first;                   ///< per point, and one more: the first edge whose smaller node is that point or a later one
  int count() const { return static_cast<int>(nodes.size()); }
  /// The edge between two nodes, which must exist.
  int find(int a, int b) const;
};

/// Linear time: edges are bucketed by their smaller node.
MeshEdges number_edges(const HexComplex& complex, const Context& context = {});

}  // namespace hexfeature
