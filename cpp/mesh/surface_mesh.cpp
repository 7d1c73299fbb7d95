// HexFeatureWB - LGPL-2.1-or-later
#include "mesh/surface_mesh.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"

namespace hexfeature {

Vec3 SurfaceMesh::mean_normal(int t) const {
  const Vec3 flat = area_normal(t);
  if (corner_normals.empty()) return flat.normalized();
  const Vec3 sum = corner_normals[3 * t] + corner_normals[3 * t + 1] + corner_normals[3 * t + 2];
  return sum.norm() > 0.3 ? sum.normalized() : flat.normalized();
}

double SurfaceMesh::dihedral(int h) const {
  const int o = opposite[h];
  Vec3 a, b;
  if (corner_normals.empty()) {
    a = area_normal(h / 3).normalized();
    b = area_normal(o / 3).normalized();
  } else {
    a = (corner_normals[h] + corner_normals[next(h)]).normalized();
    b = (corner_normals[o] + corner_normals[next(o)]).normalized();
  }
  const Vec3 e = (points[to(h)] - points[from(h)]).normalized();
  return std::atan2(e.dot(a.cross(b)), a.dot(b));
}

void connect(SurfaceMesh& mesh) {
  const int n = 3 * mesh.triangle_count();
  struct Key {
    int lo, hi, halfedge;
  };
  std::vector<Key> keys(n);
  for (int h = 0; h < n; ++h) {
    const int a = mesh.from(h), b = mesh.to(h);
    keys[h] = {std::min(a, b), std::max(a, b), h};
  }
  std::sort(keys.begin(), keys.end(), [](const Key& x, const Key& y) {
    return x.lo != y.lo ? x.lo < y.lo : x.hi != y.hi ? x.hi < y.hi : x.halfedge < y.halfedge;
  });
  mesh.opposite.assign(n, -1);
  const auto fail = [&](const char* reason, int h) {
    const int face = mesh.triangle_face.empty() ? 0 : mesh.triangle_face[h / 3];
    throw MeshingError(Failure::BadInput, "surface", reason, "the part must be a closed solid; try repairing it",
                       face > 0 ? std::vector<int>{face} : std::vector<int>{});
  };
  for (int i = 0; i < n; i += 2) {
    const Key& k = keys[i];
    if (i + 1 >= n || keys[i + 1].lo != k.lo || keys[i + 1].hi != k.hi)
      fail("the surface has a hole (a triangle edge with one side)", k.halfedge);
    if (i + 2 < n && keys[i + 2].lo == k.lo && keys[i + 2].hi == k.hi)
      fail("a triangle edge belongs to more than two triangles", k.halfedge);
    const int g = keys[i + 1].halfedge;
    if (mesh.from(k.halfedge) == mesh.from(g)) fail("neighbouring triangles are oriented against each other", k.halfedge);
    mesh.opposite[k.halfedge] = g;
    mesh.opposite[g] = k.halfedge;
  }
  // One fan of triangles round each point: all that walks round a point relies on it.
  std::vector<char> known(mesh.points.size(), 0), walked(n, 0);
  for (int h = 0; h < n; ++h) {
    if (walked[h]) continue;
    if (known[mesh.from(h)]) fail("the surface touches itself in a point", h);
    known[mesh.from(h)] = 1;
    for (int g = h; !walked[g]; g = mesh.opposite[SurfaceMesh::prev(g)]) walked[g] = 1;
  }
}

double enclosed_volume(const SurfaceMesh& mesh) {
  double six_volumes = 0;
  for (const auto& t : mesh.triangles) six_volumes += mesh.points[t[0]].dot(mesh.points[t[1]].cross(mesh.points[t[2]]));
  return six_volumes / 6;
}

}  // namespace hexfeature
