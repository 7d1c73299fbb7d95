// HexFeatureWB - LGPL-2.1-or-later
#include "fit/chain.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"

namespace hexfeature {

int Chain::segment_at(double x) const {
  const auto it = std::upper_bound(s.begin() + 1, s.end() - 1, x);
  return static_cast<int>(it - s.begin()) - 1;
}

Vec3 Chain::lattice_at(double x, const std::vector<Vec3>& lattice) const {
  const auto it = std::upper_bound(node_s.begin() + 1, node_s.end() - 1, x);
  const int i = static_cast<int>(it - node_s.begin()) - 1;
  const double d = node_s[i + 1] - node_s[i];
  double f = d > 0 ? std::clamp((x - node_s[i]) / d, 0.0, 1.0) : 0.0;
  constexpr double kCutOff = 0.1;
  const bool cut_start = i == 0 && first > 0, cut_end = i + 2 == static_cast<int>(node_s.size()) && last < s.back();
  const double low = cut_start ? kCutOff : 0.0, high = cut_end ? 1 - kCutOff : 1.0;
  if (cut_start && x < first)
    f = kCutOff * x / first;
  else if (cut_end && x > last)
    f = 1 - kCutOff * (s.back() - x) / (s.back() - last);
  else
    f = low + f * (high - low);
  return (1 - f) * lattice[nodes[i]] + f * lattice[nodes[i + 1]];
}

int followed_edge(const SurfaceMesh& mesh, const Geometry& geometry, int halfedge) {
  const int e = mesh.halfedge_edge[halfedge];
  if (e <= 0) return 0;
  const CadEdge& edge = geometry.edge(e);
  return edge.seam || edge.degenerate ? 0 : e;
}

void measure(Chain& chain, const SurfaceMesh& mesh, const Geometry& geometry) {
  const int segments = static_cast<int>(chain.halfedges.size());
  chain.s.assign(segments + 1, 0);
  for (int i = 0; i < segments; ++i)
    chain.s[i + 1] = chain.s[i] + (mesh.points[chain.vertices[i + 1]] - mesh.points[chain.vertices[i]]).norm();

  chain.first = 0;
  chain.last = chain.length();

  const auto rank = [&](int e) { return e == 0 ? 0 : geometry.edge(e).sharp ? 2 : 1; };
  chain.stops.clear();
  for (int i = 1; i < segments; ++i) {
    const int v = chain.vertices[i];
    const CadPlace& place = mesh.place[v];
    int importance = 0;
    if (place.dim == 0 && place.entity > 0 && geometry.vertex(place.entity).hard) importance = 3;
    const int before = followed_edge(mesh, geometry, chain.halfedges[i - 1]), after = followed_edge(mesh, geometry, chain.halfedges[i]);
    if (rank(before) != rank(after)) importance = std::max(importance, std::max(rank(before), rank(after)));
    // CAD edges that leave the chain here, on either side.
    const int first = chain.halfedges[i];
    int h = first;
    do {
      if (h != first && h != mesh.opposite[chain.halfedges[i - 1]])
        importance = std::max(importance, rank(followed_edge(mesh, geometry, h)));
      h = mesh.opposite[SurfaceMesh::prev(h)];
    } while (h != first);
    if (importance > 0) chain.stops.push_back({i, importance});
  }
}

std::vector<Chain> make_arc_chains(const HexComplex& complex, const SurfaceMesh& mesh, const FeatureShape& shape,
                                   const Geometry& geometry) {
  const int arcs = shape.arc_count();
  std::vector<int> corner_node(shape.corner_count(), -1);
  std::vector<std::vector<int>> nodes(arcs);
  for (int n = 0; n < complex.point_count(); ++n) {
    const ShapePlace& p = complex.shape_place[n];
    if (p.dim == 0) corner_node[p.item] = n;
    if (p.dim == 1) nodes[p.item].push_back(n);
  }
  std::vector<Chain> chains(arcs);
  for (int a = 0; a < arcs; ++a) {
    const auto& edge = shape.cells.edges[a];
    const auto& arc = shape.arcs[a];
    const auto fail = [&](const char* reason) {
      std::vector<int> faces = shape.charts[edge.left].cad_faces;
      faces.insert(faces.end(), shape.charts[edge.right].cad_faces.begin(), shape.charts[edge.right].cad_faces.end());
      std::sort(faces.begin(), faces.end());
      faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
      throw MeshingError(Failure::NoMesh, "fit", reason, "try another element size", faces);
    };
    if (arc.axis < 0 || edge.start < 0 || edge.end < 0) fail("a feature line has no corners or no direction");
    const int start = corner_node[edge.start], end = corner_node[edge.end];
    if (start < 0 || end < 0) fail("a corner of the feature shape has no lattice node");
    Chain& chain = chains[a];
    chain.arc = a;
    chain.vertices = edge.vertices;
    chain.halfedges = edge.halfedges;
    const double sign = complex.points[end][arc.axis] > complex.points[start][arc.axis] ? 1 : -1;
    std::sort(nodes[a].begin(), nodes[a].end(),
              [&](int i, int j) { return sign * complex.points[i][arc.axis] < sign * complex.points[j][arc.axis]; });
    chain.nodes.push_back(start);
    chain.nodes.insert(chain.nodes.end(), nodes[a].begin(), nodes[a].end());
    chain.nodes.push_back(end);
    const double steps = std::abs(complex.points[end][arc.axis] - complex.points[start][arc.axis]);
    if (chain.intervals() != static_cast<int>(std::lround(steps))) fail("a feature line lacks lattice nodes");
    measure(chain, mesh, geometry);
  }
  return chains;
}

void space_nodes(Chain& chain) {
  const int n = chain.intervals();
  std::vector<Stop>& stops = chain.stops;
  std::vector<char> keep(stops.size(), 1);
  for (Stop& stop : stops)
    if (!stop.pinned) stop.node = -1;

  // Fixed stations: the two ends and the pinned stops. Between two stations the unpinned stops share the intervals.
  struct Station {
    double s;
    int node, stop;
  };
  std::vector<Station> stations{{chain.first, 0, -1}};
  for (int i = 0; i < static_cast<int>(stops.size()); ++i)
    if (stops[i].pinned && chain.s[stops[i].vertex] > chain.first && chain.s[stops[i].vertex] < chain.last) {
      if (stops[i].node <= stations.back().node || stops[i].node >= n) {
        stops[i].pinned = false;  // two curves disagree: the earlier one wins
        stops[i].node = -1;
      } else {
        stations.push_back({chain.s[stops[i].vertex], stops[i].node, i});
      }
    }
  stations.push_back({chain.last, n, static_cast<int>(stops.size())});

  chain.node_s.assign(n + 1, 0);
  for (std::size_t k = 0; k + 1 < stations.size(); ++k) {
    const Station a = stations[k], b = stations[k + 1];
    const int intervals = b.node - a.node;
    const double mean = (b.s - a.s) / intervals;
    std::vector<int> inner;
    for (int i = a.stop + 1; i < b.stop; ++i)
      if (chain.s[stops[i].vertex] > a.s && chain.s[stops[i].vertex] < b.s) inner.push_back(i);
    const auto gap = [&](std::size_t i) {
      const double before = i == 0 ? a.s : chain.s[stops[inner[i - 1]].vertex];
      const double after = i + 1 == inner.size() ? b.s : chain.s[stops[inner[i + 1]].vertex];
      const double x = chain.s[stops[inner[i]].vertex];
      return std::min(x - before, after - x);
    };
    // A tangent edge may be missed rather than make a sliver; a hard vertex may not.
    const auto too_close = [&](std::size_t i) { return gap(i) < (stops[inner[i]].importance >= 3 ? 1e-9 : 0.15) * mean; };
    for (;;) {
      std::size_t worst = inner.size();
      const bool crowded = static_cast<int>(inner.size()) > intervals - 1;
      for (std::size_t i = 0; i < inner.size(); ++i) {
        if (!crowded && !too_close(i)) continue;
        if (worst == inner.size() || stops[inner[i]].importance < stops[inner[worst]].importance ||
            (stops[inner[i]].importance == stops[inner[worst]].importance && gap(i) < gap(worst)))
          worst = i;
      }
      if (worst == inner.size()) break;
      inner.erase(inner.begin() + static_cast<long>(worst));
    }
    const std::size_t pieces = inner.size() + 1;
    std::vector<double> at{a.s};
    for (int i : inner) at.push_back(chain.s[stops[i].vertex]);
    at.push_back(b.s);
    std::vector<int> share(pieces, 1);
    for (int left = intervals - static_cast<int>(pieces); left > 0; --left) {
      std::size_t best = 0;
      for (std::size_t i = 1; i < pieces; ++i)
        if ((at[i + 1] - at[i]) / share[i] > (at[best + 1] - at[best]) / share[best] * (1 + 1e-12)) best = i;
      ++share[best];
    }
    int node = a.node;
    for (std::size_t i = 0; i < pieces; ++i) {
      for (int j = 0; j < share[i]; ++j) chain.node_s[node + j] = at[i] + (at[i + 1] - at[i]) * j / share[i];
      node += share[i];
      if (i + 1 < pieces) stops[inner[i]].node = node;
    }
  }
  chain.node_s[n] = chain.last;
}

std::vector<int> snap_corners(std::vector<Chain>& chains, const SurfaceMesh& mesh, const FeatureShape& shape, const Geometry& geometry,
                              double reach) {
  const auto hard_vertex = [&](int v) {
    const CadPlace& p = mesh.place[v];
    return p.dim == 0 && p.entity > 0 && geometry.vertex(p.entity).hard;
  };
  struct Candidate {
    double distance;
    int corner, vertex, chain, index;
  };
  std::vector<Candidate> candidates;
  std::vector<char> taken(mesh.point_count(), 0);
  for (const auto& node : shape.cells.nodes) taken[node.vertex] = 1;
  for (int c = 0; c < static_cast<int>(chains.size()); ++c) {
    const Chain& chain = chains[c];
    const auto& edge = shape.cells.edges[chain.arc];
    const int last = static_cast<int>(chain.vertices.size()) - 1;
    for (int side = 0; side < 2; ++side) {
      const int corner = side == 0 ? edge.start : edge.end;
      if (hard_vertex(shape.cells.nodes[corner].vertex)) continue;
      for (int k = 1; k < last; ++k) {
        const int i = side == 0 ? k : last - k;
        const double distance = side == 0 ? chain.s[i] : chain.length() - chain.s[i];
        if (distance > reach) break;
        if (hard_vertex(chain.vertices[i])) {
          candidates.push_back({distance, corner, chain.vertices[i], c, i});
          break;
        }
      }
    }
  }
  std::sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
    return a.distance != b.distance ? a.distance < b.distance : a.corner != b.corner ? a.corner < b.corner : a.vertex < b.vertex;
  });
  std::vector<int> target(shape.corner_count(), -1);
  // Used length of each chain's two ends: an arc must keep its order.
  std::vector<std::array<double, 2>> used(chains.size(), {0, 0});
  for (const Candidate& m : candidates) {
    if (target[m.corner] >= 0 || taken[m.vertex]) continue;
    Chain& chain = chains[m.chain];
    const bool at_start = shape.cells.edges[chain.arc].start == m.corner && chain.s[m.index] == m.distance;
    if (used[m.chain][at_start ? 1 : 0] + m.distance > 0.75 * chain.length()) continue;
    used[m.chain][at_start ? 0 : 1] = m.distance;
    (at_start ? chain.first : chain.last) = chain.s[m.index];
    target[m.corner] = m.vertex;
    taken[m.vertex] = 1;
  }
  return target;
}

CadPlace place_of_vertex(int vertex, int halfedge_nearby, const SurfaceMesh& mesh, const Geometry& geometry, Vec3& point) {
  CadPlace place = mesh.place[vertex];
  point = mesh.points[vertex];
  const bool on_seam = place.dim == 1 && (geometry.edge(place.entity).seam || geometry.edge(place.entity).degenerate);
  // A CAD vertex that only seams and poles touch is no feature: the node may slide over it.
  bool soft = false;
  if (place.dim == 0 && !geometry.vertex(place.entity).hard) {
    soft = true;
    for (int e : geometry.vertex(place.entity).edges) soft = soft && (geometry.edge(e).seam || geometry.edge(e).degenerate);
  }
  // One where a closed curve begins and a seam ends is none either: the node may slide along the curve.
  if (place.dim == 0 && !soft && !geometry.vertex(place.entity).hard) {
    int curve = 0, curves = 0;
    for (int e : geometry.vertex(place.entity).edges) {
      if (geometry.edge(e).seam || geometry.edge(e).degenerate || e == curve) continue;
      curve = e;
      ++curves;
    }
    if (curves == 1 && geometry.edge(curve).vertices[0] == geometry.edge(curve).vertices[1]) {
      const CurvePoint c = geometry.projector->project_to_edge(curve, point, &geometry.edge(curve).t0);
      point = c.point;
      return {1, curve, Vec2(c.t, 0)};
    }
  }
  if (on_seam || soft) {
    const int face = mesh.triangle_face[halfedge_nearby / 3];
    const FacePoint f = geometry.projector->project_to_face(face, point, nullptr);
    return {2, face, f.uv};
  }
  return place;
}

CadPlace place_on_chain(const Chain& chain, double x, const SurfaceMesh& mesh, const Geometry& geometry, Vec3& point) {
  const int i = chain.segment_at(x);
  const double d = chain.s[i + 1] - chain.s[i], tolerance = 1e-7 * chain.length();
  const int h = chain.halfedges[i];
  if (x - chain.s[i] <= tolerance) return place_of_vertex(chain.vertices[i], h, mesh, geometry, point);
  if (chain.s[i + 1] - x <= tolerance) return place_of_vertex(chain.vertices[i + 1], h, mesh, geometry, point);
  const int v = chain.vertices[i], w = chain.vertices[i + 1];
  const double f = (x - chain.s[i]) / d;
  const Vec3 p = (1 - f) * mesh.points[v] + f * mesh.points[w];
  const CadPlace &a = mesh.place[v], &b = mesh.place[w];
  if (const int e = followed_edge(mesh, geometry, h)) {
    const bool ka = a.dim == 1 && a.entity == e, kb = b.dim == 1 && b.entity == e;
    const double guess = ka ? a.uv[0] : b.uv[0];
    const CurvePoint c = geometry.projector->project_to_edge(e, p, ka || kb ? &guess : nullptr);
    point = c.point;
    return {1, e, Vec2(c.t, 0)};
  }
  const int face = mesh.triangle_face[h / 3];
  const bool ka = a.dim == 2 && a.entity == face, kb = b.dim == 2 && b.entity == face;
  const Vec2 guess = ka ? a.uv : b.uv;
  const FacePoint c = geometry.projector->project_to_face(face, p, ka || kb ? &guess : nullptr);
  point = c.point;
  return {2, face, c.uv};
}

}  // namespace hexfeature
