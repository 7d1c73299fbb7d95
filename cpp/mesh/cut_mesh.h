// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include <functional>
#include <vector>

#include "mesh/geometry.h"
#include "mesh/surface_mesh.h"

namespace hexfeature {

/// A scalar on one patch of the surface, whose zero lines are cut: a function of a point and the outward unit normal there.
struct CutFunction {
  std::function<double(const Vec3& point, const Vec3& normal)> value;
  /// Optional: cut only where this holds (a zero line that ends inside the patch).
  std::function<bool(const Vec3& point, const Vec3& normal)> accept;
  /// > 0: edges longer than this, with one sign at both ends, are looked at in the middle too (functions that bend inside a triangle).
  double resolution = 0;
};

/// Cuts a closed surface mesh along the zero lines of functions, in place and conforming: an edge that the line crosses is
/// bisected for both its triangles, one edge after another, so that in the end the zero line is a chain of mesh edges.
/// Triangles away from the line keep their numbers; a cut one keeps its number for one piece.
///
/// New points are put on their true curve (halfedge with a CAD edge) or surface when a projector is there and no triangle would
/// turn over; else they stay on the chord. Near the end of an edge (fraction `snap`) the line takes the vertex there: the vertex
/// slides onto the line along its own face or CAD edge; one that may not slide is taken only when it is four times nearer.
/// Requires the mesh's `opposite`, `place`, `corner_normals` and `halfedge_edge`; keeps them. Deterministic.
class SurfaceCutter {
 public:
  SurfaceCutter(SurfaceMesh& mesh, const Projector* projector, double snap);

  /// Cut the triangles of `patch` (each once, all of one CAD face or site) along f = 0. Pieces are appended to `patch`.
  /// `side` gets, per triangle of `patch`, -1 or +1: the sign of f on it (with `accept`: meaningless near an open end).
  void cut(std::vector<int>& patch, const CutFunction& f, std::vector<signed char>& side);

  /// Let no later cut move this vertex. Vertices of finished cuts are pinned by themselves.
  void pin(int vertex) { pinned_[vertex] = 1; }

  /// The triangle that triangle `first_new() + i` was cut from (always of a lower number): to extend per-triangle data.
  const std::vector<int>& parents() const { return parents_; }
  int first_new() const { return first_new_; }

 private:
  struct EdgePoint {
    Vec3 point, left_normal, right_normal;
    CadPlace place;
  };
  bool crossed(int h) const { return value_[mesh_.from(h)] * value_[mesh_.to(h)] < 0; }
  double root(int h, const CutFunction& f) const;
  bool wanted(int h, double s, const CutFunction& f) const;
  EdgePoint point_on(int h, double s) const;
  EdgePoint crossing_point(int h, const CutFunction& f) const;
  void load_patch(const std::vector<int>& patch, const CutFunction& f);
  void refine(std::vector<int>& patch, const CutFunction& f);
  void snap_vertices(const std::vector<int>& patch, const CutFunction& f);
  bool slide(int vertex, int h, double s);
  int split(int h, const EdgePoint& at, std::vector<int>& patch);

  SurfaceMesh& mesh_;
  const Projector* projector_;
  double snap_;
  int first_new_;
  std::vector<int> parents_;
  std::vector<char> pinned_;    // per vertex
  std::vector<char> in_patch_;  // per triangle
  std::vector<double> value_;   // per vertex, of the current cut; 0 away from the patch
  std::vector<Vec3> normal_;    // per vertex, mean over its corners in the current patch
};

}  // namespace hexfeature
