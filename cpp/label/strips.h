// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include <vector>

#include "mesh/geometry.h"

namespace hexfeature {

/// Cylinder, cone or torus with a known axis.
bool is_revolved(const CadFace& face);

/// The frame of a surface of revolution in which it falls into four strips, centred on +-e1 and +-e2: e1 is the working axis most
/// perpendicular to the surface's, made orthogonal to it.
struct StripFrame {
  Vec3 origin, axis, e1, e2;
  double on_axis;  ///< radius below which a point (a cone's apex) counts as on the axis, where all strips meet

  /// `border`, if not zero, is a direction across the axis that a strip shall end at: e1 and e2 are turned there by the least angle.
  StripFrame(const CadFace& face, double size, const Vec3& border = Vec3::Zero());

  /// (r.e1)^2 - (r.e2)^2 of the unit radial direction r: its zeros are the borders of the strips; 0 on the axis.
  double side(const Vec3& p) const;
  /// Angle from the nearest border of a strip, in [-pi/4, pi/4].
  double off_border(const Vec3& p) const;
  double radius(const Vec3& p) const;
  /// Unit direction from the axis to p, across the axis.
  Vec3 radial(const Vec3& p) const;
};

/// How the strips of a face lie; index = its CAD number, 0 unused.
struct Strips {
  std::vector<Vec3> border;  ///< the direction across the axis that a strip shall end at; zero: any
  std::vector<char> tip;     ///< no border of a strip should lie on the lines that part the face, nor take their place
};

/// Holes and shafts often come as two CAD faces or more, parted along straight lines anywhere on their way round, and a mesh edge lies on
/// one of the two only: a node has to stand where such a line ends. When the nearest node of evenly spaced ones is the one on a strip's
/// border, that border shall lie on the line, or the mesh edges to its sides would be one very short and one very long. What touches the
/// face and is round the same axis (a chamfer at a hole's rim) is turned with it.
/// Where such a line runs on over a tip (a drilled hole's) to the axis, it is the other way round: the tip is one chart, in whose corners
/// no mesh edge but its border's ends. With one or two intervals to a strip the line can cross it from the middle of one strip to that of
/// the opposite one, and no border may take its place.
Strips place_strips(const Geometry& geometry, double size);

}  // namespace hexfeature
