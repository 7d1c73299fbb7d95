// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include <cstdint>
#include <deque>
#include <functional>
#include <set>
#include <unordered_set>
#include <utility>
#include <vector>

#include "base/context.h"
#include "label/cut_tree.h"
#include "label/label_score.h"

namespace hexfeature {

/// Labels of the sites of one cutting, and what they are worth.
struct LabelState {
  int cutting = 0;  ///< of the CutTree
  std::vector<Label> labels;
  LabelScore score;
  bool fill_tried = false;
  bool filled = false;
  std::vector<int> fill_blame;  ///< sites, when the fill failed
  double total = 0;             ///< what the search minimises
  int phase = 0;                ///< how often it has been expanded
};

struct SearchOptions {
  double size = 1;                                    ///< element size h
  int max_expansions = 4000;                          ///< bound on expansions
  double max_work = 6e7;                              ///< bound on counted work: macro edges looked at (about 10 million a second)
  double fold_tolerance = 0.75;                       ///< LabelOptions::fold_tolerance
  bool rims = false;                                  ///< look for rims along knife edges
  double good_defects = 0.05;                         ///< a filled state with fewer soft defects ends the search
  std::function<void(const LabelState&)> first_look;  ///< may be empty: called with the best start when it has to be repaired
};

struct SearchResult {
  LabelState best;  ///< filled if any was; else the one with the fewest violations
  int expansions = 0;
  int scored = 0;
  int fills = 0;
  double work = 0;
};

/// Best-first repair of site labels (experiments A7): starts from the nearest axes and from iterated conditional modes; expands the
/// sites to blame, one cluster of defects at a time, by relabelling a site, its chart, a site with a neighbour or a CAD face, and by
/// splitting, and by rims along knife edges between opposite labels, alternating between the state that is best and the one with the fewest
/// defects; a state is put back for its next candidates. Valid states are filled; the first one that fills and has few soft defects ends
/// the search. What a failed fill blames is remembered: any other state with the same labels there, and round about, is taken to fail too.
/// Deterministic.
class LabelSearch {
 public:
  struct Fill {
    bool ok = false;
    int rounds = 1;          ///< counted work
    std::vector<int> sites;  ///< to blame
  };
  using FillSites = std::function<Fill(int cutting, const std::vector<Label>& labels, bool thorough)>;

  LabelSearch(CutTree& tree, const SearchOptions& options, FillSites fill, Context& context);
  SearchResult run();

 private:
  bool evaluate(LabelState& state);
  void judge(LabelState& state);
  void learn(const LabelState& state);
  void push(LabelState&& state);
  LabelState pop();
  void push_starts();
  std::vector<Label> nearest_labels(const MacroGraph& graph) const;
  void iterate_modes(const MacroGraph& graph, std::vector<Label>& labels, double differ) const;
  void merge_islands(LabelState& state);
  void fill(LabelState& state, bool thorough);
  void fill_the_rest();
  bool finished() const;
  void keep_best(const LabelState& state);
  std::vector<int> sites_to_repair(const LabelState& state);
  void combine_children(const LabelState& state);
  void expand_labels(const LabelState& state, const int* first, const int* last);
  std::vector<SiteCut> cuts_at_turns(const LabelState& state, const int* first, const int* last);
  void expand_splits(const LabelState& state, const int* first, const int* last);
  void split(const LabelState& state, const SiteCut& cut);
  struct KnifeEdge {
    std::vector<int> sides[2];  ///< sites beside it
  };
  std::vector<KnifeEdge> knife_edges(const LabelState& state);
  bool add_rim(const LabelState& state, const KnifeEdge& edge, int side, double width, LabelState& child);
  void expand_rims(const LabelState& state, const int* first, const int* last);
  void polish();

  CutTree& tree_;
  SearchOptions options_;
  FillSites fill_;
  Context& context_;
  LabelScorer scorer_;
  SearchResult result_;
  bool have_best_ = false;
  double improve_until_ = 0;                                    // counted work
  int after_best_ = 0;                                          // expansions since something filled
  std::vector<std::vector<std::pair<int, Label>>> unfillable_;  // labels of some sites that together have failed to fill
  std::vector<LabelState> unfilled_;                            // the best valid states that a quick look could not fill
  // Waiting states in two orders, expanded in turn: by `total`, and with defects dear and violations cheap: a valid
  // labelling that flattens a pocket is often further from a good one than an invalid one is.
  std::deque<LabelState> states_;
  std::set<std::pair<double, int>> open_, open_useful_;
  std::unordered_set<std::uint64_t> seen_;
  std::vector<LabelState> children_;
  std::vector<double> blame_;
};

}  // namespace hexfeature
