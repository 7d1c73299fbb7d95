// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include <vector>

#include "mesh/geometry.h"
#include "mesh/hex_complex.h"

namespace hexfeature {

/// What a mesh kept of the CAD model's faces and sharp edges.
struct Faithfulness {
  std::vector<int> faces_without_quads;       ///< 1-based CAD faces of the solid
  std::vector<int> sharp_edges_not_followed;  ///< 1-based sharp CAD edges whose chain of mesh edges is missing or has gaps
  double lost_length = 0;                     ///< share of the sharp edges' length that those make up, 0..1
  bool complete() const { return faces_without_quads.empty() && sharp_edges_not_followed.empty(); }
};

/// `solid`: 1-based, or 0 for all solids.
Faithfulness measure_faithfulness(const HexComplex& mesh, const Geometry& geometry, int solid);

}  // namespace hexfeature
