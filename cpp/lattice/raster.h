// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "base/context.h"
#include "polycube/polycube.h"
#include "shape/feature_shape.h"

namespace hexfeature {

/// A side of a chart's rectilinear polygon, in the chart's own two axes a = (c+1)%3, b = (c+2)%3 (c the chart's axis).
struct PolygonSide {
  int along = 0;       ///< the axis it runs along (a or b)
  int at = 0;          ///< its coordinate on the other one
  int lo = 0, hi = 0;  ///< its extent
  int direction = 1;   ///< +1: from lo to hi with the chart on its left, seen from outside the solid
  int chart = -1;      ///< the chart across
  int arc = -1;
};

/// A unit square of a chart, at position `cell` (cell[c] is the chart's coordinate, the others are its lower corner).
struct ChartCell {
  std::uint64_t key = 0;  ///< see LatticeGrid::face_key
  int chart = -1;
};

/// The polycube's bounding grid: numbering of its cells, nodes and unit faces.
struct LatticeGrid {
  std::array<int, 3> n{0, 0, 0};  ///< cells along each axis

  std::size_t cell(int x, int y, int z) const { return (static_cast<std::size_t>(z) * n[1] + y) * n[0] + x; }
  std::size_t node(int x, int y, int z) const { return (static_cast<std::size_t>(z) * (n[1] + 1) + y) * (n[0] + 1) + x; }
  std::size_t node(const std::array<int, 3>& p) const { return node(p[0], p[1], p[2]); }
  std::size_t cell_count() const { return static_cast<std::size_t>(n[0]) * n[1] * n[2]; }
  std::size_t node_count() const { return static_cast<std::size_t>(n[0] + 1) * (n[1] + 1) * (n[2] + 1); }
  /// Number of the unit face normal to `axis` at p, so that the faces of one column along `axis` are consecutive.
  std::uint64_t face_key(int axis, const std::array<int, 3>& p) const {
    const int a = (axis + 1) % 3, b = (axis + 2) % 3;
    return (static_cast<std::uint64_t>(p[b]) * n[a] + p[a]) * (n[axis] + 1) + p[axis];
  }
  std::array<int, 3> face_position(int axis, std::uint64_t key) const {
    const int a = (axis + 1) % 3, b = (axis + 2) % 3;
    std::array<int, 3> p;
    p[axis] = static_cast<int>(key % (n[axis] + 1));
    key /= n[axis] + 1;
    p[a] = static_cast<int>(key % n[a]);
    p[b] = static_cast<int>(key / n[a]);
    return p;
  }
};

/// Two charts that are in each other's way at a place of the lattice (a cell's lower corner).
struct Clash {
  int first = -1, second = -1;
  std::array<int, 3> at{0, 0, 0};
};

/// Every chart's polygon as sides and as unit squares.
struct Raster {
  LatticeGrid grid;
  std::vector<std::vector<PolygonSide>> sides;  ///< per chart
  std::array<std::vector<ChartCell>, 3> cells;  ///< per axis, sorted by key (duplicates kept)
  std::vector<Clash> overlaps;                  ///< charts across sides of one polygon that overlap, cross or touch
  std::vector<int> bad_charts;                  ///< whose polygon is not simple
};

/// The grid that holds all corners.
LatticeGrid bounding_grid(const Polycube& polycube);

/// Rasterise the polygons by winding number. A polygon is good when its winding numbers are 0 and 1 and every side has the
/// chart on its left only.
Raster rasterise(const FeatureShape& shape, const Polycube& polycube, Context& context);

/// The chart that bounds another one at a place, and where on the part: the position along the axis of the arc between them.
struct Bound {
  int chart = -1;
  double position = 0;
};
/// The chart across the nearest side of `chart`'s polygon from place `at`, looking along +axis (direction +1) or -axis; the
/// chart itself on its own axis; chart -1 when there is none.
Bound bound_beside(const FeatureShape& shape, const Raster& raster, int chart, const std::array<int, 3>& at, int axis, int direction);

}  // namespace hexfeature
