// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include <vector>

#include "base/context.h"
#include "mesh/geometry.h"
#include "mesh/hex_complex.h"
#include "mesh/surface_mesh.h"

namespace hexfeature {

/// Longest distance from points of each CAD face (those that tell: corners, and what is on curved faces and edges) to the quads of its own,
/// per 1-based face (0 for those without quads). `surface` is the CAD, sampled, in the coordinates of `mesh`; `size` the element size h.
std::vector<double> face_gaps(const HexComplex& mesh, const SurfaceMesh& surface, const Geometry& geometry, double size,
                              const Context& context);

struct PointGap {
  Vec3 point;  ///< on a CAD face
  double gap;  ///< its distance to the quads of that face; infinite for a face without quads
};
/// Of points on all CAD faces, and not only of those that tell: always the same ones for the same surface.
std::vector<PointGap> point_gaps(const HexComplex& mesh, const SurfaceMesh& surface, const Geometry& geometry, double size,
                                 const Context& context);

/// Marks the points of `surface`, of those that tell, that lie more than `limit` h from the quads of a CAD face that they lie on.
std::vector<char> uncovered_points(const HexComplex& mesh, const SurfaceMesh& surface, const Geometry& geometry, double size, double limit,
                                   const Context& context);

/// Gives quads beside smooth CAD edges to the face that they cover best: points have slid since the boundary was
/// fitted. A quad changes when the longest of the gaps that this changes gets shorter.
/// Quads along a followed sharp edge stay what they are. Returns how many changed.
int cover_faces(HexComplex& mesh, const SurfaceMesh& surface, const Geometry& geometry, double size, const Context& context);

/// Draws sliding points of quads towards points of their CAD face that the quads do not reach, as far as the elements stay sound. Returns
/// the points that moved, sorted: they are to be held when the others are smoothed.
std::vector<int> draw_to_gaps(HexComplex& mesh, const SurfaceMesh& surface, const Geometry& geometry, double size, const Context& context);

}  // namespace hexfeature
