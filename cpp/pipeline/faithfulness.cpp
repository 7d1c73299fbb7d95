// HexFeatureWB - LGPL-2.1-or-later
#include "pipeline/faithfulness.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "recover/face_cover.h"

namespace hexfeature {

namespace {

/// The mesh edges between the quads of two CAD faces.
class BorderSegments {
 public:
  explicit BorderSegments(const HexComplex& mesh) {
    struct Side {
      std::array<int, 2> edge;
      int face;
    };
    std::vector<Side> sides;
    for (std::size_t q = 0; q < mesh.quads.size(); ++q)
      for (int k = 0; k < 4; ++k) {
        const int a = mesh.quads[q][k], b = mesh.quads[q][(k + 1) % 4];
        sides.push_back({{std::min(a, b), std::max(a, b)}, mesh.quad_face[q]});
      }
    std::sort(sides.begin(), sides.end(),
              [](const Side& x, const Side& y) { return x.edge != y.edge ? x.edge < y.edge : x.face < y.face; });
    for (std::size_t i = 0; i + 1 < sides.size(); ++i)
      if (sides[i].edge == sides[i + 1].edge && sides[i].face != sides[i + 1].face)
        segments_.push_back({{sides[i].face, sides[i + 1].face}, sides[i].edge});
    std::sort(segments_.begin(), segments_.end());
  }

  /// Fraction of a CAD edge that has a mesh edge between its two faces within a quarter of an element, none of many element sizes.
  double follow(const HexComplex& mesh, const Geometry& geometry, int id, double size) const {
    constexpr int kSamples = 40;
    constexpr double kNear = 0.25, kLongest = 5;
    const CadEdge& edge = geometry.edge(id);
    const std::array<int, 2> faces{std::min(edge.faces[0], edge.faces[1]), std::max(edge.faces[0], edge.faces[1])};
    const auto begin = std::lower_bound(segments_.begin(), segments_.end(), Segment{faces, {-1, -1}});
    int near = 0;
    for (int i = 0; i < kSamples; ++i) {
      const Vec3 p = geometry.projector->edge_point(id, edge.t0 + (edge.t1 - edge.t0) * i / (kSamples - 1)).point;
      for (auto s = begin; s != segments_.end() && s->first == faces; ++s) {
        const Vec3& a = mesh.points[s->second[0]];
        const Vec3 e = mesh.points[s->second[1]] - a;
        if (e.norm() > kLongest * size) continue;
        const double t = std::clamp((p - a).dot(e) / std::max(e.squaredNorm(), 1e-300), 0.0, 1.0);
        if ((a + t * e - p).norm() > kNear * size) continue;
        ++near;
        break;
      }
    }
    return static_cast<double>(near) / kSamples;
  }

 private:
  using Segment = std::pair<std::array<int, 2>, std::array<int, 2>>;  ///< faces, nodes
  std::vector<Segment> segments_;
};

bool is_of_solid(const Geometry& geometry, int face, int solid) { return face > 0 && (solid == 0 || geometry.face(face).solid == solid); }

/// The edges that a mesh has to follow.
bool counts(const Geometry& geometry, const CadEdge& edge, int solid) {
  return edge.sharp && !edge.seam && !edge.degenerate && is_of_solid(geometry, edge.faces[0], solid);
}

}  // namespace

Faithfulness measure_faithfulness(const HexComplex& mesh, const Geometry& geometry, int solid, const SurfaceMesh* surface, double size,
                                  const Context& context) {
  Faithfulness result;
  const int faces = static_cast<int>(geometry.faces->size()), edges = static_cast<int>(geometry.edges->size());
  const auto of_solid = [&](int face) { return is_of_solid(geometry, face, solid); };

  std::vector<char> has_quads(faces + 1, 0);
  for (int f : mesh.quad_face)
    if (f > 0) has_quads[f] = 1;
  for (int f = 1; f <= faces; ++f)
    if (of_solid(f) && !has_quads[f]) result.faces_without_quads.push_back(f);

  const BorderSegments borders(mesh);
  double total = 0, lost = 0;
  for (int id = 1; id <= edges; ++id) {
    context.check();
    const CadEdge& edge = geometry.edge(id);
    if (!counts(geometry, edge, solid)) continue;
    const double followed = borders.follow(mesh, geometry, id, size);
    total += edge.length;
    lost += (1 - followed) * edge.length;
    if (followed < 0.9) result.sharp_edges_not_followed.push_back(id);
    if (followed < 0.5 && edge.length >= 0.5 * size) result.sharp_edges_lost.push_back(id);
  }
  if (total > 0) result.lost_length = lost / total;

  std::vector<char> has_node(geometry.vertices->size() + 1, 0);
  for (const CadPlace& place : mesh.place)
    if (place.dim == 0) has_node[place.entity] = 1;
  for (int id = 1; id <= static_cast<int>(geometry.vertices->size()); ++id) {
    const CadVertex& vertex = geometry.vertex(id);
    const auto sharp = std::count_if(vertex.edges.begin(), vertex.edges.end(), [&](int e) { return geometry.edge(e).sharp; });
    if (sharp < 3 || has_node[id] || vertex.edges.empty() || !of_solid(geometry.edge(vertex.edges[0]).faces[0])) continue;
    // A neighbour may stand in for it: CAD edges much shorter than an element vanish.
    constexpr double kNear = 0.02;
    const bool near = std::any_of(mesh.quads.begin(), mesh.quads.end(), [&](const auto& quad) {
      return std::any_of(quad.begin(), quad.end(), [&](int v) { return (mesh.points[v] - vertex.point).norm() < kNear * size; });
    });
    if (!near) result.corners_lost.push_back(id);
  }

  if (surface != nullptr) {
    constexpr double kLargestGap = 0.5, kBad = 0.25;
    const std::vector<double> gap = face_gaps(mesh, *surface, geometry, size, context);
    for (int f = 1; f <= faces; ++f) {
      result.largest_gap = std::max(result.largest_gap, gap[f]);
      if (!(gap[f] > kLargestGap * size)) continue;
      result.faces_not_covered.push_back(f);
      result.uncovered += std::clamp((gap[f] / size - kLargestGap) / kBad, 0.1, 1.0);
    }
  }
  return result;
}

EdgesLeftOut sharp_edges_left_out(const HexComplex& mesh, const Geometry& geometry, int solid) {
  std::vector<char> has_mesh_edges(geometry.edges->size() + 1, 0);
  for (int e : mesh.feature_edge_cad)
    if (e > 0) has_mesh_edges[e] = 1;
  EdgesLeftOut left_out;
  double total = 0, length = 0;
  for (int id = 1; id <= static_cast<int>(geometry.edges->size()); ++id) {
    const CadEdge& edge = geometry.edge(id);
    if (!counts(geometry, edge, solid)) continue;
    total += edge.length;
    if (has_mesh_edges[id]) continue;
    length += edge.length;
    left_out.edges.push_back(id);
  }
  if (total > 0) left_out.share = length / total;
  return left_out;
}

}  // namespace hexfeature
