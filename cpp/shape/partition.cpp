// HexFeatureWB - LGPL-2.1-or-later
#include "shape/partition.h"

#include <algorithm>

namespace hexfeature {

Partition make_partition(const SurfaceMesh& mesh, const std::vector<int>& triangle_part) {
  Partition result;
  result.triangle_part = triangle_part;
  const int triangles = mesh.triangle_count(), halfedges = 3 * triangles;
  int parts = 0;
  for (int p : triangle_part) parts = std::max(parts, p + 1);
  result.parts.resize(parts);
  for (int t = 0; t < triangles; ++t) result.parts[triangle_part[t]].triangles.push_back(t);

  const auto on_border = [&](int h) { return triangle_part[h / 3] != triangle_part[mesh.opposite[h] / 3]; };
  // The border halfedge that follows h round the same part: turn about h's end point, inside the part.
  const auto next_on_border = [&](int h) {
    int g = SurfaceMesh::next(h);
    while (!on_border(g)) g = SurfaceMesh::next(mesh.opposite[g]);
    return g;
  };

  // Outgoing border halfedges per point; a node is where their number is not two.
  std::vector<int> degree(mesh.point_count(), 0);
  for (int h = 0; h < halfedges; ++h)
    if (on_border(h)) ++degree[mesh.from(h)];
  std::vector<int> node_of(mesh.point_count(), -1);
  for (int v = 0; v < mesh.point_count(); ++v)
    if (degree[v] > 2) {
      node_of[v] = static_cast<int>(result.nodes.size());
      result.nodes.push_back({v, {}});
    }

  std::vector<int> dart_of(halfedges, -1);
  const auto trace = [&](int first) {
    Partition::Edge edge;
    edge.left = triangle_part[first / 3];
    edge.right = triangle_part[mesh.opposite[first] / 3];
    edge.start = node_of[mesh.from(first)];
    const int dart = 2 * static_cast<int>(result.edges.size());
    edge.vertices.push_back(mesh.from(first));
    int h = first;
    do {
      dart_of[h] = dart;
      dart_of[mesh.opposite[h]] = dart + 1;
      edge.vertices.push_back(mesh.to(h));
      edge.halfedges.push_back(h);
      if (node_of[mesh.to(h)] >= 0) break;
      h = next_on_border(h);
    } while (h != first);
    edge.end = node_of[edge.vertices.back()];
    result.edges.push_back(std::move(edge));
  };
  for (int h = 0; h < halfedges; ++h)
    if (dart_of[h] < 0 && on_border(h) && node_of[mesh.from(h)] >= 0) trace(h);
  for (int h = 0; h < halfedges; ++h)
    if (dart_of[h] < 0 && on_border(h)) trace(h);

  // Darts round each node, counter-clockwise: from an outgoing halfedge h turn to opposite(prev(h)).
  std::vector<char> seen(result.nodes.size(), 0);
  for (int h = 0; h < halfedges; ++h) {
    if (!on_border(h)) continue;
    const int node = node_of[mesh.from(h)];
    if (node < 0 || seen[node]) continue;
    seen[node] = 1;
    int g = h;
    do {
      if (on_border(g)) result.nodes[node].darts.push_back(dart_of[g]);
      g = mesh.opposite[SurfaceMesh::prev(g)];
    } while (g != h);
  }

  // Loops: each dart once, following the border round its left part.
  std::vector<char> used(2 * result.edges.size(), 0);
  const auto last_halfedge = [&](int dart) {
    const auto& e = result.edges[dart / 2];
    return dart % 2 == 0 ? e.halfedges.back() : mesh.opposite[e.halfedges.front()];
  };
  for (int d = 0; d < static_cast<int>(used.size()); ++d) {
    if (used[d]) continue;
    std::vector<int> loop;
    int e = d;
    do {
      used[e] = 1;
      loop.push_back(e);
      e = dart_of[next_on_border(last_halfedge(e))];
    } while (e != d);
    result.parts[result.left_of(d)].loops.push_back(std::move(loop));
  }
  return result;
}

std::vector<int> connected_components(const SurfaceMesh& mesh, const std::vector<int>& value, const std::vector<char>& barrier_halfedge) {
  std::vector<int> component(mesh.triangle_count(), -1);
  std::vector<int> stack;
  int count = 0;
  for (int seed = 0; seed < mesh.triangle_count(); ++seed) {
    if (component[seed] >= 0) continue;
    component[seed] = count;
    stack.push_back(seed);
    while (!stack.empty()) {
      const int t = stack.back();
      stack.pop_back();
      for (int k = 0; k < 3; ++k) {
        const int h = 3 * t + k;
        if (!barrier_halfedge.empty() && barrier_halfedge[h]) continue;
        const int u = mesh.opposite[h] / 3;
        if (component[u] >= 0 || value[u] != value[seed]) continue;
        component[u] = count;
        stack.push_back(u);
      }
    }
    ++count;
  }
  return component;
}

}  // namespace hexfeature
