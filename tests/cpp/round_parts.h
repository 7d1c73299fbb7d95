// HexFeatureWB - LGPL-2.1-or-later
// Hexahedral complexes of tiny named parts: voxels cut into cells, bent onto planes, cylinders and spheres, with charts, blocks, CAD
// places and feature edges as boundary fitting leaves them.
#pragma once
#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <vector>

#include "fixtures.h"
#include "mesh/geometry.h"
#include "mesh/hex_complex.h"

namespace fixtures {

using hexfeature::Vec3;

struct AnalyticFace {
  hexfeature::SurfaceKind kind = hexfeature::SurfaceKind::Plane;
  Vec3 origin = Vec3::Zero(), axis = Vec3::UnitZ();  // plane: outward normal
  double radius = 0;
  int outward = 1;  // -1: the inside of a hole or a hollow

  // Unit gradient of the distance, and the signed distance.
  std::pair<Vec3, double> distance(const Vec3& p) const {
    const Vec3 d = p - origin;
    if (kind == hexfeature::SurfaceKind::Plane) return {axis, d.dot(axis)};
    const Vec3 r = kind == hexfeature::SurfaceKind::Cylinder ? Vec3(d - d.dot(axis) * axis) : d;
    const double length = r.norm();
    return {length > 1e-12 ? Vec3(r / length) : axis.unitOrthogonal(), length - radius};
  }
};
inline AnalyticFace plane(const Vec3& origin, const Vec3& normal) {
  return {hexfeature::SurfaceKind::Plane, origin, normal.normalized(), 0, 1};
}
inline AnalyticFace cylinder(const Vec3& origin, const Vec3& axis, double r, int outward = 1) {
  return {hexfeature::SurfaceKind::Cylinder, origin, axis.normalized(), r, outward};
}
inline AnalyticFace ball(const Vec3& centre, double r) { return {hexfeature::SurfaceKind::Sphere, centre, Vec3::UnitZ(), r, 1}; }

/// Untrimmed surfaces; edge i is where two of them meet.
class AnalyticProjector : public hexfeature::Projector {
 public:
  std::vector<AnalyticFace> faces;
  std::vector<std::array<int, 2>> edges;  // 1-based faces
  std::vector<Vec3> vertices;

  hexfeature::FacePoint project_to_face(int face, const Vec3& p, const hexfeature::Vec2*) const override {
    const auto [n, d] = faces[face - 1].distance(p);
    return {p - d * n, faces[face - 1].outward * n, hexfeature::Vec2::Zero()};
  }
  hexfeature::CurvePoint project_to_edge(int edge, const Vec3& start, const double*) const override {
    hexfeature::CurvePoint c;
    c.point = start;
    for (int i = 0; i < 30; ++i) {
      const auto [n, d] = faces[edges[edge - 1][0] - 1].distance(c.point);
      const auto [m, e] = faces[edges[edge - 1][1] - 1].distance(c.point);
      const double k = n.dot(m), det = std::max(1 - k * k, 1e-6);
      c.point -= ((d - k * e) / det) * n + ((e - k * d) / det) * m;
      c.tangent = n.cross(m).normalized();
    }
    return c;
  }
  Vec3 vertex_point(int v) const override { return vertices[v - 1]; }
  hexfeature::CurvePoint edge_point(int edge, double) const override { return project_to_edge(edge, Vec3::Zero(), nullptr); }
};

struct HexPart {
  hexfeature::FeatureShape shape;
  hexfeature::HexComplex complex;
  AnalyticProjector projector;
  std::vector<hexfeature::CadFace> faces;
  std::vector<hexfeature::CadEdge> edges;
  std::vector<hexfeature::CadVertex> vertices;
  hexfeature::Geometry geometry() const { return {&faces, &edges, &vertices, &projector}; }

  /// Boundary quads on charts of this label, and those charts.
  std::vector<int> charts_of(hexfeature::Label l) const {
    std::vector<int> c;
    for (int i = 0; i < shape.chart_count(); ++i)
      if (shape.charts[i].label == l) c.push_back(i);
    return c;
  }
};

/// `n` cells along each voxel. `map` takes voxel coordinates to the part; `face_of(label, centre of the quad in voxel
/// coordinates)` tells the 1-based face of `faces` that a boundary quad lies on.
inline HexPart make_hex_part(const Voxels& voxels, int n, const std::function<Vec3(const Vec3&)>& map,
                             const std::vector<AnalyticFace>& faces, const std::function<int(hexfeature::Label, const Vec3&)>& face_of) {
  using namespace hexfeature;
  HexPart part;
  const LabelledSurface surface = voxel_surface(voxels, n);
  part.shape = make_feature_shape(surface);
  HexComplex& c = part.complex;
  std::map<std::array<int, 3>, int> index;
  std::vector<std::array<int, 3>> lattice;
  const auto node = [&](const std::array<int, 3>& p) {
    const auto [it, fresh] = index.try_emplace(p, c.point_count());
    if (fresh) {
      c.points.push_back(map(Vec3(p[0], p[1], p[2]) / n));
      lattice.push_back(p);
    }
    return it->second;
  };
  const int step[8][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  std::array<std::set<int>, 3> planes;  // chart coordinates: blocks lie between them
  for (const auto& v : voxels)
    for (int l = 0; l < 6; ++l) {
      auto w = v;
      w[l / 2] += l % 2 == 0 ? 1 : -1;
      if (!voxels.count(w)) planes[l / 2].insert(v[l / 2] + (l % 2 == 0));
    }
  std::map<std::array<int, 3>, int> block;
  std::map<std::pair<std::array<int, 3>, int>, std::vector<int>> side_chart;  // (voxel, label) -> chart
  int triangle = 0;
  for (const auto& v : voxels) {
    std::array<int, 3> b;
    for (int a = 0; a < 3; ++a) b[a] = static_cast<int>(std::distance(planes[a].begin(), planes[a].upper_bound(v[a])));
    const int id = block.try_emplace(b, static_cast<int>(block.size())).first->second;
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j)
        for (int k = 0; k < n; ++k) {
          std::array<int, 8> h;
          for (int m = 0; m < 8; ++m) h[m] = node({n * v[0] + i + step[m][0], n * v[1] + j + step[m][1], n * v[2] + k + step[m][2]});
          c.hexes.push_back(h);
          c.hex_block.push_back(id);
          c.hex_solid.push_back(1);
        }
  }
  // The same order as voxel_surface: two triangles a quad.
  for (const auto& v : voxels)
    for (int l = 0; l < 6; ++l) {
      const int axis = l / 2, sign = l % 2 == 0 ? 1 : -1;
      auto w = v;
      w[axis] += sign;
      if (voxels.count(w)) continue;
      const int a = (axis + 1) % 3, b = (axis + 2) % 3;
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
          std::array<int, 4> q;
          Vec3 centre = Vec3::Zero();
          const int di[4] = {0, 1, 1, 0}, dj[4] = {0, 0, 1, 1};
          for (int k = 0; k < 4; ++k) {
            std::array<int, 3> p;
            p[axis] = n * (v[axis] + (sign > 0));
            p[a] = n * v[a] + i + di[k];
            p[b] = n * v[b] + j + dj[k];
            q[k] = index.at(p);
            centre += Vec3(p[0], p[1], p[2]) / (4.0 * n);
          }
          if (sign < 0) std::swap(q[1], q[3]);
          c.quads.push_back(q);
          c.quad_chart.push_back(part.shape.cells.triangle_part[triangle]);
          c.quad_face.push_back(face_of(static_cast<Label>(l), centre));
          triangle += 2;
        }
    }
  // Places on the feature shape.
  std::map<std::array<int, 3>, ShapePlace> on_lines;
  const auto lattice_point = [&](int vertex) {
    const Vec3 p = surface.mesh.points[vertex] * n;
    return std::array<int, 3>{static_cast<int>(std::lround(p[0])), static_cast<int>(std::lround(p[1])),
                              static_cast<int>(std::lround(p[2]))};
  };
  for (int e = 0; e < part.shape.arc_count(); ++e)
    for (int v : part.shape.cells.edges[e].vertices) on_lines[lattice_point(v)] = {1, e};
  for (int m = 0; m < part.shape.corner_count(); ++m) on_lines[lattice_point(part.shape.cells.nodes[m].vertex)] = {0, m};
  c.shape_place.assign(c.points.size(), {});
  c.place.assign(c.points.size(), {});
  std::vector<std::set<int>> faces_at(c.points.size());
  for (std::size_t q = 0; q < c.quads.size(); ++q)
    for (int v : c.quads[q]) {
      faces_at[v].insert(c.quad_face[q]);
      const auto it = on_lines.find(lattice[v]);
      c.shape_place[v] = it != on_lines.end() ? it->second : ShapePlace{2, c.quad_chart[q]};
    }
  // Places on the CAD: one face, the edge of two, a vertex of more.
  part.projector.faces = faces;
  for (const auto& f : faces) {
    CadFace face;
    face.kind = f.kind;
    face.origin = f.origin;
    face.axis = f.axis;
    face.radius = f.radius;
    face.outward_convex = f.outward > 0;
    part.faces.push_back(face);
  }
  std::map<std::array<int, 2>, int> edge_ids;
  const auto edge_id = [&](int f, int g) {
    const std::array<int, 2> key{std::min(f, g), std::max(f, g)};
    const auto [it, fresh] = edge_ids.try_emplace(key, static_cast<int>(edge_ids.size()) + 1);
    if (fresh) {
      part.projector.edges.push_back(key);
      CadEdge edge;
      edge.faces = key;
      part.edges.push_back(edge);
    }
    return it->second;
  };
  std::map<std::array<int, 2>, int> first_quad;
  std::map<std::array<int, 2>, int> features;
  for (int q = 0; q < static_cast<int>(c.quads.size()); ++q)
    for (int i = 0; i < 4; ++i) {
      const int a = c.quads[q][i], b = c.quads[q][(i + 1) % 4];
      const auto [it, fresh] = first_quad.try_emplace({std::min(a, b), std::max(a, b)}, q);
      if (!fresh && c.quad_face[it->second] != c.quad_face[q]) features[it->first] = edge_id(c.quad_face[it->second], c.quad_face[q]);
    }
  for (const auto& [nodes, cad] : features) {
    c.feature_edges.push_back(nodes);
    c.feature_edge_cad.push_back(cad);
    const auto& key = part.projector.edges[cad - 1];
    const Vec3 mid = part.projector.project_to_edge(cad, 0.5 * (c.points[nodes[0]] + c.points[nodes[1]]), nullptr).point;
    const Vec3 m = part.projector.project_to_face(key[0], mid, nullptr).normal,
               k = part.projector.project_to_face(key[1], mid, nullptr).normal;
    part.edges[cad - 1].dihedral = std::acos(std::clamp(m.dot(k), -1.0, 1.0));  // the sign is not used
    part.edges[cad - 1].sharp = part.edges[cad - 1].dihedral > 20 * EIGEN_PI / 180;
  }
  for (int v = 0; v < c.point_count(); ++v) {
    if (faces_at[v].size() == 1) {
      c.place[v] = {2, *faces_at[v].begin(), Vec2::Zero()};
      c.points[v] = part.projector.project_to_face(c.place[v].entity, c.points[v], nullptr).point;
    } else if (faces_at[v].size() == 2) {
      c.place[v] = {1, edge_id(*faces_at[v].begin(), *faces_at[v].rbegin()), Vec2::Zero()};
      c.points[v] = part.projector.project_to_edge(c.place[v].entity, c.points[v], nullptr).point;
    } else if (faces_at[v].size() > 2) {
      CadVertex vertex;
      vertex.point = c.points[v];
      vertex.hard = true;
      part.vertices.push_back(vertex);
      part.projector.vertices.push_back(vertex.point);
      c.place[v] = {0, static_cast<int>(part.vertices.size()), Vec2::Zero()};
    }
  }
  return part;
}

/// The square [-1, 1]^2 onto the unit disc.
inline Vec3 square_to_disc(const Vec3& p) {
  return {p[0] * std::sqrt(1 - 0.5 * p[1] * p[1]), p[1] * std::sqrt(1 - 0.5 * p[0] * p[0]), p[2]};
}
/// Rings of squares onto rings of circles: the square of half-width r onto the circle of radius r, whatever r.
inline Vec3 squares_to_circles(const Vec3& p) {
  const double r = std::max(std::abs(p[0]), std::abs(p[1]));
  if (r == 0) return p;
  const Vec3 d = square_to_disc({p[0] / r, p[1] / r, 0});
  return {r * d[0], r * d[1], p[2]};
}

inline HexPart cylinder_part(int n = 4) {
  // Radius 1, height 2.
  const auto voxels = box({-1, -1, 0}, {1, 1, 2});
  return make_hex_part(voxels, n, square_to_disc,
                       {cylinder(Vec3::Zero(), Vec3::UnitZ(), 1), plane(Vec3::Zero(), -Vec3::UnitZ()), plane({0, 0, 2}, Vec3::UnitZ())},
                       [](hexfeature::Label l, const Vec3&) { return l < 4    ? 1
                                                                     : l == 5 ? 2
                                                                              : 3; });
}
inline HexPart sphere_part(int n = 4) {
  const auto map = [](const Vec3& p) -> Vec3 {
    const double x = p[0] * p[0], y = p[1] * p[1], z = p[2] * p[2];
    return {p[0] * std::sqrt(1 - y / 2 - z / 2 + y * z / 3), p[1] * std::sqrt(1 - z / 2 - x / 2 + z * x / 3),
            p[2] * std::sqrt(1 - x / 2 - y / 2 + x * y / 3)};
  };
  return make_hex_part(box({-1, -1, -1}, {1, 1, 1}), n, map, {ball(Vec3::Zero(), 1)}, [](hexfeature::Label, const Vec3&) { return 1; });
}
/// A square plate 8 x 8 x 1.5 with a round boss of radius 1 and height 2 on it.
inline HexPart boss_part(int n = 2) {
  const auto voxels = unite(box({-4, -4, 0}, {4, 4, 1}), box({-1, -1, 1}, {1, 1, 3}));
  const auto map = [](const Vec3& p) -> Vec3 {
    const double r = std::max(std::abs(p[0]), std::abs(p[1])), t = std::clamp((r - 1) / 3, 0.0, 1.0);
    Vec3 q = (1 - t) * squares_to_circles(p) + t * p;
    q[2] = p[2] <= 1 ? 1.5 * p[2] : p[2] + 0.5;
    return q;
  };
  return make_hex_part(voxels, n, map,
                       {plane({4, 0, 0}, Vec3::UnitX()), plane({-4, 0, 0}, -Vec3::UnitX()), plane({0, 4, 0}, Vec3::UnitY()),
                        plane({0, -4, 0}, -Vec3::UnitY()), plane({0, 0, 1.5}, Vec3::UnitZ()), plane(Vec3::Zero(), -Vec3::UnitZ()),
                        cylinder(Vec3::Zero(), Vec3::UnitZ(), 1), plane({0, 0, 3.5}, Vec3::UnitZ())},
                       [](hexfeature::Label l, const Vec3& p) { return l == 4 && p[2] > 2  ? 8
                                                                       : l < 4 && p[2] > 1 ? 7
                                                                                           : l + 1; });
}
/// A flange: disc of radius 4 and height 1, boss of radius 2 and height 1.5, bore of radius 1.
inline HexPart flange_part(int n = 2) {
  const auto voxels = subtract(unite(box({-4, -4, 0}, {4, 4, 1}), box({-2, -2, 1}, {2, 2, 2})), box({-1, -1, 0}, {1, 1, 2}));
  const auto map = [](const Vec3& p) -> Vec3 {
    Vec3 q = squares_to_circles(p);
    q[2] = p[2] <= 1 ? p[2] : 1 + 1.5 * (p[2] - 1);
    return q;
  };
  return make_hex_part(
      voxels, n, map,
      {cylinder(Vec3::Zero(), Vec3::UnitZ(), 4), cylinder(Vec3::Zero(), Vec3::UnitZ(), 2), cylinder(Vec3::Zero(), Vec3::UnitZ(), 1, -1),
       plane({0, 0, 1}, Vec3::UnitZ()), plane(Vec3::Zero(), -Vec3::UnitZ()), plane({0, 0, 2.5}, Vec3::UnitZ())},
      [](hexfeature::Label l, const Vec3& p) {
        const double r = std::max(std::abs(p[0]), std::abs(p[1]));
        if (l == 4) return p[2] > 1.5 ? 6 : 4;
        if (l == 5) return 5;
        return r > 3 ? 1 : r > 1.5 ? 2 : 3;
      });
}
/// A shaft along z with shoulders: radii 1, 2, 1.
inline HexPart shaft_part(int n = 2) {
  const auto voxels = unite(unite(box({-1, -1, 0}, {1, 1, 2}), box({-2, -2, 2}, {2, 2, 4})), box({-1, -1, 4}, {1, 1, 6}));
  return make_hex_part(voxels, n, squares_to_circles,
                       {cylinder(Vec3::Zero(), Vec3::UnitZ(), 1), cylinder(Vec3::Zero(), Vec3::UnitZ(), 2),
                        cylinder(Vec3::Zero(), Vec3::UnitZ(), 1), plane(Vec3::Zero(), -Vec3::UnitZ()), plane({0, 0, 2}, -Vec3::UnitZ()),
                        plane({0, 0, 4}, Vec3::UnitZ()), plane({0, 0, 6}, Vec3::UnitZ())},
                       [](hexfeature::Label l, const Vec3& p) {
                         if (l < 4) return p[2] < 2 ? 1 : p[2] < 4 ? 2 : 3;
                         return l == 5 ? (p[2] < 1 ? 4 : 5) : (p[2] > 5 ? 7 : 6);
                       });
}
/// Three cylinders on one axis, of radii 1, 3 and 2 and lengths 2, 2 and 3.
inline HexPart stepped_shaft_part(int n = 2) {
  const auto voxels = unite(unite(box({-1, -1, 0}, {1, 1, 2}), box({-3, -3, 2}, {3, 3, 4})), box({-2, -2, 4}, {2, 2, 7}));
  return make_hex_part(voxels, n, squares_to_circles,
                       {cylinder(Vec3::Zero(), Vec3::UnitZ(), 1), cylinder(Vec3::Zero(), Vec3::UnitZ(), 3),
                        cylinder(Vec3::Zero(), Vec3::UnitZ(), 2), plane(Vec3::Zero(), -Vec3::UnitZ()), plane({0, 0, 2}, -Vec3::UnitZ()),
                        plane({0, 0, 4}, Vec3::UnitZ()), plane({0, 0, 7}, Vec3::UnitZ())},
                       [](hexfeature::Label l, const Vec3& p) {
                         if (l < 4) return p[2] < 2 ? 1 : p[2] < 4 ? 2 : 3;
                         return l == 5 ? (p[2] < 1 ? 4 : 5) : (p[2] > 5 ? 7 : 6);
                       });
}
/// A box without anything round.
inline HexPart block_part(int n = 3) {
  return make_hex_part(
      unit_box(), n, [](const Vec3& p) { return p; },
      {plane({1, 0, 0}, Vec3::UnitX()), plane(Vec3::Zero(), -Vec3::UnitX()), plane({0, 1, 0}, Vec3::UnitY()),
       plane(Vec3::Zero(), -Vec3::UnitY()), plane({0, 0, 1}, Vec3::UnitZ()), plane(Vec3::Zero(), -Vec3::UnitZ())},
      [](hexfeature::Label l, const Vec3&) { return l + 1; });
}
/// A square plate 6 x 6 x 1 with a round hole of radius 1.
inline HexPart drilled_part(int n = 2) {
  const auto voxels = subtract(box({-3, -3, 0}, {3, 3, 1}), box({-1, -1, 0}, {1, 1, 1}));
  const auto map = [](const Vec3& p) -> Vec3 {
    const double r = std::max(std::abs(p[0]), std::abs(p[1])), t = std::clamp((r - 1) / 2, 0.0, 1.0);
    return (1 - t) * squares_to_circles(p) + t * p;
  };
  return make_hex_part(
      voxels, n, map,
      {plane({3, 0, 0}, Vec3::UnitX()), plane({-3, 0, 0}, -Vec3::UnitX()), plane({0, 3, 0}, Vec3::UnitY()),
       plane({0, -3, 0}, -Vec3::UnitY()), plane({0, 0, 1}, Vec3::UnitZ()), plane(Vec3::Zero(), -Vec3::UnitZ()),
       cylinder(Vec3::Zero(), Vec3::UnitZ(), 1, -1)},
      [](hexfeature::Label l, const Vec3& p) { return l < 4 && std::max(std::abs(p[0]), std::abs(p[1])) < 2 ? 7 : l + 1; });
}
/// A blind round pocket of radius 1 and depth 2 in a block 6 x 6 x 3.
inline HexPart pocket_part(int n = 2) {
  const auto voxels = subtract(box({-3, -3, 0}, {3, 3, 3}), box({-1, -1, 1}, {1, 1, 3}));
  const auto map = [](const Vec3& p) -> Vec3 {
    const double r = std::max(std::abs(p[0]), std::abs(p[1])), t = std::clamp((r - 1) / 2, 0.0, 1.0);
    return (1 - t) * squares_to_circles(p) + t * p;
  };
  return make_hex_part(voxels, n, map,
                       {plane({3, 0, 0}, Vec3::UnitX()), plane({-3, 0, 0}, -Vec3::UnitX()), plane({0, 3, 0}, Vec3::UnitY()),
                        plane({0, -3, 0}, -Vec3::UnitY()), plane({0, 0, 3}, Vec3::UnitZ()), plane(Vec3::Zero(), -Vec3::UnitZ()),
                        cylinder(Vec3::Zero(), Vec3::UnitZ(), 1, -1), plane({0, 0, 1}, Vec3::UnitZ())},
                       [](hexfeature::Label l, const Vec3& p) {
                         if (l == 4 && p[2] < 2) return 8;
                         return l < 4 && std::max(std::abs(p[0]), std::abs(p[1])) < 2 ? 7 : l + 1;
                       });
}

/// A solid tee: a cylinder of radius 2 along x, a branch of radius 1 along z.
inline HexPart tee_part(int n = 2) {
  const auto voxels = unite(box({-4, -2, -2}, {4, 2, 2}), box({-1, -1, 2}, {1, 1, 4}));
  const auto map = [](const Vec3& p) -> Vec3 {
    const double r = std::max(std::abs(p[0]), std::abs(p[1])), t = std::clamp(std::max(r - 1, 1 - 0.5 * (p[2] + 2)), 0.0, 1.0);
    Vec3 q = (1 - t) * squares_to_circles(p) + t * p;
    q[2] = std::min(p[2], 2.0);
    const Vec3 c = squares_to_circles({q[1], q[2], 0});
    return {q[0], p[2] > 2 ? q[1] : c[0], c[1] + std::max(0.0, p[2] - 2)};
  };
  return make_hex_part(voxels, n, map,
                       {cylinder(Vec3::Zero(), Vec3::UnitX(), 2), plane({4, 0, 0}, Vec3::UnitX()), plane({-4, 0, 0}, -Vec3::UnitX()),
                        cylinder(Vec3::Zero(), Vec3::UnitZ(), 1), plane({0, 0, 4}, Vec3::UnitZ())},
                       [](hexfeature::Label l, const Vec3& p) {
                         if (p[2] > 2.1) return l == 4 ? 5 : 4;
                         return l == 0 ? 2 : l == 1 ? 3 : 1;
                       });
}

/// A disc with a step in its rim, as a cam has: half a disc of radius 2, on it a segment of a larger one, centred `below` under the first,
/// that reaches 2 farther on one side. The edge at its tip has 90 degrees with none, and less the farther below.
inline HexPart cam_part(double below, int n = 2) {
  const auto voxels = unite(box({-1, -2, 0}, {2, 2, 2}), box({-2, 0, 0}, {-1, 2, 2}));
  const auto map = [below](const Vec3& p) -> Vec3 {
    const bool upper = p[1] >= 0;
    // Half squares onto half discs: u, v along and across, the share m of the way out, s of the way round.
    const double u = upper || p[0] > 0 ? p[0] / 2 : p[0], v = std::abs(p[1]) / 2, m = std::max(std::abs(u), v);
    if (m == 0) return {0, 0, p[2]};
    const double s = u == m ? v / m : v == m ? 2 - u / m : 4 - v / m, angle = (upper ? 1 : -1) * EIGEN_PI * s / 4;
    const Vec3 d(std::cos(angle), std::sin(angle), 0);
    const double c = d.dot(Vec3(-1, -below, 0)), r = upper ? c + std::sqrt(c * c + 8) : 2;
    return Vec3(0, 0, p[2]) + m * r * d;
  };
  return make_hex_part(voxels, n, map,
                       {cylinder({-1, -below, 0}, Vec3::UnitZ(), std::sqrt(9 + below * below)), cylinder(Vec3::Zero(), Vec3::UnitZ(), 2),
                        plane(Vec3::Zero(), -Vec3::UnitY()), plane(Vec3::Zero(), -Vec3::UnitZ()), plane({0, 0, 2}, Vec3::UnitZ())},
                       [](hexfeature::Label l, const Vec3& p) {
                         if (l >= 4) return l == 5 ? 4 : 5;
                         return p[1] > 0 ? 1 : p[1] < 0 ? 2 : 3;
                       });
}

}  // namespace fixtures
