// HexFeatureWB - LGPL-2.1-or-later
#include "write/cad_groups.h"

#include <algorithm>
#include <map>
#include <utility>

namespace hexfeature {
namespace {
using Pairs = std::vector<std::pair<int, int>>;  // (CAD number, item)

std::vector<CadGroup> collect(Pairs pairs) {
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  std::vector<CadGroup> groups;
  for (const auto& [number, item] : pairs) {
    if (number <= 0) continue;  // not on any CAD entity
    if (groups.empty() || groups.back().number != number) groups.push_back({number, {}});
    groups.back().items.push_back(item);
  }
  return groups;
}

std::array<int, 4> sorted(std::array<int, 4> quad) {
  std::sort(quad.begin(), quad.end());
  return quad;
}
}  // namespace

CadGroups group_by_cad(const MeshView& view) {
  const HexComplex& mesh = view.mesh;
  Pairs face_quads, face_nodes, edge_nodes, vertex_nodes, solid_hexes;
  for (int q = 0; q < static_cast<int>(mesh.quads.size()); ++q) {
    face_quads.push_back({mesh.quad_face[q], q});
    if (view.second_order())
      for (int n : view.quads8[q]) face_nodes.push_back({mesh.quad_face[q], n});
    else
      for (int n : mesh.quads[q]) face_nodes.push_back({mesh.quad_face[q], n});
  }

  std::map<std::array<int, 2>, int> middle;  // mesh edge on the boundary -> its mid-side node
  if (view.second_order())
    for (const auto& quad : view.quads8)
      for (int k = 0; k < 4; ++k) middle[{std::min(quad[k], quad[(k + 1) % 4]), std::max(quad[k], quad[(k + 1) % 4])}] = quad[4 + k];
  for (std::size_t i = 0; i < mesh.feature_edges.size(); ++i) {
    const auto& edge = mesh.feature_edges[i];
    for (int n : edge) edge_nodes.push_back({mesh.feature_edge_cad[i], n});
    const auto found = middle.find({std::min(edge[0], edge[1]), std::max(edge[0], edge[1])});
    if (found != middle.end()) edge_nodes.push_back({mesh.feature_edge_cad[i], found->second});
  }
  for (int n = 0; n < static_cast<int>(mesh.place.size()); ++n) {
    if (mesh.place[n].dim == 1) edge_nodes.push_back({mesh.place[n].entity, n});
    if (mesh.place[n].dim == 0) vertex_nodes.push_back({mesh.place[n].entity, n});
  }
  for (int h = 0; h < mesh.hex_count(); ++h) solid_hexes.push_back({mesh.hex_solid.empty() ? 1 : mesh.hex_solid[h], h});
  return {collect(std::move(face_quads)), collect(std::move(face_nodes)), collect(std::move(edge_nodes)), collect(std::move(vertex_nodes)),
          collect(std::move(solid_hexes))};
}

std::vector<std::array<int, 2>> sides_of_quads(const HexComplex& mesh) {
  using Keyed = std::pair<std::array<int, 4>, std::array<int, 2>>;
  std::vector<Keyed> sides;
  for (const auto& side : boundary_faces(mesh)) {
    std::array<int, 4> quad;
    for (int k = 0; k < 4; ++k) quad[k] = mesh.hexes[side[0]][kHexFaces[side[1]][k]];
    sides.push_back({sorted(quad), side});
  }
  std::sort(sides.begin(), sides.end());
  std::vector<std::array<int, 2>> result;
  for (const auto& quad : mesh.quads) {
    const auto key = sorted(quad);
    const auto found =
        std::lower_bound(sides.begin(), sides.end(), key, [](const Keyed& a, const std::array<int, 4>& b) { return a.first < b; });
    result.push_back(found != sides.end() && found->first == key ? found->second : std::array<int, 2>{-1, -1});
  }
  return result;
}

}  // namespace hexfeature
