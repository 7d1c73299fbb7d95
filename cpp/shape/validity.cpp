// HexFeatureWB - LGPL-2.1-or-later
#include "shape/validity.h"

#include <algorithm>

#include "shape/chart_graph.h"

namespace hexfeature {
namespace {

ChartGraph graph_of(const FeatureShape& shape) {
  ChartGraph graph;
  graph.clear();
  for (const auto& chart : shape.charts) graph.label.push_back(chart.label);
  for (int a = 0; a < shape.arc_count(); ++a) {
    const auto& edge = shape.cells.edges[a];
    const auto& arc = shape.arcs[a];
    graph.arcs.push_back({edge.left, edge.right, edge.start, edge.end, arc.displacement, arc.length, arc.dihedral});
  }
  for (const auto& node : shape.cells.nodes) {
    graph.corner_darts.insert(graph.corner_darts.end(), node.darts.begin(), node.darts.end());
    graph.corner_first.push_back(static_cast<int>(graph.corner_darts.size()));
  }
  for (int p = 0; p < shape.chart_count(); ++p)
    for (const auto& loop : shape.cells.parts[p].loops) {
      graph.loop_darts.insert(graph.loop_darts.end(), loop.begin(), loop.end());
      graph.loop_first.push_back(static_cast<int>(graph.loop_darts.size()));
      graph.loop_chart.push_back(p);
    }
  return graph;
}

void sort_unique(std::vector<int>& v) {
  std::sort(v.begin(), v.end());
  v.erase(std::unique(v.begin(), v.end()), v.end());
}

Violation describe(const ChartIssue& issue, const ChartGraph& graph, const ChartChecker& checker) {
  Violation v;
  v.weight = issue.weight;
  const auto name = [&](int chart) {
    static const char* names[6] = {"+X", "-X", "+Y", "-Y", "+Z", "-Z"};
    return std::string(names[graph.label[chart]]);
  };
  const auto blame_arc = [&](int a) {
    v.arcs.push_back(a);
    v.charts.push_back(graph.arcs[a].left);
    v.charts.push_back(graph.arcs[a].right);
  };
  switch (issue.kind) {
    case ChartIssue::SameAxis:
      v.condition = 1;
      v.reason = name(graph.arcs[issue.arc].left) + " and " + name(graph.arcs[issue.arc].right) + " share a border";
      blame_arc(issue.arc);
      break;
    case ChartIssue::LoopNoCorner:
      v.condition = 1;
      v.reason = "a closed border between two faces has no corner";
      blame_arc(issue.arc);
      break;
    case ChartIssue::NoBorder:
      v.condition = 1;
      v.reason = "a shell has one direction only";
      v.charts = {issue.chart};
      break;
    case ChartIssue::IllegalCorner:
    case ChartIssue::CornerSigns: {
      v.condition = 2;
      v.reason = issue.kind == ChartIssue::IllegalCorner ? "no polycube has a corner of" : "the lines contradict each other at a corner of";
      for (int i = graph.corner_first[issue.corner]; i < graph.corner_first[issue.corner + 1]; ++i) {
        const int d = graph.corner_darts[i];
        v.reason += " " + name(graph.left_of(d));
        v.charts.push_back(graph.left_of(d));
        v.arcs.push_back(d / 2);
      }
      v.corners = {issue.corner};
      break;
    }
    case ChartIssue::Turning:
      v.condition = 3;
      v.reason = "a border loop of a " + name(issue.chart) + " face turns " + std::to_string(issue.turning) + " quarters";
      v.charts = {issue.chart};
      for (int i = graph.loop_first[issue.loop]; i < graph.loop_first[issue.loop + 1]; ++i) {
        const int d = graph.loop_darts[i];
        v.arcs.push_back(d / 2);
        if (graph.start_of(d) >= 0) v.corners.push_back(graph.start_of(d));
      }
      break;
    case ChartIssue::SelfArc:
      v.condition = 4;
      v.reason = "a line runs from a " + name(issue.chart) + " face to itself";
      blame_arc(issue.arc);
      v.charts.push_back(issue.chart);
      break;
    case ChartIssue::Cycle:
      v.condition = 4;
      v.reason =
          "faces on one axis lie each above the one before, round in a circle (" + std::to_string(issue.last - issue.first) + " faces)";
      v.charts.assign(checker.cycle_charts.begin() + issue.first, checker.cycle_charts.begin() + issue.last);
      break;
  }
  sort_unique(v.charts);
  sort_unique(v.arcs);
  sort_unique(v.corners);
  return v;
}

}  // namespace

ValidityReport check_validity(FeatureShape& shape, double size) {
  const ChartGraph graph = graph_of(shape);
  ChartChecker checker;
  checker.check(graph, size);
  ValidityReport report;
  for (const auto& issue : checker.issues) report.violations.push_back(describe(issue, graph, checker));
  report.cost = checker.cost;
  report.sign_cost = checker.sign_cost;
  for (int a = 0; a < shape.arc_count(); ++a) {
    shape.arcs[a].axis = checker.axis[a];
    shape.arcs[a].sign = checker.sign[a];
  }
  return report;
}

}  // namespace hexfeature
