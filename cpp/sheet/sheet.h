// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include <vector>

#include "base/context.h"
#include "fit/fit.h"
#include "mesh/hex_complex.h"
#include "shape/feature_shape.h"

namespace hexfeature {

struct SheetOptions {
  double size = 1;
  double smooth_angle = 135;  ///< degrees in the solid between fitted quads above which a sheet is needed
  double thickness = 0.3;     ///< of the neighbouring edge, at insertion
};

struct SheetReport {
  int inserted = 0, refused = 0;
  std::vector<std::vector<int>> chart_groups;  ///< per inserted sheet
};

/// Insert O-grid sheets where chart borders lie on smooth surface (design 3.7, experiments B1-B3): one sheet per group of
/// smoothly joined charts, its shrink set chosen as a minimum cut over blocks, leaving through sharp faces.
/// `complex` must be fitted (fit_boundary). New nodes get positions, shape and CAD places.
SheetReport insert_sheets(HexComplex& complex, const FeatureShape& shape, const Geometry& geometry,
                          const SheetOptions& options, Context& context);

}  // namespace hexfeature
