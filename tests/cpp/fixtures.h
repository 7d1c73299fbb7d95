// HexFeatureWB - LGPL-2.1-or-later
// Tiny named shapes for the unit tests: polycubes given as voxels, triangulated, labelled exactly, and bent when wanted.
#pragma once
#include <array>
#include <functional>
#include <map>
#include <set>
#include <vector>

#include "mesh/surface_mesh.h"
#include "shape/feature_shape.h"

namespace fixtures {

using Voxels = std::set<std::array<int, 3>>;

inline Voxels box(std::array<int, 3> lo, std::array<int, 3> hi) {
  Voxels v;
  for (int x = lo[0]; x < hi[0]; ++x)
    for (int y = lo[1]; y < hi[1]; ++y)
      for (int z = lo[2]; z < hi[2]; ++z) v.insert({x, y, z});
  return v;
}
inline Voxels unite(Voxels a, const Voxels& b) {
  a.insert(b.begin(), b.end());
  return a;
}
inline Voxels subtract(Voxels a, const Voxels& b) {
  for (const auto& c : b) a.erase(c);
  return a;
}
inline Voxels unit_box() { return box({0, 0, 0}, {1, 1, 1}); }
inline Voxels ell() { return subtract(box({0, 0, 0}, {4, 4, 2}), box({2, 2, 0}, {4, 4, 2})); }
inline Voxels plate_with_hole() { return subtract(box({0, 0, 0}, {5, 5, 1}), box({2, 2, 0}, {3, 3, 1})); }
inline Voxels plate_with_boss() { return unite(box({0, 0, 0}, {5, 5, 1}), box({2, 2, 1}, {3, 3, 3})); }
inline Voxels blind_pocket() { return subtract(box({0, 0, 0}, {5, 5, 3}), box({2, 2, 1}, {3, 3, 3})); }
inline Voxels staircase() { return unite(unite(box({0, 0, 0}, {3, 2, 1}), box({0, 0, 1}, {2, 2, 2})), box({0, 0, 2}, {1, 2, 3})); }
inline Voxels hollow_box() { return subtract(box({0, 0, 0}, {3, 3, 3}), box({1, 1, 1}, {2, 2, 2})); }

/// The boundary of the voxels: each voxel face is `n` x `n` squares of two triangles; exact labels. Spacing 1.
/// CAD faces are the charts (1-based); `place`, `halfedge_edge` are left without edges (dim 2).
inline hexfeature::LabelledSurface voxel_surface(const Voxels& voxels, int n = 2) {
  using namespace hexfeature;
  LabelledSurface s;
  std::map<std::array<int, 3>, int> index;
  const auto point = [&](std::array<int, 3> p) {
    const auto it = index.find(p);
    if (it != index.end()) return it->second;
    const int i = static_cast<int>(s.mesh.points.size());
    index[p] = i;
    s.mesh.points.push_back(Vec3(p[0], p[1], p[2]) / n);
    return i;
  };
  for (const auto& v : voxels)
    for (int l = 0; l < 6; ++l) {
      const int axis = l / 2, sign = l % 2 == 0 ? 1 : -1;
      auto w = v;
      w[axis] += sign;
      if (voxels.count(w)) continue;
      const int a = (axis + 1) % 3, b = (axis + 2) % 3;
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
          std::array<std::array<int, 3>, 4> q;
          const int di[4] = {0, 1, 1, 0}, dj[4] = {0, 0, 1, 1};
          for (int k = 0; k < 4; ++k) {
            q[k][axis] = n * (v[axis] + (sign > 0));
            q[k][a] = n * v[a] + i + di[k];
            q[k][b] = n * v[b] + j + dj[k];
          }
          if (sign < 0) std::swap(q[1], q[3]);
          s.mesh.triangles.push_back({point(q[0]), point(q[1]), point(q[2])});
          s.mesh.triangles.push_back({point(q[0]), point(q[2]), point(q[3])});
          for (int k = 0; k < 2; ++k) {
            s.label.push_back(static_cast<Label>(l));
            for (int c = 0; c < 3; ++c) s.mesh.corner_normals.push_back(direction(static_cast<Label>(l)));
          }
        }
    }
  s.mesh.triangle_face.assign(s.mesh.triangles.size(), 0);
  s.mesh.halfedge_edge.assign(3 * s.mesh.triangles.size(), 0);
  s.mesh.place.assign(s.mesh.points.size(), CadPlace{2, 0, Vec2::Zero()});
  connect(s.mesh);
  const std::vector<int> labels(s.label.begin(), s.label.end());
  s.mesh.triangle_face = connected_components(s.mesh, labels);
  for (int& f : s.mesh.triangle_face) ++f;
  return s;
}

/// Move every point by `map` and recompute the normals from the flat triangles.
inline void deform(hexfeature::SurfaceMesh& mesh, const std::function<hexfeature::Vec3(const hexfeature::Vec3&)>& map) {
  for (auto& p : mesh.points) p = map(p);
  for (int t = 0; t < mesh.triangle_count(); ++t)
    for (int k = 0; k < 3; ++k) mesh.corner_normals[3 * t + k] = mesh.area_normal(t).normalized();
}

}  // namespace fixtures
