// HexFeatureWB - LGPL-2.1-or-later
#include "label/label_score.h"

#include <algorithm>
#include <cmath>

namespace hexfeature {

void LabelScorer::build_charts(const MacroGraph& graph, const std::vector<Label>& labels) {
  const int sites = graph.site_count(), edges = graph.edge_count(), nodes = graph.node_count();
  charts.clear();

  // Charts: components of equal label, numbered by their first site.
  parent_.resize(sites);
  for (int s = 0; s < sites; ++s) parent_[s] = s;
  const auto root = [&](int s) {
    while (parent_[s] != s) s = parent_[s] = parent_[parent_[s]];
    return s;
  };
  for (const auto& e : graph.edges)
    if (labels[e.left] == labels[e.right]) {
      const int a = root(e.left), b = root(e.right);
      parent_[std::max(a, b)] = std::min(a, b);
    }
  site_chart.resize(sites);
  for (int s = 0; s < sites; ++s) {
    const int r = root(s);
    if (r == s) {
      site_chart[s] = charts.chart_count();
      charts.label.push_back(labels[s]);
    } else {
      site_chart[s] = site_chart[r];
    }
  }

  // Corners: nodes where more than two chart borders meet.
  border_.resize(edges);
  for (int e = 0; e < edges; ++e) border_[e] = site_chart[graph.edges[e].left] != site_chart[graph.edges[e].right];
  node_corner_.assign(nodes, -1);
  corner_node_.clear();
  for (int n = 0; n < nodes; ++n) {
    int degree = 0;
    for (int i = graph.node_first[n]; i < graph.node_first[n + 1]; ++i) degree += border_[graph.node_darts[i] / 2];
    if (degree > 2) {
      node_corner_[n] = static_cast<int>(corner_node_.size());
      corner_node_.push_back(n);
    }
  }

  // Arcs: chains of border edges from corner to corner. The next border dart round the left chart is the one clockwise
  // before the dart's twin at its end node.
  const auto next_border = [&](int dart) {
    const int n = graph.end_of(dart), first = graph.node_first[n], last = graph.node_first[n + 1];
    int i = first;
    while (graph.node_darts[i] != (dart ^ 1)) ++i;
    do {
      i = i == first ? last - 1 : i - 1;
    } while (!border_[graph.node_darts[i] / 2]);
    return graph.node_darts[i];
  };
  dart_arc_.assign(2 * edges, -1);
  arc_darts_.clear();
  arc_darts_first_.assign(1, 0);
  const auto trace = [&](int first) {
    ChartGraph::Arc arc;
    arc.left = site_chart[graph.left_of(first)];
    arc.right = site_chart[graph.right_of(first)];
    const int start = graph.start_of(first), id = charts.arc_count();
    arc.start = start < 0 ? -1 : node_corner_[start];
    int dart = first, end;
    for (;;) {
      const auto& e = graph.edges[dart / 2];
      dart_arc_[dart] = 2 * id;
      dart_arc_[dart ^ 1] = 2 * id + 1;
      arc_darts_.push_back(dart);
      arc.length += e.length;
      arc.dihedral += e.length * e.dihedral;
      if (dart % 2 == 0)
        arc.displacement += e.displacement;
      else
        arc.displacement -= e.displacement;
      end = graph.end_of(dart);
      if (end < 0 || node_corner_[end] >= 0) break;
      dart = next_border(dart);
      if (dart == first) break;
    }
    arc.end = end < 0 ? -1 : node_corner_[end];
    if (arc.length > 0) arc.dihedral /= arc.length;
    charts.arcs.push_back(arc);
    arc_darts_first_.push_back(static_cast<int>(arc_darts_.size()));
  };
  for (int n : corner_node_)
    for (int i = graph.node_first[n]; i < graph.node_first[n + 1]; ++i) {
      const int d = graph.node_darts[i];
      if (border_[d / 2] && dart_arc_[d] < 0) trace(d);
    }
  for (int e = 0; e < edges; ++e)
    if (border_[e] && dart_arc_[2 * e] < 0) trace(2 * e);

  // Corners' darts, and loops: the next arc dart is the one before the twin at its end corner.
  const int arcs = charts.arc_count();
  position_.assign(2 * arcs, -1);
  for (int n : corner_node_) {
    for (int i = graph.node_first[n]; i < graph.node_first[n + 1]; ++i) {
      const int d = graph.node_darts[i];
      if (!border_[d / 2]) continue;
      // The arc dart that leaves here: the one whose first macro dart is d.
      position_[dart_arc_[d]] = static_cast<int>(charts.corner_darts.size());
      charts.corner_darts.push_back(dart_arc_[d]);
    }
    charts.corner_first.push_back(static_cast<int>(charts.corner_darts.size()));
  }
  seen_.assign(2 * arcs, 0);
  for (int d = 0; d < 2 * arcs; ++d) {
    if (seen_[d]) continue;
    int e = d;
    do {
      seen_[e] = 1;
      charts.loop_darts.push_back(e);
      const int corner = charts.end_of(e);
      if (corner < 0) break;
      const int p = position_[e ^ 1];
      e = charts.corner_darts[p == charts.corner_first[corner] ? charts.corner_first[corner + 1] - 1 : p - 1];
    } while (e != d);
    charts.loop_first.push_back(static_cast<int>(charts.loop_darts.size()));
    charts.loop_chart.push_back(charts.left_of(d));
  }
}

LabelScorer::Backward LabelScorer::backward(const MacroGraph& graph, int a) const {
  Backward worst;
  const int axis = checker.axis[a];
  if (axis < 0 || charts.arcs[a].start < 0) return worst;
  // Along the arc's direction: the greatest fall from the highest point so far. Whole macro edges at a time, by their own
  // extremes, so that the cost does not depend on the triangles.
  const double sign = checker.sign[a];
  double at = 0, top = 0, start = 0;
  bool first = true;
  for (int i = arc_darts_first_[a]; i < arc_darts_first_[a + 1]; ++i) {
    const auto& e = graph.edges[arc_darts_[i] / 2];
    const bool forward = arc_darts_[i] % 2 == 0;
    const double total = e.displacement[axis];
    if (first) start = e.first[axis] + (forward ? 0 : total);
    first = false;
    // Seen from the dart's own start, along `sign`.
    double step = forward ? total : -total, low = e.low[axis], high = e.high[axis];
    if (!forward) low -= total, high -= total;
    if (sign < 0) {
      step = -step;
      std::swap(low, high);
      low = -low;
      high = -high;
    }
    const double inner = forward == (sign > 0) ? e.fall[axis] : e.rise[axis];
    const double across = top - (at + low);
    if (across > worst.length) worst = {across, start + sign * top, start + sign * (at + low)};
    if (inner > worst.length) worst = {inner, start + sign * (at + high), start + sign * (at + low)};
    top = std::max(top, at + high);
    at += step;
  }
  return worst;
}

double LabelScorer::backward_defect(const MacroGraph& graph, int a) const {
  if (checker.axis[a] < 0 || charts.arcs[a].start < 0) return 0;
  const double overall = -checker.sign[a] * charts.arcs[a].displacement[checker.axis[a]] / size_ - kBackward;
  // An arc that ends before it began makes a chart that is folded over: it hardly ever fills, and never well.
  if (overall > 0) return std::min(1.0, 0.25 + overall);
  const double excess = backward(graph, a).length / size_ - fold_tolerance_;
  return excess > 0 ? 0.3 * std::min(1.0, 0.25 + excess) : 0;
}

bool LabelScorer::starts_in_quad(const MacroGraph& graph, int dart) const {
  const int n = graph.start_of(dart);
  if (n < 0 || node_corner_[n] < 0) return false;
  const int first = graph.node_first[n], last = graph.node_first[n + 1];
  int right = first;
  while (graph.node_darts[right] != dart) ++right;
  int left = right;
  do {
    right = right == first ? last - 1 : right - 1;
  } while (!border_[graph.node_darts[right] / 2]);
  do {
    left = left + 1 == last ? first : left + 1;
  } while (!border_[graph.node_darts[left] / 2]);
  // The chart's border comes in along the left one and goes out along the right one.
  const int in = dart_arc_[graph.node_darts[left] ^ 1], out = dart_arc_[graph.node_darts[right]];
  return checker.axis[in / 2] >= 0 && checker.axis[out / 2] >= 0 && checker.turn(charts, in, out) == 1;
}

std::vector<int> LabelScorer::sites_beside(const MacroGraph& graph, int a) const {
  std::vector<int> sites;
  for (int i = arc_darts_first_[a]; i < arc_darts_first_[a + 1]; ++i) {
    sites.push_back(graph.edges[arc_darts_[i] / 2].left);
    sites.push_back(graph.edges[arc_darts_[i] / 2].right);
  }
  std::sort(sites.begin(), sites.end());
  sites.erase(std::unique(sites.begin(), sites.end()), sites.end());
  return sites;
}

LabelScore LabelScorer::score(const MacroGraph& graph, const std::vector<Label>& labels) {
  LabelScore result;
  build_charts(graph, labels);
  checker.check(charts, size_);
  result.violations = checker.cost;
  for (int s = 0; s < graph.site_count(); ++s) {
    result.energy += graph.fidelity[s][labels[s]];
    result.defects += graph.defect[s][labels[s]];
  }
  for (int i = 0; i < graph.edge_count(); ++i) {
    const auto& e = graph.edges[i];
    const Label a = labels[e.left], b = labels[e.right];
    if (a == b) {
      result.energy += e.same;
      result.defects += e.same_defect;
      if (e.lost > 0 && (starts_in_quad(graph, 2 * i) || starts_in_quad(graph, 2 * i + 1))) result.energy += e.lost;
    } else {
      result.energy += e.differ + (a == opposite(b) ? e.opposed : 0);
    }
  }
  for (int a = 0; a < charts.arc_count(); ++a) result.defects += backward_defect(graph, a);
  return result;
}

void LabelScorer::blame(const MacroGraph& graph, const std::vector<Label>& labels, std::vector<double>& site_blame) const {
  const int sites = graph.site_count();
  site_blame.assign(sites, 0);
  const auto blame_arc = [&](int a, double weight) {
    const int count = arc_darts_first_[a + 1] - arc_darts_first_[a];
    for (int i = arc_darts_first_[a]; i < arc_darts_first_[a + 1]; ++i) {
      const auto& e = graph.edges[arc_darts_[i] / 2];
      site_blame[e.left] += weight / count;
      site_blame[e.right] += weight / count;
    }
  };
  const auto blame_chart = [&](int chart, double weight) {
    int count = 0;
    for (int s = 0; s < sites; ++s) count += site_chart[s] == chart;
    for (int s = 0; s < sites; ++s)
      if (site_chart[s] == chart) site_blame[s] += weight / std::sqrt(count);
  };
  for (const auto& issue : checker.issues) switch (issue.kind) {
      case ChartIssue::SameAxis:
      case ChartIssue::LoopNoCorner:
        blame_arc(issue.arc, issue.weight);
        break;
      case ChartIssue::NoBorder:
        blame_chart(issue.chart, issue.weight);
        break;
      case ChartIssue::IllegalCorner:
      case ChartIssue::CornerSigns: {
        const int n = corner_node_[issue.corner];
        for (int i = graph.node_first[n]; i < graph.node_first[n + 1]; ++i) site_blame[graph.left_of(graph.node_darts[i])] += issue.weight;
        break;
      }
      case ChartIssue::Turning:
        blame_chart(issue.chart, issue.weight);
        for (int i = charts.loop_first[issue.loop]; i < charts.loop_first[issue.loop + 1]; ++i)
          blame_arc(charts.loop_darts[i] / 2, 0.3 * issue.weight);
        break;
      case ChartIssue::SelfArc:
        blame_arc(issue.arc, issue.weight);
        blame_chart(issue.chart, 0.5 * issue.weight);
        break;
      case ChartIssue::Cycle:
        for (int i = issue.first; i < issue.last; ++i) blame_chart(checker.cycle_charts[i], issue.weight);
        for (int i = issue.first; i < issue.last; ++i)
          for (int a = 0; a < charts.arc_count(); ++a)
            if (charts.arcs[a].left == checker.cycle_charts[i] || charts.arcs[a].right == checker.cycle_charts[i])
              blame_arc(a, 0.2 * issue.weight);
        break;
    }
  for (int a = 0; a < charts.arc_count(); ++a)
    if (const double b = backward_defect(graph, a); b > 0) blame_arc(a, b);
  for (int s = 0; s < sites; ++s)
    if (const double q = graph.defect[s][labels[s]]; q > 0) {
      site_blame[s] += q;
      for (int i = graph.site_first[s]; i < graph.site_first[s + 1]; ++i) site_blame[graph.right_of(graph.site_darts[i])] += 0.2 * q;
    }
  for (const auto& e : graph.edges)
    if (labels[e.left] == labels[e.right] && e.same_defect > 0) {
      site_blame[e.left] += e.same_defect;
      site_blame[e.right] += e.same_defect;
    }
}

}  // namespace hexfeature
