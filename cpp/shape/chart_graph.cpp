// HexFeatureWB - LGPL-2.1-or-later
#include "shape/chart_graph.h"

#include <algorithm>
#include <cmath>

#include "shape/corner_table.h"

namespace hexfeature {

void ChartGraph::clear() {
  label.clear();
  arcs.clear();
  corner_first.assign(1, 0);
  corner_darts.clear();
  loop_first.assign(1, 0);
  loop_darts.clear();
  loop_chart.clear();
}

void ChartChecker::add(const ChartIssue& issue) {
  issues.push_back(issue);
  cost += issue.weight;
}

void ChartChecker::check(const ChartGraph& graph, double size) {
  issues.clear();
  cycle_charts.clear();
  cost = sign_cost = 0;

  // V1
  const int charts = graph.chart_count(), arcs = graph.arc_count();
  axis.resize(arcs);
  for (int a = 0; a < arcs; ++a) {
    const auto& arc = graph.arcs[a];
    const int left = axis_of(graph.label[arc.left]), right = axis_of(graph.label[arc.right]);
    axis[a] = static_cast<signed char>(left == right ? -1 : third_axis(left, right));
    ChartIssue issue{};
    issue.arc = a;
    if (left == right) {
      issue.kind = ChartIssue::SameAxis;
      add(issue);
    } else if (arc.start < 0) {
      issue.kind = ChartIssue::LoopNoCorner;
      add(issue);
    }
  }
  stack_.assign(charts, 0);
  for (int c : graph.loop_chart) stack_[c] = 1;
  for (int c = 0; c < charts; ++c)
    if (!stack_[c]) {
      ChartIssue issue{};
      issue.kind = ChartIssue::NoBorder;
      issue.chart = c;
      issue.weight = 2;
      add(issue);
    }

  choose_signs(graph, size);
  check_turnings(graph);
  check_order(graph);
}

unsigned ChartChecker::mask_at(const ChartGraph& graph, int corner) const {
  unsigned mask = 0;
  const int first = graph.corner_first[corner], last = graph.corner_first[corner + 1];
  for (int i = first; i < last; ++i) {
    const int d = graph.corner_darts[i];
    if ((sign[d / 2] > 0) == (d % 2 == 0)) mask |= 1u << (i - first);
  }
  return mask;
}

void ChartChecker::choose_signs(const ChartGraph& graph, double size) {
  constexpr double kClear = EIGEN_PI / 4;  // a dihedral from which on convexity is beyond doubt
  const int arcs = graph.arc_count(), corners = graph.corner_count();
  sign.resize(arcs);
  cost_plus_.resize(arcs);
  cost_minus_.resize(arcs);
  double cheapest = 0;
  for (int a = 0; a < arcs; ++a) {
    sign[a] = 0;
    cost_plus_[a] = cost_minus_[a] = 0;
    if (axis[a] < 0 || graph.arcs[a].start < 0) {
      if (axis[a] >= 0) sign[a] = 1;
      continue;
    }
    const auto& arc = graph.arcs[a];
    const double along = arc.displacement[axis[a]] / size;
    if (along > 0)
      cost_minus_[a] += std::min(3.0, along);
    else
      cost_plus_[a] += std::min(3.0, -along);
    // The dart runs along n_left x n_right where the edge is convex, against it where it is concave.
    const Label left = graph.label[arc.left], right = graph.label[arc.right];
    const int handed = (axis_of(right) - axis_of(left) + 3) % 3 == 1 ? 1 : -1;
    const int convex = handed * sign_of(left) * sign_of(right);
    const double doubt = std::min(1.0, std::abs(arc.dihedral) / kClear) * std::min(3.0, arc.length / size);
    if ((arc.dihedral > 0) == (convex > 0))
      cost_minus_[a] += doubt;
    else
      cost_plus_[a] += doubt;
    sign[a] = cost_plus_[a] <= cost_minus_[a] ? 1 : -1;
    cheapest += std::min(cost_plus_[a], cost_minus_[a]);
  }

  legal_.resize(corners);
  Label labels[kMaxCornerValence];
  int conflicts = 0;
  const auto allows = [](const Signs& s, unsigned mask) { return std::find(s.begin, s.end, mask) != s.end; };
  for (int c = 0; c < corners; ++c) {
    const int first = graph.corner_first[c], valence = graph.corner_first[c + 1] - first;
    CornerSigns signs;
    if (valence <= kMaxCornerValence) {
      for (int i = 0; i < valence; ++i) labels[i] = graph.label[graph.left_of(graph.corner_darts[first + i])];
      signs = corner_signs(labels, valence);
    }
    legal_[c] = {signs.begin, signs.end};
    if (!signs.empty() && !allows(legal_[c], mask_at(graph, c))) ++conflicts;
  }

  // Min-conflicts: the first corner in conflict takes the legal signs that leave the fewest conflicts at the least cost;
  // arcs flipped often become dear, so that the walk does not turn in a circle.
  const auto in_conflict = [&](int c) { return c >= 0 && legal_[c].begin != legal_[c].end && !allows(legal_[c], mask_at(graph, c)); };
  if (conflicts > 0) {
    best_sign_ = sign;
    flips_.assign(arcs, 0);
    int best_conflicts = conflicts, cursor = 0;
    double walk = cheapest, best_walk = cheapest;
    const int bound = 24 + 6 * conflicts;
    const auto cost_of = [&](int a) { return sign[a] > 0 ? cost_plus_[a] : cost_minus_[a]; };
    const auto flip = [&](int a) {
      const auto& arc = graph.arcs[a];
      conflicts -= in_conflict(arc.start) + (arc.end != arc.start && in_conflict(arc.end));
      walk -= cost_of(a);
      sign[a] = static_cast<signed char>(-sign[a]);
      walk += cost_of(a);
      conflicts += in_conflict(arc.start) + (arc.end != arc.start && in_conflict(arc.end));
    };
    const auto apply = [&](int c, unsigned mask) {
      const int first = graph.corner_first[c], last = graph.corner_first[c + 1];
      for (int i = first; i < last; ++i) {
        const int d = graph.corner_darts[i];
        const int wanted = ((mask >> (i - first)) & 1) == (d % 2 == 0 ? 1u : 0u) ? 1 : -1;
        if (sign[d / 2] != wanted) flip(d / 2);
      }
    };
    for (int step = 0; step < bound && conflicts > 0; ++step) {
      int c = cursor;
      while (!in_conflict(c)) c = (c + 1) % corners;
      cursor = (c + 1) % corners;
      const unsigned before = mask_at(graph, c);
      unsigned chosen = before;
      double chosen_score = 1e300;
      for (const unsigned char* m = legal_[c].begin; m != legal_[c].end; ++m) {
        double tired = 0;
        const int first = graph.corner_first[c], last = graph.corner_first[c + 1];
        for (int i = first; i < last; ++i)
          if (((before ^ *m) >> (i - first)) & 1u) tired += flips_[graph.corner_darts[i] / 2];
        apply(c, *m);
        const double score = 8.0 * conflicts + walk + 2.0 * tired;
        const bool reached = mask_at(graph, c) == *m;  // not when both ends of one arc are here and would differ
        apply(c, before);
        if (reached && score < chosen_score) {
          chosen_score = score;
          chosen = *m;
        }
      }
      if (chosen == before) continue;
      const int first = graph.corner_first[c], last = graph.corner_first[c + 1];
      for (int i = first; i < last; ++i)
        if (((before ^ chosen) >> (i - first)) & 1u) ++flips_[graph.corner_darts[i] / 2];
      apply(c, chosen);
      if (conflicts < best_conflicts || (conflicts == best_conflicts && walk < best_walk)) {
        best_conflicts = conflicts;
        best_walk = walk;
        best_sign_ = sign;
      }
    }
    sign = best_sign_;
    walk = 0;
    for (int a = 0; a < arcs; ++a)
      if (sign[a] != 0) walk += cost_of(a);
    sign_cost = walk - cheapest;
  }
  for (int c = 0; c < corners; ++c) {
    ChartIssue issue{};
    issue.corner = c;
    if (legal_[c].begin == legal_[c].end) {
      issue.kind = ChartIssue::IllegalCorner;
      add(issue);
    } else if (in_conflict(c)) {
      issue.kind = ChartIssue::CornerSigns;
      add(issue);
    }
  }
}

int ChartChecker::turn(const ChartGraph& graph, int d, int e) const {
  const int ad = axis[d / 2], ae = axis[e / 2];
  const int sd = d % 2 == 0 ? sign[d / 2] : -sign[d / 2], se = e % 2 == 0 ? sign[e / 2] : -sign[e / 2];
  if (ad == ae) return sd == se ? 0 : -2;
  // Left turn: e = normal x d.
  const Label normal = graph.label[graph.left_of(d)];
  const int handed = (ad - axis_of(normal) + 3) % 3 == 1 ? 1 : -1;
  return handed * sign_of(normal) * sd == se ? 1 : -1;
}

void ChartChecker::check_turnings(const ChartGraph& graph) {
  // Left turns minus right turns of every loop, in quarter turns; kNone where it cannot be told.
  constexpr int kNone = 1000;
  const int loops = graph.loop_count(), charts = graph.chart_count();
  stack_.assign(loops, kNone);  // turning per loop
  order_.assign(charts, -1);    // the chart's outer loop: the one that turns most
  for (int l = 0; l < loops; ++l) {
    const int first = graph.loop_first[l], last = graph.loop_first[l + 1];
    int turning = 0;
    bool known = true;
    for (int i = first; i < last && known; ++i) {
      const int d = graph.loop_darts[i], e = graph.loop_darts[i + 1 < last ? i + 1 : first];
      if (axis[d / 2] < 0 || axis[e / 2] < 0 || graph.start_of(e) < 0) {
        known = false;
        break;
      }
      turning += turn(graph, d, e);
    }
    if (!known) continue;
    stack_[l] = turning;
    int& outer = order_[graph.loop_chart[l]];
    if (outer < 0 || turning > stack_[outer]) outer = l;
  }
  // A chart one of whose loops is unknown has an issue already; its outer loop may be the unknown one.
  low_.assign(charts, 0);
  for (int l = 0; l < loops; ++l)
    if (stack_[l] == kNone) low_[graph.loop_chart[l]] = 1;
  for (int l = 0; l < loops; ++l) {
    const int turning = stack_[l], chart = graph.loop_chart[l];
    if (turning == kNone) continue;
    const int wanted = order_[chart] == l && !(low_[chart] && turning == -4) ? 4 : -4;
    if (turning == wanted) continue;
    ChartIssue issue{};
    issue.kind = ChartIssue::Turning;
    issue.chart = chart;
    issue.loop = l;
    issue.turning = turning;
    issue.weight = std::min(1.5, 0.5 + 0.125 * std::abs(turning - wanted));
    add(issue);
  }
}

void ChartChecker::check_order(const ChartGraph& graph) {
  const int charts = graph.chart_count(), corners = graph.corner_count(), arcs = graph.arc_count();
  // Charts of one axis at a legal corner have one coordinate: union them.
  component_.resize(charts);
  for (int c = 0; c < charts; ++c) component_[c] = c;
  const auto root = [&](int c) {
    while (component_[c] != c) c = component_[c] = component_[component_[c]];
    return c;
  };
  stack_.assign(3 * corners, -1);  // per corner and axis: a chart of that axis
  for (int c = 0; c < corners; ++c)
    for (int i = graph.corner_first[c]; i < graph.corner_first[c + 1]; ++i) {
      const int chart = graph.left_of(graph.corner_darts[i]);
      int& known = stack_[3 * c + axis_of(graph.label[chart])];
      if (known < 0) {
        known = chart;
      } else if (legal_[c].begin != legal_[c].end) {
        const int a = root(known), b = root(chart);
        component_[std::max(a, b)] = std::min(a, b);
      }
    }

  // One edge low -> high per arc, as a linked list: low_ = head per chart, successor_ = next, order_ = high end, parent_ = arc.
  low_.assign(charts, -1);
  successor_.clear();
  order_.clear();
  for (int a = 0; a < arcs; ++a) {
    const auto& arc = graph.arcs[a];
    if (axis[a] < 0 || arc.start < 0) continue;
    int low = stack_[3 * arc.start + axis[a]], high = stack_[3 * arc.end + axis[a]];
    if (low < 0 || high < 0) continue;
    low = root(low);
    high = root(high);
    if (low == high) {
      ChartIssue issue{};
      issue.kind = ChartIssue::SelfArc;
      issue.arc = a;
      issue.chart = low;
      add(issue);
      continue;
    }
    if (sign[a] < 0) std::swap(low, high);
    order_.push_back(high);
    successor_.push_back(low_[low]);
    low_[low] = static_cast<int>(order_.size()) - 1;
  }

  // Every edge asks for a difference >= 1, so a positive cycle is a cycle. Peel off charts without a predecessor; what
  // is left contains every cycle (and what lies above one); then peel from above.
  degree_first_.assign(charts, 0);
  for (int h : order_) ++degree_first_[h];
  stack_.clear();
  flips_.assign(charts, 1);  // 1: still there
  int left = 0;
  for (int c = 0; c < charts; ++c) {
    if (component_[c] != c) {
      flips_[c] = 0;
      continue;
    }
    ++left;
    if (degree_first_[c] == 0) stack_.push_back(c);
  }
  while (!stack_.empty()) {
    const int c = stack_.back();
    stack_.pop_back();
    flips_[c] = 0;
    --left;
    for (int e = low_[c]; e >= 0; e = successor_[e])
      if (--degree_first_[order_[e]] == 0) stack_.push_back(order_[e]);
  }
  // Shortest cycles first, each once: take a shortest cycle, remove its charts, look again.
  while (left > 0) {
    int best_length = charts + 1;
    best_cycle_.clear();
    for (int s = 0; s < charts; ++s) {
      if (!flips_[s]) continue;
      parent_.assign(charts, -1);
      stack_.assign(1, s);
      bool closed = false;
      for (std::size_t q = 0; q < stack_.size() && !closed; ++q)
        for (int e = low_[stack_[q]]; e >= 0; e = successor_[e]) {
          const int to = order_[e];
          if (!flips_[to] || (to != s && parent_[to] >= 0)) continue;
          parent_[to] = stack_[q];
          if (to == s) {
            closed = true;
            break;
          }
          stack_.push_back(to);
        }
      if (!closed) {
        flips_[s] = 0;  // on no cycle of what is left
        --left;
        continue;
      }
      int length = 0;
      for (int c = parent_[s]; c != s; c = parent_[c]) ++length;
      if (++length < best_length) {
        best_length = length;
        best_cycle_.assign(1, s);
        for (int c = parent_[s]; c != s; c = parent_[c]) best_cycle_.push_back(c);
        if (length == 2) break;
      }
    }
    if (best_cycle_.empty()) break;
    ChartIssue issue{};
    issue.kind = ChartIssue::Cycle;
    issue.first = static_cast<int>(cycle_charts.size());
    for (auto c = best_cycle_.rbegin(); c != best_cycle_.rend(); ++c) {
      cycle_charts.push_back(*c);
      flips_[*c] = 0;
      --left;
    }
    issue.last = static_cast<int>(cycle_charts.size());
    issue.chart = cycle_charts[issue.first];
    add(issue);
  }
}

}  // namespace hexfeature
