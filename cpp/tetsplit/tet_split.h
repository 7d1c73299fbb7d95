// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "base/context.h"
#include "mesh/geometry.h"
#include "mesh/hex_complex.h"
#include "mesh/surface_mesh.h"
#include "smooth/smooth.h"
#include "tetsplit/remesh.h"
#include "tetsplit/size_field.h"
#include "tetsplit/tetrahedra.h"

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

/// A surface of triangles as long as the tetrahedra want them, and these.
struct FilledSurface {
  SurfaceMesh triangles;
  std::vector<int> pinned;  ///< points of it where tips were cut
  TetMesh tets;
};

/// What the method begins with: it takes nothing from other methods, so that it may be made while one of these is at work. Looks at the
/// geometry for as long as it lives: when it is used, that must be where it was. Either `first` or `failure` is there.
struct TetSplitStart {
  Remesher surface;   ///< no edge much longer than h
  SizeField lengths;  ///< of the triangles' edges
  std::optional<FilledSurface> first;
  std::optional<MeshingError> failure;  ///< why it could not be filled (NoMesh)
};

/// Of one solid's surface mesh.
TetSplitStart begin_tet_split(const SurfaceMesh& surface, const Geometry& geometry, const TetSplitOptions& options, Context& context);

/// The tet-split method (design 4.3) on one solid's surface mesh: remesh the surface to the lengths that features ask for, fill it
/// with tetrahedra, split each into four hexahedra, bring the new nodes onto the CAD and smooth; where elements stay bad, refine
/// there and begin again. All CAD edges, sharp and smooth, are followed. Returns the best attempt, all of whose elements are positive.
/// Throws MeshingError(NoMesh) with the step that failed. `start`: made with the same geometry and options.
HexComplex tet_split(TetSplitStart start, const Geometry& geometry, const TetSplitOptions& options, Context& context,
                     TetSplitReport& report);

}  // namespace hexfeature
