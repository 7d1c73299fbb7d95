// HexFeatureWB - LGPL-2.1-or-later
#include "tetsplit/split.h"

#include <algorithm>
#include <array>
#include <tuple>
#include <utility>

namespace hexfeature {
namespace {

/// Numbers for distinct keys, in sorted order.
template <class Key>
class Numbering {
 public:
  explicit Numbering(std::vector<Key> keys) : keys_(std::move(keys)) {
    std::sort(keys_.begin(), keys_.end());
    keys_.erase(std::unique(keys_.begin(), keys_.end()), keys_.end());
  }
  int size() const { return static_cast<int>(keys_.size()); }
  const Key& operator[](int i) const { return keys_[i]; }
  int of(const Key& key) const { return static_cast<int>(std::lower_bound(keys_.begin(), keys_.end(), key) - keys_.begin()); }

 private:
  std::vector<Key> keys_;
};

using Edge = std::array<int, 2>;
using Face = std::array<int, 3>;
Edge edge_key(int a, int b) { return {std::min(a, b), std::max(a, b)}; }
Face face_key(int a, int b, int c) {
  Face f{a, b, c};
  std::sort(f.begin(), f.end());
  return f;
}

/// Corner k first, then the other three so that the four are an even permutation.
constexpr std::array<std::array<int, 4>, 4> kFromCorner{{{0, 1, 2, 3}, {1, 0, 3, 2}, {2, 0, 1, 3}, {3, 0, 2, 1}}};

}  // namespace

HexComplex split_tetrahedra(const TetMesh& mesh, const SurfaceMesh& surface, const Geometry& geometry, const Context& context) {
  std::vector<Edge> all_edges;
  std::vector<Face> all_faces;
  for (const auto& t : mesh.tets) {
    for (const auto& e : kTetEdges) all_edges.push_back(edge_key(t[e[0]], t[e[1]]));
    for (const auto& f : kTetFaces) all_faces.push_back(face_key(t[f[0]], t[f[1]], t[f[2]]));
  }
  context.check();
  const Numbering<Edge> edges(std::move(all_edges));
  context.check();
  const Numbering<Face> faces(std::move(all_faces));
  const int first_edge = static_cast<int>(mesh.points.size()), first_face = first_edge + edges.size(),
            first_middle = first_face + faces.size();
  const auto edge_node = [&](int a, int b) { return first_edge + edges.of(edge_key(a, b)); };
  const auto face_node = [&](int a, int b, int c) { return first_face + faces.of(face_key(a, b, c)); };

  HexComplex result;
  result.points = mesh.points;
  result.points.resize(first_middle + mesh.tets.size());
  for (int i = 0; i < edges.size(); ++i) result.points[first_edge + i] = 0.5 * (mesh.points[edges[i][0]] + mesh.points[edges[i][1]]);
  for (int i = 0; i < faces.size(); ++i)
    result.points[first_face + i] = (mesh.points[faces[i][0]] + mesh.points[faces[i][1]] + mesh.points[faces[i][2]]) / 3;
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    if (t % 4096 == 0) context.check();
    const auto& v = mesh.tets[t];
    const int o = first_middle + static_cast<int>(t);
    result.points[o] = (mesh.points[v[0]] + mesh.points[v[1]] + mesh.points[v[2]] + mesh.points[v[3]]) / 4;
    for (const auto& p : kFromCorner) {
      const int a = v[p[0]], b = v[p[1]], c = v[p[2]], d = v[p[3]];
      result.hexes.push_back(
          {a, edge_node(a, b), face_node(a, b, c), edge_node(a, c), edge_node(a, d), face_node(a, b, d), o, face_node(a, c, d)});
      result.hex_block.push_back(static_cast<int>(t));
    }
  }
  result.hex_solid.assign(result.hexes.size(), 1);

  result.place.resize(result.points.size());
  std::copy(surface.place.begin(), surface.place.end(), result.place.begin());
  for (int t = 0; t < surface.triangle_count(); ++t) {
    if (t % 256 == 0) context.check();
    const auto& v = surface.triangles[t];
    const int face = surface.triangle_face[t], centre = face_node(v[0], v[1], v[2]);
    result.place[centre] = {2, face, geometry.projector->project_to_face(face, result.points[centre], nullptr).uv};
    for (int k = 0; k < 3; ++k) {
      const int a = v[k], b = v[(k + 1) % 3], c = v[(k + 2) % 3], middle = edge_node(a, b), cad = surface.halfedge_edge[3 * t + k];
      result.quads.push_back({a, middle, centre, edge_node(a, c)});
      result.quad_face.push_back(face);
      result.quad_chart.push_back(-1);
      if (a > b) continue;
      if (cad > 0) {
        result.place[middle] = {1, cad, {geometry.projector->project_to_edge(cad, result.points[middle], nullptr).t, 0}};
        result.feature_edges.push_back(edge_key(a, middle));
        result.feature_edges.push_back(edge_key(b, middle));
        result.feature_edge_cad.insert(result.feature_edge_cad.end(), 2, cad);
      } else {
        result.place[middle] = {2, face, geometry.projector->project_to_face(face, result.points[middle], nullptr).uv};
      }
    }
  }
  // Sorted, as HexComplex wants them.
  std::vector<std::pair<Edge, int>> features;
  for (std::size_t i = 0; i < result.feature_edges.size(); ++i) features.push_back({result.feature_edges[i], result.feature_edge_cad[i]});
  std::sort(features.begin(), features.end());
  for (std::size_t i = 0; i < features.size(); ++i) std::tie(result.feature_edges[i], result.feature_edge_cad[i]) = features[i];
  return result;
}

}  // namespace hexfeature
