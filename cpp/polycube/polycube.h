// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include <array>
#include <vector>

#include "base/context.h"
#include "shape/feature_shape.h"

namespace hexfeature {

struct QuantizeOptions {
  double size = 1;           ///< element size h
  int minimum_intervals = 1; ///< least |delta u| along an arc
  int rays = 4000;           ///< sample rays for order and gap constraints (deterministic)
};

/// The recognition model: the feature shape with integer, axis-aligned coordinates. A chart of label l lies on the
/// plane x[axis(l)] = coordinate; a corner takes one coordinate from a chart of each axis.
struct Polycube {
  std::vector<int> coordinate;                ///< per chart
  std::vector<std::array<int, 3>> corners;    ///< per corner of the feature shape
  double length_error = 0;                    ///< sum over arcs of |delta u - L/h| / number of arcs
};

/// Two charts or arcs that must be kept apart on an axis: coordinate[high] - coordinate[low] >= gap.
struct Separation {
  int low = -1, high = -1;
  int gap = 1;
};

/// Integer coordinates as three difference-constraint LPs solved exactly by network simplex (design 3.5, experiments A8).
/// `separations` are added as hard constraints (lazy separation by the lattice).
/// Throws MeshingError(NoMesh, "polycube") when constraints have a positive cycle, naming the CAD faces on it.
Polycube quantize(const SurfaceMesh& mesh, const FeatureShape& shape, const QuantizeOptions& options,
                  const std::vector<Separation>& separations, Context& context);

}  // namespace hexfeature
