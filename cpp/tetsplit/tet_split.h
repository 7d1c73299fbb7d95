// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include <string>

#include "base/context.h"
#include "mesh/geometry.h"
#include "mesh/hex_complex.h"
#include "mesh/surface_mesh.h"
#include "smooth/smooth.h"

namespace hexfeature {

struct TetSplitOptions {
  double size = 1;            ///< element size h
  int attempts = 5;           ///< at most so many: finer where the first one was bad, then coarser and finer everywhere
  double good_enough = 0.15;  ///< least scaled Jacobian at which no further attempt is made
  int threads = 2;
  std::string netgen;  ///< see TetOptions::program
};

struct TetSplitReport {
  int attempts = 0, triangles = 0, tetrahedra = 0;
  SmoothReport smoothing;  ///< of the mesh returned
};

/// The tet-split method (design 4.3) on one solid's surface mesh: remesh the surface to the lengths that features ask for, fill it
/// with tetrahedra, split each into four hexahedra, bring the new nodes onto the CAD and smooth; where elements stay bad, refine
/// there and begin again. All CAD edges, sharp and smooth, are followed. Returns the best attempt, all of whose elements are positive.
/// Throws MeshingError(NoMesh) with the step that failed.
HexComplex tet_split(const SurfaceMesh& surface, const Geometry& geometry, const TetSplitOptions& options, Context& context,
                     TetSplitReport& report);

}  // namespace hexfeature
