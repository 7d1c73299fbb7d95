// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include <array>
#include <tuple>
#include <utility>
#include <vector>

#include "base/context.h"
#include "polycube/concentric.h"
#include "polycube/difference_lp.h"
#include "polycube/orders.h"
#include "shape/feature_shape.h"

namespace hexfeature {

struct QuantizeOptions {
  double size = 1;             ///< element size h
  int minimum_intervals = 1;   ///< least |delta u| along an arc
  int rays = 4000;             ///< at most so many sample rays for order and gap constraints (deterministic)
  double arc_curvature = 0.5;  ///< how much the cost of too many intervals on an arc bends upwards
  double largest_sag = 0.2;    ///< an arc gets intervals until the chords' sag is below this many h (wish, not constraint)
};

/// The recognition model: the feature shape with integer, axis-aligned coordinates. A chart of label l lies on the
/// plane x[axis(l)] = coordinate; a corner takes one coordinate from a chart of each axis.
struct Polycube {
  std::vector<int> coordinate;              ///< per chart; least on each axis is 0
  std::vector<std::array<int, 3>> corners;  ///< per corner of the feature shape
  double length_error = 0;                  ///< sum over arcs of |delta u - L/h| / number of arcs
};

/// Two charts that must be kept apart on their axis: coordinate[high] - coordinate[low] >= gap.
struct Separation {
  int low = -1, high = -1;
  int gap = 1;
  bool operator<(const Separation& o) const { return std::tie(low, high, gap) < std::tie(o.low, o.high, o.gap); }
  bool operator==(const Separation& o) const { return std::tie(low, high, gap) == std::tie(o.low, o.high, o.gap); }
};

/// The hard constraints contradict each other, or the feature shape is not one that has coordinates.
struct PolycubeError : MeshingError {
  PolycubeError(std::string reason_, const FeatureShape& shape, std::vector<int> charts_);
  std::vector<int> charts;  ///< to blame, sorted
};

/// Integer coordinates as three difference-constraint LPs solved exactly by network simplex (design 3.5, experiments A8).
/// Hard: delta u >= minimum_intervals along every arc's sign; charts of one axis that meet at a corner are equal.
/// Soft: arc lengths; orders and gaps of `orders`; `separations` (dearer than anything but never infeasible); positions; round
/// charts about one line even to each other (concentric.h).
/// Made once for a feature shape, then solved with more and more separations.
class Quantizer {
 public:
  /// Throws PolycubeError when a corner or an arc has no direction, MeshingError(Usage) for a size that is no length.
  Quantizer(const SurfaceMesh& mesh, const FeatureShape& shape, const std::vector<ChartOrder>& orders, const QuantizeOptions& options);
  /// Throws PolycubeError when constraints have a positive cycle, naming the CAD faces on it.
  Polycube solve(const std::vector<Separation>& separations, Context& context) const;

 private:
  int axis(int chart) const { return axis_of(shape_.charts[chart].label); }
  void add_arcs(const SurfaceMesh& mesh);
  void add_orders(const std::vector<ChartOrder>& orders);
  void add_positions();
  void add_concentric(const SurfaceMesh& mesh);

  const FeatureShape& shape_;
  QuantizeOptions options_;
  std::vector<int> unknown_;                         // per chart, of its axis: charts of one axis that meet at corners share one
  std::vector<std::array<int, 3>> corner_unknowns_;  // per corner and axis
  std::array<int, 3> count_{0, 0, 0};                // unknowns per axis; one more is the origin
  std::array<std::vector<DifferenceTerm>, 3> terms_;
  std::array<std::vector<int>, 3> term_arc_;  // per term: the arc of a hard one, -1 otherwise (shorter than the terms: the rest is -1)
  std::vector<ConcentricUnknowns> concentric_;
};

/// One solution, sampling its own orders.
Polycube quantize(const SurfaceMesh& mesh, const FeatureShape& shape, const QuantizeOptions& options,
                  const std::vector<Separation>& separations, Context& context);

/// Which orders of charts on one axis the arcs force: the transitive closure of V4's differences.
class ForcedOrders {
 public:
  /// Throws PolycubeError like quantize when a corner or an arc has no direction.
  explicit ForcedOrders(const FeatureShape& shape);
  /// Two charts of one axis: must coordinate[low] < coordinate[high] in every polycube?
  bool below(int low, int high) const { return reach(of_chart_[low], of_chart_[high]); }
  /// Could coordinate[low] < coordinate[high] be asked for without contradicting the arcs?
  bool allows(int low, int high) const { return of_chart_[low] != of_chart_[high] && !below(high, low); }

 private:
  bool reach(int from, int to) const { return reach_[static_cast<std::size_t>(from) * count_ + to]; }
  std::vector<int> of_chart_;
  std::vector<bool> reach_;
  int count_ = 0;
};

/// Number of rays that suit a mesh: grows with it, at most options.rays.
int ray_count(const SurfaceMesh& mesh, const QuantizeOptions& options);

}  // namespace hexfeature
