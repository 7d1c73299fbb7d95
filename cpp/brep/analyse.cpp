// HexFeatureWB - LGPL-2.1-or-later
#include <BRepGProp.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <OSD_Parallel.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>
#include <algorithm>
#include <cmath>
#include <exception>
#include <mutex>

#include "brep/model_impl.h"
#include "brep/occt.h"

namespace hexfeature {
namespace {

constexpr double kSharp = 20 * EIGEN_PI / 180;
constexpr double kKink = 30 * EIGEN_PI / 180;

/// Outward normals of the true surface at the three corners of a base triangle.
Vec3 corner_normal(const CadModel::Impl& impl, int h) {
  const int t = h / 3;
  const Vec2 middle = (impl.base.corner_uv[3 * t] + impl.base.corner_uv[3 * t + 1] + impl.base.corner_uv[3 * t + 2]) / 3;
  return impl.cad.face(impl.base.triangle_face[t]).normal_towards(impl.base.corner_uv[h], middle);
}

/// Face `i`, 0-based, with its base triangles.
void analyse_face(CadModel& model, int i, const std::vector<int>& triangles) {
  const CadModel::Impl& impl = model.impl();
  const BaseMesh& base = impl.base;
  const FaceGeometry& g = impl.cad.faces[i];
  CadFace& f = model.faces[i];
  const TopoDS_Face shape = TopoDS::Face(impl.cad.face_map(i + 1));
  GProp_GProps properties;
  BRepGProp::SurfaceProperties(shape, properties);
  f.area = std::abs(properties.Mass());
  f.solid = triangles.empty() ? 0 : base.triangle_solid[triangles.front()];
  for (TopExp_Explorer e(shape, TopAbs_EDGE); e.More(); e.Next()) {
    const int id = impl.cad.edge_map.FindIndex(e.Current());
    if (std::find(f.edges.begin(), f.edges.end(), id) == f.edges.end()) f.edges.push_back(id);
  }
  f.kind = g.native;
  f.origin = g.origin;
  f.axis = g.z;
  f.radius = g.radius;
  f.radius2 = g.radius2;
  f.half_angle = std::atan2(g.sine, g.cosine);
  if (g.native == SurfaceKind::Plane) f.axis = g.normal(g.lower);
  if (triangles.empty()) return;
  if (g.native == SurfaceKind::Other) {
    std::vector<Vec3> points, normals;
    const int step = std::max<int>(1, static_cast<int>(triangles.size()) / 100);
    for (std::size_t k = 0; k < triangles.size(); k += step) {
      const int t = triangles[k];
      const Vec2 uv = (base.corner_uv[3 * t] + base.corner_uv[3 * t + 1] + base.corner_uv[3 * t + 2]) / 3;
      const Vec3 n = g.normal(uv);
      if (!n.isZero()) {
        points.push_back(g.point(uv));
        normals.push_back(n);
      }
      for (int c = 0; c < 3; ++c) {
        const Vec3 m = g.normal(base.corner_uv[3 * t + c]);
        if (m.isZero()) continue;
        points.push_back(g.point(base.corner_uv[3 * t + c]));
        normals.push_back(m);
      }
    }
    recognise(points, normals, 1e-5 * impl.cad.diagonal, f);
  }
  if (f.kind != SurfaceKind::Plane && f.kind != SurfaceKind::Other) {
    const int t = triangles.front();
    const Vec2 uv = (base.corner_uv[3 * t] + base.corner_uv[3 * t + 1] + base.corner_uv[3 * t + 2]) / 3;
    const Vec3 p = g.point(uv), d = p - f.origin, n = g.normal(uv);
    Vec3 away = d - d.dot(f.axis) * f.axis;
    if (f.kind == SurfaceKind::Sphere) away = d;
    if (f.kind == SurfaceKind::Torus) away = d - f.radius * away.normalized();
    f.outward_convex = n.dot(away) > 0;
  }
}

void analyse_faces(CadModel& model, Context& context, int threads) {
  const BaseMesh& base = model.impl().base;
  std::vector<std::vector<int>> triangles(model.faces.size());
  for (int t = 0; t < base.triangle_count(); ++t) triangles[base.triangle_face[t] - 1].push_back(t);
  // Areas of splines take their time. What is thrown is carried over by hand: OpenCASCADE's loop would make something else of it. Of
  // several the one of the lowest face, whatever thread was first.
  std::exception_ptr thrown;
  int thrown_at = 0;
  std::mutex mutex;
  OSD_Parallel::For(
      0, static_cast<int>(model.faces.size()),
      [&](int i) {
        try {
          context.check();
          analyse_face(model, i, triangles[i]);
        } catch (...) {
          const std::lock_guard<std::mutex> lock(mutex);
          if (!thrown || i < thrown_at) {
            thrown = std::current_exception();
            thrown_at = i;
          }
        }
      },
      threads < 2);
  if (thrown) std::rethrow_exception(thrown);
}

void analyse_edges(CadModel& model) {
  const CadModel::Impl& impl = model.impl();
  const CadTables& cad = impl.cad;
  const BaseMesh& base = impl.base;
  std::vector<std::vector<int>> halfedges(cad.edges.size());  // one per segment: that along increasing t, if any
  for (int h = 0; h < 3 * base.triangle_count(); ++h) {
    const int e = base.halfedge_edge[h];
    if (e == 0) continue;
    CadEdge& edge = model.edges[e - 1];
    const int f = base.triangle_face[h / 3];
    if (edge.faces[0] == 0) edge.faces = {f, base.triangle_face[base.opposite[h] / 3]};
    if (base.halfedge_t[h][0] < base.halfedge_t[h][1]) halfedges[e - 1].push_back(h);
  }
  for (std::size_t i = 0; i < cad.edges.size(); ++i) {
    CadEdge& edge = model.edges[i];
    const EdgeGeometry& g = cad.edges[i];
    const TopoDS_Edge shape = TopoDS::Edge(TopoDS::Edge(cad.edge_map(static_cast<int>(i) + 1)).Oriented(TopAbs_FORWARD));
    const TopoDS_Vertex first = TopExp::FirstVertex(shape), last = TopExp::LastVertex(shape);
    edge.vertices = {first.IsNull() ? 0 : cad.vertex_map.FindIndex(first), last.IsNull() ? 0 : cad.vertex_map.FindIndex(last)};
    edge.degenerate = g.kind == EdgeGeometry::Kind::None;
    edge.t0 = g.t0;
    edge.t1 = g.t1;
    edge.length = g.length(g.t0, g.t1);
    edge.seam = edge.faces[0] != 0 && edge.faces[0] == edge.faces[1];
    // Dihedral angles in the middle of the segments (at most about 16 of them), from the true normals of both faces.
    std::vector<double> angles;
    const auto& side = halfedges[i];
    const std::size_t step = std::max<std::size_t>(1, side.size() / 16);
    for (std::size_t k = 0; k < side.size(); k += step) {
      const int h = side[k];
      const double t = 0.5 * (base.halfedge_t[h][0] + base.halfedge_t[h][1]);
      const Vec3 p = g.point(t);
      Vec3 normal[2];
      for (int s = 0; s < 2; ++s) {
        const int halfedge = s == 0 ? h : base.opposite[h];
        const int tri = halfedge / 3, next = 3 * tri + (halfedge % 3 + 1) % 3;
        const FaceGeometry& face = cad.face(base.triangle_face[tri]);
        const Vec2 guess = 0.5 * (base.corner_uv[halfedge] + base.corner_uv[next]);
        const Vec2 centre = (base.corner_uv[3 * tri] + base.corner_uv[3 * tri + 1] + base.corner_uv[3 * tri + 2]) / 3;
        Vec2 uv;
        face.closest(p, guess, uv);
        normal[s] = face.normal_towards(uv, centre);
      }
      angles.push_back(std::atan2(g.tangent(t).dot(normal[0].cross(normal[1])), normal[0].dot(normal[1])));
    }
    if (!angles.empty()) {
      std::nth_element(angles.begin(), angles.begin() + angles.size() / 2, angles.end());
      edge.dihedral = angles[angles.size() / 2];
    }
    edge.sharp = !edge.degenerate && (edge.faces[1] == 0 || std::abs(edge.dihedral) > kSharp);
  }
}

void analyse_vertices(CadModel& model) {
  const CadModel::Impl& impl = model.impl();
  const int count = static_cast<int>(impl.cad.vertices.size());
  std::vector<std::vector<Vec3>> leaving(count);  // tangents of the sharp edges' ends, pointing away from the vertex
  for (int v = 0; v < count; ++v) model.vertices[v].point = impl.cad.vertices[v];
  for (int e = 1; e <= static_cast<int>(model.edges.size()); ++e) {
    const CadEdge& edge = model.edge(e);
    if (edge.degenerate) continue;
    const EdgeGeometry& g = impl.cad.edge(e);
    for (int end = 0; end < 2; ++end) {
      const int v = edge.vertices[end];
      if (v == 0) continue;
      auto& list = model.vertices[v - 1].edges;
      if (list.empty() || list.back() != e) list.push_back(e);
      if (edge.sharp) leaving[v - 1].push_back(end == 0 ? g.tangent(g.t0) : Vec3(-g.tangent(g.t1)));
    }
  }
  for (int v = 0; v < count; ++v) {
    const auto& ways = leaving[v];
    model.vertices[v].hard =
        !(ways.empty() || (ways.size() == 2 && std::atan2(ways[0].cross(ways[1]).norm(), -ways[0].dot(ways[1])) < kKink));
  }
  // An apex: no sharp edge, but normals on all sides.
  std::vector<Vec3> first(count, Vec3::Zero());
  for (int h = 0; h < 3 * impl.base.triangle_count(); ++h) {
    const CadPlace& place = impl.base.place[impl.base.from(h)];
    if (place.dim != 0) continue;
    CadVertex& vertex = model.vertices[place.entity - 1];
    if (vertex.hard || !leaving[place.entity - 1].empty()) continue;
    const Vec3 n = corner_normal(impl, h);
    Vec3& reference = first[place.entity - 1];
    if (reference.isZero())
      reference = n;
    else if (!n.isZero() && n.dot(reference) < std::cos(kKink))
      vertex.hard = true;
  }
}

}  // namespace

void analyse(CadModel& model, Context& context, int threads) {
  CadModel::Impl& impl = model.impl();
  model.solid_count = static_cast<int>(impl.cad.solids.size());
  model.faces.assign(impl.cad.faces.size(), {});
  model.edges.assign(impl.cad.edges.size(), {});
  model.vertices.assign(impl.cad.vertices.size(), {});
  guarded("read", "the part cannot be analysed", [&] {
    analyse_faces(model, context, threads);
    analyse_edges(model);
    analyse_vertices(model);
    return 0;
  });
}

}  // namespace hexfeature
