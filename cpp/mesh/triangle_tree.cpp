// HexFeatureWB - LGPL-2.1-or-later
#include "mesh/triangle_tree.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace hexfeature {
namespace {

constexpr int kLeafSize = 4;

/// Ray/triangle test in the ray's own sheared frame, where the ray is the z axis.
struct ShearedRay {
  Vec3 origin;
  int kx, ky, kz;
  double sx, sy, sz;

  ShearedRay(const Vec3& o, const Vec3& d) : origin(o) {
    d.cwiseAbs().maxCoeff(&kz);
    kx = (kz + 1) % 3;
    ky = (kx + 1) % 3;
    if (d[kz] < 0) std::swap(kx, ky);  // keeps the winding
    sx = d[kx] / d[kz];
    sy = d[ky] / d[kz];
    sz = 1 / d[kz];
  }

  /// An edge function that is exactly zero counts as inside for one of the two directions of the edge.
  static bool owns(double x0, double y0, double x1, double y1) { return y0 < y1 || (y0 == y1 && x0 < x1); }

  bool meets(const std::array<Vec3, 3>& triangle, double& t, bool& entering) const {
    double x[3], y[3], z[3];
    for (int i = 0; i < 3; ++i) {
      const Vec3 p = triangle[i] - origin;
      z[i] = sz * p[kz];
      x[i] = p[kx] - sx * p[kz];
      y[i] = p[ky] - sy * p[kz];
    }
    double e[3];  // edge function of the edge opposite to corner i; all of one sign inside
    for (int i = 0; i < 3; ++i) {
      const int a = (i + 1) % 3, b = (i + 2) % 3;
      e[i] = x[a] * y[b] - y[a] * x[b];
    }
    const double determinant = e[0] + e[1] + e[2];
    if (!(determinant != 0)) return false;
    const bool positive = determinant > 0;
    for (int i = 0; i < 3; ++i) {
      if (e[i] == 0) {
        const int a = (i + (positive ? 1 : 2)) % 3, b = (i + (positive ? 2 : 1)) % 3;
        if (!owns(x[a], y[a], x[b], y[b])) return false;
      } else if ((e[i] > 0) != positive) {
        return false;
      }
    }
    t = (e[0] * z[0] + e[1] * z[1] + e[2] * z[2]) / determinant;
    // Counter-clockwise in (kx, ky) means an outward normal along the ray's direction: the ray leaves.
    entering = !positive;
    return true;
  }
};

bool meets_box(const Vec3& lo, const Vec3& hi, const Vec3& origin, const Vec3& inverse, double t_min, double t_max) {
  for (int k = 0; k < 3; ++k) {
    double a = (lo[k] - origin[k]) * inverse[k], b = (hi[k] - origin[k]) * inverse[k];
    if (a > b) std::swap(a, b);
    // 0 * inf (a ray in the box's own plane) is not a number: such a comparison leaves the interval as it is.
    if (a > t_min) t_min = a;
    if (b < t_max) t_max = b;
  }
  return t_min <= t_max;
}

}  // namespace

Vec3 closest_on_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c, Vec3& barycentric) {
  const Vec3 ab = b - a, ac = c - a, ap = p - a, bp = p - b, cp = p - c;
  const double d1 = ab.dot(ap), d2 = ac.dot(ap);
  const auto result = [&](double u, double v, double w) {
    barycentric = Vec3(u, v, w);
    return Vec3(u * a + v * b + w * c);
  };
  if (d1 <= 0 && d2 <= 0) return result(1, 0, 0);
  const double d3 = ab.dot(bp), d4 = ac.dot(bp);
  if (d3 >= 0 && d4 <= d3) return result(0, 1, 0);
  const double d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d6 >= 0 && d5 <= d6) return result(0, 0, 1);
  const double vc = d1 * d4 - d3 * d2, vb = d5 * d2 - d1 * d6, va = d3 * d6 - d5 * d4;
  if (vc <= 0 && d1 >= 0 && d3 <= 0 && d1 > d3) return result(1 - d1 / (d1 - d3), d1 / (d1 - d3), 0);
  if (vb <= 0 && d2 >= 0 && d6 <= 0 && d2 > d6) return result(1 - d2 / (d2 - d6), 0, d2 / (d2 - d6));
  const double bc = (d4 - d3) + (d5 - d6);
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0 && bc > 0) return result(0, 1 - (d4 - d3) / bc, (d4 - d3) / bc);
  const double sum = va + vb + vc;
  if (!(sum > 0)) return result(1, 0, 0);
  return result(1 - vb / sum - vc / sum, vb / sum, vc / sum);
}

TriangleTree::TriangleTree(const SurfaceMesh& mesh, const Context& context) {
  std::vector<int> all(mesh.triangle_count());
  std::iota(all.begin(), all.end(), 0);
  build(mesh, std::move(all), context);
}

TriangleTree::TriangleTree(const SurfaceMesh& mesh, const std::vector<int>& triangles) { build(mesh, triangles, {}); }

void TriangleTree::build(const SurfaceMesh& mesh, std::vector<int> triangles, const Context& context) {
  if (triangles.empty()) return;
  std::vector<Vec3> centre(mesh.triangle_count());
  for (int t : triangles) centre[t] = mesh.centroid(t);

  struct Range {
    int parent, begin, end;  // parent: whose `first` is this node, -1 for a first child
  };
  std::vector<Range> stack{{-1, 0, static_cast<int>(triangles.size())}};
  nodes_.reserve(triangles.size());
  while (!stack.empty()) {
    const Range r = stack.back();
    stack.pop_back();
    const int index = static_cast<int>(nodes_.size());
    if (index % 4096 == 0) context.check();
    if (r.parent >= 0) nodes_[r.parent].first = index;
    Node node;
    Box centres;
    for (int i = r.begin; i < r.end; ++i) {
      for (int v : mesh.triangles[triangles[i]]) node.box.add(mesh.points[v]);
      centres.add(centre[triangles[i]]);
    }
    if (r.end - r.begin <= kLeafSize) {
      node.first = r.begin;
      node.count = r.end - r.begin;
      std::sort(triangles.begin() + r.begin, triangles.begin() + r.end);
      nodes_.push_back(node);
      continue;
    }
    nodes_.push_back(node);
    int axis = 0;
    (centres.hi - centres.lo).maxCoeff(&axis);
    const int middle = (r.begin + r.end) / 2;
    std::nth_element(triangles.begin() + r.begin, triangles.begin() + middle, triangles.begin() + r.end,
                     [&](int a, int b) { return centre[a][axis] != centre[b][axis] ? centre[a][axis] < centre[b][axis] : a < b; });
    stack.push_back({index, middle, r.end});
    stack.push_back({-1, r.begin, middle});  // popped next: becomes index + 1
  }
  triangle_ = std::move(triangles);
  corners_.reserve(triangle_.size());
  for (int t : triangle_) {
    const auto& v = mesh.triangles[t];
    corners_.push_back({mesh.points[v[0]], mesh.points[v[1]], mesh.points[v[2]]});
  }
}

void TriangleTree::ray_hits(const Vec3& origin, const Vec3& direction, std::vector<RayHit>& hits, double t_min, double t_max) const {
  hits.clear();
  if (nodes_.empty()) return;
  const ShearedRay ray(origin, direction);
  const Vec3 inverse = direction.cwiseInverse();
  // Boxes a hair larger than they are: a rounding error must not lose a hit.
  const Vec3 slack = Vec3::Constant(1e-12 * (nodes_[0].box.hi - nodes_[0].box.lo).norm() + 1e-14 * origin.cwiseAbs().maxCoeff());
  const double t_slack = slack[0] / direction.cwiseAbs().maxCoeff();
  std::array<int, 64> stack;
  int top = 0;
  stack[top++] = 0;
  while (top > 0) {
    const int index = stack[--top];
    const Node& node = nodes_[index];
    if (!meets_box(node.box.lo - slack, node.box.hi + slack, origin, inverse, t_min - t_slack, t_max + t_slack)) continue;
    if (node.count == 0) {
      stack[top++] = node.first;
      stack[top++] = index + 1;
      continue;
    }
    for (int i = node.first; i < node.first + node.count; ++i) {
      RayHit hit;
      if (ray.meets(corners_[i], hit.t, hit.entering) && hit.t > t_min && hit.t <= t_max) {
        hit.triangle = triangle_[i];
        hits.push_back(hit);
      }
    }
  }
  std::sort(hits.begin(), hits.end(), [](const RayHit& a, const RayHit& b) { return a.t != b.t ? a.t < b.t : a.triangle < b.triangle; });
}

}  // namespace hexfeature
