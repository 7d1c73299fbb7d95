// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include <vector>

#include "base/context.h"
#include "mesh/geometry.h"
#include "mesh/hex_complex.h"
#include "mesh/surface_mesh.h"

namespace hexfeature {

/// What a mesh kept of the CAD model's faces, sharp edges and corners.
struct Faithfulness {
  std::vector<int> faces_without_quads;  ///< 1-based CAD faces of the solid
  std::vector<int> faces_not_covered;    ///< ... parts of which are farther than half an element from the face's own quads
  std::vector<int>
      sharp_edges_not_followed;       ///< 1-based sharp CAD edges, a tenth or more of which has no mesh edge between its faces near it
  std::vector<int> sharp_edges_lost;  ///< of these, the ones half an element long or more, most of which has none
  std::vector<int> corners_lost;      ///< 1-based CAD vertices where three or more sharp edges meet, without a node
  double lost_length = 0;             ///< share of the sharp edges' length that no mesh edge follows, 0..1
  double uncovered = 0;               ///< how badly the faces not covered are: 0.1 to 1 for each, 1 for a gap of 0.75 h
  double largest_gap = 0;             ///< longest distance from a point of a CAD face to the face's own quads
  /// Nothing lost but a hundredth of the sharp edges, and no whole one (tips that no element can follow).
  bool complete() const { return faces_without_quads.empty() && faces_not_covered.empty() && edges_kept() && corners_lost.empty(); }
  bool edges_kept() const { return lost_length <= 0.01 && sharp_edges_lost.empty(); }
};

/// `surface` is the solid's surface mesh (the CAD, sampled), in the coordinates of `mesh`; null: gaps are not measured.
/// `solid`: 1-based, or 0 for all solids. `size` is the element size h.
Faithfulness measure_faithfulness(const HexComplex& mesh, const Geometry& geometry, int solid, const SurfaceMesh* surface, double size,
                                  const Context& context);

/// The sharp edges that have no mesh edges of their own in a fitted mesh.
struct EdgesLeftOut {
  std::vector<int> edges;  ///< 1-based CAD edges
  double share = 0;        ///< of the sharp edges' length, 0..1
};
EdgesLeftOut sharp_edges_left_out(const HexComplex& mesh, const Geometry& geometry, int solid);

}  // namespace hexfeature
