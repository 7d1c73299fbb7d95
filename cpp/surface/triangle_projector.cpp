// HexFeatureWB - LGPL-2.1-or-later
#include "surface/triangle_projector.h"

#include <algorithm>
#include <cmath>

namespace hexfeature {
namespace {

/// Closest point of a segment, as a fraction.
double closest_on_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 e = b - a;
  const double e2 = e.squaredNorm();
  return e2 > 0 ? std::clamp((p - a).dot(e) / e2, 0.0, 1.0) : 0.0;
}

/// Closest point of a triangle as barycentric coordinates: inside its plane's foot when that is in, else the best of its sides.
Vec3 closest_on_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 n = (b - a).cross(c - a);
  const double n2 = n.squaredNorm();
  if (n2 > 0) {
    const Vec3 w(n.dot((c - b).cross(p - b)), n.dot((a - c).cross(p - c)), n.dot((b - a).cross(p - a)));
    if (w.minCoeff() >= 0) return w / w.sum();
  }
  Vec3 best = Vec3::UnitX();
  double best2 = std::numeric_limits<double>::max();
  const Vec3* corner[3] = {&a, &b, &c};
  for (int k = 0; k < 3; ++k) {
    const Vec3 &q = *corner[k], &r = *corner[(k + 1) % 3];
    const double s = closest_on_segment(p, q, r), d = (q + s * (r - q) - p).squaredNorm();
    if (d < best2) {
      best2 = d;
      best = Vec3::Zero();
      best[k] = 1 - s;
      best[(k + 1) % 3] = s;
    }
  }
  return best;
}

}  // namespace

TriangleProjector::TriangleProjector(const SurfaceMesh& mesh, std::size_t face_count, const std::vector<std::vector<int>>& chains,
                                     const std::vector<CadVertex>& vertices)
    : points_(mesh.points),
      triangles_(mesh.triangles),
      triangle_face_(mesh.triangle_face),
      corner_normals_(mesh.corner_normals),
      faces_(face_count) {
  for (int t = 0; t < mesh.triangle_count(); ++t) faces_[triangle_face_[t] - 1].triangles.push_back(t);
  std::vector<BoxTree::Box> boxes;
  for (Face& face : faces_) {
    boxes.assign(face.triangles.size(), {});
    for (std::size_t i = 0; i < boxes.size(); ++i)
      for (const int v : triangles_[face.triangles[i]]) boxes[i].add(points_[v]);
    face.tree = BoxTree(boxes);
  }
  for (const auto& list : chains) {
    Chain chain;
    double t = 0;
    for (std::size_t i = 0; i < list.size(); ++i) {
      if (i > 0) t += (points_[list[i]] - points_[list[i - 1]]).norm();
      chain.points.push_back(points_[list[i]]);
      chain.t.push_back(t);
    }
    boxes.assign(list.size() - 1, {});
    for (std::size_t i = 0; i + 1 < list.size(); ++i) {
      boxes[i].add(chain.points[i]);
      boxes[i].add(chain.points[i + 1]);
    }
    chain.tree = BoxTree(boxes);
    chains_.push_back(std::move(chain));
  }
  for (const CadVertex& v : vertices) vertices_.push_back(v.point);
}

FacePoint TriangleProjector::project_to_face(int face_id, const Vec3& p, const Vec2* guess) const {
  const Face& face = faces_[face_id - 1];
  const auto foot = [&](int t) {
    const auto& v = triangles_[t];
    return closest_on_triangle(p, points_[v[0]], points_[v[1]], points_[v[2]]);
  };
  const auto at = [&](int t, const Vec3& w) {
    const auto& v = triangles_[t];
    return Vec3(w[0] * points_[v[0]] + w[1] * points_[v[1]] + w[2] * points_[v[2]]);
  };
  double bound = std::numeric_limits<double>::max();
  int best = -1;
  if (guess != nullptr && (*guess)[0] >= 0 && (*guess)[0] < static_cast<double>(triangles_.size())) {
    const int t = static_cast<int>((*guess)[0]);
    if (triangle_face_[t] == face_id) {
      best = t;
      bound = (at(t, foot(t)) - p).squaredNorm();
    }
  }
  const int found = face.tree.nearest(p, bound, [&](int i) { return (at(face.triangles[i], foot(face.triangles[i])) - p).squaredNorm(); });
  if (found >= 0) best = face.triangles[found];
  if (best < 0) best = face.triangles.front();  // not a number
  const Vec3 w = foot(best);
  const Vec3 n = w[0] * corner_normals_[3 * best] + w[1] * corner_normals_[3 * best + 1] + w[2] * corner_normals_[3 * best + 2];
  return {at(best, w), n.norm() > 0.1 ? Vec3(n.normalized()) : corner_normals_[3 * best], {static_cast<double>(best), 0}};
}

CurvePoint TriangleProjector::on_segment(const Chain& chain, int i, double s) const {
  const Vec3 e = chain.points[i + 1] - chain.points[i];
  return {chain.points[i] + s * e, e.stableNormalized(), chain.t[i] + s * (chain.t[i + 1] - chain.t[i])};
}

CurvePoint TriangleProjector::project_to_edge(int edge, const Vec3& p, const double*) const {
  const Chain& chain = chains_[edge - 1];
  const auto fraction = [&](int i) { return closest_on_segment(p, chain.points[i], chain.points[i + 1]); };
  const int i = chain.tree.nearest(p, std::numeric_limits<double>::max(), [&](int k) {
    return (chain.points[k] + fraction(k) * (chain.points[k + 1] - chain.points[k]) - p).squaredNorm();
  });
  return on_segment(chain, std::max(i, 0), fraction(std::max(i, 0)));
}

Vec3 TriangleProjector::vertex_point(int vertex) const { return vertices_[vertex - 1]; }

CurvePoint TriangleProjector::edge_point(int edge, double t) const {
  const Chain& chain = chains_[edge - 1];
  const auto above = std::upper_bound(chain.t.begin() + 1, chain.t.end() - 1, t);
  const int i = static_cast<int>(above - chain.t.begin()) - 1;
  const double range = chain.t[i + 1] - chain.t[i];
  return on_segment(chain, i, range > 0 ? std::clamp((t - chain.t[i]) / range, 0.0, 1.0) : 0.0);
}

}  // namespace hexfeature
