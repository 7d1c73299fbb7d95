// HexFeatureWB - LGPL-2.1-or-later
#include "sheet/quad_faces.h"

#include <algorithm>
#include <array>
#include <vector>

namespace hexfeature {

int face_quads_at_sharp_edges(HexComplex& complex, const Geometry& geometry) {
  if (!geometry.edges || !geometry.faces) return 0;
  struct Side {
    std::array<int, 2> nodes;
    int quad;
  };
  std::vector<Side> sides;
  for (int q = 0; q < static_cast<int>(complex.quads.size()); ++q)
    for (int i = 0; i < 4; ++i) {
      const int a = complex.quads[q][i], b = complex.quads[q][(i + 1) % 4];
      sides.push_back({{std::min(a, b), std::max(a, b)}, q});
    }
  std::sort(sides.begin(), sides.end(),
            [](const Side& a, const Side& b) { return a.nodes != b.nodes ? a.nodes < b.nodes : a.quad < b.quad; });

  constexpr int kNone = 0, kStay = -1;
  std::vector<int> wish(complex.quads.size(), kNone);
  for (std::size_t e = 0; e < complex.feature_edges.size(); ++e) {
    const CadEdge& edge = geometry.edge(complex.feature_edge_cad[e]);
    if (!edge.sharp || edge.faces[0] == edge.faces[1]) continue;
    const auto at = std::lower_bound(sides.begin(), sides.end(), complex.feature_edges[e],
                                     [](const Side& s, const std::array<int, 2>& nodes) { return s.nodes < nodes; });
    if (sides.end() - at < 2 || at->nodes != complex.feature_edges[e] || (at + 1)->nodes != at->nodes) continue;
    // Of the edge's faces, the one that the quad lies on: 0, 1; -1 when it is another.
    const auto side_of = [&](int q) { return complex.quad_face[q] == edge.faces[0] ? 0 : complex.quad_face[q] == edge.faces[1] ? 1 : -1; };
    const int p = at->quad, q = (at + 1)->quad, of_p = side_of(p), of_q = side_of(q);
    for (const auto& [quad, own, other] : {std::array{p, of_p, of_q}, std::array{q, of_q, of_p}}) {
      if (own >= 0) wish[quad] = kStay;
      if (own >= 0 || other < 0) continue;
      const int face = edge.faces[1 - other];
      wish[quad] = wish[quad] == kNone || wish[quad] == face ? face : kStay;
    }
  }
  std::vector<int> count(geometry.faces->size() + 1, 0);
  for (int f : complex.quad_face) ++count[f];
  int changed = 0;
  for (std::size_t q = 0; q < wish.size(); ++q) {
    if (wish[q] <= 0 || count[complex.quad_face[q]] < 2) continue;
    --count[complex.quad_face[q]];
    ++count[wish[q]];
    complex.quad_face[q] = wish[q];
    ++changed;
  }
  return changed;
}

}  // namespace hexfeature
