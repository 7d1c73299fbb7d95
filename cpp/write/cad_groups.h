// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include <array>
#include <vector>

#include "write/write.h"

namespace hexfeature {

/// The items (0-based nodes, quads or hexahedra, ascending) that belong to one CAD entity (1-based number).
struct CadGroup {
  int number = 0;
  std::vector<int> items;
};

/// Everything of a mesh by CAD entity; groups in ascending number, none empty. Mid-side nodes belong to their group too.
struct CadGroups {
  std::vector<CadGroup> face_quads, face_nodes, edge_nodes, vertex_nodes, solid_hexes;
};
CadGroups group_by_cad(const MeshView& view);

/// Per quad the hexahedron that it bounds and that hexahedron's local face (kHexFaces); {-1, -1} when there is none.
std::vector<std::array<int, 2>> sides_of_quads(const HexComplex& mesh);

}  // namespace hexfeature
