// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include <array>
#include <vector>

#include "base/context.h"
#include "base/types.h"
#include "mesh/surface_mesh.h"

namespace hexfeature {

/// Where a node lies on the feature shape: corner (dim 0), arc (1), chart (2), inside (3); index of that item, -1 inside.
struct ShapePlace {
  int dim = 3;
  int item = -1;
};

/// An unstructured all-hexahedral complex with its boundary. Every method (lattice, sheets, grid,
/// tet-split) produces this one thing, and fit, smooth, quality and write know nothing of how it was made.
///
/// VTK node order of a hexahedron:      faces (outward):
///
///          7--------6                  0: 0 3 2 1   (bottom)
///         /|       /|                  1: 4 5 6 7   (top)
///        4--------5 |                  2: 0 1 5 4
///        | 3------|-2                  3: 1 2 6 5
///        |/       |/                   4: 2 3 7 6
///        0--------1                    5: 3 0 4 7
struct HexComplex {
  std::vector<Vec3> points;
  std::vector<std::array<int, 8>> hexes;  ///< VTK order, positive volume when valid
  std::vector<int> hex_solid;             ///< per hexahedron: 1-based CAD solid
  std::vector<int> hex_block;             ///< per hexahedron: coarse block (lattice cut at all chart coordinates); sheets add their own

  std::vector<std::array<int, 4>> quads;  ///< boundary, outward (counter-clockwise seen from outside)
  std::vector<int> quad_chart;            ///< per quad: chart of the feature shape, -1 when there is none
  std::vector<int> quad_face;             ///< per quad: 1-based CAD face, 0 = not yet known

  std::vector<ShapePlace> shape_place;  ///< per point; empty when the method has no feature shape
  std::vector<CadPlace> place;          ///< per point: the CAD entity that the node must lie on

  /// Mesh edges (pairs of points, smaller first, sorted) that follow a CAD edge, and that edge's 1-based number.
  std::vector<std::array<int, 2>> feature_edges;
  std::vector<int> feature_edge_cad;

  int point_count() const { return static_cast<int>(points.size()); }
  int hex_count() const { return static_cast<int>(hexes.size()); }
};

/// The boundary quads as triangles, two for each: 2q and 2q + 1 are those of quad q. Only points and triangles are set.
SurfaceMesh triangles_of_quads(const HexComplex& complex);

/// The six faces of a hexahedron, outward, as corner indices (drawing above).
inline constexpr std::array<std::array<int, 4>, 6> kHexFaces{
    {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}};
/// The twelve edges.
inline constexpr std::array<std::array<int, 2>, 12> kHexEdges{
    {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6}, {6, 7}, {7, 4}, {0, 4}, {1, 5}, {2, 6}, {3, 7}}};
/// Each corner and its three neighbours, right-handed: det(p1-p0, p2-p0, p3-p0) > 0 in a good element.
inline constexpr std::array<std::array<int, 4>, 8> kHexCorners{
    {{0, 1, 3, 4}, {1, 2, 0, 5}, {2, 3, 1, 6}, {3, 0, 2, 7}, {4, 7, 5, 0}, {5, 4, 6, 1}, {6, 5, 7, 2}, {7, 6, 4, 3}}};

/// The other side of every element face, as 6 * hex + local face.
struct FaceMates {
  static constexpr int kBoundary = -1;  ///< the face has one element
  static constexpr int kCrowded = -2;   ///< three or more elements, or a neighbour that lies on the same side or is twisted
  std::vector<int> mate;                ///< per 6 * hex + face
};
/// Requires node indices within range. Linear time: faces are bucketed by their smallest node.
FaceMates match_faces(const HexComplex& complex, const Context& context = {});

/// The four nodes of face 6 * hex + local face, outward.
inline std::array<int, 4> face_nodes(const HexComplex& complex, int face) {
  const auto& hex = complex.hexes[face / 6];
  const auto& local = kHexFaces[face % 6];
  return {hex[local[0]], hex[local[1]], hex[local[2]], hex[local[3]]};
}
/// Whether b runs through the nodes of a in the same (`step` 1) or the opposite (`step` 3) cyclic order.
bool same_cycle(const std::array<int, 4>& a, const std::array<int, 4>& b, int step);

/// Faces that no other element has: per face {hex, local face 0..5}, in (hex, face) order. Requires node indices within range.
std::vector<std::array<int, 2>> boundary_faces(const HexComplex& complex, const Context& context = {});

}  // namespace hexfeature
