// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include "mesh/hex_complex.h"

namespace hexfeature {

/// The elements at the boundary, where stresses are read: how square they stand on the surface, how thick they are, how flat their quads.
struct SkinReport {
  double mean_lean = 0, max_lean = 0;            ///< degrees between a boundary quad's normal and the inner edges at its corners; 0 is best
  double min_thickness = 0, mean_thickness = 0;  ///< length: from a boundary quad's middle to the opposite face's, along the quad's normal
  double max_warp = 0;                           ///< degrees: largest angle between the normals at a quad's corners and its own
  double warped = 0;                             ///< fraction of the boundary quads with more than 15 degrees of it
};
/// Edges that lie on the boundary themselves do not count as inner ones: at a sharp edge of the part they say nothing of the mesh.
SkinReport measure_skin(const HexComplex& complex, const Context& context = {});

}  // namespace hexfeature
