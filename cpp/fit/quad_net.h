// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include <array>
#include <vector>

namespace hexfeature {

/// The boundary quads as halfedges: g = 4*quad + k runs from corner k to corner (k+1)%4 of its quad, counter-clockwise seen
/// from outside, so that its quad lies on the left.
struct QuadNet {
  std::vector<std::array<int, 4>> quads;
  std::vector<int> opposite;        ///< per halfedge; -1 where the boundary is not closed
  std::vector<int> out_begin, out;  ///< outgoing halfedges of node n: out[out_begin[n] .. out_begin[n + 1])

  static int quad_of(int g) { return g / 4; }
  static int next(int g) { return g - g % 4 + (g + 1) % 4; }
  static int prev(int g) { return g - g % 4 + (g + 3) % 4; }
  int from(int g) const { return quads[g / 4][g % 4]; }
  int to(int g) const { return quads[g / 4][(g + 1) % 4]; }
  /// The halfedge from a to b, -1 when there is none.
  int find(int a, int b) const {
    for (int i = out_begin[a]; i < out_begin[a + 1]; ++i)
      if (to(out[i]) == b) return out[i];
    return -1;
  }
};

QuadNet make_quad_net(const std::vector<std::array<int, 4>>& quads, int node_count);

}  // namespace hexfeature
