// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include <vector>

#include "base/types.h"

namespace hexfeature {

/// The feature shape reduced to what the conditions V1-V4 need, in flat arrays that are refilled without allocation.
/// Made from a FeatureShape, or by the label search straight from its macro graph, thousands of times a second.
/// Darts as in Partition: 2a runs start -> end of arc a with chart `left` on its left, 2a+1 the other way.
struct ChartGraph {
  struct Arc {
    int left = -1, right = -1;  ///< charts
    int start = -1, end = -1;   ///< corners; -1 when closed without a corner
    Vec3 displacement = Vec3::Zero();
    double length = 0;
    double dihedral = 0;  ///< mean signed dihedral, radians, > 0 convex
  };
  std::vector<Label> label;  ///< per chart
  std::vector<Arc> arcs;
  std::vector<int> corner_first;  ///< corner c owns corner_darts[corner_first[c] .. corner_first[c+1])
  std::vector<int> corner_darts;  ///< outgoing, counter-clockwise seen from outside
  std::vector<int> loop_first;    ///< loop l owns loop_darts[loop_first[l] .. loop_first[l+1])
  std::vector<int> loop_darts;    ///< in order, the chart on the left
  std::vector<int> loop_chart;    ///< per loop

  int chart_count() const { return static_cast<int>(label.size()); }
  int arc_count() const { return static_cast<int>(arcs.size()); }
  int corner_count() const { return static_cast<int>(corner_first.size()) - 1; }
  int loop_count() const { return static_cast<int>(loop_chart.size()); }
  int left_of(int dart) const { return dart % 2 == 0 ? arcs[dart / 2].left : arcs[dart / 2].right; }
  int start_of(int dart) const { return dart % 2 == 0 ? arcs[dart / 2].start : arcs[dart / 2].end; }
  int end_of(int dart) const { return start_of(dart ^ 1); }
  void clear();
};

/// One violated condition of V1-V4 (design 3.4).
struct ChartIssue {
  enum Kind {
    SameAxis,       ///< V1: the charts of `arc` are on one axis
    LoopNoCorner,   ///< V1: `arc` is closed and has no corner
    NoBorder,       ///< V1: `chart` has no border at all
    IllegalCorner,  ///< V2: no polycube has the labels round `corner`
    CornerSigns,    ///< V2: the labels round `corner` are legal, its arcs' signs could not be
    Turning,        ///< V3: `loop` of `chart` turns wrongly
    SelfArc,        ///< V4: `arc` runs from a chart to itself (or one with the same coordinate)
    Cycle,          ///< V4: `charts` lie each above the one before, round in a circle
  } kind;
  double weight = 1;
  int chart = -1, arc = -1, corner = -1, loop = -1;
  int first = 0, last = 0;  ///< Cycle: range in ChartChecker::cycle_charts
  int turning = 0;          ///< Turning: what the loop turns
};

/// Checks V1-V4 on a chart graph. Keeps its scratch arrays: use one object for many graphs (and one a thread).
///
/// Arc signs are a constraint problem (experiments A6). The cost of a sign is min(3, displacement against it / h), plus, where
/// the dihedral's convexity disagrees, min(1, |dihedral| / 45 degrees) * min(3, length / h). Start with the cheapest sign
/// of every arc; then min-conflicts until every corner with legal labels has legal signs, or a bound is met.
class ChartChecker {
 public:
  /// `size`: the element size h. Results are valid until the next call.
  void check(const ChartGraph& graph, double size);

  /// Quarter turns to the left from an arc dart into the next one round the chart on their left: 1, -1, 0, or -2 (back on itself).
  /// Both darts must have an axis.
  int turn(const ChartGraph& graph, int dart, int next) const;

  std::vector<ChartIssue> issues;
  std::vector<int> cycle_charts;
  std::vector<signed char> sign;  ///< per arc: +1, -1; 0 when its charts share an axis
  std::vector<signed char> axis;  ///< per arc: 0..2; -1 when its charts share an axis
  double cost = 0;                ///< sum of weights
  double sign_cost = 0;           ///< sum over arcs of (cost of the chosen sign - cost of the cheapest)

 private:
  void choose_signs(const ChartGraph& graph, double size);
  void check_turnings(const ChartGraph& graph);
  void check_order(const ChartGraph& graph);
  unsigned mask_at(const ChartGraph& graph, int corner) const;
  void add(const ChartIssue& issue);

  struct Signs {
    const unsigned char *begin, *end;
  };
  std::vector<Signs> legal_;                    // per corner
  std::vector<double> cost_plus_, cost_minus_;  // per arc
  std::vector<int> stack_, component_, low_, order_, degree_first_, successor_, parent_, flips_, best_cycle_;
  std::vector<signed char> best_sign_;
};

}  // namespace hexfeature
