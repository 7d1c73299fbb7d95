// HexFeatureWB - LGPL-2.1-or-later
// A voxel shape as a whole little part: surface with pseudo CAD (charts = faces, arcs = edges, corners = vertices), lattice,
// and a projector onto its triangles; bent by any map.
#pragma once
#include <algorithm>
#include <functional>
#include <map>

#include "fixtures.h"
#include "mesh/geometry.h"
#include "mesh/hex_complex.h"

namespace fixtures {

using namespace hexfeature;

struct TrianglesProjector : Projector {
  const SurfaceMesh* mesh = nullptr;
  std::vector<std::vector<int>> face_triangles;  // by face - 1
  std::vector<std::vector<int>> edge_points;     // polylines, by edge - 1
  std::vector<int> vertex_points;                // by vertex - 1

  static Vec3 closest_on_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 n = (b - a).cross(c - a);
    const Vec3 q = p - n * n.dot(p - a) / n.squaredNorm();
    if (n.dot((b - a).cross(q - a)) >= 0 && n.dot((c - b).cross(q - b)) >= 0 && n.dot((a - c).cross(q - c)) >= 0) return q;
    Vec3 best = a;
    for (const auto& e : {std::pair<Vec3, Vec3>{a, b}, {b, c}, {c, a}}) {
      const Vec3 d = e.second - e.first;
      const Vec3 r = e.first + std::clamp(d.dot(p - e.first) / d.squaredNorm(), 0.0, 1.0) * d;
      if ((r - p).squaredNorm() < (best - p).squaredNorm()) best = r;
    }
    return best;
  }
  FacePoint project_to_face(int face, const Vec3& p, const Vec2*) const override {
    FacePoint best;
    double least = 1e300;
    for (int t : face_triangles[face - 1]) {
      const auto& v = mesh->triangles[t];
      const Vec3 q = closest_on_triangle(p, mesh->points[v[0]], mesh->points[v[1]], mesh->points[v[2]]);
      if ((q - p).squaredNorm() < least) {
        least = (q - p).squaredNorm();
        best = {q, mesh->area_normal(t).normalized(), Vec2::Zero()};
      }
    }
    return best;
  }
  CurvePoint project_to_edge(int edge, const Vec3& p, const double*) const override {
    CurvePoint best;
    double least = 1e300, s = 0;
    const auto& line = edge_points[edge - 1];
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      const Vec3 a = mesh->points[line[i]], d = mesh->points[line[i + 1]] - a;
      const double f = std::clamp(d.dot(p - a) / d.squaredNorm(), 0.0, 1.0);
      if ((a + f * d - p).squaredNorm() < least) {
        least = (a + f * d - p).squaredNorm();
        best = {a + f * d, d.normalized(), s + f * d.norm()};
      }
      s += d.norm();
    }
    return best;
  }
  Vec3 vertex_point(int vertex) const override { return mesh->points[vertex_points[vertex - 1]]; }
  CurvePoint edge_point(int edge, double t) const override {
    const auto& line = edge_points[edge - 1];
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      const Vec3 a = mesh->points[line[i]], d = mesh->points[line[i + 1]] - a;
      if (t <= d.norm() || i + 2 == line.size()) return {a + t * d.normalized(), d.normalized(), t};
      t -= d.norm();
    }
    return {};
  }
};

struct VoxelPart {
  LabelledSurface surface;
  FeatureShape shape;
  std::vector<CadFace> faces;
  std::vector<CadEdge> edges;
  std::vector<CadVertex> vertices;
  TrianglesProjector projector;
  HexComplex lattice;  ///< as the lattice room returns it

  Geometry geometry() const { return {&faces, &edges, &vertices, &projector}; }
};

/// `n`: triangles per voxel side (2 n^2 a face); `r`: hexahedra per voxel side. `bend` moves the surface; the lattice stays.
/// With `face_key`, CAD faces are components of its value instead of the charts, so that several may share a chart.
inline void make_part(VoxelPart& part, const Voxels& voxels, int n, int r, const std::function<Vec3(const Vec3&)>& bend,
                      const std::function<int(Label, const Vec3&)>& face_key = {}, double sharp_degrees = 20) {
  part.surface = voxel_surface(voxels, n);
  SurfaceMesh& mesh = part.surface.mesh;
  part.shape = make_feature_shape(part.surface);
  const FeatureShape& shape = part.shape;

  // The lattice, found by position while the surface is still straight.
  std::map<std::array<int, 3>, int> index;
  HexComplex& lattice = part.lattice;
  for (const auto& v : voxels)
    for (int i = 0; i < r; ++i)
      for (int j = 0; j < r; ++j)
        for (int k = 0; k < r; ++k) {
          std::array<int, 8> hex;
          const int d[8][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
          for (int c = 0; c < 8; ++c) {
            const std::array<int, 3> p{r * v[0] + i + d[c][0], r * v[1] + j + d[c][1], r * v[2] + k + d[c][2]};
            const auto found = index.emplace(p, static_cast<int>(lattice.points.size()));
            if (found.second) lattice.points.push_back(Vec3(p[0], p[1], p[2]));
            hex[c] = found.first->second;
          }
          lattice.hexes.push_back(hex);
        }
  lattice.hex_solid.assign(lattice.hexes.size(), 1);
  lattice.hex_block.assign(lattice.hexes.size(), 0);
  lattice.place.assign(lattice.points.size(), CadPlace{});
  lattice.shape_place.assign(lattice.points.size(), ShapePlace{});
  TrianglesProjector straight;
  straight.mesh = &mesh;
  for (const auto& f : boundary_faces(lattice)) {
    std::array<int, 4> quad;
    Vec3 centre = Vec3::Zero();
    for (int i = 0; i < 4; ++i) {
      quad[i] = lattice.hexes[f[0]][kHexFaces[f[1]][i]];
      centre += 0.25 / r * lattice.points[quad[i]];
    }
    int chart = -1;
    for (int t = 0; t < mesh.triangle_count() && chart < 0; ++t) {
      const auto& v = mesh.triangles[t];
      const Vec3 q = TrianglesProjector::closest_on_triangle(centre, mesh.points[v[0]], mesh.points[v[1]], mesh.points[v[2]]);
      if ((q - centre).norm() < 1e-9) chart = shape.cells.triangle_part[t];
    }
    lattice.quads.push_back(quad);
    lattice.quad_chart.push_back(chart);
    for (int p : quad) lattice.shape_place[p] = {2, chart};
  }
  lattice.quad_face.assign(lattice.quads.size(), 0);
  for (int p = 0; p < lattice.point_count(); ++p) {
    const Vec3 x = lattice.points[p] / r;
    for (int a = 0; a < shape.arc_count(); ++a) {
      const auto& line = shape.cells.edges[a].vertices;
      for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        const Vec3 u = mesh.points[line[i]], d = mesh.points[line[i + 1]] - u;
        const double f = d.dot(x - u) / d.squaredNorm();
        if (f > -1e-9 && f < 1 + 1e-9 && (u + f * d - x).norm() < 1e-9) lattice.shape_place[p] = {1, a};
      }
    }
    for (int c = 0; c < shape.corner_count(); ++c)
      if ((mesh.points[shape.cells.nodes[c].vertex] - x).norm() < 1e-9) lattice.shape_place[p] = {0, c};
  }

  // Pseudo CAD.
  if (face_key) {
    std::vector<int> key(mesh.triangle_count());
    for (int t = 0; t < mesh.triangle_count(); ++t) key[t] = face_key(part.surface.label[t], mesh.centroid(t));
    mesh.triangle_face = connected_components(mesh, key);
    for (int& f : mesh.triangle_face) ++f;
  }
  deform(mesh, bend);
  std::vector<int> face_index(mesh.triangle_face);
  for (int& f : face_index) --f;
  const Partition cad = make_partition(mesh, face_index);
  part.faces.resize(cad.parts.size());
  part.edges.resize(cad.edges.size());
  part.vertices.resize(cad.nodes.size());
  part.projector.mesh = &mesh;
  part.projector.face_triangles.clear();
  for (std::size_t f = 0; f < cad.parts.size(); ++f) {
    part.projector.face_triangles.push_back(cad.parts[f].triangles);
    for (int t : cad.parts[f].triangles) part.faces[f].area += mesh.area(t);
  }
  for (std::size_t e = 0; e < cad.edges.size(); ++e) {
    CadEdge& edge = part.edges[e];
    edge.faces = {cad.edges[e].left + 1, cad.edges[e].right + 1};
    edge.vertices = {cad.edges[e].start + 1, cad.edges[e].end + 1};
    double s = 0;
    for (std::size_t i = 0; i < cad.edges[e].halfedges.size(); ++i) {
      const int h = cad.edges[e].halfedges[i];
      mesh.halfedge_edge[h] = mesh.halfedge_edge[mesh.opposite[h]] = static_cast<int>(e) + 1;
      const double length = (mesh.points[mesh.to(h)] - mesh.points[mesh.from(h)]).norm();
      edge.dihedral += length * mesh.dihedral(h);
      s += length;
      mesh.place[mesh.to(h)] = {1, static_cast<int>(e) + 1, Vec2(s, 0)};
    }
    edge.length = edge.t1 = s;
    edge.dihedral /= s;
    edge.sharp = std::abs(edge.dihedral) > sharp_degrees * EIGEN_PI / 180;
    part.projector.edge_points.push_back(cad.edges[e].vertices);
    for (int f : edge.faces) part.faces[f - 1].edges.push_back(static_cast<int>(e) + 1);
  }
  for (std::size_t v = 0; v < cad.nodes.size(); ++v) {
    CadVertex& vertex = part.vertices[v];
    vertex.point = mesh.points[cad.nodes[v].vertex];
    mesh.place[cad.nodes[v].vertex] = {0, static_cast<int>(v) + 1, Vec2::Zero()};
    part.projector.vertex_points.push_back(cad.nodes[v].vertex);
    int sharp = 0;
    for (int d : cad.nodes[v].darts) {
      vertex.edges.push_back(d / 2 + 1);
      sharp += part.edges[d / 2].sharp;
    }
    vertex.hard = sharp != 0 && sharp != 2;
  }
  for (int t = 0; t < mesh.triangle_count(); ++t)
    for (int k = 0; k < 3; ++k)
      if (mesh.place[mesh.triangles[t][k]].dim == 2) mesh.place[mesh.triangles[t][k]].entity = mesh.triangle_face[t];
}

}  // namespace fixtures
