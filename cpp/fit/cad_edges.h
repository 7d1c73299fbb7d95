// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include <string>
#include <vector>

#include "fit/boundary_fit.h"

namespace hexfeature {

/// A CAD edge, or several joined at soft vertices, that runs inside one chart and has no lattice line yet.
struct InnerCurve {
  std::vector<int> vertices;   ///< of the surface mesh; closed: first == last
  std::vector<int> halfedges;  ///< vertices[i] -> vertices[i + 1]
  double length = 0;
  bool sharp = false;

  bool closed() const { return vertices.front() == vertices.back(); }
};

/// All of them, sharp ones first, then by rising length: short ones have the least choice. An end is where the curve meets a chain, a
/// branch or a hard CAD vertex.
std::vector<InnerCurve> collect_inner_curves(const BoundaryFit& fit);

/// The curve as its region's map shows it, with what routing asks of it.
class FlatCurve {
 public:
  FlatCurve(const BoundaryFit& fit, const InnerCurve& curve);
  const std::vector<Vec2>& points() const { return flat_; }
  /// Squared distance of a point of the lattice plane, and the arc length (on the part) of the nearest point of the curve.
  double distance2(const Vec2& q, double& s) const;
  /// The same for a point of the part.
  double distance2_on_part(const Vec3& p, double& s) const;
  /// Signed turn of the curve on the part within one element size on either side of arc length s; left positive.
  double turn_at(double s) const;
  /// Unit direction on the part that the curve sets out in from its start, or comes in to its end (then pointing back).
  Vec3 direction_from(bool start) const;

 private:
  Vec3 at(double s) const;
  const BoundaryFit& fit_;
  const InnerCurve& curve_;
  std::vector<Vec2> flat_;
  std::vector<double> s_;
};

/// Whether CAD edge `e` is to be followed with any turns: FitOptions::insisted.
bool is_insisted(const BoundaryFit& fit, int e);

/// Log line: the curve stays without mesh edges of its own, and why.
void report_given_up(const BoundaryFit& fit, const InnerCurve& curve, const std::string& why);

struct Route {
  std::vector<int> nodes;   ///< of the complex; empty: none
  bool free_turns = false;  ///< see FitOptions
};

/// Node path (>= 2 nodes) along which the lattice should follow an open curve; none when every path is too dear.
/// Cheapest path with state = directed edge (experiments B4): distance to the curve in lattice units; two consecutive edges of one
/// quad only where the curve itself turns that way, since the quad's corner there would open to 180 degrees.
Route route_open_curve(const BoundaryFit& fit, int region, const InnerCurve& curve, const std::vector<int>& node_of_vertex);

/// Node loop (first == last) round a closed curve: the rectangle of the lattice plane that encloses about its area.
std::vector<int> route_closed_curve(const BoundaryFit& fit, int region, const InnerCurve& curve);

}  // namespace hexfeature
