// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include "mesh/geometry.h"
#include "mesh/hex_complex.h"

namespace hexfeature {

/// A sheet's new quads carry the CAD face of the quad that made room for them, which need not be the one that they lie on: where a sheet
/// comes out beside a sharp CAD edge whose two faces go over smoothly into others, it may be one of the others. A quad that no side of its
/// own puts right, with one on a mesh edge along a sharp CAD edge whose other quad lies on one of the edge's faces, takes the other face;
/// not where two sides disagree, nor the last quad of a face. Returns the number of quads changed.
int face_quads_at_sharp_edges(HexComplex& complex, const Geometry& geometry);

}  // namespace hexfeature
