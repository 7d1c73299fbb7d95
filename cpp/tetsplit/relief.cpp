// HexFeatureWB - LGPL-2.1-or-later
#include "tetsplit/relief.h"

#include <algorithm>
#include <array>

namespace hexfeature {
namespace {

/// Dihedral of more than 110 degrees: cosine between the faces' outward normals.
constexpr double kOpen = 0.35;

using Edge = std::array<int, 2>;
Edge edge_of(int a, int b) { return {std::min(a, b), std::max(a, b)}; }

std::array<int, 3> sorted_face(const std::array<int, 4>& tet, int face) {
  std::array<int, 3> f{tet[kTetFaces[face][0]], tet[kTetFaces[face][1]], tet[kTetFaces[face][2]]};
  std::sort(f.begin(), f.end());
  return f;
}

Vec3 outward(const TetMesh& mesh, const std::array<int, 4>& tet, int face) {
  const Vec3 &a = mesh.points[tet[kTetFaces[face][0]]], &b = mesh.points[tet[kTetFaces[face][1]]],
             &c = mesh.points[tet[kTetFaces[face][2]]];
  return (b - a).cross(c - a).normalized();
}

}  // namespace

int relieve_boundary(TetMesh& mesh, const SurfaceMesh& surface, Context& context) {
  constexpr int kRounds = 8;
  std::vector<std::array<int, 3>> triangles;
  std::vector<Edge> surface_edges;
  for (const auto& t : surface.triangles) {
    std::array<int, 3> f = t;
    std::sort(f.begin(), f.end());
    triangles.push_back(f);
    for (int k = 0; k < 3; ++k)
      if (t[k] < t[(k + 1) % 3]) surface_edges.push_back({t[k], t[(k + 1) % 3]});
  }
  std::sort(triangles.begin(), triangles.end());
  std::sort(surface_edges.begin(), surface_edges.end());

  int count = 0;
  for (int round = 0; round < kRounds; ++round) {
    context.check();
    std::vector<Edge> cut;
    for (const auto& tet : mesh.tets) {
      std::array<bool, 4> on_boundary;
      for (int f = 0; f < 4; ++f) on_boundary[f] = std::binary_search(triangles.begin(), triangles.end(), sorted_face(tet, f));
      for (const auto& e : kTetEdges) {
        // The faces at edge e[0] e[1] are those that lack e[2] and e[3].
        if (!on_boundary[e[2]] || !on_boundary[e[3]]) continue;
        if (outward(mesh, tet, e[2]).dot(outward(mesh, tet, e[3])) < kOpen) continue;
        const Edge opposite = edge_of(tet[e[2]], tet[e[3]]);
        if (!std::binary_search(surface_edges.begin(), surface_edges.end(), opposite)) cut.push_back(opposite);
      }
    }
    if (cut.empty()) break;
    std::sort(cut.begin(), cut.end());
    cut.erase(std::unique(cut.begin(), cut.end()), cut.end());
    // Each tetrahedron is cut once a round; what is left over is found again in the next.
    std::vector<int> middle(cut.size(), -1);
    const std::size_t n = mesh.tets.size();
    std::vector<int> edge_of_tet(n, -1), corner_pair(n, -1);
    std::vector<char> blocked(cut.size(), 0);
    for (std::size_t t = 0; t < n; ++t)
      for (int k = 0; k < 6; ++k) {
        const Edge e = edge_of(mesh.tets[t][kTetEdges[k][0]], mesh.tets[t][kTetEdges[k][1]]);
        const auto it = std::lower_bound(cut.begin(), cut.end(), e);
        if (it == cut.end() || *it != e) continue;
        const int i = static_cast<int>(it - cut.begin());
        if (edge_of_tet[t] >= 0) blocked[std::max(i, edge_of_tet[t])] = 1;
        if (edge_of_tet[t] < 0 || i < edge_of_tet[t]) {
          edge_of_tet[t] = i;
          corner_pair[t] = k;
        }
      }
    for (std::size_t t = 0; t < n; ++t) {
      const int i = edge_of_tet[t];
      if (i < 0 || blocked[i]) continue;
      const int a = kTetEdges[corner_pair[t]][0], b = kTetEdges[corner_pair[t]][1];
      if (middle[i] < 0) {
        middle[i] = static_cast<int>(mesh.points.size());
        mesh.points.push_back(0.5 * (mesh.points[cut[i][0]] + mesh.points[cut[i][1]]));
        ++count;
      }
      auto other = mesh.tets[t];
      mesh.tets[t][a] = middle[i];
      other[b] = middle[i];
      mesh.tets.push_back(other);
    }
  }
  return count;
}

}  // namespace hexfeature
