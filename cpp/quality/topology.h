// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include <string>
#include <vector>

#include "base/context.h"
#include "mesh/hex_complex.h"

namespace hexfeature {

/// One kind of fault: how many, and points that show where (the first thousand at most).
struct MeshFault {
  std::string reason;
  int count = 0;
  std::vector<int> points;

  void add(const int* nodes, int node_count) {
    ++count;
    if (points.size() < 1000) points.insert(points.end(), nodes, nodes + node_count);
  }
};

/// All topological conditions of the certificate, in order; the first kind of fault found, or count = 0.
/// Safe on any input: indices are checked first.
MeshFault check_topology(const HexComplex& complex, Context& context);

/// Pairs of points nearer than `tolerance` (sorted cells, n log n).
MeshFault find_coincident_points(const std::vector<Vec3>& points, double tolerance, Context& context);

}  // namespace hexfeature
