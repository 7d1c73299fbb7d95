// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include <vector>

#include "mesh/surface_mesh.h"

namespace hexfeature {

/// Join every site that is under `least_share` of its CAD face and under `least_area` to the neighbour in its face with the
/// longest common border, the smallest site first, until none is left that has such a neighbour. Sites are renumbered
/// 0..n-1 in order of their first triangle. `face_area`: per CAD face (index = its 1-based number).
void merge_small_sites(const SurfaceMesh& mesh, const std::vector<double>& face_area, double least_share, double least_area,
                       std::vector<int>& site);

}  // namespace hexfeature
