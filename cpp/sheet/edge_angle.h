// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include "mesh/geometry.h"
#include "sheet/topology.h"

namespace hexfeature {

/// Angle in the solid between the two boundary quads at a boundary edge, as they lie now: degrees in [0, 360);
/// 90 on a convex box edge, 180 flat, 270 in a corner of a pocket.
double solid_angle(const HexComplex& complex, const HexTopology::Edge& edge);

/// Angle of boundary quad q at its corner i, degrees in [0, 360), in the plane that its two edges and its normal span.
double corner_angle(const HexComplex& complex, int q, int i);

/// CAD edge that the mesh edge (a, b) follows, 1-based; 0: none.
int feature_of(const HexComplex& complex, int a, int b);

}  // namespace hexfeature
