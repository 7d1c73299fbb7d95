// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include <array>
#include <limits>
#include <utility>
#include <vector>

#include "base/context.h"
#include "base/types.h"
#include "mesh/surface_mesh.h"

namespace hexfeature {

/// Where a ray or line meets a triangle.
struct RayHit {
  double t = 0;           ///< point = origin + t * direction
  int triangle = -1;      ///< of the surface mesh
  bool entering = false;  ///< the ray goes into the solid here (against the triangle's outward side)
};

/// The closest point of a triangle set.
struct ClosestPoint {
  int triangle = -1;  ///< of the surface mesh; -1: none within the distance asked for
  double distance2 = std::numeric_limits<double>::infinity();
  Vec3 point = Vec3::Zero();
  Vec3 barycentric = Vec3::Zero();  ///< weights of the triangle's three corners: >= 0, sum 1
};

/// Closest point of the triangle a b c to p (C. Ericson, Real-Time Collision Detection, 2005, section 5.1.5: by Voronoi
/// regions), also for triangles without area. `barycentric` are the corner weights.
Vec3 closest_on_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c, Vec3& barycentric);

/// A flat bounding-volume tree over the triangles of a surface mesh (or some of them): all hits along a ray, and closest
/// points. Keeps its own copy of the triangles, so it outlives the mesh. Const, thread-safe, deterministic: ties go to the
/// smaller triangle number.
///
/// Ray hits are watertight (S. Woop, C. Benthin, I. Wald, Watertight Ray/Triangle Intersection, JCGT 2(1), 2013), and a ray
/// through a mesh edge or point meets exactly as many triangles as a ray moved a little aside would (the rasteriser's
/// top-left rule), so that parity along a ray through a closed surface is right.
class TriangleTree {
 public:
  TriangleTree() = default;
  explicit TriangleTree(const SurfaceMesh& mesh, const Context& context = {});
  TriangleTree(const SurfaceMesh& mesh, const std::vector<int>& triangles);

  bool empty() const { return nodes_.empty(); }

  /// All hits with t_min < t <= t_max, sorted by (t, triangle), into `hits` (cleared first). `direction` need not be a unit
  /// vector but not zero. Triangles seen exactly edge-on are not met.
  void ray_hits(const Vec3& origin, const Vec3& direction, std::vector<RayHit>& hits, double t_min = 0,
                double t_max = std::numeric_limits<double>::infinity()) const;

  /// Closest point within `max_distance` of p.
  ClosestPoint closest(const Vec3& p, double max_distance = std::numeric_limits<double>::infinity()) const {
    return closest_if(
        p, [](int) { return true; }, max_distance);
  }
  /// The same over the triangles for which `accept(triangle)` is true.
  template <class Accept>
  ClosestPoint closest_if(const Vec3& p, const Accept& accept, double max_distance = std::numeric_limits<double>::infinity()) const;

 private:
  struct Box {
    Vec3 lo = Vec3::Constant(std::numeric_limits<double>::infinity());
    Vec3 hi = Vec3::Constant(-std::numeric_limits<double>::infinity());
    void add(const Vec3& p) {
      lo = lo.cwiseMin(p);
      hi = hi.cwiseMax(p);
    }
    double distance2(const Vec3& p) const { return (lo - p).cwiseMax(p - hi).cwiseMax(0).squaredNorm(); }
  };
  /// Leaf: count > 0, corners_[first .. first + count). Inner: children at this node + 1 and at `first`.
  struct Node {
    Box box;
    int first = 0, count = 0;
  };
  void build(const SurfaceMesh& mesh, std::vector<int> triangles, const Context& context);

  std::vector<Node> nodes_;
  std::vector<std::array<Vec3, 3>> corners_;  ///< in leaf order
  std::vector<int> triangle_;                 ///< in leaf order: number in the mesh
};

template <class Accept>
ClosestPoint TriangleTree::closest_if(const Vec3& p, const Accept& accept, double max_distance) const {
  ClosestPoint best;
  best.distance2 = max_distance * max_distance;
  if (nodes_.empty()) return best;
  struct Entry {
    int node;
    double distance2;
  };
  std::array<Entry, 64> stack;  // depth of a median-split tree is far below
  int top = 0;
  stack[top++] = {0, nodes_[0].box.distance2(p)};
  while (top > 0) {
    const Entry e = stack[--top];
    if (e.distance2 > best.distance2) continue;
    const Node& node = nodes_[e.node];
    for (int i = node.first; i < node.first + node.count; ++i) {
      if (!accept(triangle_[i])) continue;
      Vec3 weights;
      const Vec3 q = closest_on_triangle(p, corners_[i][0], corners_[i][1], corners_[i][2], weights);
      const double d = (q - p).squaredNorm();
      if (d < best.distance2 || (d == best.distance2 && (best.triangle < 0 || triangle_[i] < best.triangle)))
        best = {triangle_[i], d, q, weights};
    }
    if (node.count > 0) continue;
    Entry near{e.node + 1, nodes_[e.node + 1].box.distance2(p)}, far{node.first, nodes_[node.first].box.distance2(p)};
    if (far.distance2 < near.distance2) std::swap(near, far);
    stack[top++] = far;
    stack[top++] = near;
  }
  return best;
}

}  // namespace hexfeature
