// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include <Geom_Curve.hxx>
#include <TopoDS_Edge.hxx>
#include <vector>

#include "base/types.h"

namespace hexfeature {

/// The curve of one CAD edge, in the file's frame: evaluation and closest points. Lines and circles in closed form, others
/// by Newton; thread-safe.
struct EdgeGeometry {
  enum class Kind { None, Line, Circle, Other };
  Kind kind = Kind::None;                                            ///< None: a degenerate edge
  Vec3 origin = Vec3::Zero(), x = Vec3::UnitX(), y = Vec3::UnitY();  ///< line: origin + t x; circle: origin + r (cos t x + sin t y)
  double radius = 0;
  double t0 = 0, t1 = 0;
  bool closed = false;  ///< ends where it starts: t wraps round
  double size = 0;      ///< length of its polyline, the scale of tolerances
  Handle(Geom_Curve) curve;
  std::vector<double> sample_t;  ///< increasing, for starts without a guess; Kind::Other alone
  std::vector<Vec3> sample_p;

  explicit EdgeGeometry(const TopoDS_Edge& edge);

  Vec3 point(double t) const;
  Vec3 derivative(double t) const;
  Vec3 tangent(double t) const;  ///< unit; a chord's direction where the derivative vanishes
  /// Parameter in [t0, t1] of the closest point; `guess` may be null.
  double closest(const Vec3& p, const double* guess) const;
  double length(double a, double b) const;  ///< of the curve between two parameters (a < b)

 private:
  bool newton(const Vec3& p, double& t) const;
  double from_samples(const Vec3& p) const;
};

}  // namespace hexfeature
