// HexFeatureWB - LGPL-2.1-or-later
#include "brep/base_mesh.h"

#include <BRepMesh_IncrementalMesh.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <Poly_PolygonOnTriangulation.hxx>
#include <Poly_Triangulation.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>
#include <algorithm>
#include <numeric>

#include "brep/model_impl.h"
#include "brep/occt.h"

namespace hexfeature {
namespace {

struct Chain {
  std::vector<int> points;  ///< of the mesh, from t0 to t1
  std::vector<double> t;
};

/// A side of a triangle within one face, waiting for its other side.
struct Side {
  int a, b, halfedge;  ///< local nodes, a < b
};
bool operator<(const Side& p, const Side& q) { return p.a != q.a ? p.a < q.a : p.b != q.b ? p.b < q.b : p.halfedge < q.halfedge; }

class Builder {
 public:
  explicit Builder(const CadTables& cad) : cad_(cad) {}

  /// Returns the CAD faces that do not close; empty when all is well.
  std::vector<int> build(Context& context) {
    for (int s = 0; s < static_cast<int>(cad_.solids.size()); ++s) {
      solid_ = s + 1;
      chains_.assign(cad_.edges.size(), {});
      vertex_point_.assign(cad_.vertices.size(), -1);
      edge_sides_.clear();
      for (TopExp_Explorer faces(cad_.solids[s], TopAbs_FACE); faces.More(); faces.Next()) {
        context.check();
        add_face(TopoDS::Face(faces.Current()));
      }
      pair_edges();
    }
    std::sort(bad_.begin(), bad_.end());
    bad_.erase(std::unique(bad_.begin(), bad_.end()), bad_.end());
    return bad_;
  }
  BaseMesh mesh;

 private:
  struct EdgeSide {
    int edge, segment, halfedge;
  };

  int add_point(const Vec3& p, int dim, int entity, const Vec2& uv) {
    mesh.points.push_back(p);
    mesh.place.push_back({dim, entity, uv});
    return static_cast<int>(mesh.points.size()) - 1;
  }

  int vertex(int v) {
    int& p = vertex_point_[v - 1];
    if (p < 0) p = add_point(cad_.vertices[v - 1], 0, v, Vec2::Zero());
    return p;
  }

  const Chain& chain(int e, const TopoDS_Edge& edge, const TColStd_Array1OfReal& parameters) {
    Chain& c = chains_[e - 1];
    if (!c.points.empty()) return c;
    const TopoDS_Edge forward = TopoDS::Edge(edge.Oriented(TopAbs_FORWARD));
    const int first = cad_.vertex_map.FindIndex(TopExp::FirstVertex(forward)),
              last = cad_.vertex_map.FindIndex(TopExp::LastVertex(forward));
    const EdgeGeometry& g = cad_.edge(e);
    const int n = parameters.Length();
    for (int i = 0; i < n; ++i) {
      const double t = i == 0 ? g.t0 : i == n - 1 ? g.t1 : parameters(parameters.Lower() + i);
      const int end = i == 0 ? first : i == n - 1 ? last : 0;
      c.t.push_back(t);
      if (g.kind == EdgeGeometry::Kind::None)
        c.points.push_back(vertex(std::max(first, last)));
      else
        c.points.push_back(end > 0 ? vertex(end) : add_point(g.point(t), 1, e, {t, 0}));
    }
    return c;
  }

  void add_face(const TopoDS_Face& face) {
    const int f = cad_.face_map.FindIndex(face);
    TopLoc_Location location;
    const Handle(Poly_Triangulation) tri = BRep_Tool::Triangulation(face, location);
    if (tri.IsNull() || tri->NbTriangles() == 0 || !tri->HasUVNodes()) {
      bad_.push_back(f);
      return;
    }
    const FaceGeometry& geometry = cad_.face(f);
    const int n = tri->NbNodes();
    // `node` welds within the face (nodes on one pole become one), `point` is the mesh's point.
    std::vector<int> node(n), point(n, -1);
    std::iota(node.begin(), node.end(), 0);
    struct Segment {
      int a, b, edge, index;
      bool forward;
    };
    std::vector<Segment> segments;
    std::vector<int> pole_node(cad_.vertices.size(), -1);
    std::vector<signed char> free_parameter(n, -1);
    for (TopExp_Explorer edges(face, TopAbs_EDGE); edges.More(); edges.Next()) {
      const TopoDS_Edge edge = TopoDS::Edge(edges.Current());
      const int e = cad_.edge_map.FindIndex(edge);
      const Handle(Poly_PolygonOnTriangulation) polygon = BRep_Tool::PolygonOnTriangulation(edge, tri, location);
      if (polygon.IsNull() || !polygon->HasParameters() || polygon->NbNodes() < 2) {
        bad_.push_back(f);
        return;
      }
      const Chain& c = chain(e, edge, polygon->Parameters()->Array1());
      const int m = polygon->NbNodes();
      if (m != static_cast<int>(c.points.size())) {
        bad_.push_back(f);
        return;
      }
      const bool degenerate = cad_.edge(e).kind == EdgeGeometry::Kind::None;
      const Vec2 run = to_eigen(tri->UVNode(polygon->Node(m))) - to_eigen(tri->UVNode(polygon->Node(1)));
      for (int i = 0; i < m; ++i) {
        const int k = polygon->Node(i + 1) - 1;
        point[k] = c.points[i];
        if (degenerate) {
          int& pole = pole_node[mesh.place[c.points[i]].entity - 1];
          if (pole < 0) pole = k;
          node[k] = pole;
          free_parameter[k] = std::abs(run[0]) >= std::abs(run[1]) ? 0 : 1;
        } else if (i > 0) {
          const int j = polygon->Node(i) - 1;
          segments.push_back({std::min(j, k), std::max(j, k), e, i - 1, j < k});
        }
      }
    }
    for (auto& s : segments) {  // now that poles are known
      const int a = node[s.a], b = node[s.b];
      if (a > b) s.forward = !s.forward;
      s.a = std::min(a, b);
      s.b = std::max(a, b);
    }
    const auto segment_less = [](const Segment& p, const Segment& q) { return p.a != q.a ? p.a < q.a : p.b < q.b; };
    std::stable_sort(segments.begin(), segments.end(), segment_less);

    for (int k = 0; k < n; ++k)
      if (point[k] < 0) {
        const Vec2 uv = to_eigen(tri->UVNode(k + 1));
        point[k] = add_point(geometry.point(uv), 2, f, uv);
      }
    const bool flip = face.Orientation() == TopAbs_REVERSED;
    std::vector<Side> sides;
    const int first_corner = 3 * mesh.triangle_count();
    for (int i = 1; i <= tri->NbTriangles(); ++i) {
      int k[3];
      tri->Triangle(i).Get(k[0], k[1], k[2]);
      for (int& j : k) --j;
      if (flip) std::swap(k[1], k[2]);
      const std::array<int, 3> p{point[k[0]], point[k[1]], point[k[2]]};
      const int q[3] = {node[k[0]], node[k[1]], node[k[2]]};
      if (q[0] == q[1] || q[1] == q[2] || q[2] == q[0]) continue;  // at a pole
      const int t = mesh.triangle_count();
      mesh.triangles.push_back(p);
      mesh.triangle_face.push_back(f);
      mesh.triangle_solid.push_back(solid_);
      mesh.triangle_side.push_back(face.Orientation() == cad_.face_map(f).Orientation() ? 1 : -1);
      for (int c = 0; c < 3; ++c) {
        mesh.corner_uv.push_back(to_eigen(tri->UVNode(k[c] + 1)));
        mesh.corner_free.push_back(free_parameter[k[c]]);
        mesh.halfedge_edge.push_back(0);
        mesh.halfedge_t.push_back(Vec2::Zero());
        mesh.opposite.push_back(-1);
        const int a = q[c], b = q[(c + 1) % 3], h = 3 * t + c;
        const Segment key{std::min(a, b), std::max(a, b), 0, 0, true};
        const auto s = std::lower_bound(segments.begin(), segments.end(), key, segment_less);
        if (s != segments.end() && s->a == key.a && s->b == key.b) {
          const Chain& on = chains_[s->edge - 1];
          const bool along = s->forward == (a < b);
          mesh.halfedge_edge[h] = s->edge;
          mesh.halfedge_t[h] = along ? Vec2(on.t[s->index], on.t[s->index + 1]) : Vec2(on.t[s->index + 1], on.t[s->index]);
          edge_sides_.push_back({s->edge, s->index, h});
        } else {
          sides.push_back({key.a, key.b, h});
        }
      }
    }
    for (int h = first_corner; h < 3 * mesh.triangle_count(); ++h) mesh.settle_pole(h);
    std::sort(sides.begin(), sides.end());
    for (std::size_t i = 0; i < sides.size();) {
      if (i + 1 < sides.size() && sides[i].a == sides[i + 1].a && sides[i].b == sides[i + 1].b &&
          (i + 2 == sides.size() || sides[i + 2].a != sides[i].a || sides[i + 2].b != sides[i].b)) {
        mesh.opposite[sides[i].halfedge] = sides[i + 1].halfedge;
        mesh.opposite[sides[i + 1].halfedge] = sides[i].halfedge;
        i += 2;
      } else {
        bad_.push_back(f);
        ++i;
      }
    }
  }

  void pair_edges() {
    std::sort(edge_sides_.begin(), edge_sides_.end(), [](const EdgeSide& p, const EdgeSide& q) {
      return p.edge != q.edge ? p.edge < q.edge : p.segment != q.segment ? p.segment < q.segment : p.halfedge < q.halfedge;
    });
    for (std::size_t i = 0; i < edge_sides_.size();) {
      std::size_t j = i;
      while (j < edge_sides_.size() && edge_sides_[j].edge == edge_sides_[i].edge && edge_sides_[j].segment == edge_sides_[i].segment) ++j;
      const int h = edge_sides_[i].halfedge, g = j == i + 2 ? edge_sides_[i + 1].halfedge : -1;
      if (g >= 0 && (mesh.halfedge_t[h][0] < mesh.halfedge_t[h][1]) != (mesh.halfedge_t[g][0] < mesh.halfedge_t[g][1])) {
        mesh.opposite[h] = g;
        mesh.opposite[g] = h;
      } else {
        for (std::size_t k = i; k < j; ++k) bad_.push_back(mesh.triangle_face[edge_sides_[k].halfedge / 3]);
      }
      i = j;
    }
    edge_sides_.clear();
  }

  const CadTables& cad_;
  int solid_ = 1;
  std::vector<Chain> chains_;
  std::vector<int> vertex_point_;
  std::vector<EdgeSide> edge_sides_;
  std::vector<int> bad_;
};

/// Solids that are inside out (their surface encloses a negative volume) are turned.
void turn_outward(CadTables& cad, BaseMesh& mesh) {
  std::vector<double> volume(cad.solids.size(), 0);
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    const auto& v = mesh.triangles[t];
    const Vec3& o = mesh.points.front();
    volume[mesh.triangle_solid[t] - 1] += (mesh.points[v[0]] - o).dot((mesh.points[v[1]] - o).cross(mesh.points[v[2]] - o)) / 6;
  }
  for (std::size_t s = 0; s < volume.size(); ++s) {
    if (volume[s] >= 0) continue;
    std::vector<char> turned(cad.faces.size(), 0);
    for (int t = 0; t < mesh.triangle_count(); ++t) {
      if (mesh.triangle_solid[t] != static_cast<int>(s) + 1) continue;
      // Corner 0 stays; halfedges 0 1 2 become 2 1 0 reversed.
      std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
      std::swap(mesh.corner_uv[3 * t + 1], mesh.corner_uv[3 * t + 2]);
      std::swap(mesh.corner_free[3 * t + 1], mesh.corner_free[3 * t + 2]);
      std::swap(mesh.halfedge_edge[3 * t], mesh.halfedge_edge[3 * t + 2]);
      std::swap(mesh.halfedge_t[3 * t], mesh.halfedge_t[3 * t + 2]);
      std::swap(mesh.opposite[3 * t], mesh.opposite[3 * t + 2]);
      for (int c = 0; c < 3; ++c) {
        std::swap(mesh.halfedge_t[3 * t + c][0], mesh.halfedge_t[3 * t + c][1]);
        int& o = mesh.opposite[3 * t + c];
        o = o - o % 3 + 2 - o % 3;
      }
      const int f = mesh.triangle_face[t];
      if (turned[f - 1] == 0) cad.faces[f - 1].reversed = !cad.faces[f - 1].reversed;
      turned[f - 1] = 1;
    }
  }
}

}  // namespace

BaseMesh make_base_mesh(CadTables& cad, Context& context, int threads) {
  std::vector<int> bad;
  const double deflection[4] = {0.004, 0.001, 0.0003, 0.02};
  const double degrees[4] = {15, 9, 5, 30};
  for (int attempt = 0; attempt < 4; ++attempt) {
    IMeshTools_Parameters parameters;
    parameters.Deflection = parameters.DeflectionInterior = deflection[attempt] * cad.diagonal;
    parameters.Angle = parameters.AngleInterior = degrees[attempt] * EIGEN_PI / 180;
    parameters.MinSize = 1e-5 * cad.diagonal;
    parameters.InParallel = threads > 1;
    bad = guarded("read", "a face cannot be triangulated", [&] {
      BRepTools::Clean(cad.shape);
      Handle(CancelIndicator) indicator = new CancelIndicator(context);
      BRepMesh_IncrementalMesh(cad.shape, parameters, indicator->Start());
      indicator->rethrow();
      context.check();
      return std::vector<int>();
    });
    Builder builder(cad);
    bad = builder.build(context);
    if (bad.empty()) {
      turn_outward(cad, builder.mesh);
      return std::move(builder.mesh);
    }
  }
  throw MeshingError(Failure::BadInput, "read", "the surface does not close at " + std::to_string(bad.size()) + " face(s)",
                     "the part must be a closed solid with sound faces; try Part > Check geometry or a shape healing", bad);
}

}  // namespace hexfeature
