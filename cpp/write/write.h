// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include <array>
#include <string>
#include <vector>

#include "mesh/hex_complex.h"

namespace hexfeature {

/// What a writer is given: a complex in world coordinates and, for second order, its 20-node hexahedra and 8-node
/// quads (VTK node order, as many as `mesh.hexes` and `mesh.quads`; the mid-side nodes stand in `mesh.points`).
/// Holds references only.
struct MeshView {
  const HexComplex& mesh;
  const std::vector<std::array<int, 20>>& hexes20;  ///< empty: first order
  const std::vector<std::array<int, 8>>& quads8;
  std::vector<std::string> solid_names = {};  ///< one a solid, as the part's file has them, empty where it has none; or no list

  bool second_order() const { return !hexes20.empty(); }
};

struct WriteOptions {
  std::string element_type;  ///< .inp: C3D8 (default), C3D8R, C3D8I; second order: C3D20R (default), C3D20
};

/// Solids (1-based) of one name, as a group: letters, digits, '_', '-' alone, other characters as '_', at most 64; never a name
/// that the writers give themselves (SolidN, FaceN, EdgeN, VertexN, Nall, Eall).
struct NamedSolids {
  std::string name;
  std::vector<int> solids;
};
std::vector<NamedSolids> named_solids(const std::vector<std::string>& solid_names);

/// Write by the path's ending: .vtk .inp .unv. Every writer below gathers the file under a temporary name in the same
/// folder and renames it when it is complete: there is never a half-written file, and a file that was there before stays
/// when the writing fails. They throw MeshingError(Output, "write") with the system's reason (no such folder, not allowed,
/// disk full), and MeshingError(Usage, "write") for an ending or element type that is not known.
void write_mesh(const MeshView& view, const std::string& path, const WriteOptions& options = {});

/// Legacy VTK, binary, double precision: the hexahedra (cell type 12 or 25), then the boundary quadrilaterals (9 or 23).
/// Cell arrays (int): `cad_face`, 0 on hexahedra, on quads the 1-based CAD face; `cad_solid`, 1-based.
/// Point arrays (int): `cad_dim` and `cad_entity`, where the node lies (CadPlace), when the complex knows it.
void write_vtk(const MeshView& view, const std::string& path);

/// Abaqus / CalculiX input: nodes, elements (set SolidN, and a set by the solid's name), node sets FaceN, EdgeN, VertexN and element
/// surfaces FaceN by CAD number. Numbers keep to 20 characters, which is all that CalculiX reads of one: 13 significant digits at least.
void write_inp(const MeshView& view, const std::string& path, const WriteOptions& options = {});

/// I-DEAS universal file: datasets 164 (unit), 2411 (nodes), 2412 (bricks 115/116, quads 94/95), 2467 (groups: FaceN of
/// quads, SolidN of bricks and again by the solid's name, EdgeN and VertexN of nodes).
void write_unv(const MeshView& view, const std::string& path);

/// Endings that `write_mesh` knows, with the dot.
const std::vector<std::string>& writable_endings();

}  // namespace hexfeature
