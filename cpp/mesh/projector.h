// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include <vector>

#include "base/types.h"

namespace hexfeature {

struct FacePoint {
  Vec3 point = Vec3::Zero();
  Vec3 normal = Vec3::Zero();  ///< outward unit normal of the solid
  Vec2 uv = Vec2::Zero();
};
struct CurvePoint {
  Vec3 point = Vec3::Zero();
  Vec3 tangent = Vec3::Zero();  ///< unit, along increasing t
  double t = 0;
};

/// The true geometry as fit and smooth see it: closest points on one entity's own surface or curve, with
/// cached parameters as the starting guess. The CAD supplies one implementation, a triangle mesh another.
/// Entities are 1-based CAD numbers. Results lie on the *trimmed* entity (clamped to its boundary when the
/// foot point falls outside it). Const, thread-safe, deterministic.
class Projector {
 public:
  virtual ~Projector() = default;
  /// Closest point of face `face` near `p`; `guess` (may be null) are parameters of a nearby point of that face.
  virtual FacePoint project_to_face(int face, const Vec3& p, const Vec2* guess) const = 0;
  /// Closest point of edge `edge` near `p`; `guess` (may be null) is a parameter of a nearby point.
  virtual CurvePoint project_to_edge(int edge, const Vec3& p, const double* guess) const = 0;
  virtual Vec3 vertex_point(int vertex) const = 0;
  /// Edge point by parameter, and length of the edge's curve between two parameters (by quadrature or dense samples).
  virtual CurvePoint edge_point(int edge, double t) const = 0;
};

}  // namespace hexfeature
