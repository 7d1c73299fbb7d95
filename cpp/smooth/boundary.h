// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include <utility>
#include <vector>

#include "base/context.h"
#include "mesh/projector.h"
#include "mesh/surface_mesh.h"
#include "smooth/workers.h"

namespace hexfeature {

/// The sliding of boundary points on their CAD entities: feet (closest points), the tangent planes and lines there, and what
/// these mean for a gradient. Coordinates are flat, 3 a point; lengths in the part's unit.
class Boundary {
 public:
  enum class Motion : char { Fixed, Line, Plane };  ///< where a point may go on the tangent spaces
  /// All that is found out about the boundary points, in their order.
  struct Feet {
    std::vector<char> clamped;  ///< the foot is on the rim, the point was beyond it
    std::vector<Motion> motion;
    std::vector<Vec2> parameter;
    std::vector<Vec3> foot, origin;
    std::vector<Vec3> axis;     ///< the surface's normal or the curve's tangent at the foot
    std::vector<Vec3> outward;  ///< where clamped: unit vector away from the face, in its tangent plane; or along the curve
    std::vector<Vec3> line;     ///< where motion is Line: its direction
  };

  /// `place` of each point; a point that is not `free` is never moved. `size` is the element size h.
  Boundary(const std::vector<CadPlace>& place, const std::vector<char>& free, const Projector& projector, double size, Workers& workers,
           const Context& context);

  /// Find the feet of all boundary points, from the parameters of their last ones. Returns the largest distance.
  double find_feet(const std::vector<double>& x);
  /// The same for some of them: `which` per point.
  void find_feet(const std::vector<double>& x, const std::vector<char>& which);
  Feet save() const { return feet_; }
  void restore(Feet feet) { feet_ = std::move(feet); }
  /// Put all boundary points onto their feet: the CAD's own points, exactly.
  void snap(std::vector<double>& x);
  /// Only look: x with its boundary points on the feet.
  void place_on_feet(std::vector<double>& x) const;

  /// Where a foot is on the rim of its face (or at the end of its curve) and the descent leads outward, the point may from
  /// now on move along the rim only. Call before a descent on the tangent spaces.
  void hold_at_rims(const std::vector<double>& gradient);
  /// Leave of the gradient only what moves points within their tangent plane or line.
  void make_tangent(std::vector<double>& gradient) const;
  /// Corners stay; everything else is free (for the soft rounds).
  void fix_corners(std::vector<double>& gradient) const;

  /// weight / h^2 times the squared distance from the tangent planes and lines; adds to `gradient`.
  double add_penalty(const std::vector<double>& x, double weight, std::vector<double>& gradient) const;
  /// Per point the symmetric matrix (xx yy zz yz xz xy) that turns a gradient into a Newton step of that point alone: the
  /// inverse of `stiffness`, with the penalty's own (weight > 0), or within the tangent space (weight = 0).
  void invert_stiffness(const std::vector<double>& stiffness, double weight, std::vector<double>& inverse) const;

  /// Whether a boundary point has moved farther than `limit` from where it was at the last find_feet or snap.
  bool drifted(const std::vector<double>& x, double limit) const;
  /// Write the feet's parameters into the places.
  void store(std::vector<CadPlace>& place) const;
  /// The inverse: where the next feet are looked for first.
  void load(const std::vector<CadPlace>& place);
  bool empty() const { return node_.empty(); }

 private:
  void find_foot(int i, const Vec3& p);
  /// Splines take their time: asks for cancellation now and then, from any thread.
  void breathe(int i) const {
    if (i % 512 == 0) context_.check();
  }
  Vec3 penalised(int i, const Vec3& d) const;

  std::vector<int> node_, entity_;
  std::vector<char> dim_;
  Feet feet_;
  std::vector<int> fixed_;  ///< points that are not free
  const Projector& projector_;
  double size_;
  Workers& workers_;
  const Context& context_;
};

}  // namespace hexfeature
