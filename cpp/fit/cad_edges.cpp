// HexFeatureWB - LGPL-2.1-or-later
#include "fit/cad_edges.h"

#include <algorithm>

namespace hexfeature {

void BoundaryFit::route_cad_edges() {
  const std::vector<InnerCurve> curves = collect_inner_curves(*this);
  std::vector<int> node_of_vertex(mesh.point_count(), -1);
  for (int n = 0; n < complex.point_count(); ++n) {
    const ShapePlace& p = complex.shape_place[n];
    if (p.dim != 0) continue;
    node_of_vertex[shape.cells.nodes[p.item].vertex] = n;
    if (corner_target[p.item] >= 0) node_of_vertex[corner_target[p.item]] = n;
  }
  // Pin the stop of `node` on the chain that `vertex` lies inside; returns that chain, -1 when there is none.
  const auto pin = [&](int h, int node) {
    int g = h;
    do {
      const int c = border_of[g];
      if (c >= 0) {
        for (Stop& stop : chains[c].stops) {
          if (stop.vertex != border_index[g]) continue;
          const auto at = std::find(chains[c].nodes.begin(), chains[c].nodes.end(), node);
          if (at == chains[c].nodes.begin() || at == chains[c].nodes.end()) return -1;
          stop.node = static_cast<int>(at - chains[c].nodes.begin());
          stop.pinned = true;
          return c;
        }
        return -1;
      }
      g = mesh.opposite[SurfaceMesh::prev(g)];
    } while (g != h);
    return -1;
  };

  for (std::size_t k = 0; k < curves.size(); ++k) {
    const InnerCurve& curve = curves[k];
    context.progress("fit", 0.1 + 0.4 * static_cast<double>(k) / static_cast<double>(curves.size()));
    const int region = region_of_triangle[curve.halfedges.front() / 3];
    update(region);
    Chain chain;
    const bool loop = curve.closed();
    Route route = loop ? Route{route_closed_curve(*this, region, curve), false} : route_open_curve(*this, region, curve, node_of_vertex);
    chain.nodes = std::move(route.nodes);
    if (chain.nodes.size() < 2) continue;
    chain.vertices = curve.vertices;
    chain.halfedges = curve.halfedges;
    measure(chain, mesh, geometry);

    const int first_h = curve.halfedges.front(), last_h = mesh.opposite[curve.halfedges.back()];
    std::array<int, 2> changed{-1, -1};
    std::array<std::vector<Stop>, 2> saved;
    for (int side = 0; side < 2 && !loop; ++side) {
      const int h = side == 0 ? first_h : last_h, node = side == 0 ? chain.nodes.front() : chain.nodes.back();
      if (node_of_vertex[mesh.from(h)] >= 0) continue;
      // Saved first: both ends may lie on one chain.
      int g = h, c = -1;
      do {
        c = std::max(c, border_of[g]);
        g = mesh.opposite[SurfaceMesh::prev(g)];
      } while (g != h);
      if (c >= 0) saved[side] = chains[c].stops;
      changed[side] = pin(h, node);
    }
    const int index = static_cast<int>(chains.size());
    chains.push_back(std::move(chain));
    chain_lattice.emplace_back();
    attach(index);
    for (int c : changed)
      if (c >= 0) space(c);
    space(index);
    bool ok = true;
    for (int side = 0; side < 2; ++side)
      if (changed[side] >= 0)
        for (const Stop& stop : chains[changed[side]].stops) ok = ok && (!stop.pinned || stop.node >= 0);
    const Region before = regions[region];
    const int region_count = static_cast<int>(regions.size());
    ok = ok && split(region, index);
    const char* why = "part and lattice would be cut differently";
    if (ok) {
      // A cut that the maps cannot follow was the wrong one.
      update(region);
      int folded = regions[region].map.folded;
      for (int r = region_count; r < static_cast<int>(regions.size()); ++r) {
        update(r);
        folded += regions[r].map.folded;
      }
      if (folded > before.map.folded + 2) {
        ok = false;
        why = "the maps on its sides would fold";
        regions[region] = before;
        regions[region].dirty = true;
        regions.resize(region_count);
        for (int t : before.triangles) region_of_triangle[t] = region;
        for (int q : before.quads) region_of_quad[q] = region;
      }
    }
    if (!ok) {
      report_given_up(*this, curve, why);
      detach(index);
      chains.pop_back();
      chain_lattice.pop_back();
      for (int side : {1, 0})
        if (changed[side] >= 0) {
          chains[changed[side]].stops = saved[side];
          space(changed[side]);
        }
      continue;
    }
    freely_turned += route.free_turns;
    if (loop) continue;
    node_of_vertex[curve.vertices.front()] = chains[index].nodes.front();
    node_of_vertex[curve.vertices.back()] = chains[index].nodes.back();
  }
  // The arcs' last spacing moves the ends of the routed chains along.
  for (int c = 0; c < static_cast<int>(chains.size()); ++c)
    if (chains[c].arc < 0) space(c);
}

}  // namespace hexfeature
