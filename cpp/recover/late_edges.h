// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include <array>
#include <vector>

#include "base/context.h"
#include "mesh/geometry.h"
#include "mesh/hex_complex.h"
#include "mesh/surface_mesh.h"

namespace hexfeature {

/// Points of a mesh, one after the other along its edges, that could follow a CAD edge.
struct LateRun {
  int edge = 0;  ///< 1-based CAD edge
  std::vector<int> nodes;
  std::vector<double> t;  ///< the curve's parameter at each
  /// On the two sides of each of its mesh edges, with the CAD face that each of them is to lie on: 2 (nodes - 1).
  std::vector<std::array<int, 2>> quads;
};

/// Straight runs of mesh edges between the quads that lie mostly on the one face of a CAD edge and those on its other, where no mesh edge
/// follows it. `edges`: the CAD edges in question, 1-based; `surface` is the CAD, sampled; `size` the element size h.
std::vector<LateRun> runs_beside_edges(const HexComplex& mesh, const std::vector<int>& edges, const SurfaceMesh& surface,
                                       const Geometry& geometry, double size, const Context& context);

/// Makes the runs' points those of the curves, and gives the quads beside them their faces. Only the next smoothing moves them there.
void bind_points(HexComplex& mesh, const std::vector<LateRun>& runs);

/// Takes the marked points out of the runs, which may fall in pieces; one of a single point still draws its quads' border there. False when
/// there were none.
bool release(std::vector<LateRun>& runs, const std::vector<char>& marked);

/// Takes marked points off the CAD edges that they follow, onto a face beside: off smooth ones, and off sharp ones if `sharp`. The mesh
/// edges there follow none any more. Only the next smoothing moves the points. Returns those taken off.
std::vector<int> loosen(HexComplex& mesh, const std::vector<char>& marked, const Geometry& geometry, bool sharp);

}  // namespace hexfeature
