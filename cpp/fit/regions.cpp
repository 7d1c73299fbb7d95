// HexFeatureWB - LGPL-2.1-or-later
#include <algorithm>
#include <cmath>
#include <string>

#include "base/error.h"
#include "fit/boundary_fit.h"

namespace hexfeature {

BoundaryFit::BoundaryFit(HexComplex& complex_, const SurfaceMesh& mesh_, const FeatureShape& shape_, const Geometry& geometry_,
                         const FitOptions& options_, Context& context_)
    : complex(complex_), mesh(mesh_), shape(shape_), geometry(geometry_), options(options_), context(context_) {}

Vec2 BoundaryFit::flatten(int chart, const Vec3& p) const {
  const Label label = shape.charts[chart].label;
  const int a = axis_of(label), b = (a + 1) % 3, c = (a + 2) % 3;
  return sign_of(label) > 0 ? Vec2(p[b], p[c]) : Vec2(p[c], p[b]);
}

void BoundaryFit::start() {
  lattice = complex.points;
  net = make_quad_net(complex.quads, complex.point_count());
  border_of.assign(3 * mesh.triangle_count(), -1);
  border_index.assign(3 * mesh.triangle_count(), -1);
  quad_cut.assign(4 * complex.quads.size(), 0);
  node_taken.assign(complex.point_count(), 0);
  corner_flat.assign(3 * mesh.triangle_count(), Vec2::Zero());

  regions.resize(shape.chart_count());
  region_of_triangle = shape.cells.triangle_part;
  region_of_quad = complex.quad_chart;
  for (int c = 0; c < shape.chart_count(); ++c) {
    regions[c].chart = c;
    regions[c].triangles = shape.cells.parts[c].triangles;
  }
  for (int q = 0; q < static_cast<int>(complex.quads.size()); ++q) regions[complex.quad_chart[q]].quads.push_back(q);

  chains = make_arc_chains(complex, mesh, shape, geometry);
  chain_lattice.resize(chains.size());
  corner_target = snap_corners(chains, mesh, shape, geometry, options.corner_snap * options.size);
  for (int c = 0; c < static_cast<int>(chains.size()); ++c) {
    attach(c);
    space(c);
  }
}

void BoundaryFit::space(int index) {
  Chain& chain = chains[index];
  space_nodes(chain);
  std::vector<Vec3>& at = chain_lattice[index];
  at.resize(chain.vertices.size());
  for (std::size_t i = 0; i < at.size(); ++i) at[i] = chain.lattice_at(chain.s[i], lattice);
  for (int h : chain.halfedges) {
    regions[region_of_triangle[h / 3]].dirty = true;
    regions[region_of_triangle[mesh.opposite[h] / 3]].dirty = true;
  }
  if (chain.arc >= 0) return;
  // Its ends lie on other chains, maybe between two of their nodes (a snapped corner): meet them there.
  for (std::size_t end : {std::size_t(0), at.size() - 1}) {
    const int h = end == 0 ? chain.halfedges.front() : mesh.opposite[chain.halfedges.back()];
    for (int g = mesh.opposite[SurfaceMesh::prev(h)]; g != h; g = mesh.opposite[SurfaceMesh::prev(g)])
      if (border_of[g] >= 0 && border_of[g] < index) {
        at[end] = chain_lattice[border_of[g]][border_index[g]];
        break;
      }
  }
}

void BoundaryFit::attach(int index) {
  const Chain& chain = chains[index];
  for (int i = 0; i < static_cast<int>(chain.halfedges.size()); ++i) {
    const int h = chain.halfedges[i], o = mesh.opposite[h];
    border_of[h] = border_of[o] = index;
    border_index[h] = i;
    border_index[o] = i + 1;
  }
  for (int i = 0; i < chain.intervals(); ++i) {
    const int g = net.find(chain.nodes[i], chain.nodes[i + 1]);
    if (g < 0) throw MeshingError(Failure::NoMesh, "fit", "a feature line is not followed by the lattice", "try another element size");
    quad_cut[g] = 1;
    if (net.opposite[g] >= 0) quad_cut[net.opposite[g]] = 1;
  }
  for (int n : chain.nodes) ++node_taken[n];
}

void BoundaryFit::detach(int index) {
  const Chain& chain = chains[index];
  for (int h : chain.halfedges) border_of[h] = border_of[mesh.opposite[h]] = -1;
  for (int i = 0; i < chain.intervals(); ++i) {
    const int g = net.find(chain.nodes[i], chain.nodes[i + 1]);
    quad_cut[g] = 0;
    if (net.opposite[g] >= 0) quad_cut[net.opposite[g]] = 0;
  }
  for (int n : chain.nodes) --node_taken[n];
}

void BoundaryFit::update(int index) {
  Region& region = regions[index];
  if (!region.dirty) return;
  context.check();
  region.map = map_region(
      mesh, region.triangles, border_of, [&](int h) { return flatten(region.chart, chain_lattice[border_of[h]][border_index[h]]); },
      corner_flat, context);
  region.dirty = false;
  if (region.map.folded > 0)
    context.log("fit: the map of chart " + std::to_string(region.chart) + " keeps " + std::to_string(region.map.folded) +
                " folded triangles");
}

bool BoundaryFit::split(int index, int chain_index) {
  // Components of the region's triangles and quads, now that the chain cuts.
  const int none = -1;
  std::vector<int> stack;
  std::vector<int> triangle_part(mesh.triangle_count(), none), quad_part(complex.quads.size(), none);
  int triangle_parts = 0, quad_parts = 0;
  for (int seed : regions[index].triangles) {
    if (triangle_part[seed] >= 0) continue;
    triangle_part[seed] = triangle_parts;
    stack.assign(1, seed);
    while (!stack.empty()) {
      const int t = stack.back();
      stack.pop_back();
      for (int h = 3 * t; h < 3 * t + 3; ++h) {
        const int u = mesh.opposite[h] / 3;
        if (border_of[h] >= 0 || triangle_part[u] >= 0) continue;
        triangle_part[u] = triangle_parts;
        stack.push_back(u);
      }
    }
    ++triangle_parts;
  }
  for (int seed : regions[index].quads) {
    if (quad_part[seed] >= 0) continue;
    quad_part[seed] = quad_parts;
    stack.assign(1, seed);
    while (!stack.empty()) {
      const int q = stack.back();
      stack.pop_back();
      for (int g = 4 * q; g < 4 * q + 4; ++g) {
        const int o = net.opposite[g];
        if (quad_cut[g] || o < 0 || quad_part[o / 4] >= 0) continue;
        quad_part[o / 4] = quad_parts;
        stack.push_back(o / 4);
      }
    }
    ++quad_parts;
  }
  if (triangle_parts != quad_parts) return false;

  // Every interval of every chain round the region must have the same part on the lattice and on the mesh.
  std::vector<int> match(quad_parts, none);
  std::vector<int> border_chains{chain_index};
  for (int t : regions[index].triangles)
    for (int h = 3 * t; h < 3 * t + 3; ++h)
      if (border_of[h] >= 0) border_chains.push_back(border_of[h]);
  std::sort(border_chains.begin(), border_chains.end());
  border_chains.erase(std::unique(border_chains.begin(), border_chains.end()), border_chains.end());
  for (int c : border_chains) {
    const Chain& border = chains[c];
    for (int i = 0; i < border.intervals(); ++i) {
      const int h = border.halfedges[border.segment_at(0.5 * (border.node_s[i] + border.node_s[i + 1]))];
      const int g = net.find(border.nodes[i], border.nodes[i + 1]);
      for (int side = 0; side < 2; ++side) {
        const int gs = side == 0 ? g : net.opposite[g], hs = side == 0 ? h : mesh.opposite[h];
        const int q = gs < 0 ? none : quad_part[gs / 4], t = triangle_part[hs / 3];
        if (q == none && t == none) continue;
        if (q == none || t == none || (match[q] != none && match[q] != t)) return false;
        match[q] = t;
      }
    }
  }
  std::vector<char> used(triangle_parts, 0);
  for (int t : match) {
    if (t == none || used[t]) return false;
    used[t] = 1;
  }

  std::vector<int> region_of_part(triangle_parts);
  for (int p = 0; p < triangle_parts; ++p) {
    region_of_part[p] = p == 0 ? index : static_cast<int>(regions.size());
    if (p > 0) regions.emplace_back();
    regions[region_of_part[p]].chart = regions[index].chart;
  }
  const std::vector<int> triangles = std::move(regions[index].triangles), quads = std::move(regions[index].quads);
  regions[index].triangles.clear();
  regions[index].quads.clear();
  for (int t : triangles) {
    region_of_triangle[t] = region_of_part[triangle_part[t]];
    regions[region_of_triangle[t]].triangles.push_back(t);
  }
  for (int q : quads) {
    region_of_quad[q] = region_of_part[match[quad_part[q]]];
    regions[region_of_quad[q]].quads.push_back(q);
  }
  for (int r : region_of_part) regions[r].dirty = true;
  return true;
}

}  // namespace hexfeature
