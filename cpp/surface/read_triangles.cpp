// HexFeatureWB - LGPL-2.1-or-later
#include <algorithm>
#include <cmath>

#include "surface/surface.h"
#include "surface/triangle_projector.h"
#include "surface/weld.h"

namespace hexfeature {
namespace {

constexpr double kDegree = EIGEN_PI / 180;
constexpr double kCornerKink = 60;  ///< degrees: a chain of creases that turns so far has a corner there
constexpr double kHardKink = 30;

/// Builds the pseudo CAD of a welded mesh: regions between creases, chains of creases, their ends.
class PseudoCad {
 public:
  PseudoCad(TrianglePart& part, double crease) : part_(part), mesh_(part.mesh), crease_(crease) {}

  void build() {
    find_faces();
    find_vertices();
    find_edges();
    fill_tables();
  }
  std::vector<std::vector<int>> chain_points;  ///< per edge; a closed one repeats its first point

 private:
  bool is_border(int h) const { return crease_edge_[h] != 0; }

  void find_faces() {
    const int n = mesh_.triangle_count();
    crease_edge_.assign(3 * n, 0);
    flat_.resize(n);
    for (int t = 0; t < n; ++t) flat_[t] = mesh_.area_normal(t).stableNormalized();
    for (int h = 0; h < 3 * n; ++h) {
      const Vec3 &a = flat_[h / 3], &b = flat_[mesh_.opposite[h] / 3];
      // Triangles without area have no say.
      crease_edge_[h] = !a.isZero() && !b.isZero() && std::atan2(a.cross(b).norm(), a.dot(b)) > crease_;
    }
    mesh_.triangle_face.assign(n, 0);
    std::vector<int> stack;
    int faces = 0;
    for (int seed = 0; seed < n; ++seed) {
      if (mesh_.triangle_face[seed] != 0) continue;
      mesh_.triangle_face[seed] = ++faces;
      stack.assign(1, seed);
      while (!stack.empty()) {
        const int t = stack.back();
        stack.pop_back();
        for (int h = 3 * t; h < 3 * t + 3; ++h) {
          const int s = mesh_.opposite[h] / 3;
          if (is_border(h) || mesh_.triangle_face[s] != 0) continue;
          mesh_.triangle_face[s] = faces;
          stack.push_back(s);
        }
      }
    }
    part_.faces.resize(faces);
  }

  void find_vertices() {
    leaving_.assign(mesh_.point_count(), {});
    for (int h = 0; h < 3 * mesh_.triangle_count(); ++h)
      if (is_border(h)) leaving_[mesh_.from(h)].push_back(h);
    vertex_.assign(mesh_.point_count(), 0);
    for (int p = 0; p < mesh_.point_count(); ++p) {
      const auto& ways = leaving_[p];
      if (ways.empty() || (ways.size() == 2 && kink(ways[0], ways[1]) < kCornerKink * kDegree)) continue;
      CadVertex v;
      v.point = mesh_.points[p];
      v.hard = ways.size() != 2 || kink(ways[0], ways[1]) > kHardKink * kDegree;
      part_.vertices.push_back(v);
      vertex_[p] = static_cast<int>(part_.vertices.size());
    }
  }

  double kink(int g, int h) const {
    const Vec3 a = mesh_.points[mesh_.to(g)] - mesh_.points[mesh_.from(g)], b = mesh_.points[mesh_.to(h)] - mesh_.points[mesh_.from(h)];
    return std::atan2(a.cross(b).norm(), -a.dot(b));
  }

  void find_edges() {
    mesh_.halfedge_edge.assign(3 * mesh_.triangle_count(), 0);
    for (int p = 0; p < mesh_.point_count(); ++p)
      if (vertex_[p] != 0)
        for (const int h : leaving_[p])
          if (mesh_.halfedge_edge[h] == 0) follow(h);
    for (int h = 0; h < 3 * mesh_.triangle_count(); ++h)  // closed chains without a vertex
      if (is_border(h) && mesh_.halfedge_edge[h] == 0) follow(h);
  }

  void follow(int start) {
    const int id = static_cast<int>(part_.edges.size()) + 1;
    CadEdge edge;
    std::vector<int> points{mesh_.from(start)};
    std::vector<double> angles;
    edge.faces = {mesh_.triangle_face[start / 3], mesh_.triangle_face[mesh_.opposite[start] / 3]};
    for (int h = start;;) {
      const int g = mesh_.opposite[h], p = mesh_.to(h);
      mesh_.halfedge_edge[h] = mesh_.halfedge_edge[g] = id;
      points.push_back(p);
      const Vec3 e = (mesh_.points[p] - mesh_.points[mesh_.from(h)]).stableNormalized();
      const Vec3 &a = flat_[h / 3], &b = flat_[g / 3];
      angles.push_back(std::atan2(e.dot(a.cross(b)), a.dot(b)));
      edge.length += (mesh_.points[p] - mesh_.points[mesh_.from(h)]).norm();
      if (vertex_[p] != 0 || p == points.front()) break;
      const auto& ways = leaving_[p];
      h = ways[0] == g ? ways[1] : ways[0];
    }
    edge.vertices = {vertex_[points.front()], vertex_[points.back()]};
    edge.t1 = edge.length;
    std::nth_element(angles.begin(), angles.begin() + angles.size() / 2, angles.end());
    edge.dihedral = angles[angles.size() / 2];
    edge.seam = edge.faces[0] == edge.faces[1];
    edge.sharp = true;
    part_.edges.push_back(edge);
    chain_points.push_back(std::move(points));
  }

  void fill_tables() {
    for (int e = 1; e <= static_cast<int>(part_.edges.size()); ++e) {
      const CadEdge& edge = part_.edges[e - 1];
      for (int k = 0; k < 2; ++k) {
        if (edge.vertices[k] != 0 && (k == 0 || edge.vertices[1] != edge.vertices[0]))
          part_.vertices[edge.vertices[k] - 1].edges.push_back(e);
        if (k == 0 || !edge.seam) part_.faces[edge.faces[k] - 1].edges.push_back(e);
      }
    }
    mesh_.place.assign(mesh_.point_count(), {});
    for (int h = 0; h < 3 * mesh_.triangle_count(); ++h) {
      CadPlace& place = mesh_.place[mesh_.from(h)];
      if (place.dim > 2) place = {2, mesh_.triangle_face[h / 3], {static_cast<double>(h / 3), 0}};
    }
    for (int e = 0; e < static_cast<int>(chain_points.size()); ++e) {
      double t = 0;
      const auto& points = chain_points[e];
      for (std::size_t i = 0; i < points.size(); ++i) {
        if (i > 0) t += (mesh_.points[points[i]] - mesh_.points[points[i - 1]]).norm();
        if (i == 0 || points[i] != points.front()) mesh_.place[points[i]] = {1, e + 1, {t, 0}};
      }
    }
    for (int p = 0; p < mesh_.point_count(); ++p)
      if (vertex_[p] != 0) mesh_.place[p] = {0, vertex_[p], Vec2::Zero()};
    smooth_normals();
    recognise_planes();
  }

  /// Corner normals: the flat normals round the corner's point, weighted by angle, as far as no crease comes between.
  void smooth_normals() {
    const int n = 3 * mesh_.triangle_count();
    mesh_.corner_normals.assign(n, Vec3::Zero());
    std::vector<char> done(n, 0);
    std::vector<int> fan;
    for (int corner = 0; corner < n; ++corner) {
      if (done[corner]) continue;
      // Back to the first corner of the fan (or once round), then forward.
      int h = corner;
      while (!is_border(h)) {
        const int g = SurfaceMesh::next(mesh_.opposite[h]);
        if (g == corner) break;
        h = g;
      }
      fan.clear();
      Vec3 sum = Vec3::Zero();
      for (const int first = h;;) {
        fan.push_back(h);
        const Vec3 a = mesh_.points[mesh_.to(h)] - mesh_.points[mesh_.from(h)],
                   b = mesh_.points[mesh_.from(SurfaceMesh::prev(h))] - mesh_.points[mesh_.from(h)];
        sum += std::atan2(a.cross(b).norm(), a.dot(b)) * flat_[h / 3];
        const int back = SurfaceMesh::prev(h);
        h = mesh_.opposite[back];
        if (is_border(back) || h == first) break;
      }
      for (const int c : fan) {
        done[c] = 1;
        Vec3 normal = sum.norm() > 1e-9 ? Vec3(sum.normalized()) : flat_[c / 3];
        // A cone's tip: the triangle's own direction.
        if (normal.dot(flat_[c / 3]) < 0.5 && !flat_[c / 3].isZero()) normal = flat_[c / 3];
        mesh_.corner_normals[c] = normal.isZero() ? Vec3(Vec3::UnitZ()) : normal;
      }
    }
  }

  void recognise_planes() {
    std::vector<Vec3> sum(part_.faces.size(), Vec3::Zero());
    std::vector<double> spread(part_.faces.size(), 0);
    for (int t = 0; t < mesh_.triangle_count(); ++t) {
      const int f = mesh_.triangle_face[t] - 1;
      part_.faces[f].area += mesh_.area(t);
      part_.faces[f].origin += mesh_.area(t) * mesh_.centroid(t);
      sum[f] += 0.5 * mesh_.area_normal(t);
    }
    for (std::size_t f = 0; f < sum.size(); ++f) {
      CadFace& face = part_.faces[f];
      if (face.area > 0) face.origin /= face.area;
      if (!sum[f].isZero()) face.axis = sum[f].stableNormalized();
    }
    for (int t = 0; t < mesh_.triangle_count(); ++t) {
      const CadFace& face = part_.faces[mesh_.triangle_face[t] - 1];
      for (const int v : mesh_.triangles[t]) {
        double& s = spread[mesh_.triangle_face[t] - 1];
        s = std::max(s, std::abs((mesh_.points[v] - face.origin).dot(face.axis)));
      }
    }
    for (std::size_t f = 0; f < sum.size(); ++f) {
      CadFace& face = part_.faces[f];
      if (sum[f].norm() > 0.9999 * face.area && spread[f] < 1e-4 * std::sqrt(face.area)) face.kind = SurfaceKind::Plane;
    }
  }

  TrianglePart& part_;
  SurfaceMesh& mesh_;
  double crease_;
  std::vector<char> crease_edge_;  ///< per halfedge
  std::vector<Vec3> flat_;
  std::vector<std::vector<int>> leaving_;  ///< per point: crease halfedges that start there
  std::vector<int> vertex_;                ///< per point: pseudo vertex or 0
};

}  // namespace

TrianglePart read_triangles(const std::string& path, double crease_degrees, Context& context) {
  context.progress("read", 0);
  const TriangleSoup soup = read_triangle_file(path);
  context.progress("read", 0.4);
  TrianglePart part;
  part.mesh = weld(soup);
  context.progress("read", 0.7);
  PseudoCad cad(part, crease_degrees * kDegree);
  cad.build();
  part.projector = std::make_unique<TriangleProjector>(part.mesh, part.faces.size(), cad.chain_points, part.vertices);
  context.progress("read", 1);
  return part;
}

}  // namespace hexfeature
