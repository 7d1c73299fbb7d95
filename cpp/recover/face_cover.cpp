// HexFeatureWB - LGPL-2.1-or-later
#include "recover/face_cover.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "mesh/buckets.h"
#include "mesh/hex_element.h"
#include "mesh/incidence.h"
#include "mesh/triangle_tree.h"

namespace hexfeature {

namespace {

/// Points of the surface mesh that tell whether a face is covered by its own quads: its corners and what is on curved faces and edges.
/// Along a straight tangent edge that no mesh edge follows the border between two groups may be off by an element.
std::vector<char> telling_points(const SurfaceMesh& surface, const Geometry& geometry) {
  std::vector<char> telling(surface.points.size(), 0);
  for (int v = 0; v < surface.point_count(); ++v) {
    const CadPlace& place = surface.place[v];
    if (place.dim == 0) telling[v] = 1;
    if (place.dim == 2) telling[v] = geometry.face(place.entity).kind != SurfaceKind::Plane;
    if (place.dim != 1) continue;
    const CadEdge& edge = geometry.edge(place.entity);
    const Vec3 chord =
        geometry.projector->edge_point(place.entity, edge.t1).point - geometry.projector->edge_point(place.entity, edge.t0).point;
    telling[v] = edge.length - chord.norm() > 1e-6 * edge.length;
  }
  return telling;
}

/// The points of the surface mesh, once for each CAD face that they lie on, more of them along the faces' borders, and the quads that
/// cover them.
class Cover {
 public:
  struct Sample {
    int face, vertex;  ///< the vertex of the surface mesh where it is, or next to it
    Vec3 point;
    int quad = -1;  ///< nearest of its face
    double distance2 = std::numeric_limits<double>::infinity();
  };

  /// `wanted`: of the surface mesh's points; null: all.
  Cover(const HexComplex& mesh, const SurfaceMesh& surface, int faces, const std::vector<char>* wanted, double size, const Context& context)
      : mesh_(mesh) {
    constexpr double kDense = 0.3;  // of h: distance between samples along a border
    const auto is_wanted = [&](int v) { return wanted == nullptr || (*wanted)[v] != 0; };
    const Buckets by_face(faces + 1, surface.triangle_count(), [&](int t) { return std::max(surface.triangle_face[t], 0); });
    begin_.assign(faces + 2, 0);
    std::vector<int> sampled(surface.points.size(), 0);  // for which face last
    for (int face = 1; face <= faces; ++face) {
      begin_[face] = static_cast<int>(samples_.size());
      for (int i = by_face.start[face]; i < by_face.start[face + 1]; ++i)
        for (int v : surface.triangles[by_face.item[i]]) {
          if (sampled[v] != face && is_wanted(v)) samples_.push_back({face, v, surface.points[v]});
          sampled[v] = face;
        }
      for (int i = by_face.start[face]; i < by_face.start[face + 1]; ++i)
        for (int h = 3 * by_face.item[i]; h < 3 * by_face.item[i] + 3; ++h) {
          const int a = surface.from(h), b = surface.to(h);
          if (surface.halfedge_edge[h] <= 0 || !is_wanted(a) || !is_wanted(b)) continue;
          const Vec3 along = surface.points[b] - surface.points[a];
          const int pieces = static_cast<int>(std::ceil(along.norm() / (kDense * size)));
          for (int k = 1; k < pieces; ++k)
            samples_.push_back({face, 2 * k < pieces ? a : b, surface.points[a] + static_cast<double>(k) / pieces * along});
        }
    }
    begin_[faces + 1] = static_cast<int>(samples_.size());
    has_quads_.assign(faces + 1, 0);
    for (int f : mesh.quad_face)
      if (f > 0) has_quads_[f] = 1;
    if (mesh.quads.empty()) return;
    tree_ = TriangleTree(triangles_of_quads(mesh), context);
    for (std::size_t i = 0; i < samples_.size(); ++i) {
      if (i % 256 == 0) context.check();
      find(samples_[i], i > 0 && samples_[i - 1].face == samples_[i].face ? samples_[i - 1].quad : -1);
    }
  }

  std::vector<Sample>& samples() { return samples_; }
  int begin(int face) const { return begin_[face]; }
  int end(int face) const { return begin_[face + 1]; }
  int nearest_quad(const Vec3& p) const { return tree_.closest(p).triangle / 2; }
  double distance2(const Vec3& p, int quad) const {
    const auto& v = mesh_.quads[quad];
    double least = std::numeric_limits<double>::infinity();
    for (int k = 0; k < 2; ++k) {
      Vec3 weights;
      const Vec3 q = closest_on_triangle(p, mesh_.points[v[0]], mesh_.points[v[k + 1]], mesh_.points[v[k + 2]], weights);
      least = std::min(least, (q - p).squaredNorm());
    }
    return least;
  }
  /// `near`: a quad of the face, as the nearest is for a sample beside; it makes the search shorter. -1: none is known.
  void find(Sample& s, int near = -1) const {
    s.quad = -1;
    s.distance2 = std::numeric_limits<double>::infinity();
    if (!has_quads_[s.face]) return;
    constexpr double kRounding = 1 + 1e-9;  // the nearest one must not be lost for the last digit
    const double reach = near < 0 ? std::numeric_limits<double>::infinity() : kRounding * std::sqrt(distance2(s.point, near));
    const ClosestPoint c = tree_.closest_if(
        s.point, [&](int t) { return mesh_.quad_face[t / 2] == s.face; }, reach);
    s.quad = c.triangle < 0 ? near : c.triangle / 2;  // nothing nearer than that one
    s.distance2 = c.triangle < 0 && near >= 0 ? distance2(s.point, near) : c.distance2;
  }

 private:
  const HexComplex& mesh_;
  TriangleTree tree_;
  std::vector<Sample> samples_;  // by face
  std::vector<int> begin_;       // per face
  std::vector<char> has_quads_;  // per face: it had some at the beginning
};

/// Whether two faces meet in a smooth CAD edge.
class SmoothNeighbours {
 public:
  explicit SmoothNeighbours(const Geometry& geometry) {
    for (const CadEdge& e : *geometry.edges)
      if (!e.sharp && !e.degenerate && e.faces[1] > 0 && e.faces[0] != e.faces[1]) pairs_.push_back(std::minmax(e.faces[0], e.faces[1]));
    std::sort(pairs_.begin(), pairs_.end());
  }
  bool operator()(int a, int b) const { return std::binary_search(pairs_.begin(), pairs_.end(), std::pair<int, int>(std::minmax(a, b))); }

 private:
  std::vector<std::pair<int, int>> pairs_;
};

/// Quads that must keep their face: they lie along a sharp edge of it.
std::vector<char> quads_along_sharp_edges(const HexComplex& mesh, const Geometry& geometry) {
  std::vector<std::array<int, 2>> sharp;  // sorted, as feature_edges are
  for (std::size_t i = 0; i < mesh.feature_edges.size(); ++i)
    if (geometry.edge(mesh.feature_edge_cad[i]).sharp) sharp.push_back(mesh.feature_edges[i]);
  std::vector<char> along(mesh.quads.size(), 0);
  for (std::size_t q = 0; q < mesh.quads.size(); ++q)
    for (int k = 0; k < 4; ++k) {
      const int a = mesh.quads[q][k], b = mesh.quads[q][(k + 1) % 4];
      if (std::binary_search(sharp.begin(), sharp.end(), std::array<int, 2>{std::min(a, b), std::max(a, b)})) along[q] = 1;
    }
  return along;
}

}  // namespace

std::vector<double> face_gaps(const HexComplex& mesh, const SurfaceMesh& surface, const Geometry& geometry, double size,
                              const Context& context) {
  const int faces = static_cast<int>(geometry.faces->size());
  std::vector<double> gap(faces + 1, 0);
  const std::vector<char> telling = telling_points(surface, geometry);
  Cover cover(mesh, surface, faces, &telling, size, context);
  for (const Cover::Sample& s : cover.samples())
    if (s.quad >= 0) gap[s.face] = std::max(gap[s.face], std::sqrt(s.distance2));
  return gap;
}

std::vector<PointGap> point_gaps(const HexComplex& mesh, const SurfaceMesh& surface, const Geometry& geometry, double size,
                                 const Context& context) {
  Cover cover(mesh, surface, static_cast<int>(geometry.faces->size()), nullptr, size, context);
  std::vector<PointGap> gaps;
  for (const Cover::Sample& s : cover.samples()) gaps.push_back({s.point, std::sqrt(s.distance2)});
  return gaps;
}

std::vector<char> uncovered_points(const HexComplex& mesh, const SurfaceMesh& surface, const Geometry& geometry, double size, double limit,
                                   const Context& context) {
  std::vector<char> marked(surface.points.size(), 0);
  const std::vector<char> telling = telling_points(surface, geometry);
  Cover cover(mesh, surface, static_cast<int>(geometry.faces->size()), &telling, size, context);
  for (const Cover::Sample& s : cover.samples())
    if (s.quad < 0 || s.distance2 > limit * limit * size * size) marked[s.vertex] = 1;
  return marked;
}

int cover_faces(HexComplex& mesh, const SurfaceMesh& surface, const Geometry& geometry, double size, const Context& context) {
  constexpr double kSmall = 0.2;  // gaps below so many h are nobody's loss
  constexpr int kPasses = 4;
  const SmoothNeighbours smooth_neighbours(geometry);
  const std::vector<char> keep = quads_along_sharp_edges(mesh, geometry);
  Cover cover(mesh, surface, static_cast<int>(geometry.faces->size()), nullptr, size, context);
  std::vector<Cover::Sample>& samples = cover.samples();

  struct Change {
    int sample;
    Cover::Sample after;
  };
  std::vector<Change> changes;
  const auto improves = [&](int q, int face) {
    const int from = mesh.quad_face[q];
    double before = 0, after = 0;
    changes.clear();
    mesh.quad_face[q] = face;
    const auto note = [&](int i, const Cover::Sample& now) {
      changes.push_back({i, now});
      before = std::max(before, samples[i].distance2);
      after = std::max(after, now.distance2);
    };
    Vec3 middle = Vec3::Zero();
    for (int v : mesh.quads[q]) middle += 0.25 * mesh.points[v];
    double radius = 0;
    for (int v : mesh.quads[q]) radius = std::max(radius, (mesh.points[v] - middle).norm());
    for (int i = cover.begin(face); i < cover.end(face); ++i) {
      const double far = radius + std::sqrt(samples[i].distance2);
      if ((samples[i].point - middle).squaredNorm() > far * far) continue;
      const double d2 = cover.distance2(samples[i].point, q);
      if (d2 >= samples[i].distance2) continue;
      Cover::Sample now = samples[i];
      now.quad = q;
      now.distance2 = d2;
      note(i, now);
    }
    for (int i = cover.begin(from); i < cover.end(from); ++i) {
      if (samples[i].quad != q) continue;
      Cover::Sample now = samples[i];
      cover.find(now);
      note(i, now);
    }
    if (after < before) return true;
    mesh.quad_face[q] = from;
    return false;
  };

  int changed = 0;
  std::vector<int> bad, refused(mesh.quads.size(), 0);  // per quad: the face that it was last denied in this pass
  for (int pass = 0, before = -1; pass < kPasses && changed != before; ++pass) {
    before = changed;
    std::fill(refused.begin(), refused.end(), 0);
    bad.clear();
    for (int i = 0; i < static_cast<int>(samples.size()); ++i)
      if (samples[i].quad >= 0 && samples[i].distance2 > kSmall * kSmall * size * size) bad.push_back(i);
    std::stable_sort(bad.begin(), bad.end(), [&](int a, int b) { return samples[a].distance2 > samples[b].distance2; });
    for (int i : bad) {
      context.check();
      if (!(samples[i].distance2 > kSmall * kSmall * size * size)) continue;
      const int face = samples[i].face, q = cover.nearest_quad(samples[i].point);
      if (mesh.quad_face[q] == face || keep[q] || refused[q] == face || !smooth_neighbours(face, mesh.quad_face[q])) continue;
      if (!improves(q, face)) {
        refused[q] = face;
        continue;
      }
      for (const Change& c : changes) samples[c.sample] = c.after;
      ++changed;
    }
  }
  return changed;
}

std::vector<int> draw_to_gaps(HexComplex& mesh, const SurfaceMesh& surface, const Geometry& geometry, double size, const Context& context) {
  constexpr double kWanted = 0.36, kTooLong = 0.41;  // gaps of so many h
  constexpr double kReach = 1.2;                     // of h: how far from a gap points are looked for
  constexpr double kSound = 0.15, kKeep = 0.9;       // the worst element at a point stays above the one, or above so much of what it was
  constexpr double kLeastGain = 0.01;                // of h
  constexpr int kPasses = 6;
  const std::vector<char> telling = telling_points(surface, geometry);
  const Incidence hexes_at(mesh.hexes, mesh.points.size()), quads_at(mesh.quads, mesh.points.size());
  const auto worst_at = [&](int v) {
    double least = 1;
    for (int h : hexes_at.at(v)) {
      const auto& hex = mesh.hexes[h];
      least = std::min(least, proves_positive(mesh.points, hex) ? scaled_jacobian(mesh.points, hex) : -1.0);
    }
    return least;
  };
  const double too_long = kTooLong * size;
  std::vector<int> moved, near;
  bool any = true;
  for (int pass = 0; pass < kPasses && any; ++pass) {
    any = false;
    Cover cover(mesh, surface, static_cast<int>(geometry.faces->size()), &telling, size, context);
    std::vector<Cover::Sample>& samples = cover.samples();
    std::vector<std::vector<int>> quads_of(geometry.faces->size() + 1);
    for (int q = 0; q < static_cast<int>(mesh.quads.size()); ++q) quads_of[mesh.quad_face[q]].push_back(q);
    std::vector<int> bad;
    for (int i = 0; i < static_cast<int>(samples.size()); ++i)
      if (samples[i].quad >= 0 && samples[i].distance2 > too_long * too_long) bad.push_back(i);
    std::stable_sort(bad.begin(), bad.end(), [&](int a, int b) { return samples[a].distance2 > samples[b].distance2; });
    for (int i : bad) {
      context.check();
      const Cover::Sample& s = samples[i];
      near.clear();
      for (int q : quads_of[s.face])
        for (int v : mesh.quads[q])
          if ((mesh.points[v] - s.point).norm() < kReach * size) near.push_back(v);
      std::sort(near.begin(), near.end());
      near.erase(std::unique(near.begin(), near.end()), near.end());
      // A gap that a neighbour's move has closed already needs no other.
      const auto gap_at = [&](int v) {
        double least = std::numeric_limits<double>::infinity();
        for (int q : quads_at.at(v))
          if (mesh.quad_face[q] == s.face) least = std::min(least, cover.distance2(s.point, q));
        return std::sqrt(least);
      };
      double gap = std::numeric_limits<double>::infinity();
      for (int v : near) gap = std::min(gap, gap_at(v));
      if (gap < too_long) continue;
      // Of the points that could close it that one whose elements stay best; else the one that comes nearest.
      int best = -1;
      double best_gap = gap - kLeastGain * size, best_quality = -1;
      Vec3 best_point = s.point;
      Vec2 best_uv = Vec2::Zero();
      for (int v : near) {
        if (mesh.place[v].dim != 2) continue;
        const Vec3 from = mesh.points[v], way = s.point - from;
        const double distance = way.norm(), floor = std::min(kSound, kKeep * worst_at(v));
        for (double step : {1.0, 0.7, 0.4, 0.2}) {
          const Vec3 to = from + step * std::max(0.0, 1 - kWanted * size / distance) * way;
          const FacePoint f = geometry.projector->project_to_face(mesh.place[v].entity, to, &mesh.place[v].uv);
          mesh.points[v] = f.point;
          const double quality = worst_at(v), now = std::max(gap_at(v), kTooLong * size);
          mesh.points[v] = from;
          if (quality < floor || now > best_gap || (now == best_gap && quality <= best_quality)) continue;
          best = v;
          best_gap = now;
          best_quality = quality;
          best_point = f.point;
          best_uv = f.uv;
        }
      }
      if (best < 0) continue;
      mesh.points[best] = best_point;
      mesh.place[best].uv = best_uv;
      moved.push_back(best);
      any = true;
    }
  }
  std::sort(moved.begin(), moved.end());
  moved.erase(std::unique(moved.begin(), moved.end()), moved.end());
  return moved;
}

}  // namespace hexfeature
