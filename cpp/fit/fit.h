// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include <vector>

#include "base/context.h"
#include "mesh/geometry.h"
#include "mesh/hex_complex.h"
#include "shape/feature_shape.h"

namespace hexfeature {

struct FitOptions {
  double size = 1;            ///< element size h
  double corner_snap = 1.1;   ///< a hard CAD vertex within this many h along an arc attracts the corner (experiments B4)
  bool inner_edges = true;    ///< follow CAD edges that run inside charts
  bool smooth_edges = true;   ///< ... also tangent ones where a cheap path exists
  bool free_turns = false;    ///< a sharp CAD edge that no path follows otherwise may be followed by one that turns where the curve does
                              ///< not: the quads there have flat corners until a sheet takes these away (find_sheet_groups)
  std::vector<int> insisted;  ///< CAD edges (1-based, sorted), sharp or not, that may be followed by a path with any turns to both sides
  std::vector<int> released;  ///< CAD edges (1-based, sorted) that need not be followed where they run inside a chart
};

/// Boundary fitting: place the lattice's nodes on the part (corners, arcs by length, charts by a fold-free 2D map onto the
/// chart's triangles, then onto the true surface), follow the CAD edges that run inside charts by mesh edges, give every
/// boundary node its CadPlace and every quad its CAD face, and set inner nodes harmonically. Changes `complex` in place.
/// Returns the number of CAD edges followed with free turns.
int fit_boundary(HexComplex& complex, const SurfaceMesh& mesh, const FeatureShape& shape, const Geometry& geometry,
                 const FitOptions& options, Context& context);

/// Harmonic (Laplace) positions for nodes of dimension 3 with the boundary held.
void fit_interior(HexComplex& complex, Context& context);

}  // namespace hexfeature
