// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include "base/context.h"
#include "mesh/surface_mesh.h"
#include "tetsplit/tetrahedra.h"

namespace hexfeature {

/// A tetrahedron with two boundary faces side by side on smooth surface opens to a straight angle there once its new nodes lie
/// on the surface: split the edge opposite to theirs, so that the two get tetrahedra of their own. Where that edge is on the boundary
/// too it stays. Returns the number of edges split. Volumes stay positive.
int relieve_boundary(TetMesh& mesh, const SurfaceMesh& surface, Context& context);

}  // namespace hexfeature
