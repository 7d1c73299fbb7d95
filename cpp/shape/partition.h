// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include <vector>

#include "mesh/surface_mesh.h"

namespace hexfeature {

/// A surface mesh cut into parts (sites or charts): the cells, edges and nodes of that cutting, a B-rep.
///
/// A *node* is a mesh point where three or more border halfedges leave. An *edge* is a chain of mesh edges between
/// two parts, from node to node (or closed, without nodes). A *dart* is an edge with a direction:
/// dart 2e runs start -> end with part `left` on its left, dart 2e+1 runs end -> start with `right` on its left
/// (left: seen from outside the solid).
struct Partition {
  struct Edge {
    int left = -1, right = -1;   ///< parts
    int start = -1, end = -1;    ///< nodes; -1 when closed without a node
    std::vector<int> vertices;   ///< mesh points from start to end; closed: first == last
    std::vector<int> halfedges;  ///< of the left part's triangles, in order
  };
  struct Node {
    int vertex = -1;         ///< mesh point
    std::vector<int> darts;  ///< outgoing darts, counter-clockwise seen from outside
  };
  struct Part {
    std::vector<int> triangles;
    std::vector<std::vector<int>> loops;  ///< darts with this part on the left; each loop in order
  };
  std::vector<int> triangle_part;  ///< per triangle, 0-based
  std::vector<Part> parts;
  std::vector<Edge> edges;
  std::vector<Node> nodes;

  int left_of(int dart) const { return dart % 2 == 0 ? edges[dart / 2].left : edges[dart / 2].right; }
  int right_of(int dart) const { return left_of(dart ^ 1); }
  int start_of(int dart) const { return dart % 2 == 0 ? edges[dart / 2].start : edges[dart / 2].end; }
  int end_of(int dart) const { return start_of(dart ^ 1); }
};

/// Build the B-rep of a cutting. `triangle_part` holds 0-based part numbers, each part connected or not.
/// Deterministic: edges in order of their first halfedge.
Partition make_partition(const SurfaceMesh& mesh, const std::vector<int>& triangle_part);

/// Number the connected components of equal value (over triangle adjacency), in order of first triangle.
/// With `barrier_edges`, no component crosses a halfedge for which it is true (may be empty).
std::vector<int> connected_components(const SurfaceMesh& mesh, const std::vector<int>& value,
                                      const std::vector<char>& barrier_halfedge = {});

}  // namespace hexfeature
