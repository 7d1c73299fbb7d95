// HexFeatureWB - LGPL-2.1-or-later
#include "label/macro_graph.h"

#include <algorithm>
#include <cmath>

namespace hexfeature {
namespace {

constexpr double kDegree = EIGEN_PI / 180;
constexpr double kTangent = 20 * kDegree, kBlunt = 40 * kDegree, kBent = 50 * kDegree;
// At 70 degrees sharp edges got lost; at 60 a hexagonal hole, which must merge two of its walls, failed.
constexpr double kCrease = 63 * kDegree;

void add_sites(const Regions& regions, const Partition& partition, double size, const MacroGraph* parent, int changed, MacroGraph& graph) {
  const SurfaceMesh& mesh = regions.mesh;
  const int sites = static_cast<int>(partition.parts.size());
  graph.area.assign(sites, 0);
  graph.face = regions.site_face;
  graph.low.assign(sites, Vec3::Constant(1e300));
  graph.high.assign(sites, Vec3::Constant(-1e300));
  graph.tilt.assign(sites, 0);
  graph.cosine.assign(sites, {});
  graph.fidelity.assign(sites, {});
  graph.defect.assign(sites, {});
  const auto known = [&](int s) { return parent && s < parent->site_count() && s != changed; };
  for (int s = 0; s < sites; ++s) {
    if (known(s)) {
      graph.area[s] = parent->area[s];
      graph.low[s] = parent->low[s];
      graph.high[s] = parent->high[s];
      graph.tilt[s] = parent->tilt[s];
      graph.cosine[s] = parent->cosine[s];
      graph.fidelity[s] = parent->fidelity[s];
      graph.defect[s] = parent->defect[s];
      continue;
    }
    for (int t : partition.parts[s].triangles) {
      const double area = mesh.area(t);
      const Vec3 n = mesh.mean_normal(t);
      graph.area[s] += area;
      graph.tilt[s] += area * (1 - n.cwiseAbs().maxCoeff());
      for (Label l = 0; l < 6; ++l) {
        const double c = sign_of(l) * n[axis_of(l)];
        graph.cosine[s][l] += area * c;
        graph.fidelity[s][l] += area * (1 - c + 2 * std::max(0.0, 0.1 - c));
      }
      for (int v : mesh.triangles[t]) {
        graph.low[s] = graph.low[s].cwiseMin(mesh.points[v]);
        graph.high[s] = graph.high[s].cwiseMax(mesh.points[v]);
      }
    }
    graph.total_area += graph.area[s];
  }
  const double h2 = size * size;
  // Shares of one total, the parent's: a cut hardly changes it, and energies must compare between cuttings.
  if (parent) graph.total_area = parent->total_area;
  for (int s = 0; s < sites; ++s) {
    if (known(s)) continue;
    const double area = std::max(graph.area[s], 1e-300);
    graph.tilt[s] /= area * (1 - 1 / std::sqrt(3.0));
    for (Label l = 0; l < 6; ++l) {
      graph.cosine[s][l] /= area;
      graph.fidelity[s][l] /= graph.total_area;
      const double short_of = (0.17 - graph.cosine[s][l]) / 0.17;
      if (short_of > 0) graph.defect[s][l] = 0.6 * std::min(1.0, 0.25 + area / h2) * std::min(1.5, short_of);
    }
  }
}

void add_edges(const SurfaceMesh& mesh, const Partition& partition, double size, MacroGraph& graph) {
  for (const auto& chain : partition.edges) {
    MacroGraph::Edge e;
    e.left = chain.left;
    e.right = chain.right;
    e.start = chain.start;
    e.end = chain.end;
    e.first = mesh.points[chain.vertices.front()];
    for (int v : chain.vertices) {
      e.displacement = mesh.points[v] - e.first;
      e.low = e.low.cwiseMin(e.displacement);
      e.high = e.high.cwiseMax(e.displacement);
      e.fall = e.fall.cwiseMax(e.high - e.displacement);
      e.rise = e.rise.cwiseMax(e.displacement - e.low);
    }
    const double l = std::min(size, std::sqrt(std::min(graph.area[e.left], graph.area[e.right])));
    const double unit = l / graph.total_area;
    double merged = 0;  // length over which equal labels would flatten a sharp edge
    for (int h : chain.halfedges) {
      const double length = (mesh.points[mesh.to(h)] - mesh.points[mesh.from(h)]).norm();
      const double dihedral = mesh.dihedral(h), angle = std::abs(dihedral);
      e.length += length;
      e.dihedral += length * dihedral;
      e.differ += 0.5 * length * unit * (angle < kTangent ? 1.0 : angle < kBent ? 0.4 : 0.1);
      e.same += length * unit * (angle > kCrease ? 3.0 : angle > kBlunt ? 0.3 : 0.0);
      if (angle > kCrease) merged += length;
      if (angle > kTangent) e.lost += 0.3 * length * unit;
    }
    e.opposed = 4 * e.length * unit;
    if (e.length > 0) e.dihedral /= e.length;
    if (merged > 0.3 * e.length) e.same_defect = 0.4 * std::min(1.0, 0.3 + merged / size);
    graph.edges.push_back(e);
  }
}

}  // namespace

MacroGraph make_macro_graph(const Regions& regions, const Partition& partition, double size, const MacroGraph* parent, int changed) {
  MacroGraph graph;
  add_sites(regions, partition, size, parent, changed, graph);
  add_edges(regions.mesh, partition, size, graph);

  graph.node_first.push_back(0);
  for (const auto& node : partition.nodes) {
    graph.node_darts.insert(graph.node_darts.end(), node.darts.begin(), node.darts.end());
    graph.node_first.push_back(static_cast<int>(graph.node_darts.size()));
  }
  graph.site_first.assign(graph.site_count() + 1, 0);
  for (const auto& e : graph.edges) {
    ++graph.site_first[e.left + 1];
    ++graph.site_first[e.right + 1];
  }
  for (int s = 0; s < graph.site_count(); ++s) graph.site_first[s + 1] += graph.site_first[s];
  graph.site_darts.resize(2 * graph.edges.size());
  std::vector<int> fill(graph.site_first.begin(), graph.site_first.end() - 1);
  for (int d = 0; d < 2 * graph.edge_count(); ++d) graph.site_darts[fill[graph.left_of(d)]++] = d;
  return graph;
}

}  // namespace hexfeature
