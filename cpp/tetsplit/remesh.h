// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include <array>
#include <functional>
#include <vector>

#include "base/context.h"
#include "mesh/geometry.h"
#include "mesh/surface_mesh.h"

namespace hexfeature {

/// Wanted edge length at a point.
using LengthAt = std::function<double(const Vec3&)>;

/// A triangulated surface being remeshed to given edge lengths: edges are split, collapsed and flipped, points slide. CAD vertices
/// stay, CAD edges stay followed by mesh edges, every point stays on its CAD entity. Seams and poles on smooth surface are forgotten.
/// Source: M. Botsch, L. Kobbelt, "A remeshing approach to multiresolution modeling", SGP 2004, section 4; changed: works on true
/// surfaces and curves, judges triangles by their shape, and never turns one away from the surface's own normal.
class Remesher {
 public:
  /// CAD edges shorter than `tiny` may vanish.
  Remesher(const SurfaceMesh& mesh, const Geometry& geometry, double tiny);

  /// Split only, until no edge is longer than wanted (by a third); flips on the way.
  void refine(const LengthAt& length, Context& context);
  /// The whole: `rounds` of split, collapse, flip, slide.
  void remesh(const LengthAt& length, int rounds, Context& context);
  /// Where two edges of one triangle follow smooth CAD curve, its corner would open to a straight angle once they bend along: split
  /// the third.
  void cut_ears(Context& context);

  /// Where a face runs out into a tip between two CAD edges that touch (a line and its tangent arc), no element can have an angle.
  /// Such tips narrower than `width` are cut: the second edge ends on the first, at a point that stays. What is cut is no longer
  /// than `longest`, and than a twelfth of either edge. Call on a mesh that is fine along CAD edges. Returns their number.
  int cut_tips(double width, double longest, Context& context);

  /// `halfedge_edge` names the CAD edges followed; no seams. `pinned`: the points where tips were cut.
  SurfaceMesh result(const Context& context, std::vector<int>* pinned = nullptr) const;

 private:
  static int next(int h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static int prev(int h) { return h % 3 == 0 ? h + 2 : h - 1; }
  int from(int h) const { return triangles_[h / 3][h % 3]; }
  int to(int h) const { return triangles_[next(h) / 3][next(h) % 3]; }
  bool alive(int t) const { return triangles_[t][0] >= 0; }
  double edge_length(int h) const { return (points_[from(h)] - points_[to(h)]).norm(); }
  double wanted(int h) const { return 0.5 * (length_[from(h)] + length_[to(h)]); }

  /// Outgoing halfedges of a point, in order, into ring_.
  void circulate(int h);
  /// Shape in [0, 1] (1: equilateral) of a triangle with true normals at its corners; negative when it looks away from them.
  double shape(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& na, const Vec3& nb, const Vec3& nc) const;
  double shape(int t) const;
  void split(int h, const LengthAt& length);
  bool collapse(int h, bool forced = false);
  bool flip(int h, bool forced = false);
  bool cut_tip(int h, int g, double width, double longest);
  int find(int a, int b);
  bool slide(int v, const LengthAt& length);
  bool may_vanish(int h) const;
  void want(const LengthAt& length, const Context& context);
  void split_long(double factor, const LengthAt& length, Context& context);
  void collapse_short(Context& context);
  void flip_all(Context& context);

  Geometry geometry_;  // by value: callers make one on the spot
  double tiny_;
  std::vector<Vec3> points_;
  std::vector<CadPlace> place_;
  std::vector<double> length_;                 ///< wanted, per point
  std::vector<char> pinned_;                   ///< per point: it never moves
  std::vector<int> out_;                       ///< per point: an outgoing halfedge, -1 when it is gone
  std::vector<std::array<int, 3>> triangles_;  ///< {-1, ..}: gone
  std::vector<int> face_;
  std::vector<Vec3> normals_;  ///< 3 per triangle
  std::vector<int> edge_;      ///< 3 per triangle
  std::vector<int> opposite_;
  std::vector<int> ring_, other_ring_;  ///< scratch
  std::vector<Vec3> slide_normals_;     ///< scratch
};

}  // namespace hexfeature
