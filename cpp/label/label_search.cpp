// HexFeatureWB - LGPL-2.1-or-later
#include "label/label_search.h"

#include <algorithm>
#include <cmath>

#include "base/fingerprint.h"

namespace hexfeature {
namespace {

constexpr double kDefectWeight = 0.8, kEnergyWeight = 3, kSplitWeight = 0.1, kFillWeight = 0.75;
constexpr double kPutBack = 0.12;      // a state put back for its next candidates is worse by this
constexpr std::size_t kOpen = 20000;   // states kept waiting
constexpr std::size_t kChildren = 60;  // best children of one expansion that are kept
constexpr int kSitesPerExpansion = 14;
constexpr int kSplitSites = 5;
constexpr std::size_t kTurnCuts = 8;              // cuts where an arc turns back, of one expansion
constexpr double kTilted = 0.01;                  // faces nearer to square with an axis are split only in later phases
constexpr double kKnife = 60 * EIGEN_PI / 180;    // opposite labels at an edge that bends more may get a rim between them
constexpr std::size_t kRims = 8;                  // such edges of one expansion
constexpr double kRimWidths[] = {0.15, 0.35, 1};  // of a rim, in h
constexpr int kCombined = 12;                     // relabellings of one expansion that are tried together
constexpr double kClean = 0.25;                   // defects that a relabelling that cures a violation may add and still be clean
constexpr double kLeastCosine = -0.3;             // a site never takes a label that its normals oppose more
constexpr int kAfterBest = 4;                     // expansions spent on improving a filled state ...
constexpr int kAfterBestDefects = 12;             // ... and so many more when it has a defect too many
constexpr double kFillWork = 1e5;                 // counted work of one fill check ...
constexpr double kRoundWork = 4e4;                // ... and of each of its rounds
constexpr int kThoroughFills = 3;                 // so many fill checks may take their time
constexpr double kSplitWork = 1.5;                // ... of one split, per triangle of the surface
constexpr double kImproveWork = 3e7;              // counted work spent on improving a filled state
constexpr double kTangent = 20 * EIGEN_PI / 180;

double total_of(const LabelState& s, const CutTree& tree) {
  return s.score.violations + kDefectWeight * s.score.defects + kEnergyWeight * s.score.energy + kSplitWeight * tree.splits(s.cutting) +
         (s.fill_tried && !s.filled ? kFillWeight : 0);
}

double useful_key(const LabelState& s) { return s.total - 0.8 * s.score.violations + 2 * s.score.defects + kPutBack * s.phase; }

/// Whether a relabelling cures a violation at little cost in defects.
bool is_clean(const LabelState& before, const LabelState& after) {
  const double cured = before.score.violations - after.score.violations, added = after.score.defects - before.score.defects;
  return cured > 0.9 && added < kClean;
}

std::uint64_t hash_of(const LabelState& s) {
  Fingerprint print;
  print.take(static_cast<std::uint64_t>(s.cutting));
  for (Label l : s.labels) print.take(static_cast<std::uint64_t>(l));
  return print.value();
}

}  // namespace

LabelSearch::LabelSearch(CutTree& tree, const SearchOptions& options, FillSites fill, Context& context)
    : tree_(tree), options_(options), fill_(std::move(fill)), context_(context), scorer_(options.size, options.fold_tolerance) {}

/// Score a state; false when it was seen before.
bool LabelSearch::evaluate(LabelState& state) {
  if (!seen_.insert(hash_of(state)).second || tree_.redundant(state.cutting, state.labels)) return false;
  judge(state);
  if ((result_.scored & 255) == 0) context_.check();
  return true;
}

void LabelSearch::judge(LabelState& state) {
  const MacroGraph& graph = tree_.graph(state.cutting);
  state.score = scorer_.score(graph, state.labels);
  state.fill_tried = state.filled = false;
  state.fill_blame.clear();
  for (const auto& labels : unfillable_) {
    const auto same = [&](const std::pair<int, Label>& l) {
      return l.first < static_cast<int>(state.labels.size()) && state.labels[l.first] == l.second;
    };
    if (!std::all_of(labels.begin(), labels.end(), same)) continue;
    state.fill_tried = true;
    for (const auto& l : labels) state.fill_blame.push_back(l.first);
    break;
  }
  state.total = total_of(state, tree_);
  ++result_.scored;
  result_.work += graph.edge_count() + graph.site_count();
}

/// Remember the labels of the sites that a failed fill blames, and of their neighbours.
void LabelSearch::learn(const LabelState& state) {
  constexpr std::size_t kRemembered = 100;
  const MacroGraph& graph = tree_.graph(state.cutting);
  scorer_.score(graph, state.labels);
  const std::vector<int>& chart = scorer_.site_chart;
  std::vector<int> blamed(graph.site_count(), 0);
  for (int s : state.fill_blame) blamed[s] = 1;
  int charts = 0;
  std::vector<char> counted(scorer_.charts.chart_count(), 0);
  for (int s : state.fill_blame)
    if (!counted[chart[s]]) counted[chart[s]] = 1, ++charts;
  // Of the neighbours those count that touch two of the charts: there the charts are in each other's way.
  std::vector<char> involved(graph.site_count(), 0);
  for (int s = 0; s < graph.site_count(); ++s) {
    int touched = -1;
    for (int i = graph.site_first[s]; i < graph.site_first[s + 1] && !involved[s]; ++i) {
      const int t = graph.right_of(graph.site_darts[i]);
      if (!blamed[t]) continue;
      involved[s] = blamed[s] || charts == 1 || (touched >= 0 && touched != chart[t]);
      touched = chart[t];
    }
    involved[s] = involved[s] || blamed[s];
  }
  std::vector<std::pair<int, Label>> labels;
  for (int s = 0; s < graph.site_count(); ++s)
    if (involved[s]) labels.emplace_back(s, state.labels[s]);
  if (!labels.empty() && unfillable_.size() < kRemembered) unfillable_.push_back(std::move(labels));
}

void LabelSearch::push(LabelState&& state) {
  if (!have_best_ && (result_.best.labels.empty() || state.score.violations < result_.best.score.violations - 1e-12 ||
                      (state.score.violations < result_.best.score.violations + 1e-12 && state.total < result_.best.total - 1e-12)))
    result_.best = state;
  const int id = static_cast<int>(states_.size());
  open_.emplace(state.total + kPutBack * state.phase, id);
  open_useful_.emplace(useful_key(state), id);
  states_.push_back(std::move(state));
  if (open_.size() > kOpen) {
    const int worst = std::prev(open_.end())->second;
    open_.erase(std::prev(open_.end()));
    open_useful_.erase({useful_key(states_[worst]), worst});
    states_[worst] = {};
  }
}

LabelState LabelSearch::pop() {
  const int id = (result_.expansions % 2 == 0 ? open_ : open_useful_).begin()->second;
  LabelState state = std::move(states_[id]);
  open_.erase({state.total + kPutBack * state.phase, id});
  open_useful_.erase({useful_key(state), id});
  return state;
}

std::vector<Label> LabelSearch::nearest_labels(const MacroGraph& graph) const {
  std::vector<Label> labels(graph.site_count());
  for (int s = 0; s < graph.site_count(); ++s)
    labels[s] = static_cast<Label>(std::min_element(graph.fidelity[s].begin(), graph.fidelity[s].end()) - graph.fidelity[s].begin());
  return labels;
}

/// Iterated conditional modes: every site in turn takes the label that is cheapest given its neighbours.
void LabelSearch::iterate_modes(const MacroGraph& graph, std::vector<Label>& labels, double differ) const {
  constexpr double kDefect = kDefectWeight / kEnergyWeight;
  for (int sweep = 0; sweep < 20; ++sweep) {
    bool changed = false;
    for (int s = 0; s < graph.site_count(); ++s) {
      std::array<double, 6> cost;
      for (Label l = 0; l < 6; ++l) cost[l] = graph.fidelity[s][l] + kDefect * graph.defect[s][l];
      for (int i = graph.site_first[s]; i < graph.site_first[s + 1]; ++i) {
        const int d = graph.site_darts[i];
        const auto& e = graph.edges[d / 2];
        const Label other = labels[graph.right_of(d)];
        for (Label l = 0; l < 6; ++l)
          cost[l] += l == other ? e.same + kDefect * e.same_defect : differ * e.differ + (l == opposite(other) ? e.opposed : 0);
      }
      const Label best = static_cast<Label>(std::min_element(cost.begin(), cost.end()) - cost.begin());
      if (cost[best] < cost[labels[s]] - 1e-12) {
        labels[s] = best;
        changed = true;
      }
    }
    if (!changed) break;
  }
}

/// A small site surrounded by one label takes it, or lends its own to a neighbour, if violations fall and defects hardly rise.
void LabelSearch::merge_islands(LabelState& state) {
  const MacroGraph& graph = tree_.graph(state.cutting);
  const double small = options_.size * options_.size;
  for (int s = 0; s < graph.site_count(); ++s) {
    if (graph.area[s] > small || graph.site_first[s] == graph.site_first[s + 1]) continue;
    const Label round = state.labels[graph.right_of(graph.site_darts[graph.site_first[s]])];
    bool alone = round != state.labels[s];
    for (int i = graph.site_first[s]; i < graph.site_first[s + 1] && alone; ++i)
      alone = state.labels[graph.right_of(graph.site_darts[i])] == round;
    if (!alone) continue;
    const auto attempt = [&](int site, Label label) {
      LabelState next = state;
      next.labels[site] = label;
      next.score = scorer_.score(graph, next.labels);
      ++result_.scored;
      if (next.score.violations > state.score.violations - 1e-9 || next.score.defects > state.score.defects + 0.05) return false;
      state = std::move(next);
      return true;
    };
    if (attempt(s, round)) continue;
    for (int i = graph.site_first[s]; i < graph.site_first[s + 1]; ++i) {
      const int t = graph.right_of(graph.site_darts[i]);
      if (graph.cosine[t][state.labels[s]] > 0.3 && attempt(t, state.labels[s])) break;
    }
  }
  state.total = total_of(state, tree_);
}

void LabelSearch::push_starts() {
  const MacroGraph& graph = tree_.graph(0);
  std::vector<std::vector<Label>> starts = {nearest_labels(graph)};
  for (double differ : {0.3, 1.0, 3.0}) {
    starts.push_back(starts.front());
    iterate_modes(graph, starts.back(), differ);
  }
  std::vector<LabelState> states;
  for (auto& labels : starts) {
    LabelState state;
    state.labels = std::move(labels);
    if (!evaluate(state)) continue;
    LabelState merged = state;
    merge_islands(merged);
    states.push_back(std::move(state));
    if (evaluate(merged)) states.push_back(std::move(merged));
  }
  // A valid start that fills is something to fall back on, however many defects it has.
  std::stable_sort(states.begin(), states.end(), [](const LabelState& a, const LabelState& b) { return a.total < b.total; });
  for (LabelState& state : states) {
    if (have_best_ || !state.score.valid()) continue;
    fill(state, result_.fills < kThoroughFills);
    if (state.filled) keep_best(state);
  }
  for (LabelState& state : states) push(std::move(state));
}

void LabelSearch::keep_best(const LabelState& state) {
  if (have_best_ && state.total >= result_.best.total - 1e-12) return;
  if (!have_best_) improve_until_ = result_.work + kImproveWork;
  have_best_ = true;
  result_.best = state;
}

void LabelSearch::fill(LabelState& state, bool thorough) {
  ++result_.fills;
  Fill filled = fill_(state.cutting, state.labels, thorough);
  result_.work += kFillWork + kRoundWork * filled.rounds;
  state.fill_tried = true;
  state.filled = filled.ok;
  state.fill_blame = std::move(filled.sites);
  state.total = total_of(state, tree_);
  if (filled.ok) return;
  learn(state);
  if (thorough) return;
  unfilled_.push_back(state);
  std::stable_sort(unfilled_.begin(), unfilled_.end(), [](const LabelState& a, const LabelState& b) { return a.total < b.total; });
  if (unfilled_.size() > kThoroughFills) unfilled_.pop_back();
}

/// When nothing has filled: the best valid states once more, with all means.
void LabelSearch::fill_the_rest() {
  std::vector<LabelState> states = std::move(unfilled_);
  for (LabelState& state : states) {
    if (have_best_) return;
    fill(state, true);
    if (state.filled) keep_best(state);
  }
}

bool LabelSearch::finished() const {
  return open_.empty() || result_.expansions >= options_.max_expansions || result_.work > options_.max_work ||
         (have_best_ && (result_.work > improve_until_ || result_.best.score.defects < options_.good_defects)) ||
         (have_best_ && after_best_ > kAfterBest + kAfterBestDefects * std::min(1.0, std::max(0.0, result_.best.score.defects - 0.4)));
}

/// Sites in the order in which they are worth changing: the most blamed one, the blamed ones that touch it and each other, then the next
/// cluster: independent defects are repaired one after another, not in all orders at once.
std::vector<int> LabelSearch::sites_to_repair(const LabelState& state) {
  const MacroGraph& graph = tree_.graph(state.cutting);
  scorer_.score(graph, state.labels);
  scorer_.blame(graph, state.labels, blame_);
  for (int s : state.fill_blame) blame_[s] += kFillWeight;
  std::vector<int> blamed, order;
  for (int s = 0; s < graph.site_count(); ++s)
    if (blame_[s] > 1e-9) blamed.push_back(s);
  const auto more = [&](int a, int b) { return blame_[a] != blame_[b] ? blame_[a] > blame_[b] : a < b; };
  std::sort(blamed.begin(), blamed.end(), more);
  std::vector<char> taken(graph.site_count(), 0);
  for (int seed : blamed) {
    if (taken[seed]) continue;
    std::vector<int> front = {seed};
    taken[seed] = 1;
    while (!front.empty()) {
      const auto top = std::min_element(front.begin(), front.end(), more);
      const int s = *top;
      front.erase(top);
      order.push_back(s);
      for (int i = graph.site_first[s]; i < graph.site_first[s + 1]; ++i) {
        const int t = graph.right_of(graph.site_darts[i]);
        if (taken[t] || blame_[t] <= 1e-9) continue;
        taken[t] = 1;
        front.push_back(t);
      }
    }
  }
  return order;
}

void LabelSearch::expand_labels(const LabelState& state, const int* first, const int* last) {
  const MacroGraph& graph = tree_.graph(state.cutting);
  scorer_.score(graph, state.labels);
  const std::vector<int> site_chart = scorer_.site_chart;
  std::vector<int> group;
  const auto relabel = [&](const std::vector<int>& sites) {
    double area = 0;
    std::array<double, 6> cosine{};
    for (int s : sites) {
      area += graph.area[s];
      for (Label l = 0; l < 6; ++l) cosine[l] += graph.area[s] * graph.cosine[s][l];
    }
    for (Label l = 0; l < 6; ++l) {
      if (cosine[l] <= kLeastCosine * area) continue;
      LabelState child;
      child.cutting = state.cutting;
      child.labels = state.labels;
      for (int s : sites) child.labels[s] = l;
      if (evaluate(child)) children_.push_back(std::move(child));
    }
  };
  for (const int* p = first; p != last; ++p) {
    const int s = *p;
    relabel({s});
    group.clear();
    for (int t = 0; t < graph.site_count(); ++t)
      if (site_chart[t] == site_chart[s]) group.push_back(t);
    if (group.size() > 1) relabel(group);
    group.clear();
    for (int t = 0; t < graph.site_count(); ++t)
      if (graph.face[t] == graph.face[s]) group.push_back(t);
    if (group.size() > 1) relabel(group);
    for (int i = graph.site_first[s]; i < graph.site_first[s + 1]; ++i) {
      const int d = graph.site_darts[i], t = graph.right_of(d);
      if (std::abs(graph.edges[d / 2].dihedral) < kTangent || graph.face[t] == graph.face[s]) relabel({s, t});
    }
  }
}

/// Independent defects have independent cures: put the best relabellings of an expansion together, one after another, as long as that
/// helps.
void LabelSearch::combine_children(const LabelState& state) {
  std::vector<int> order;
  for (int i = 0; i < static_cast<int>(children_.size()); ++i)
    if (is_clean(state, children_[i]) || (state.score.valid() && children_[i].score.valid() && children_[i].total < state.total - 0.1))
      order.push_back(i);
  if (order.size() < 2) return;
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return children_[a].total < children_[b].total; });
  LabelState combined = children_[order.front()];
  std::vector<char> touched(state.labels.size(), 0);
  const auto touch = [&](const LabelState& child) {
    for (std::size_t s = 0; s < state.labels.size(); ++s) touched[s] = touched[s] || child.labels[s] != state.labels[s];
  };
  touch(combined);
  int added = 0;
  for (int i : order) {
    const LabelState& child = children_[i];
    bool apart = true;
    for (std::size_t s = 0; s < state.labels.size() && apart; ++s) apart = child.labels[s] == state.labels[s] || !touched[s];
    if (!apart) continue;
    LabelState next = combined;
    for (std::size_t s = 0; s < state.labels.size(); ++s)
      if (child.labels[s] != state.labels[s]) next.labels[s] = child.labels[s];
    judge(next);
    if (next.total >= combined.total - 0.05) continue;
    combined = std::move(next);
    touch(combined);
    if (++added >= kCombined) break;
  }
  if (added > 0 && evaluate(combined)) children_.push_back(std::move(combined));
}

void LabelSearch::split(const LabelState& state, const SiteCut& cut) {
  result_.work += kSplitWork * tree_.regions(0).mesh.triangle_count();
  context_.check();
  const int cutting = tree_.child(state.cutting, cut);
  if (cutting < 0) return;
  const MacroGraph& graph = tree_.graph(cutting);
  const int old_sites = static_cast<int>(state.labels.size());
  std::vector<Label> labels = state.labels;
  labels.resize(graph.site_count(), state.labels[cut.site]);
  std::vector<int> parts = {cut.site};
  for (int s = old_sites; s < graph.site_count(); ++s) parts.push_back(s);
  for (int p : parts)
    for (Label l = 0; l < 6; ++l) {
      if (l == labels[p] || graph.cosine[p][l] <= kLeastCosine) continue;
      LabelState child;
      child.cutting = cutting;
      child.labels = labels;
      child.labels[p] = l;
      if (evaluate(child)) children_.push_back(std::move(child));
    }
  if (parts.size() < 3) return;
  for (int kept : parts)  // all parts but one together: a cut often leaves two pieces on one side
    for (Label l = 0; l < 6; ++l) {
      LabelState child;
      child.cutting = cutting;
      child.labels = labels;
      for (int p : parts)
        if (p != kept) child.labels[p] = l;
      if (l != labels[cut.site] && evaluate(child)) children_.push_back(std::move(child));
    }
}

/// Cuts, across the axis of an arc that runs back, through the points where it turns: the sites beside it fall apart there, and
/// another label on one part gives the turn the corner that it needs.
std::vector<SiteCut> LabelSearch::cuts_at_turns(const LabelState& state, const int* first, const int* last) {
  const MacroGraph& graph = tree_.graph(state.cutting);
  const double h = options_.size;
  scorer_.score(graph, state.labels);
  std::vector<SiteCut> cuts;
  for (int a = 0; a < scorer_.charts.arc_count(); ++a) {
    const auto back = scorer_.backward(graph, a);
    if (back.length <= scorer_.fold_tolerance() * h) continue;
    for (int s : scorer_.sites_beside(graph, a)) {
      if (std::find(first, last, s) == last) continue;
      const int axis = scorer_.checker.axis[a];
      for (double c : {back.from, back.to}) {
        if (c < graph.low[s][axis] + 0.05 * h || c > graph.high[s][axis] - 0.05 * h) continue;
        SiteCut cut;
        cut.kind = SiteCut::Across;
        cut.site = s;
        cut.axis = axis;
        cut.coordinate = c;
        cuts.push_back(cut);
        if (cuts.size() >= kTurnCuts) return cuts;
      }
    }
  }
  return cuts;
}

/// Sharp edges between opposite labels: where two holes graze each other, or a hole comes out through a face at a small angle, the
/// solid ends in a knife edge between two faces that rightly have opposite labels.
std::vector<LabelSearch::KnifeEdge> LabelSearch::knife_edges(const LabelState& state) {
  const MacroGraph& graph = tree_.graph(state.cutting);
  scorer_.score(graph, state.labels);
  std::vector<KnifeEdge> edges;
  for (const auto& issue : scorer_.checker.issues) {
    if (issue.kind != ChartIssue::SameAxis) continue;
    const auto& arc = scorer_.charts.arcs[issue.arc];
    if (std::abs(arc.dihedral) < kKnife) continue;
    KnifeEdge edge;
    for (int s : scorer_.sites_beside(graph, issue.arc)) edge.sides[scorer_.site_chart[s] == arc.left ? 0 : 1].push_back(s);
    edges.push_back(std::move(edge));
  }
  return edges;
}

/// The state with a rim on one side of a knife edge; false when there is no room for one, or it was seen before.
bool LabelSearch::add_rim(const LabelState& state, const KnifeEdge& edge, int side, double width, LabelState& child) {
  child.cutting = state.cutting;
  child.labels.assign(state.labels.begin(), state.labels.end());
  for (int s : edge.sides[side]) {
    SiteCut cut;
    cut.kind = SiteCut::Rim;
    cut.site = s;
    cut.axis = axis_of(state.labels[s]);
    cut.width = width;
    cut.beyond = edge.sides[1 - side];
    result_.work += kSplitWork * tree_.regions(0).mesh.triangle_count();
    context_.check();
    const int cutting = tree_.child(child.cutting, cut);
    if (cutting < 0) continue;
    child.cutting = cutting;
    const std::vector<Label>& rim = tree_.rim_labels(cutting);
    child.labels.resize(rim.size(), state.labels[s]);
    for (std::size_t i = 0; i < rim.size(); ++i)
      if (rim[i] != kNoLabel) child.labels[i] = rim[i];
  }
  return child.cutting != state.cutting && evaluate(child);
}

/// At a knife edge a polycube has a narrow wall between the two faces: a rim along it, on one side or the other. The best rim of an
/// edge is kept for the next one: knife edges seldom come alone, and their cures are independent.
void LabelSearch::expand_rims(const LabelState& state, const int* first, const int* last) {
  LabelState current = state;
  std::size_t at = 0;
  for (std::size_t rims = 0; rims < kRims; ++rims) {
    const std::vector<KnifeEdge> edges = knife_edges(current);
    if (rims == 0) {  // only where this expansion looks
      const auto looked_at = [&](int s) { return std::find(first, last, s) != last; };
      const auto near = [&](const KnifeEdge& e) {
        return std::any_of(e.sides[0].begin(), e.sides[0].end(), looked_at) || std::any_of(e.sides[1].begin(), e.sides[1].end(), looked_at);
      };
      while (at < edges.size() && !near(edges[at])) ++at;
    }
    if (at >= edges.size()) break;
    LabelState best;
    for (int side = 0; side < 2; ++side)
      for (double width : kRimWidths) {
        LabelState child;
        if (!add_rim(current, edges[at], side, width * options_.size, child)) continue;
        if (best.labels.empty() || child.total < best.total) best = child;
        children_.push_back(std::move(child));
      }
    if (best.labels.empty() || best.total > current.total - 1e-3)
      ++at;
    else
      current = std::move(best);
  }
}

void LabelSearch::expand_splits(const LabelState& state, const int* first, const int* last) {
  const double h = options_.size;
  if (options_.rims && state.phase == 0 && !state.score.valid()) expand_rims(state, first, last);
  const std::vector<SiteCut> turns = cuts_at_turns(state, first, last);
  for (const SiteCut& cut : turns) split(state, cut);
  // Of a valid state's defects those are the ones that other splits cannot cure.
  if (state.score.valid() && !turns.empty() && state.phase == 0) return;
  // Tilted faces first: a part of a face square to an axis can only be flattened.
  const MacroGraph& graph = tree_.graph(state.cutting);
  std::vector<int> sites(first, last);
  std::stable_sort(sites.begin(), sites.end(),
                   [&](int a, int b) { return blame_[a] * (0.3 + graph.tilt[a]) > blame_[b] * (0.3 + graph.tilt[b]); });
  if (static_cast<int>(sites.size()) > kSplitSites) sites.resize(kSplitSites);

  for (int s : sites) {
    if (graph.area[s] < 0.1 * h * h || (state.phase == 0 && graph.tilt[s] < kTilted)) continue;
    const Vec3 low = graph.low[s], high = graph.high[s];
    const std::vector<int> darts(graph.site_darts.begin() + graph.site_first[s], graph.site_darts.begin() + graph.site_first[s + 1]);
    for (int d : darts) {
      const double extent = tree_.extent(state.cutting, d);
      SiteCut cut;
      cut.kind = SiteCut::Strip;
      cut.site = s;
      cut.dart = d;
      cut.width = std::min(0.5 * extent, std::max(1.3 * h, 0.3 * extent));
      if (cut.width > 0.1 * h) split(state, cut);
    }
    for (int axis = 0; axis < 3; ++axis) {
      if (high[axis] - low[axis] < 0.8 * h) continue;
      SiteCut cut;
      cut.kind = SiteCut::Across;
      cut.site = s;
      cut.axis = axis;
      cut.coordinate = 0.5 * (low[axis] + high[axis]);
      split(state, cut);
    }
    SiteCut cut;
    cut.kind = SiteCut::Creases;
    cut.site = s;
    cut.degrees = 10;
    split(state, cut);
  }
}

/// Label moves on the best state that lower its total while it stays valid and still fills.
void LabelSearch::polish() {
  if (!have_best_) return;
  const MacroGraph& graph = tree_.graph(result_.best.cutting);
  LabelState state = result_.best;
  int accepted = 0;
  for (int sweep = 0; sweep < 3; ++sweep) {
    const int before = accepted;
    for (int s = 0; s < graph.site_count(); ++s) {
      for (Label l = 0; l < 6; ++l) {
        if (l == state.labels[s] || graph.cosine[s][l] < 0.17) continue;
        LabelState next = state;
        next.labels[s] = l;
        next.score = scorer_.score(graph, next.labels);
        next.total = total_of(next, tree_);
        result_.work += graph.edge_count();
        if (!next.score.valid() || next.total > state.total - 1e-4) continue;
        state = std::move(next);
        ++accepted;
      }
      if ((s & 15) == 0) context_.check();
    }
    if (accepted == before) break;
  }
  if (accepted == 0) return;
  fill(state, false);
  if (state.filled) keep_best(state);
}

SearchResult LabelSearch::run() {
  push_starts();
  if (options_.first_look && !finished()) options_.first_look(result_.best);
  while (!finished()) {
    context_.check();
    LabelState state = pop();
    const auto worth_filling = [&] {
      return state.score.valid() && !state.fill_tried && (!have_best_ || state.total < result_.best.total - 1e-12);
    };
    const auto try_to_fill = [&] {
      fill(state, !have_best_ && result_.fills < kThoroughFills);
      if (state.filled) keep_best(state);
      return have_best_ && result_.best.score.defects < options_.good_defects;
    };
    if (worth_filling() && state.score.defects < options_.good_defects) {
      if (try_to_fill()) break;
      push(std::move(state));
      continue;
    }
    if (have_best_) ++after_best_;
    ++result_.expansions;
    const std::vector<int> order = sites_to_repair(state);
    const int begin = state.phase * kSitesPerExpansion;
    const int end = std::min(static_cast<int>(order.size()), begin + kSitesPerExpansion);
    if (begin >= end) continue;
    children_.clear();
    expand_labels(state, order.data() + begin, order.data() + end);
    combine_children(state);
    bool clean = false;  // labels alone go on well: no need for splits, which are dear
    for (const LabelState& child : children_)
      clean = clean || (child.score.valid() && child.score.defects < options_.good_defects) || is_clean(state, child);
    if (!clean || state.phase > 0) expand_splits(state, order.data() + begin, order.data() + end);
    std::stable_sort(children_.begin(), children_.end(), [](const LabelState& a, const LabelState& b) { return a.total < b.total; });
    if (children_.size() > kChildren) children_.resize(kChildren);
    // A state with defects is filled only when it has no better valid child: filling is dear.
    const bool topped = !children_.empty() && children_.front().score.valid() && children_.front().total < state.total - 1e-3;
    for (LabelState& child : children_) push(std::move(child));
    if (!topped && worth_filling()) try_to_fill();
    ++state.phase;
    push(std::move(state));
  }
  fill_the_rest();
  polish();
  return std::move(result_);
}

}  // namespace hexfeature
