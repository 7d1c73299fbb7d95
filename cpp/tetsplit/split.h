// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include "mesh/geometry.h"
#include "mesh/hex_complex.h"
#include "mesh/surface_mesh.h"
#include "tetsplit/tetrahedra.h"

namespace hexfeature {

/// Every tetrahedron into four hexahedra, one at each corner, by the middles of its edges, faces and volume:
///
///            d                       hexahedron at a:   a  ab abc ac   (bottom)
///           /|\                                         ad abd  o acd  (top)
///          / | \         ab: middle of the edge a b, abc: of the face, o: of the volume
///         a--|--c
///          \ | /         The map of each is affine in each direction and its Jacobian determinant positive wherever the
///           \|/          tetrahedron's is: the mesh is valid as it leaves, with all new nodes on the flat triangles.
///            b
///
/// Boundary nodes get their CadPlace (those in the middle of an edge or face of the surface are not on the CAD yet), quads their
/// CAD face, and mesh edges along CAD edges their number.
HexComplex split_tetrahedra(const TetMesh& mesh, const SurfaceMesh& surface, const Geometry& geometry, const Context& context = {});

}  // namespace hexfeature
