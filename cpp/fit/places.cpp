// HexFeatureWB - LGPL-2.1-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "base/error.h"
#include "fit/boundary_fit.h"
#include "fit/untangle2d.h"

namespace hexfeature {

void BoundaryFit::finish() {
  for (int r = 0; r < static_cast<int>(regions.size()); ++r) {
    update(r);
    context.progress("fit", 0.5 + 0.3 * (r + 1) / static_cast<double>(regions.size()));
  }
  place_nodes();
  assign_faces();
  collect_feature_edges();
  cover_narrow_faces();
  require_own_vertices();
}

void BoundaryFit::place_nodes() {
  complex.place.assign(complex.point_count(), CadPlace{});
  std::vector<char> done(complex.point_count(), 0);
  for (const Chain& chain : chains)
    for (int i = 0; i <= chain.intervals(); ++i) {
      const int n = chain.nodes[i];
      if (done[n]) continue;
      done[n] = 1;
      complex.place[n] = place_on_chain(chain, chain.node_s[i], mesh, geometry, complex.points[n]);
    }
  for (int n = 0; n < complex.point_count(); ++n) {
    const ShapePlace& p = complex.shape_place[n];
    if (p.dim != 0 || corner_target[p.item] < 0) continue;
    const int v = corner_target[p.item];
    complex.place[n] = mesh.place[v];
    complex.points[n] = mesh.points[v];
  }
  for (const Region& region : regions) {
    context.check();
    for (int q : region.quads)
      for (int n : complex.quads[q]) {
        if (done[n]) continue;
        done[n] = 1;
        const RegionMap::Location where = region.map.locate(flatten(region.chart, lattice[n]));
        const Vec3 p = region.map.point_at(where);
        const int t = region.map.source[where.triangle], face = mesh.triangle_face[t];
        const Vec2* guess = nullptr;
        double nearest = 1e300;
        for (int v : mesh.triangles[t]) {
          const double d = (mesh.points[v] - p).squaredNorm();
          if (mesh.place[v].dim != 2 || mesh.place[v].entity != face || d >= nearest) continue;
          nearest = d;
          guess = &mesh.place[v].uv;
        }
        const FacePoint f = geometry.projector->project_to_face(face, p, guess);
        complex.points[n] = f.point;
        complex.place[n] = {2, face, f.uv};
      }
  }
}

bool BoundaryFit::lies_on(int node, int edge) const {
  const CadPlace& p = complex.place[node];
  if (p.dim == 1) return p.entity == edge;
  const auto& ends = geometry.edge(edge).vertices;
  return p.dim == 0 && (p.entity == ends[0] || p.entity == ends[1]);
}

bool BoundaryFit::lies_beyond_soft_end(int node, int edge) const {
  const CadPlace& p = complex.place[node];
  if (p.dim != 1) return false;
  const auto &ends = geometry.edge(edge).vertices, &others = geometry.edge(p.entity).vertices;
  return std::any_of(ends.begin(), ends.end(),
                     [&](int v) { return v > 0 && !geometry.vertex(v).hard && (v == others[0] || v == others[1]); });
}

void BoundaryFit::require_own_vertices() const {
  std::vector<int> holder(geometry.vertices->size() + 1, -1);
  for (int n = 0; n < complex.point_count(); ++n) {
    if (complex.place[n].dim != 0 || complex.place[n].entity <= 0) continue;
    const int vertex = complex.place[n].entity;
    if (holder[vertex] >= 0) {
      std::vector<int> faces;
      for (std::size_t q = 0; q < complex.quads.size(); ++q)
        for (int v : complex.quads[q])
          if (v == n || v == holder[vertex]) faces.push_back(complex.quad_face[q]);
      std::sort(faces.begin(), faces.end());
      faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
      throw MeshingError(Failure::NoMesh, "fit", "two mesh points would stand on CAD vertex " + std::to_string(vertex),
                         "try another element size", faces);
    }
    holder[vertex] = n;
  }
}

void BoundaryFit::assign_faces() {
  complex.quad_face.assign(complex.quads.size(), 0);
  for (const Region& region : regions) {
    const int first = mesh.triangle_face[region.triangles.front()];
    const bool one_face =
        std::all_of(region.triangles.begin(), region.triangles.end(), [&](int t) { return mesh.triangle_face[t] == first; });
    for (int q : region.quads) {
      if (one_face) {
        complex.quad_face[q] = first;
        continue;
      }
      // Several faces: that of the quad's sliding nodes when they agree, else the one at its middle.
      Vec3 centre = Vec3::Zero();
      int face = 0;
      bool agree = true;
      for (int n : complex.quads[q]) {
        centre += 0.25 * lattice[n];
        if (complex.place[n].dim != 2) continue;
        agree = agree && (face == 0 || face == complex.place[n].entity);
        face = complex.place[n].entity;
      }
      if (face == 0 || !agree) face = mesh.triangle_face[region.map.source[region.map.locate(flatten(region.chart, centre)).triangle]];
      complex.quad_face[q] = face;
    }
  }
  // A quad with a side on a sharp CAD edge lies on the face that the edge has on that side, wherever its other nodes ended up:
  // beside a tangent edge that no mesh edge follows they may well be on the next face. Where two sides disagree, the above stands.
  std::vector<int> beside(complex.quads.size(), 0);
  for (const Chain& chain : chains)
    for (int i = 0; i < chain.intervals(); ++i) {
      const int h = chain.halfedges[chain.segment_at(0.5 * (chain.node_s[i] + chain.node_s[i + 1]))];
      const int e = followed_edge(mesh, geometry, h), a = chain.nodes[i], b = chain.nodes[i + 1];
      if (e <= 0 || !geometry.edge(e).sharp || !lies_on(a, e) || !lies_on(b, e)) continue;
      for (const auto& [g, t] : {std::make_pair(net.find(a, b), h / 3), std::make_pair(net.find(b, a), mesh.opposite[h] / 3)}) {
        if (g < 0) continue;
        int& face = beside[g / 4];
        face = face == 0 || face == mesh.triangle_face[t] ? mesh.triangle_face[t] : -1;
      }
    }
  for (std::size_t q = 0; q < beside.size(); ++q)
    if (beside[q] > 0) complex.quad_face[q] = beside[q];
}

void BoundaryFit::cover_narrow_faces() {
  std::vector<char> covered(geometry.faces->size() + 1, 0);
  for (int f : complex.quad_face) covered[f] = 1;
  // Halfedges of quads that must keep their face: they lie along a sharp edge of it.
  std::vector<char> keep(complex.quads.size(), 0);
  for (std::size_t e = 0; e < complex.feature_edges.size(); ++e) {
    if (!geometry.edge(complex.feature_edge_cad[e]).sharp) continue;
    const auto& n = complex.feature_edges[e];
    for (int g : {net.find(n[0], n[1]), net.find(n[1], n[0])})
      if (g >= 0) keep[g / 4] = 1;
  }
  std::vector<double> share(complex.quads.size(), 0);
  for (const Region& region : regions) {
    std::vector<int> faces;
    for (int t : region.triangles)
      if (!covered[mesh.triangle_face[t]]) faces.push_back(mesh.triangle_face[t]);
    std::sort(faces.begin(), faces.end());
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    if (faces.empty()) continue;
    // The region's quads by their least corner in the lattice plane.
    std::map<std::array<int, 2>, int> quad_at;
    for (int q : region.quads) {
      Vec2 low = Vec2::Constant(1e300);
      for (int n : complex.quads[q]) low = low.cwiseMin(flatten(region.chart, lattice[n]));
      quad_at[{static_cast<int>(std::lround(low.x())), static_cast<int>(std::lround(low.y()))}] = q;
    }
    for (int f : faces) {
      double largest = 0;
      std::vector<int> touched;
      for (std::size_t t = 0; t < region.map.triangles.size(); ++t) {
        if (mesh.triangle_face[region.map.source[t]] != f) continue;
        const auto& v = region.map.triangles[t];
        const Vec2 &a = region.map.flat[v[0]], &b = region.map.flat[v[1]], &c = region.map.flat[v[2]];
        const Vec2 centre = (a + b + c) / 3;
        const auto at = quad_at.find({static_cast<int>(std::floor(centre.x())), static_cast<int>(std::floor(centre.y()))});
        if (at == quad_at.end() || keep[at->second]) continue;
        if (share[at->second] == 0) touched.push_back(at->second);
        share[at->second] += std::abs(cross2(b - a, c - a));
        largest = std::max(largest, share[at->second]);
      }
      for (int q : touched) {
        if (share[q] > 0.5 * largest) complex.quad_face[q] = f;
        share[q] = 0;
      }
    }
  }
}

void BoundaryFit::collect_feature_edges() {
  std::vector<std::array<int, 3>> found;
  for (const Chain& chain : chains)
    for (int i = 0; i < chain.intervals(); ++i) {
      // The CAD edge under the middle of the interval. A soft vertex, which parts a circle only by name, may lie between its ends.
      const int h = chain.halfedges[chain.segment_at(0.5 * (chain.node_s[i] + chain.node_s[i + 1]))];
      const int e = followed_edge(mesh, geometry, h), a = chain.nodes[i], b = chain.nodes[i + 1];
      if (e <= 0) continue;
      const bool own_a = lies_on(a, e), own_b = lies_on(b, e);
      if ((own_a && own_b) || (own_a && lies_beyond_soft_end(b, e)) || (own_b && lies_beyond_soft_end(a, e)))
        found.push_back({std::min(a, b), std::max(a, b), e});
    }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  complex.feature_edges.clear();
  complex.feature_edge_cad.clear();
  for (const auto& f : found) {
    complex.feature_edges.push_back({f[0], f[1]});
    complex.feature_edge_cad.push_back(f[2]);
  }
}

}  // namespace hexfeature
