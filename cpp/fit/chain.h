// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include <vector>

#include "base/types.h"
#include "mesh/geometry.h"
#include "mesh/hex_complex.h"
#include "mesh/surface_mesh.h"
#include "shape/feature_shape.h"

namespace hexfeature {

/// A place along a chain where a node should come to lie, however few intervals there are.
struct Stop {
  int vertex = 0;       ///< index into Chain::vertices
  int importance = 0;   ///< 3 hard CAD vertex, 2 a sharp CAD edge begins, ends or branches off, 1 a tangent one
  int node = -1;        ///< index into Chain::nodes once it has one
  bool pinned = false;  ///< `node` was chosen from outside (a routed curve ends there) and must be kept
};

/// A line on the part and the lattice nodes that follow it: an arc of the feature shape, or a CAD edge routed inside a
/// chart. Left of the mesh line is left of the node path.
struct Chain {
  int arc = -1;  ///< of the feature shape; -1: routed
  std::vector<int> vertices;
  std::vector<int> halfedges;  ///< vertices[i] -> vertices[i + 1]
  std::vector<double> s;       ///< arc length at each vertex
  std::vector<int> nodes;      ///< of the complex; closed: first == last
  std::vector<double> node_s;  ///< arc length at each node
  std::vector<Stop> stops;     ///< in order of vertex
  double first = 0, last = 0;  ///< arc length of the first and last node: a snapped corner stands inside the polyline

  double length() const { return s.back(); }
  int intervals() const { return static_cast<int>(nodes.size()) - 1; }
  bool closed() const { return vertices.front() == vertices.back(); }
  /// Index i with s[i] <= x <= s[i + 1].
  int segment_at(double x) const;
  /// Lattice position (real) at arc length x: linear between the nodes on either side. What a snapped corner cut off keeps a
  /// little of the first interval, so that no triangle of a map collapses.
  Vec3 lattice_at(double x, const std::vector<Vec3>& lattice) const;
};

/// CAD edge that a mesh halfedge follows, 0 for none, a seam or a pole.
int followed_edge(const SurfaceMesh& mesh, const Geometry& geometry, int halfedge);

/// One chain per arc with its nodes in order (start to end), arc lengths and stops; not yet spaced.
/// Throws MeshingError(NoMesh, "fit") when the lattice does not have the arc's nodes.
std::vector<Chain> make_arc_chains(const HexComplex& complex, const SurfaceMesh& mesh, const FeatureShape& shape, const Geometry& geometry);

/// Arc lengths and the stops of a polyline that follows mesh halfedges.
void measure(Chain& chain, const SurfaceMesh& mesh, const Geometry& geometry);

/// Place the nodes along the chain by arc length with stops (experiments B4): every piece between stops gets one interval, then
/// the piece with the greatest length per interval gets the next. When there are fewer intervals than pieces, the least important
/// stops are dropped. Pinned stops keep their node.
void space_nodes(Chain& chain);

/// Hard CAD vertices within `reach` along an arc end attract the corner there: per corner, the mesh vertex to move to, or -1.
/// Each vertex serves one corner; an arc keeps a positive length. Sets the chains' `first` and `last`.
std::vector<int> snap_corners(std::vector<Chain>& chains, const SurfaceMesh& mesh, const FeatureShape& shape, const Geometry& geometry,
                              double reach);

/// CAD place and position of the point at arc length x of the chain.
CadPlace place_on_chain(const Chain& chain, double x, const SurfaceMesh& mesh, const Geometry& geometry, Vec3& point);
/// CAD place and position of a mesh vertex (a vertex on a seam or a pole slides on its face).
CadPlace place_of_vertex(int vertex, int halfedge_nearby, const SurfaceMesh& mesh, const Geometry& geometry, Vec3& point);

}  // namespace hexfeature
