// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include <vector>

#include "mesh/geometry.h"
#include "mesh/surface_mesh.h"

namespace hexfeature {

/// What makes a site too small to be one.
struct LeastSite {
  double share = 0, area = 0;         ///< less than this share of its CAD face and than this area ...
  double strip_share = 0, width = 0;  ///< ... or less than this share, on the mean narrower than this, and along a tangent CAD edge
};

/// Join every site that is too small to the neighbour in its face with the longest common border, the smallest site first, until none is
/// left that has such a neighbour. Sites are renumbered 0..n-1 in order of their first triangle. `face_area`, `tip`: per CAD face (index =
/// its 1-based number); on a tip (Strips::tip) narrow strips stay.
void merge_small_sites(const SurfaceMesh& mesh, const std::vector<double>& face_area, const Geometry& geometry,
                       const std::vector<char>& tip, const LeastSite& least_site, std::vector<int>& site);

}  // namespace hexfeature
