// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include <array>
#include <string>
#include <vector>

#include "mesh/hex_complex.h"

namespace hexfeature {

/// Neighbours in a hexahedral complex, as flat arrays. A *side* is 6 * hex + local face.
struct HexTopology {
  struct Edge {
    std::array<int, 2> nodes;  ///< smaller first
    std::array<int, 2> quads;  ///< the two boundary quads that meet here; quads[0] runs nodes[0] -> nodes[1]
    int first = 0, count = 0;  ///< its hexahedra: edge_hexes[first .. first + count)
  };
  std::vector<int> neighbour;   ///< per side: the side on the other hexahedron, or -1 - q for boundary quad q
  std::vector<int> quad_side;   ///< per boundary quad: its side
  std::vector<Edge> edges;      ///< boundary edges, sorted by nodes
  std::vector<int> first_edge;  ///< per point, and one more: the first edge whose smaller node is that point or a later one
  std::vector<int> edge_hexes;  ///< see Edge

  const Edge* find_edge(int a, int b) const;  ///< null when (a, b) is no boundary edge
  int hex_of_quad(int q) const { return quad_side[q] / 6; }
};

/// Throws MeshingError(NoMesh, "sheet") when faces do not match in pairs from opposite sides, the single ones are not exactly `quads`,
/// outward, or a boundary edge has not two quads. Requires node indices within range. Linear time but for sorting the boundary's edges.
HexTopology make_topology(const HexComplex& complex, const Context& context = {});

/// Empty when `complex` is a conforming complex: hexahedra of eight different nodes; faces shared by at most two, from opposite
/// sides; single ones exactly `quads`, oriented outward; boundary a closed manifold at edges and nodes; arrays of the right
/// lengths; boundary nodes, and they alone, with a place on the CAD and on the feature shape. Else what is wrong.
std::string check_complex(const HexComplex& complex, const Context& context = {});

}  // namespace hexfeature
