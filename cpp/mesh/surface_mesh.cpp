// HexFeatureWB - LGPL-2.1-or-later
#include "mesh/surface_mesh.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "mesh/buckets.h"

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

void connect(SurfaceMesh& mesh, const Context& context) {
  const int n = 3 * mesh.triangle_count();
  const auto low = [&](int h) { return std::min(mesh.from(h), mesh.to(h)); };
  const auto high = [&](int h) { return std::max(mesh.from(h), mesh.to(h)); };
  mesh.opposite.assign(n, -1);
  const auto fail = [&](const char* reason, int h) {
    const int face = mesh.triangle_face.empty() ? 0 : mesh.triangle_face[h / 3];
    throw MeshingError(Failure::BadInput, "surface", reason, "the part must be a closed solid; try repairing it",
                       face > 0 ? std::vector<int>{face} : std::vector<int>{});
  };
  Buckets halfedges(mesh.point_count(), n, low);
  for (int v = 0; v < mesh.point_count(); ++v) {
    if (v % 8192 == 0) context.check();
    const auto begin = halfedges.item.begin() + halfedges.start[v], end = halfedges.item.begin() + halfedges.start[v + 1];
    std::sort(begin, end, [&](int g, int h) { return high(g) != high(h) ? high(g) < high(h) : g < h; });
    for (auto it = begin; it != end; it += 2) {
      const int h = *it;
      if (it + 1 == end || high(*(it + 1)) != high(h)) fail("the surface has a hole (a triangle edge with one side)", h);
      if (it + 2 != end && high(*(it + 2)) == high(h)) fail("a triangle edge belongs to more than two triangles", h);
      const int g = *(it + 1);
      if (mesh.from(h) == mesh.from(g)) fail("neighbouring triangles are oriented against each other", h);
      mesh.opposite[h] = g;
      mesh.opposite[g] = h;
    }
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
