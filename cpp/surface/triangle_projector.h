// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include <vector>

#include "mesh/geometry.h"
#include "mesh/projector.h"
#include "mesh/surface_mesh.h"
#include "surface/box_tree.h"

namespace hexfeature {

/// Closest points on a triangle surface: on the triangles of one pseudo face (normals blended between the corners'),
/// on the polyline of one pseudo edge (t is the arc length from its start). A face's parameters are (triangle, 0): a
/// guess that is a good one makes the search short. Keeps its own copy of what it needs.
class TriangleProjector : public Projector {
 public:
  /// `chains`: the points of each pseudo edge in order; a closed one repeats its first point.
  TriangleProjector(const SurfaceMesh& mesh, std::size_t face_count, const std::vector<std::vector<int>>& chains,
                    const std::vector<CadVertex>& vertices);

  FacePoint project_to_face(int face, const Vec3& p, const Vec2* guess) const override;
  CurvePoint project_to_edge(int edge, const Vec3& p, const double* guess) const override;
  Vec3 vertex_point(int vertex) const override;
  CurvePoint edge_point(int edge, double t) const override;

 private:
  struct Face {
    std::vector<int> triangles;
    BoxTree tree;
  };
  struct Chain {
    std::vector<Vec3> points;
    std::vector<double> t;
    BoxTree tree;
  };
  CurvePoint on_segment(const Chain& chain, int segment, double s) const;

  std::vector<Vec3> points_;
  std::vector<std::array<int, 3>> triangles_;
  std::vector<int> triangle_face_;
  std::vector<Vec3> corner_normals_;
  std::vector<Face> faces_;
  std::vector<Chain> chains_;
  std::vector<Vec3> vertices_;
};

}  // namespace hexfeature
