// HexFeatureWB - LGPL-2.1-or-later
#include "pipeline/faithfulness.h"

namespace hexfeature {

Faithfulness measure_faithfulness(const HexComplex& mesh, const Geometry& geometry, int solid) {
  // Chords are shorter than the curve: a full circle followed by four edges keeps 90% of its length.
  constexpr double kCovered = 0.85;
  Faithfulness result;
  const int faces = static_cast<int>(geometry.faces->size()), edges = static_cast<int>(geometry.edges->size());
  const auto of_solid = [&](int face) { return face > 0 && (solid == 0 || geometry.face(face).solid == solid); };

  std::vector<char> has_quads(faces + 1, 0);
  for (int f : mesh.quad_face)
    if (f > 0) has_quads[f] = 1;
  for (int f = 1; f <= faces; ++f)
    if (of_solid(f) && !has_quads[f]) result.faces_without_quads.push_back(f);

  std::vector<double> covered(edges + 1, 0);
  for (std::size_t i = 0; i < mesh.feature_edges.size(); ++i) {
    const auto& e = mesh.feature_edges[i];
    covered[mesh.feature_edge_cad[i]] += (mesh.points[e[1]] - mesh.points[e[0]]).norm();
  }
  double total = 0, lost = 0;
  for (int id = 1; id <= edges; ++id) {
    const CadEdge& edge = geometry.edge(id);
    if (!edge.sharp || edge.seam || edge.degenerate || !of_solid(edge.faces[0])) continue;
    total += edge.length;
    if (covered[id] >= kCovered * edge.length) continue;
    lost += edge.length;
    result.sharp_edges_not_followed.push_back(id);
  }
  if (total > 0) result.lost_length = lost / total;
  return result;
}

}  // namespace hexfeature
