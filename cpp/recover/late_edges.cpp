// HexFeatureWB - LGPL-2.1-or-later
#include "recover/late_edges.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "fit/quad_net.h"
#include "mesh/triangle_tree.h"

namespace hexfeature {

namespace {

/// A point goes no farther than this many h to its curve; and along it, neighbours keep this much between them.
constexpr double kFar = 0.9, kClose = 0.2;

using FacePair = std::pair<int, int>;  // smaller first

/// Per quad: the CAD face under most of it, of its own and those across one of the edges.
std::vector<int> faces_under(const HexComplex& mesh, const std::map<FacePair, std::vector<int>>& edges_between, const SurfaceMesh& surface,
                             const Context& context) {
  constexpr int kSide = 4;
  std::vector<int> faces = mesh.quad_face;
  std::vector<char> concerned;
  for (const auto& [pair, edges] : edges_between) {
    concerned.resize(std::max<std::size_t>(concerned.size(), pair.second + 1), 0);
    concerned[pair.first] = concerned[pair.second] = 1;
  }
  const TriangleTree tree(surface, context);
  std::map<int, int> count;
  for (std::size_t q = 0; q < mesh.quads.size(); ++q) {
    const int own = mesh.quad_face[q];
    if (own <= 0 || own >= static_cast<int>(concerned.size()) || !concerned[own]) continue;
    context.check();
    count.clear();
    const auto& v = mesh.quads[q];
    for (int i = 0; i < kSide; ++i)
      for (int j = 0; j < kSide; ++j) {
        const double a = (i + 0.5) / kSide, b = (j + 0.5) / kSide;
        const Vec3 p =
            (1 - b) * ((1 - a) * mesh.points[v[0]] + a * mesh.points[v[1]]) + b * ((1 - a) * mesh.points[v[3]] + a * mesh.points[v[2]]);
        const ClosestPoint c = tree.closest(p);
        if (c.triangle < 0) continue;
        const int face = surface.triangle_face[c.triangle];
        if (face == own || edges_between.count(std::minmax(face, own)) > 0) ++count[face];
      }
    int most = count.count(own) > 0 ? count[own] : 0;
    for (const auto& [face, n] : count)
      if (n > most) {
        most = n;
        faces[q] = face;
      }
  }
  return faces;
}

}  // namespace

std::vector<LateRun> runs_beside_edges(const HexComplex& mesh, const std::vector<int>& edges, const SurfaceMesh& surface,
                                       const Geometry& geometry, double size, const Context& context) {
  std::vector<LateRun> found;
  std::map<FacePair, std::vector<int>> edges_between;
  for (int e : edges) {
    const CadEdge& edge = geometry.edge(e);
    if (edge.faces[1] > 0 && edge.faces[0] != edge.faces[1]) edges_between[std::minmax(edge.faces[0], edge.faces[1])].push_back(e);
  }
  if (edges_between.empty()) return found;
  const std::vector<int> faces = faces_under(mesh, edges_between, surface, context);
  const QuadNet net = make_quad_net(mesh.quads, mesh.point_count());

  const auto pair_at = [&](int g) {
    const int o = net.opposite[g];
    return o < 0 ? FacePair{0, 0} : FacePair(std::minmax(faces[g / 4], faces[o / 4]));
  };
  const auto is_border = [&](int g) {
    const std::array<int, 2> nodes{std::min(net.from(g), net.to(g)), std::max(net.from(g), net.to(g))};
    return edges_between.count(pair_at(g)) > 0 && !std::binary_search(mesh.feature_edges.begin(), mesh.feature_edges.end(), nodes);
  };
  const auto is_free = [&](int n) { return mesh.place[n].dim == 2; };
  // The halfedge that goes straight on, -1 when there is none.
  const auto straight = [&](int g) {
    const int n = net.to(g);
    if (net.out_begin[n + 1] - net.out_begin[n] != 4) return -1;
    const int left = net.opposite[net.next(g)];
    return left < 0 ? -1 : net.next(left);
  };

  // The curve's foot of a node; edge 0 when it is too far or beyond an end.
  struct Foot {
    int edge = 0;
    double t = 0, distance = 0;
  };
  const auto foot_of = [&](int n, const FacePair& pair) {
    Foot best;
    for (int e : edges_between.at(pair)) {
      const CurvePoint c = geometry.projector->project_to_edge(e, mesh.points[n], nullptr);
      const double d = (c.point - mesh.points[n]).norm();
      const CadEdge& edge = geometry.edge(e);
      const double margin = 1e-6 * (edge.t1 - edge.t0);
      const bool closed = edge.vertices[0] == edge.vertices[1];
      if (!closed && (c.t < edge.t0 + margin || c.t > edge.t1 - margin)) continue;
      if (d < kFar * size && (best.edge == 0 || d < best.distance)) best = {e, c.t, d};
    }
    return best;
  };

  std::vector<char> used(net.opposite.size(), 0), taken(mesh.points.size(), 0);
  std::vector<int> run;
  for (int start = 0; start < static_cast<int>(net.opposite.size()); ++start) {
    if (used[start] || net.opposite[start] < start || !is_border(start)) continue;
    const FacePair pair = pair_at(start);
    const auto goes_on = [&](int g) { return g >= 0 && !used[g] && is_border(g) && pair_at(g) == pair; };
    run.clear();
    // Back to the run's beginning, then forward.
    int g = net.opposite[start];
    std::vector<int> back;
    for (; goes_on(g); g = straight(g)) {
      used[g] = used[net.opposite[g]] = 1;
      back.push_back(net.to(g));
    }
    run.assign(back.rbegin(), back.rend());
    run.push_back(net.to(start));
    for (g = straight(start); goes_on(g); g = straight(g)) {
      used[g] = used[net.opposite[g]] = 1;
      run.push_back(net.to(g));
    }
    // Pieces of the run whose points are free and have their feet one after the other on one curve.
    LateRun piece;
    const auto finish = [&] {
      if (piece.nodes.size() >= 2) {
        for (int n : piece.nodes) taken[n] = 1;
        for (std::size_t i = 0; i + 1 < piece.nodes.size(); ++i) {
          const int along = net.find(piece.nodes[i], piece.nodes[i + 1]);
          for (int side : {along, net.opposite[along]}) piece.quads.push_back({side / 4, faces[side / 4]});
        }
        found.push_back(std::move(piece));
      }
      piece = {};
    };
    for (int n : run) {
      context.check();
      const Foot foot = is_free(n) && !taken[n] ? foot_of(n, pair) : Foot{};
      if (foot.edge == 0) {
        finish();
        continue;
      }
      if (!piece.nodes.empty()) {
        const Vec3 p = geometry.projector->edge_point(foot.edge, foot.t).point,
                   q = geometry.projector->edge_point(piece.edge, piece.t.back()).point;
        const std::size_t m = piece.t.size();
        const bool other_way = m > 1 && (foot.t > piece.t[m - 1]) != (piece.t[m - 1] > piece.t[m - 2]);
        if (foot.edge != piece.edge || (p - q).norm() < kClose * size || other_way) finish();
      }
      piece.edge = foot.edge;
      piece.nodes.push_back(n);
      piece.t.push_back(foot.t);
    }
    finish();
  }
  return found;
}

void bind_points(HexComplex& mesh, const std::vector<LateRun>& runs) {
  std::vector<std::array<int, 3>> followed;  // nodes, CAD edge
  for (std::size_t i = 0; i < mesh.feature_edges.size(); ++i)
    followed.push_back({mesh.feature_edges[i][0], mesh.feature_edges[i][1], mesh.feature_edge_cad[i]});
  for (const LateRun& run : runs) {
    for (const auto& [quad, face] : run.quads) mesh.quad_face[quad] = face;
    for (std::size_t i = 0; i < run.nodes.size(); ++i) {
      mesh.place[run.nodes[i]] = {1, run.edge, Vec2(run.t[i], 0)};
      if (i > 0) followed.push_back({std::min(run.nodes[i - 1], run.nodes[i]), std::max(run.nodes[i - 1], run.nodes[i]), run.edge});
    }
  }
  std::sort(followed.begin(), followed.end());
  mesh.feature_edges.clear();
  mesh.feature_edge_cad.clear();
  for (const auto& f : followed) {
    mesh.feature_edges.push_back({f[0], f[1]});
    mesh.feature_edge_cad.push_back(f[2]);
  }
}

bool release(std::vector<LateRun>& runs, const std::vector<char>& marked) {
  std::vector<LateRun> kept;
  bool any = false;
  for (const LateRun& run : runs) {
    LateRun piece{run.edge, {}, {}, {}};
    for (std::size_t i = 0; i <= run.nodes.size(); ++i) {
      if (i < run.nodes.size() && !marked[run.nodes[i]]) {
        // The two quads beside the mesh edge to the point before.
        if (!piece.nodes.empty())
          piece.quads.insert(piece.quads.end(), run.quads.begin() + 2 * static_cast<long>(i) - 2,
                             run.quads.begin() + 2 * static_cast<long>(i));
        piece.nodes.push_back(run.nodes[i]);
        piece.t.push_back(run.t[i]);
        continue;
      }
      any = any || i < run.nodes.size();
      if (!piece.nodes.empty()) kept.push_back(std::move(piece));
      piece = {run.edge, {}, {}, {}};
    }
  }
  runs = std::move(kept);
  return any;
}

std::vector<int> loosen(HexComplex& mesh, const std::vector<char>& marked, const Geometry& geometry, bool sharp) {
  std::vector<int> points;
  std::vector<char> off(mesh.points.size(), 0);
  for (const auto& quad : mesh.quads)
    for (int v : quad) {
      const CadPlace& place = mesh.place[v];
      if (marked[v] && place.dim == 1 && (sharp || !geometry.edge(place.entity).sharp)) off[v] = 1;
    }
  for (std::size_t q = 0; q < mesh.quads.size(); ++q)
    for (int v : mesh.quads[q]) {
      if (!off[v] || mesh.place[v].dim != 1) continue;
      // The face of a quad at the point that the edge borders.
      const auto& faces = geometry.edge(mesh.place[v].entity).faces;
      const int face = mesh.quad_face[q];
      if (face != faces[0] && face != faces[1]) continue;
      const FacePoint foot = geometry.projector->project_to_face(face, mesh.points[v], nullptr);
      mesh.place[v] = {2, face, foot.uv};
      points.push_back(v);
    }
  std::size_t kept = 0;
  for (std::size_t i = 0; i < mesh.feature_edges.size(); ++i) {
    const auto [a, b] = mesh.feature_edges[i];
    if ((off[a] && mesh.place[a].dim == 2) || (off[b] && mesh.place[b].dim == 2)) continue;
    mesh.feature_edges[kept] = mesh.feature_edges[i];
    mesh.feature_edge_cad[kept++] = mesh.feature_edge_cad[i];
  }
  mesh.feature_edges.resize(kept);
  mesh.feature_edge_cad.resize(kept);
  std::sort(points.begin(), points.end());
  return points;
}

}  // namespace hexfeature
