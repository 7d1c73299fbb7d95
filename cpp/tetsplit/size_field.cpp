// HexFeatureWB - LGPL-2.1-or-later
#include "tetsplit/size_field.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <queue>
#include <unordered_map>
#include <utility>

namespace hexfeature {
namespace {

/// CAD edges that a point lies on, seams and poles left out.
std::vector<int> edges_of(const CadPlace& place, const Geometry& geometry) {
  std::vector<int> edges;
  const auto add = [&](int e) {
    if (e > 0 && !geometry.edge(e).seam && !geometry.edge(e).degenerate) edges.push_back(e);
  };
  if (place.dim == 1) add(place.entity);
  if (place.dim == 0)
    for (int e : geometry.vertex(place.entity).edges) add(e);
  return edges;
}

bool share_a_face(const CadEdge& a, const CadEdge& b) {
  for (int f : a.faces)
    for (int g : b.faces)
      if (f > 0 && f == g) return true;
  return false;
}

bool share_a_vertex(const CadEdge& a, const CadEdge& b) {
  for (int v : a.vertices)
    for (int w : b.vertices)
      if (v > 0 && v == w) return true;
  return false;
}

/// Whether two points stand on two edges across a face from one another: the distance is a width that the mesh has to respect.
bool across_a_face(const std::vector<int>& a, const std::vector<int>& b, const Geometry& geometry) {
  bool common = false;
  for (int e : a)
    for (int f : b) {
      if (e == f || share_a_vertex(geometry.edge(e), geometry.edge(f))) return false;
      common |= share_a_face(geometry.edge(e), geometry.edge(f));
    }
  return common;
}

}  // namespace

SizeField::SizeField(const SurfaceMesh& mesh, const Geometry& geometry, const SizeOptions& options, const Context& context)
    : mesh_(mesh), geometry_(geometry), tree_(mesh, context), length_(mesh.points.size(), options.longest), grading_(options.grading) {
  follow_curvature(options);
  context.check();
  follow_strips(options, context);
  follow_walls(options, context);
  grade(context);
}

double SizeField::at(const Vec3& p) const {
  const ClosestPoint c = tree_.closest(p);
  const auto& t = mesh_.triangles[c.triangle];
  return c.barycentric[0] * length_[t[0]] + c.barycentric[1] * length_[t[1]] + c.barycentric[2] * length_[t[2]];
}

void SizeField::follow_curvature(const SizeOptions& options) {
  const auto length_of = [&](double curvature, double tight) {
    return std::max(options.turn / curvature, std::min(tight / curvature, options.least_curve));
  };
  // Of the faces: how fast the true normals turn along triangle edges.
  for (int h = 0; h < 3 * mesh_.triangle_count(); ++h) {
    const int a = mesh_.from(h), b = mesh_.to(h);
    const double d = (mesh_.points[a] - mesh_.points[b]).norm();
    const double turn = (mesh_.corner_normals[h] - mesh_.corner_normals[SurfaceMesh::next(h)]).norm();
    if (!(d > 0) || turn < 1e-3) continue;
    const double length = length_of(turn / d, options.tight_face);
    lower(a, length);
    lower(b, length);
  }
  // Of the CAD edges: the circle through three successive points.
  std::vector<std::array<int, 2>> neighbours(mesh_.points.size(), {-1, -1});
  for (int h = 0; h < 3 * mesh_.triangle_count(); ++h) {
    const int e = mesh_.halfedge_edge[h], a = mesh_.from(h);
    if (e == 0 || mesh_.place[a].dim != 1 || mesh_.place[a].entity != e) continue;
    auto& n = neighbours[a];
    const int b = mesh_.to(h);
    if (n[0] < 0)
      n[0] = b;
    else if (n[0] != b)
      n[1] = b;
  }
  for (int v = 0; v < mesh_.point_count(); ++v) {
    const auto& n = neighbours[v];
    if (n[0] < 0 || n[1] < 0) continue;
    const Vec3 p = mesh_.points[n[0]] - mesh_.points[v], q = mesh_.points[n[1]] - mesh_.points[v];
    const double lengths = p.norm() * q.norm() * (p - q).norm();
    const double curvature = lengths > 0 ? 2 * p.cross(q).norm() / lengths : 0;
    if (curvature * options.longest > 1e-3) lower(v, length_of(curvature, options.tight_edge));
  }
}

void SizeField::follow_strips(const SizeOptions& options, const Context& context) {
  const auto length_of = [&](int e) { return std::max(options.strips * geometry_.edge(e).length, options.least); };
  std::vector<std::vector<int>> edges(mesh_.points.size());
  for (int v = 0; v < mesh_.point_count(); ++v) {
    edges[v] = edges_of(mesh_.place[v], geometry_);
    for (int e : edges[v]) lower(v, length_of(e));
  }
  // Points on CAD edges in cells of the longest distance that matters.
  const double reach = options.longest / options.strips;
  const auto cell = [&](const Vec3& p) -> std::array<long, 3> {
    return {std::lround(std::floor(p[0] / reach)), std::lround(std::floor(p[1] / reach)), std::lround(std::floor(p[2] / reach))};
  };
  const auto key = [](const std::array<long, 3>& c) { return (c[0] * 73856093L) ^ (c[1] * 19349663L) ^ (c[2] * 83492791L); };
  std::unordered_map<long, std::vector<int>> cells;
  for (int v = 0; v < mesh_.point_count(); ++v)
    if (!edges[v].empty()) cells[key(cell(mesh_.points[v]))].push_back(v);
  for (int v = 0; v < mesh_.point_count(); ++v) {
    if (v % 1024 == 0) context.check();
    if (edges[v].empty()) continue;
    const auto c = cell(mesh_.points[v]);
    for (long i = -1; i <= 1; ++i)
      for (long j = -1; j <= 1; ++j)
        for (long k = -1; k <= 1; ++k) {
          const auto it = cells.find(key({c[0] + i, c[1] + j, c[2] + k}));
          if (it == cells.end()) continue;
          for (int w : it->second) {
            const double d = (mesh_.points[v] - mesh_.points[w]).norm();
            const double length = std::max(options.strips * d, options.least);
            if (w != v && length < length_[v] && across_a_face(edges[v], edges[w], geometry_)) lower(v, length);
          }
        }
  }
}

void SizeField::follow_walls(const SizeOptions& options, const Context& context) {
  std::vector<RayHit> hits;
  for (int t = 0; t < mesh_.triangle_count(); ++t) {
    if (t % 256 == 0) context.check();
    const Vec3 inward = -mesh_.mean_normal(t);
    const double reach = options.longest / options.walls;
    tree_.ray_hits(mesh_.centroid(t) + 1e-6 * reach * inward, inward, hits, 0, reach);
    for (const RayHit& hit : hits) {
      if (hit.entering || hit.triangle == t) continue;
      // A wall has two sides that look away from each other; the sides of a wedge meet anyway.
      if (mesh_.mean_normal(hit.triangle).dot(inward) < 0.7) break;
      const double length = std::max(options.walls * hit.t, options.least_wall);
      for (int v : mesh_.triangles[t]) lower(v, length);
      for (int v : mesh_.triangles[hit.triangle]) lower(v, length);
      break;
    }
  }
}

void SizeField::grade(const Context& context) {
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
  for (int v = 0; v < mesh_.point_count(); ++v) queue.push({length_[v], v});
  std::vector<int> begin(mesh_.points.size() + 1, 0), neighbours(3 * mesh_.triangles.size());
  for (int h = 0; h < 3 * mesh_.triangle_count(); ++h) ++begin[mesh_.from(h) + 1];
  for (std::size_t v = 0; v < mesh_.points.size(); ++v) begin[v + 1] += begin[v];
  std::vector<int> at(begin.begin(), begin.end() - 1);
  for (int h = 0; h < 3 * mesh_.triangle_count(); ++h) neighbours[at[mesh_.from(h)]++] = mesh_.to(h);
  for (std::size_t done = 0; !queue.empty(); ++done) {
    if (done % 8192 == 0) context.check();
    const auto [length, v] = queue.top();
    queue.pop();
    if (length > length_[v]) continue;
    for (int i = begin[v]; i < begin[v + 1]; ++i) {
      const int w = neighbours[i];
      const double most = length + grading_ * (mesh_.points[v] - mesh_.points[w]).norm();
      if (most >= length_[w]) continue;
      length_[w] = most;
      queue.push({most, w});
    }
  }
}

void SizeField::refine(const std::vector<Vec3>& near, double factor, const Context& context) {
  std::vector<double> wanted = length_;
  for (std::size_t i = 0; i < near.size(); ++i) {
    if (i % 1024 == 0) context.check();
    const ClosestPoint c = tree_.closest(near[i]);
    for (int v : mesh_.triangles[c.triangle]) wanted[v] = std::min(wanted[v], factor * length_[v]);
  }
  length_ = std::move(wanted);
  grade(context);
}

SizeField SizeField::scaled(double factor) const {
  SizeField other = *this;
  for (double& length : other.length_) length *= factor;
  return other;
}

}  // namespace hexfeature
