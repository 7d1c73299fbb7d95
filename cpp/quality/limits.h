// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include <vector>

#include "mesh/geometry.h"
#include "mesh/hex_complex.h"

namespace hexfeature {

/// What a sharp CAD edge forbids, and what the mesh makes of it. Where the part fills an angle theta round the edge and k hexahedra share
/// it, the scaled Jacobian of one of them is at most sin(theta / k): the bound is the best over all k.
struct EdgeLimit {
  int cad_edge = 0;      ///< 1-based
  double angle = 0;      ///< theta at the median place, radians; below pi: convex
  int best_count = 1;    ///< the k that the bound is for
  double bound = 1;      ///< of the scaled Jacobian, 0..1
  double min_sj = 1;     ///< of the hexahedra that have a mesh edge on this CAD edge; 1 when none has
  int most_crowded = 0;  ///< hexahedra that share the mesh edge on it that most share
};

/// A face's tip: two CAD edges that leave a CAD vertex at an angle, with the face between them. The scaled Jacobian there is at most
/// sin(angle / k) for k quadrilaterals; 0 where the two edges touch.
struct TipLimit {
  int cad_vertex = 0, cad_face = 0;  ///< 1-based
  double angle = 0;                  ///< radians
  double bound = 1;
};

struct Limits {
  std::vector<EdgeLimit> edges;  ///< every sharp CAD edge, by number
  std::vector<TipLimit> tips;    ///< face corners under 30 degrees between two sharp edges
  double bound = 1;              ///< the least of all edges: no mesh of the part with its edges followed can do better
};

/// The best that k hexahedra can make of an angle theta (0 < theta < 2 pi): max over k of sin(theta / k).
double angle_bound(double theta, int* best_count = nullptr);

/// `mesh` and `geometry` in the same coordinates.
Limits measure_limits(const HexComplex& mesh, const Geometry& geometry);

}  // namespace hexfeature
