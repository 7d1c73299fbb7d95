// HexFeatureWB - LGPL-2.1-or-later
#include "quality/limits.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "mesh/hex_element.h"

namespace hexfeature {
namespace {

constexpr double kPi = 3.14159265358979323846;

/// Unit direction in which an edge leaves a vertex; zero when it does not begin or end there.
Vec3 leaving(const Geometry& geometry, int edge, int vertex) {
  const CadEdge& e = geometry.edge(edge);
  if (e.vertices[0] == vertex) return geometry.projector->edge_point(edge, e.t0).tangent;
  if (e.vertices[1] == vertex) return -geometry.projector->edge_point(edge, e.t1).tangent;
  return Vec3::Zero();
}

bool on_face(const CadEdge& edge, int face) { return edge.faces[0] == face || edge.faces[1] == face; }

void find_tips(const Geometry& geometry, Limits& limits) {
  constexpr double kNarrow = kPi / 6;
  for (int v = 1; v <= static_cast<int>(geometry.vertices->size()); ++v) {
    const CadVertex& vertex = geometry.vertex(v);
    for (std::size_t i = 0; i < vertex.edges.size(); ++i)
      for (std::size_t j = i + 1; j < vertex.edges.size(); ++j) {
        const CadEdge &a = geometry.edge(vertex.edges[i]), &b = geometry.edge(vertex.edges[j]);
        if (!a.sharp || !b.sharp || vertex.edges[i] == vertex.edges[j]) continue;
        const Vec3 da = leaving(geometry, vertex.edges[i], v), db = leaving(geometry, vertex.edges[j], v);
        if (da.isZero() || db.isZero()) continue;
        const double angle = std::acos(std::clamp(da.dot(db), -1.0, 1.0));
        if (angle > kNarrow) continue;
        for (int face : a.faces) {
          if (face <= 0 || !on_face(b, face)) continue;
          // Is the face between the two edges, or all round them? A point between them, a little way off, tells.
          const double step = 0.05 * std::min(a.length, b.length);
          const auto ahead = [&](int edge, const CadEdge& e) {
            const double t = e.vertices[0] == v ? e.t0 + 0.05 * (e.t1 - e.t0) : e.t1 - 0.05 * (e.t1 - e.t0);
            return geometry.projector->edge_point(edge, t).point;
          };
          const Vec3 between = 0.5 * (ahead(vertex.edges[i], a) + ahead(vertex.edges[j], b));
          const double width = (ahead(vertex.edges[i], a) - ahead(vertex.edges[j], b)).norm();
          const FacePoint foot = geometry.projector->project_to_face(face, between, nullptr);
          const Vec3 side = foot.point - between - foot.normal.dot(foot.point - between) * foot.normal;
          if (side.norm() > 0.1 * width + 1e-6 * step) continue;
          limits.tips.push_back({v, face, angle, angle_bound(std::max(angle, 0.0))});
        }
      }
  }
}

}  // namespace

double angle_bound(double theta, int* best_count) {
  const int nearest = std::max(1, static_cast<int>(std::lround(theta / (kPi / 2))));
  double best = 0;
  for (int k = std::max(1, nearest - 1); k <= nearest + 1; ++k) {
    const double bound = std::sin(theta / k);
    if (bound <= best) continue;
    best = bound;
    if (best_count != nullptr) *best_count = k;
  }
  return best;
}

Limits measure_limits(const HexComplex& mesh, const Geometry& geometry) {
  Limits limits;
  std::vector<int> row(geometry.edges->size() + 1, -1);
  for (int id = 1; id <= static_cast<int>(geometry.edges->size()); ++id) {
    const CadEdge& edge = geometry.edge(id);
    if (!edge.sharp || edge.seam || edge.degenerate || edge.faces[1] == 0) continue;
    EdgeLimit limit;
    limit.cad_edge = id;
    limit.angle = kPi - edge.dihedral;
    limit.bound = angle_bound(limit.angle, &limit.best_count);
    limits.bound = std::min(limits.bound, limit.bound);
    row[id] = static_cast<int>(limits.edges.size());
    limits.edges.push_back(limit);
  }
  std::vector<int> sharing(mesh.feature_edges.size(), 0);
  for (const auto& hex : mesh.hexes) {
    double quality = -2;  // measured where it is needed
    for (const auto& e : kHexEdges) {
      const std::array<int, 2> key{std::min(hex[e[0]], hex[e[1]]), std::max(hex[e[0]], hex[e[1]])};
      const auto it = std::lower_bound(mesh.feature_edges.begin(), mesh.feature_edges.end(), key);
      if (it == mesh.feature_edges.end() || *it != key) continue;
      const std::size_t i = static_cast<std::size_t>(it - mesh.feature_edges.begin());
      const int r = row[mesh.feature_edge_cad[i]];
      if (r < 0) continue;
      if (quality < -1) quality = scaled_jacobian(mesh.points, hex);
      EdgeLimit& limit = limits.edges[r];
      limit.min_sj = std::min(limit.min_sj, quality);
      limit.most_crowded = std::max(limit.most_crowded, ++sharing[i]);
    }
  }
  find_tips(geometry, limits);
  return limits;
}

}  // namespace hexfeature
