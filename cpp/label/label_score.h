// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include <vector>

#include "label/macro_graph.h"
#include "shape/chart_graph.h"

namespace hexfeature {

/// What a set of site labels is worth (experiments A5, A6).
struct LabelScore {
  double violations = 0;  ///< V: sum of weights of the violated conditions V1-V4
  double defects = 0;     ///< Q: valid but useless: flattened faces, lost sharp edges, lines that run backwards
  double energy = 0;      ///< E: fidelity and border length
  bool valid() const { return violations < 1e-9; }
};

/// Scores site labels on a macro graph: charts, arcs, corners and loops come from the macro graph alone, in scratch arrays
/// that are kept. Linear in the number of macro edges: about 10 microseconds per 100 of them.
class LabelScorer {
 public:
  LabelScorer(double size, double fold_tolerance) : size_(size), fold_tolerance_(fold_tolerance) {}

  double fold_tolerance() const { return fold_tolerance_; }

  LabelScore score(const MacroGraph& graph, const std::vector<Label>& labels);

  /// Blame per site of the labels scored last, for violations and defects; `extra_charts` (may be empty) are blamed with `weight` each.
  void blame(const MacroGraph& graph, const std::vector<Label>& labels, std::vector<double>& site_blame) const;

  /// The way an arc of the labels scored last runs back against its sign, at its worst: from where to where on its axis.
  struct Backward {
    double length = 0;  ///< in the part's unit
    double from = 0, to = 0;
  };
  Backward backward(const MacroGraph& graph, int arc) const;
  /// Sites beside an arc of the labels scored last, each once, in order.
  std::vector<int> sites_beside(const MacroGraph& graph, int arc) const;

  // Of the labels scored last.
  std::vector<int> site_chart;  ///< per site
  ChartGraph charts;
  ChartChecker checker;

  /// Length that an arc may run backwards along its axis without blame, in h: from end to end, and anywhere on its way (where a
  /// wiggle below the lattice's spacing does no harm: small islands may join their surroundings).
  static constexpr double kBackward = 0.25;

 private:
  void build_charts(const MacroGraph& graph, const std::vector<Label>& labels);

  double backward_defect(const MacroGraph& graph, int arc) const;
  /// Whether a macro dart inside a chart sets out from a corner at which the chart has one quad: no mesh edge of its own leaves there.
  bool starts_in_quad(const MacroGraph& graph, int dart) const;

  double size_, fold_tolerance_;
  std::vector<int> parent_, node_corner_, dart_arc_, position_, seen_, arc_darts_, arc_darts_first_, corner_node_;
  std::vector<signed char> border_;
};

}  // namespace hexfeature
