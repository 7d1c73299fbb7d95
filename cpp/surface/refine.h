// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include <vector>

#include "brep/model_impl.h"

namespace hexfeature {

/// A base mesh being refined within its CAD faces: edges are split at points of the true CAD and flipped towards
/// Delaunay; CAD edges are kept. Works in the file's frame.
///
///         c                  c                   c                  c
///        / \                /|\                 / \                /|\      .
///       /   \              / | \               /   \              / | \     .
///      a --h-> b   split  a--m--b             a --h-> b   flip   a  |  b
///       \   /              \ | /               \   /              \ | /
///        \ /                \|/                 \ /                \|/
///         d                  d                   d                  d
class Refiner {
 public:
  Refiner(const CadModel& model, double edge_length, double plane_length, int segments_per_turn);

  /// Split until no edge is too long, flipping on the way.
  void run(Context& context);
  /// Normals at poles, as the triangles have become.
  void settle_poles();
  /// Split edges whose two points are those of another edge too, so that points alone tell edges apart.
  void separate_double_edges(Context& context);

  BaseMesh mesh;
  std::vector<Vec3> corner_normals;  ///< 3 per triangle, outward

 private:
  static int next(int h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static int prev(int h) { return h % 3 == 0 ? h + 2 : h - 1; }
  Vec3 normal_at(int triangle, const Vec2& uv, const Vec2& inside) const;
  double excess(int h) const;  ///< length over allowed length
  void split(int h);
  bool flip_if_better(int h);
  void flip_all(Context& context);
  void queue(int h);
  void flip_queued(int limit, Context& context);
  int add_triangle_like(int triangle);
  double middle_of(int edge, double ta, double tb) const;

  const CadModel& model_;
  const CadTables& cad_;
  double edge_length_, plane_length_, turn_cosine_, shortest_;
  std::vector<char> planar_;  ///< per CAD face
  std::vector<int> stack_;
  std::vector<char> queued_;
  bool settled_ = true;  ///< no flipping had to stop early
};

}  // namespace hexfeature
