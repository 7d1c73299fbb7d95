// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include <array>
#include <string>
#include <vector>

#include "base/context.h"
#include "mesh/surface_mesh.h"

namespace hexfeature {

/// A tetrahedral mesh whose boundary is a given surface mesh; that mesh's points come first, with the same numbers.
struct TetMesh {
  std::vector<Vec3> points;
  std::vector<std::array<int, 4>> tets;  ///< det(p1 - p0, p2 - p0, p3 - p0) > 0
};

/// The six edges of a tetrahedron, each with the opposite edge beside it.
inline constexpr std::array<std::array<int, 4>, 6> kTetEdges{
    {{0, 1, 2, 3}, {0, 2, 3, 1}, {0, 3, 1, 2}, {1, 2, 0, 3}, {1, 3, 2, 0}, {2, 3, 0, 1}}};
/// The four faces, outward; the corner that face i does not have is i.
inline constexpr std::array<std::array<int, 3>, 4> kTetFaces{{{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};

struct TetOptions {
  double longest = 1;    ///< edge length inside, at most
  double grading = 0.3;  ///< Netgen's: 0 uniform, 1 coarse
  std::string program;   ///< the program that runs Netgen; empty: `hexfeature-netgen` beside this library
};

/// Fill a closed surface with tetrahedra, with Netgen (J. Schöberl, "NETGEN An advancing front 2D/3D-mesh generator based on abstract
/// rules", Computing and Visualization in Science 1, 1997). It runs as a process of its own: it has global state, cannot be asked
/// to stop, writes to standard output, and may crash on a bad surface. Cancelling kills it.
/// Throws MeshingError(NoMesh, "tetrahedra") when it gives up, crashes or is not installed.
TetMesh fill_with_tetrahedra(const SurfaceMesh& surface, const TetOptions& options, Context& context);

double tet_volume(const std::vector<Vec3>& points, const std::array<int, 4>& tet);

}  // namespace hexfeature
