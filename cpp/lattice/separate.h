// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include <vector>

#include "lattice/raster.h"

namespace hexfeature {

/// Order constraints that would keep clashing charts apart. Two charts clash at a place; on each axis either may come first:
/// the charts that bound them there (themselves on their own axis) must then be at least one apart. Taken is the axis and
/// order in which the part itself separates them most, by arcs and centroids (design 3.5, lazy separation),
/// of those that the arcs allow and that are not in `tried` (sorted) already. Best shown first, each once; at most `limit`.
std::vector<Separation> separations_for(const FeatureShape& shape, const Polycube& polycube, const Raster& raster,
                                        const std::vector<Clash>& clashes, const std::vector<Separation>& tried, int limit = 200);

}  // namespace hexfeature
