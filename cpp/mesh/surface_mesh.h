// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include <array>
#include <vector>

#include "base/context.h"
#include "base/types.h"

namespace hexfeature {

/// Where a point lies on the CAD: on a vertex (dim 0), an edge (1), a face (2), or inside (3).
/// `entity` is the 1-based CAD number (TopExp::MapShapes order), 0 when there is none.
/// Parameters: an edge's t in uv[0]; a face's (u, v).
struct CadPlace {
  int dim = 3;
  int entity = 0;
  Vec2 uv = Vec2::Zero();
};

/// The surface-mesh model: a closed, oriented triangle mesh that knows the CAD it came from.
///
/// Halfedge h = 3*t + k runs from corner k to corner (k+1)%3 of triangle t; triangles are
/// counter-clockwise seen from outside. A part may have several shells (inner voids).
struct SurfaceMesh {
  std::vector<Vec3> points;
  std::vector<CadPlace> place;                ///< per point
  std::vector<std::array<int, 3>> triangles;  ///< point indices
  std::vector<int> triangle_face;             ///< per triangle: 1-based CAD face
  std::vector<Vec3> corner_normals;           ///< 3 per triangle: outward unit normal of the true surface at the corner
  std::vector<int> halfedge_edge;             ///< 3 per triangle: 1-based CAD edge that the halfedge lies on, 0 = none
  std::vector<int> opposite;                  ///< 3 per triangle: the opposite halfedge (closed: never -1)

  int triangle_count() const { return static_cast<int>(triangles.size()); }
  int point_count() const { return static_cast<int>(points.size()); }
  static int triangle_of(int h) { return h / 3; }
  static int next(int h) { return h - h % 3 + (h + 1) % 3; }
  static int prev(int h) { return h - h % 3 + (h + 2) % 3; }
  int from(int h) const { return triangles[h / 3][h % 3]; }
  int to(int h) const { return triangles[h / 3][(h + 1) % 3]; }
  /// Unnormalised normal of the flat triangle; its length is twice the area.
  Vec3 area_normal(int t) const {
    const auto& v = triangles[t];
    return (points[v[1]] - points[v[0]]).cross(points[v[2]] - points[v[0]]);
  }
  double area(int t) const { return 0.5 * area_normal(t).norm(); }
  Vec3 centroid(int t) const {
    const auto& v = triangles[t];
    return (points[v[0]] + points[v[1]] + points[v[2]]) / 3.0;
  }
  /// Mean of the three true-surface normals, normalised (the flat normal when they cancel).
  Vec3 mean_normal(int t) const;
  /// Signed dihedral of the true surfaces across halfedge h, radians in (-pi, pi):
  /// the angle between the two sides' normals; positive convex, negative concave, 0 tangent.
  double dihedral(int h) const;
};

/// Fill `opposite` from `triangles`. Throws MeshingError(BadInput, "surface") when the mesh is not a closed oriented 2-manifold.
void connect(SurfaceMesh& mesh, const Context& context = {});

/// Signed volume enclosed (positive for outward orientation).
double enclosed_volume(const SurfaceMesh& mesh);

}  // namespace hexfeature
