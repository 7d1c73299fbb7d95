// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include <array>
#include <functional>
#include <vector>

#include "base/context.h"
#include "base/types.h"
#include "mesh/surface_mesh.h"

namespace hexfeature {

/// A region of the surface mesh laid onto its piece of the lattice plane.
struct RegionMap {
  std::vector<Vec3> points;                   ///< on the part (the region's own copies: a slit has two sides)
  std::vector<Vec2> flat;                     ///< in lattice units
  std::vector<std::array<int, 3>> triangles;  ///< some mesh triangles are split
  std::vector<int> source;                    ///< per triangle: the mesh triangle it is part of
  int folded = 0;                             ///< triangles with a non-positive image

  struct Location {
    int triangle = -1;  ///< of `triangles`
    Vec3 weight = Vec3::Zero();
  };
  /// The triangle whose image holds q; the nearest one when none does.
  Location locate(const Vec2& q) const;
  Vec3 point_at(const Location& l) const {
    const auto& v = triangles[l.triangle];
    return l.weight[0] * points[v[0]] + l.weight[1] * points[v[1]] + l.weight[2] * points[v[2]];
  }

  void build_grid();  ///< for locate; after `flat` is final

 private:
  Vec2 origin_ = Vec2::Zero();
  std::array<int, 2> cells_{0, 0};
  std::vector<int> cell_begin_, cell_items_;
};

/// Lay `triangles` (connected, cut along the halfedges with `border_of` set) onto the plane: harmonic with the border held at
/// `border_position(h)` = image of the start of border halfedge h (W. T. Tutte 1963; cotangent weights clipped to stay
/// positive, so that convex pieces never fold), then untangled where a non-convex piece folds.
/// Inner edges between two border vertices are split, since both ends may lie on one straight side.
/// Writes the image of every mesh corner (3 per triangle) into `corner_flat`.
RegionMap map_region(const SurfaceMesh& mesh, const std::vector<int>& triangles, const std::vector<int>& border_of,
                     const std::function<Vec2(int)>& border_position, std::vector<Vec2>& corner_flat, const Context& context);

}  // namespace hexfeature
