// HexFeatureWB - LGPL-2.1-or-later
#include "mesh/cut_mesh.h"

#include <algorithm>
#include <cmath>

namespace hexfeature {
namespace {

Vec3 blend(const Vec3& a, const Vec3& b, double s) {
  const Vec3 n = (1 - s) * a + s * b;
  const double length = n.norm();
  return length > 1e-6 ? Vec3(n / length) : a;
}

}  // namespace

SurfaceCutter::SurfaceCutter(SurfaceMesh& mesh, const Projector* projector, double snap)
    : mesh_(mesh),
      projector_(projector),
      snap_(snap),
      first_new_(mesh.triangle_count()),
      pinned_(mesh.point_count(), 0),
      in_patch_(mesh.triangle_count(), 0),
      value_(mesh.point_count(), 0.0),
      normal_(mesh.point_count(), Vec3::Zero()) {}

void SurfaceCutter::cut(std::vector<int>& patch, const CutFunction& f, std::vector<signed char>& side) {
  load_patch(patch, f);
  const int old_points = mesh_.point_count();
  if (f.resolution > 0) refine(patch, f);
  snap_vertices(patch, f);

  // Bisect the longest wanted crossing of each triangle until none is left; pieces join the end of the list.
  for (std::size_t i = 0; i < patch.size(); ++i)
    for (bool again = true; again;) {
      again = false;
      int longest = -1;
      double most = 0;
      for (int h = 3 * patch[i]; h < 3 * patch[i] + 3; ++h) {
        if (!crossed(h) || (f.accept && !wanted(h, root(h, f), f))) continue;
        const double length = (mesh_.points[mesh_.to(h)] - mesh_.points[mesh_.from(h)]).squaredNorm();
        if (length > most) most = length, longest = h;
      }
      if (longest >= 0) {
        split(longest, crossing_point(longest, f), patch);
        again = true;
      }
    }

  side.resize(patch.size());
  for (std::size_t i = 0; i < patch.size(); ++i) {
    double low = 0, high = 0;
    for (int v : mesh_.triangles[patch[i]]) {
      low = std::min(low, value_[v]);
      high = std::max(high, value_[v]);
    }
    if ((low < 0) == (high > 0)) low = high = f.value(mesh_.centroid(patch[i]), mesh_.mean_normal(patch[i]));
    side[i] = low + high < 0 ? -1 : 1;
  }

  for (int t : patch) {
    in_patch_[t] = 0;
    for (int v : mesh_.triangles[t]) {
      if (value_[v] == 0 && (v >= old_points || !f.accept)) pinned_[v] = 1;
      normal_[v] = Vec3::Zero();
    }
  }
  for (int t : patch)
    for (int v : mesh_.triangles[t]) value_[v] = 0;
}

void SurfaceCutter::load_patch(const std::vector<int>& patch, const CutFunction& f) {
  for (int t : patch) {
    in_patch_[t] = 1;
    for (int k = 0; k < 3; ++k) normal_[mesh_.triangles[t][k]] += mesh_.corner_normals[3 * t + k];
  }
  for (int t : patch)
    for (int k = 0; k < 3; ++k) {
      const int v = mesh_.triangles[t][k];
      const double length = normal_[v].norm();
      normal_[v] = length > 1e-6 ? Vec3(normal_[v] / length) : mesh_.corner_normals[3 * t + k];
      value_[v] = f.value(mesh_.points[v], normal_[v]);
    }
}

/// Where f vanishes on a crossed edge (Illinois variant of regula falsi, on the chord with blended normals).
double SurfaceCutter::root(int h, const CutFunction& f) const {
  const int a = mesh_.from(h), b = mesh_.to(h);
  double s0 = 0, s1 = 1, f0 = value_[a], f1 = value_[b], s = 0.5;
  const double scale = std::max(std::abs(f0), std::abs(f1));
  for (int i = 0; i < 12; ++i) {
    s = s0 + (s1 - s0) * f0 / (f0 - f1);
    const double g = f.value((1 - s) * mesh_.points[a] + s * mesh_.points[b], blend(normal_[a], normal_[b], s));
    if (std::abs(g) <= 1e-9 * scale || s1 - s0 < 1e-9) break;
    if ((g < 0) == (f1 < 0)) {
      s1 = s, f1 = g;
      f0 *= 0.5;
    } else {
      s0 = s1, f0 = f1;
      s1 = s, f1 = g;
    }
  }
  return std::clamp(s, 0.0, 1.0);
}

bool SurfaceCutter::wanted(int h, double s, const CutFunction& f) const {
  const int a = mesh_.from(h), b = mesh_.to(h);
  return f.accept((1 - s) * mesh_.points[a] + s * mesh_.points[b], blend(normal_[a], normal_[b], s));
}

/// The point at fraction s of halfedge h, put onto its true curve or surface where that is safe.
SurfaceCutter::EdgePoint SurfaceCutter::point_on(int h, double s) const {
  const int o = mesh_.opposite[h], a = mesh_.from(h), b = mesh_.to(h);
  const CadPlace &pa = mesh_.place[a], &pb = mesh_.place[b];
  const Vec3 chord = mesh_.points[b] - mesh_.points[a];
  EdgePoint at;
  at.point = mesh_.points[a] + s * chord;
  at.left_normal = blend(mesh_.corner_normals[h], mesh_.corner_normals[SurfaceMesh::next(h)], s);
  at.right_normal = blend(mesh_.corner_normals[SurfaceMesh::next(o)], mesh_.corner_normals[o], s);
  const double reach = 0.5 * chord.norm();
  const int edge = mesh_.halfedge_edge[h], face = mesh_.triangle_face[h / 3];
  const CadPlace& near = s < 0.5 ? pa : pb;
  const CadPlace& far = s < 0.5 ? pb : pa;

  if (edge > 0) {
    at.place = {1, edge, Vec2::Zero()};
    if (!projector_) return at;
    const bool near_known = near.dim == 1 && near.entity == edge, far_known = far.dim == 1 && far.entity == edge;
    double guess = near_known ? near.uv[0] : far.uv[0];
    if (near_known && far_known) guess = (1 - s) * pa.uv[0] + s * pb.uv[0];
    CurvePoint on = projector_->project_to_edge(edge, at.point, near_known || far_known ? &guess : nullptr);
    // A guess blended across a closed curve's start lies on its far side: ask again without one.
    if ((near_known || far_known) && (on.point - at.point).norm() > reach) on = projector_->project_to_edge(edge, at.point, nullptr);
    at.place.uv[0] = on.t;
    if ((on.point - at.point).norm() <= reach) at.point = on.point;
    return at;
  }
  at.place = {2, face, Vec2::Zero()};
  if (!projector_ || mesh_.triangle_face[o / 3] != face) return at;
  const Vec2* guess = nullptr;
  if (near.dim == 2 && near.entity == face)
    guess = &near.uv;
  else if (far.dim == 2 && far.entity == face)
    guess = &far.uv;
  const FacePoint on = projector_->project_to_face(face, at.point, guess);
  at.place.uv = on.uv;
  if ((on.point - at.point).norm() > reach || on.normal.dot(at.left_normal) < 0.5) return at;
  at.point = on.point;
  at.left_normal = at.right_normal = on.normal;
  return at;
}

/// The point of a crossed edge where f vanishes on the true curve or surface, not just on the chord.
SurfaceCutter::EdgePoint SurfaceCutter::crossing_point(int h, const CutFunction& f) const {
  const double f0 = value_[mesh_.from(h)], f1 = value_[mesh_.to(h)], scale = std::max(std::abs(f0), std::abs(f1));
  double s = root(h, f);
  EdgePoint at = point_on(h, s);
  if (!projector_) return at;
  for (int i = 0; i < 2; ++i) {
    const double g = f.value(at.point, in_patch_[h / 3] ? at.left_normal : at.right_normal);
    if (std::abs(g) <= 1e-4 * scale) break;
    s = (g < 0) == (f0 < 0) ? s + (1 - s) * g / (g - f1) : s * f0 / (f0 - g);
    at = point_on(h, s);
  }
  return at;
}

/// Edges with one sign at both ends and the other in the middle: bisect them there.
void SurfaceCutter::refine(std::vector<int>& patch, const CutFunction& f) {
  for (std::size_t i = 0; i < patch.size(); ++i)
    for (int k = 0; k < 3; ++k) {
      const int h = 3 * patch[i] + k, a = mesh_.from(h), b = mesh_.to(h);
      if (value_[a] * value_[b] <= 0 || (mesh_.points[a] - mesh_.points[b]).norm() <= f.resolution) continue;
      const EdgePoint at = point_on(h, 0.5);
      const Vec3 normal = blend(normal_[a], normal_[b], 0.5);
      const double g = f.value(at.point, normal);
      if (g * value_[a] >= 0) continue;
      const int v = split(h, at, patch);
      value_[v] = g;
      normal_[v] = normal;
      k = -1;
    }
}

void SurfaceCutter::snap_vertices(const std::vector<int>& patch, const CutFunction& f) {
  struct Candidate {
    int vertex, halfedge;
    double distance;
  };
  std::vector<Candidate> candidates;
  for (int t : patch)
    for (int h = 3 * t; h < 3 * t + 3; ++h) {
      if (!crossed(h) || (h > mesh_.opposite[h] && in_patch_[mesh_.opposite[h] / 3])) continue;
      const double s = root(h, f);
      if (f.accept && !wanted(h, s, f)) continue;
      if (s < snap_) candidates.push_back({mesh_.from(h), h, s});
      if (1 - s < snap_) candidates.push_back({mesh_.to(h), h, 1 - s});
    }
  std::stable_sort(candidates.begin(), candidates.end(), [](const Candidate& x, const Candidate& y) { return x.distance < y.distance; });
  for (const Candidate& c : candidates) {
    if (!crossed(c.halfedge)) continue;  // an end has been taken already
    const double s = root(c.halfedge, f), distance = mesh_.from(c.halfedge) == c.vertex ? s : 1 - s;
    if (distance > snap_) continue;
    if (!slide(c.vertex, c.halfedge, s) && distance > 0.25 * snap_) continue;
    value_[c.vertex] = 0;
    pinned_[c.vertex] = 1;
  }
}

/// Move a vertex along halfedge h (which it ends) to fraction s, on its own face or CAD edge, if no triangle suffers.
bool SurfaceCutter::slide(int vertex, int h, double s) {
  const CadPlace& place = mesh_.place[vertex];
  if (pinned_[vertex] || place.dim == 0 || place.dim > 2) return false;
  if (place.dim == 1 && (place.entity == 0 || mesh_.halfedge_edge[h] != place.entity)) return false;
  const EdgePoint at = point_on(h, s);
  if (at.place.dim != place.dim || at.place.entity != place.entity) return false;

  const int first = mesh_.from(h) == vertex ? h : SurfaceMesh::next(h);  // a halfedge that leaves the vertex
  for (int g = first;;) {
    const Vec3 &p = mesh_.points[mesh_.to(g)], &q = mesh_.points[mesh_.from(SurfaceMesh::prev(g))];
    const Vec3 before = mesh_.area_normal(g / 3), after = (p - at.point).cross(q - at.point);
    if (after.dot(before) < 0.3 * before.squaredNorm()) return false;
    if (place.dim == 2 && mesh_.triangle_face[g / 3] != place.entity) return false;
    g = mesh_.opposite[SurfaceMesh::prev(g)];
    if (g == first) break;
  }
  const int left_face = mesh_.triangle_face[h / 3];
  for (int g = first;;) {
    mesh_.corner_normals[g] = mesh_.triangle_face[g / 3] == left_face ? at.left_normal : at.right_normal;
    g = mesh_.opposite[SurfaceMesh::prev(g)];
    if (g == first) break;
  }
  mesh_.points[vertex] = at.point;
  mesh_.place[vertex] = at.place;
  normal_[vertex] = in_patch_[h / 3] ? at.left_normal : at.right_normal;
  return true;
}

/// Bisect halfedge h = a -> b and its opposite at a new point p; returns p. With c, d the points opposite:
///      c                 c
///     / \               /|\      t = (a,b,c) -> (a,p,c) and T = (p,b,c)
///    a---b      ->     a-p-b     u = (b,a,d) -> (p,a,d) and U = (b,p,d)
///     \ /               \|/
///      d                 d
int SurfaceCutter::split(int h, const EdgePoint& at, std::vector<int>& patch) {
  SurfaceMesh& m = mesh_;
  const int o = m.opposite[h], h1 = SurfaceMesh::next(h), o1 = SurfaceMesh::next(o), o2 = SurfaceMesh::prev(o);
  const int t = h / 3, u = o / 3, a = m.from(h), b = m.to(h), c = m.to(h1), d = m.to(o1);
  const int p = m.point_count(), T = m.triangle_count(), U = T + 1;

  // On the true surface unless that turns a triangle over (a sliver beside a bulging curve): then on the chord.
  const auto folds = [&](int from, int to, int apex, const Vec3& flat) {
    const Vec3 n = (m.points[to] - m.points[from]).cross(m.points[apex] - m.points[from]);
    return n.dot(flat) <= 1e-3 * n.norm() * flat.norm();
  };
  m.points.push_back(at.point);
  const Vec3 flat_t = m.area_normal(t), flat_u = m.area_normal(u);
  if (folds(a, p, c, flat_t) || folds(p, b, c, flat_t) || folds(p, a, d, flat_u) || folds(b, p, d, flat_u)) {
    const Vec3 e = m.points[b] - m.points[a];
    const double s = std::clamp((at.point - m.points[a]).dot(e) / std::max(e.squaredNorm(), 1e-300), 0.01, 0.99);
    m.points[p] = m.points[a] + s * e;
  }
  m.place.push_back(at.place);
  value_.push_back(0);
  pinned_.push_back(0);
  normal_.push_back(in_patch_[t] ? at.left_normal : at.right_normal);

  // Halfedges b -> c and d -> b move to the new triangles.
  const auto moved = [&](int x) { return x == h1 ? 3 * T + 1 : x == o2 ? 3 * U + 2 : x; };
  const int beyond_bc = moved(m.opposite[h1]), beyond_db = moved(m.opposite[o2]);
  const int edge = m.halfedge_edge[h], edge_bc = m.halfedge_edge[h1], edge_db = m.halfedge_edge[o2];
  const Vec3 normal_b = m.corner_normals[h1], normal_c = m.corner_normals[SurfaceMesh::prev(h)];
  const Vec3 normal_b_right = m.corner_normals[o], normal_d = m.corner_normals[o2];

  m.triangles[t][h1 % 3] = p;
  m.triangles[u][o % 3] = p;
  m.triangles.push_back({p, b, c});
  m.triangles.push_back({b, p, d});
  m.corner_normals[h1] = at.left_normal;
  m.corner_normals[o] = at.right_normal;
  for (const Vec3& n : {at.left_normal, normal_b, normal_c, normal_b_right, at.right_normal, normal_d}) m.corner_normals.push_back(n);
  m.halfedge_edge[h1] = m.halfedge_edge[o2] = 0;
  for (int e : {edge, edge_bc, 0, edge, 0, edge_db}) m.halfedge_edge.push_back(e);
  m.opposite.resize(m.opposite.size() + 6);
  const auto join = [&](int x, int y) { m.opposite[x] = y, m.opposite[y] = x; };
  join(3 * T, 3 * U);          // p-b
  join(h1, 3 * T + 2);         // p-c
  join(o2, 3 * U + 1);         // p-d
  join(3 * T + 1, beyond_bc);  // b-c
  join(3 * U + 2, beyond_db);  // d-b
  for (int from : {t, u}) {
    m.triangle_face.push_back(m.triangle_face[from]);
    parents_.push_back(from);
    in_patch_.push_back(in_patch_[from]);
    if (in_patch_[from]) patch.push_back(from == t ? T : U);
  }
  return p;
}

}  // namespace hexfeature
