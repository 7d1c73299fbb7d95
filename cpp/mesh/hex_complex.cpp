// HexFeatureWB - LGPL-2.1-or-later
#include "mesh/hex_complex.h"

#include <algorithm>

#include "mesh/buckets.h"

namespace hexfeature {

SurfaceMesh triangles_of_quads(const HexComplex& complex) {
  SurfaceMesh mesh;
  mesh.points = complex.points;
  mesh.triangles.reserve(2 * complex.quads.size());
  for (const auto& v : complex.quads) {
    mesh.triangles.push_back({v[0], v[1], v[2]});
    mesh.triangles.push_back({v[0], v[2], v[3]});
  }
  return mesh;
}

bool same_cycle(const std::array<int, 4>& a, const std::array<int, 4>& b, int step) {
  for (int s = 0; s < 4; ++s)
    if (b[s] == a[0] && b[(s + step) % 4] == a[1] && b[(s + 2) % 4] == a[2] && b[(s + 3 * step) % 4] == a[3]) return true;
  return false;
}

FaceMates match_faces(const HexComplex& complex, const Context& context) {
  const int n = complex.point_count(), faces = 6 * complex.hex_count();
  std::vector<std::array<int, 4>> sorted(faces);
  for (int f = 0; f < faces; ++f) {
    if (f % 65536 == 0) context.check();
    sorted[f] = face_nodes(complex, f);
    std::sort(sorted[f].begin(), sorted[f].end());
  }
  const Buckets by_node(n, faces, [&](int f) { return sorted[f][0]; });
  FaceMates result;
  result.mate.assign(faces, FaceMates::kBoundary);
  std::vector<int> bucket;
  for (int v = 0; v < n; ++v) {
    if (v % 8192 == 0) context.check();
    bucket.assign(by_node.item.begin() + by_node.start[v], by_node.item.begin() + by_node.start[v + 1]);
    std::sort(bucket.begin(), bucket.end(), [&](int a, int b) { return sorted[a] != sorted[b] ? sorted[a] < sorted[b] : a < b; });
    for (std::size_t i = 0; i < bucket.size();) {
      std::size_t j = i + 1;
      while (j < bucket.size() && sorted[bucket[j]] == sorted[bucket[i]]) ++j;
      if (j == i + 2 && same_cycle(face_nodes(complex, bucket[i]), face_nodes(complex, bucket[i + 1]), 3)) {
        result.mate[bucket[i]] = bucket[i + 1];
        result.mate[bucket[i + 1]] = bucket[i];
      } else if (j > i + 1) {
        for (std::size_t k = i; k < j; ++k) result.mate[bucket[k]] = FaceMates::kCrowded;
      }
      i = j;
    }
  }
  return result;
}

std::vector<std::array<int, 2>> boundary_faces(const HexComplex& complex, const Context& context) {
  const FaceMates faces = match_faces(complex, context);
  std::vector<std::array<int, 2>> result;
  for (int f = 0; f < static_cast<int>(faces.mate.size()); ++f)
    if (faces.mate[f] == FaceMates::kBoundary) result.push_back({f / 6, f % 6});
  return result;
}

}  // namespace hexfeature
