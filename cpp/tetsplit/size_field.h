// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include <vector>

#include "base/context.h"
#include "mesh/geometry.h"
#include "mesh/surface_mesh.h"
#include "mesh/triangle_tree.h"

namespace hexfeature {

/// The defaults of lengths are those for elements of size h = 1. An edge of a tetrahedron that becomes four hexahedra of volume h^3 is
/// `longest`: about 0.1 of its cube is the volume of an average one.
struct SizeOptions {
  double longest = 3.2;       ///< triangle edge length where nothing asks for less
  double least = 0.7;         ///< narrow faces and short edges ask for no less than this
  double least_curve = 1.25;  ///< tight curvature asks for no less than this, as far as it can do with it:
  double turn = 1.15;         ///< radians of curvature that one edge may span (five or six edges a turn)
  double tight_edge = 1.4;    ///< ... at most so many radians on CAD edges
  double tight_face = 2.0;    ///< ... and on faces: a fillet is one strip of triangles
  double walls = 1.8;         ///< edge length over the thickness of a wall
  double least_wall = 0.5;    ///< walls ask for no less than this
  double strips = 1.8;        ///< edge length over the width of a narrow face or the length of a short CAD edge
  double grading = 0.7;       ///< the length grows by no more than this times the distance
};

/// Edge length that a triangulation should have, as a function of the place on the surface: from curvature, the width of faces,
/// the length of CAD edges and the thickness of walls, graded. Length unit: the part's.
class SizeField {
 public:
  /// `mesh` must be fine enough to show all that (about the element size); it is copied.
  SizeField(const SurfaceMesh& mesh, const Geometry& geometry, const SizeOptions& options, const Context& context);

  /// At the point of the surface nearest to p.
  double at(const Vec3& p) const;
  /// Ask for `factor` times the present length within about one such length of each point; then graded again.
  void refine(const std::vector<Vec3>& near, double factor, const Context& context);
  SizeField scaled(double factor) const;

 private:
  void follow_curvature(const SizeOptions& options);
  void follow_strips(const SizeOptions& options, const Context& context);
  void follow_walls(const SizeOptions& options, const Context& context);
  void grade(const Context& context);
  void lower(int v, double length) { length_[v] = std::min(length_[v], length); }

  SurfaceMesh mesh_;
  Geometry geometry_;
  TriangleTree tree_;
  std::vector<double> length_;  ///< per point of mesh_
  double grading_;
};

}  // namespace hexfeature
