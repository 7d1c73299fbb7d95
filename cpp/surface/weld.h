// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include "mesh/surface_mesh.h"
#include "surface/triangle_files.h"

namespace hexfeature {

/// A closed oriented mesh (points, triangles, opposite) from triangles as read: points welded (exactly, and within a
/// millionth of the diagonal when that leaves gaps), degenerate and doubled triangles dropped, neighbours turned alike, each shell
/// outward (voids inward). Throws MeshingError(BadInput, "read") naming the number of open or crowded edges.
SurfaceMesh weld(const TriangleSoup& soup);

}  // namespace hexfeature
