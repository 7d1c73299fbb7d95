// HexFeatureWB - LGPL-2.1-or-later
#include "pipeline/sheet_trials.h"

#include <algorithm>
#include <utility>

#include "base/share.h"

namespace hexfeature {
namespace {

/// A mesh whose worst element is below this is worth a second try without (or with fewer) sheets.
constexpr double kGoodEnough = 0.5;

/// Elements of all the meshes that are made to better one that is sound and keeps the part, or another one that has no inverted element.
constexpr int kMostToBetter = 8000, kMostToMend = 24000;

/// Sheets that run through the part can be in each other's way.
bool may_be_too_long(const SheetTrial& trial) {
  const bool bad = trial.smoothing.inverted > 0 || trial.smoothing.min_sj < kGoodEnough;
  return trial.sheets.run_through && (trial.sheets.refused > 0 || (bad && !trial.suspects.empty()));
}

/// Of a mesh that is not faithful: what it lost, and a little for poor elements.
double price(const SheetTrial& trial) {
  constexpr double kPoorPrice = 0.1, kFine = 0.5;
  return trial.worth.lost + kPoorPrice * std::max(0.0, kFine - trial.smoothing.min_sj);
}

}  // namespace

bool is_better(const SheetTrial& a, const SheetTrial& b) {
  constexpr double kSeen = 0.005, kAsGood = 0.002, kSeenOfMean = 0.0005;
  if (a.again) return false;
  if (a.smoothing.inverted != b.smoothing.inverted) return a.smoothing.inverted < b.smoothing.inverted;
  if (a.worth.faithful != b.worth.faithful) return a.worth.faithful;
  if (a.smoothing.inverted == 0 && !a.worth.faithful && a.worth.lost != b.worth.lost) return price(a) < price(b);
  if (a.smoothing.min_sj > b.smoothing.min_sj + kSeen) return true;
  return a.worth.faithful && a.smoothing.min_sj >= b.smoothing.min_sj - kAsGood && a.smoothing.mean_sj > b.smoothing.mean_sj + kSeenOfMean;
}

SheetTrial try_sheets(const MakeTrial& mesh_without, const SheetRules& rules, Context& context) {
  SheetTrial best;
  // suspects: the next one to leave out last; all: ever inserted.
  SheetNames left_out, suspects, together, all;
  bool bare = false;  // the mesh without any has been made
  bool run_through = true;
  int work = 0;
  for (int trial = 0; trial < rules.most; ++trial) {
    if (best.smoothing.inverted == 0 && work >= (best.worth.good() ? kMostToBetter : kMostToMend)) break;
    SheetNames without = left_out;
    if (trial > 0) {
      if (suspects.empty()) suspects.swap(together);
      if (!suspects.empty()) {
        const bool at_once = best.smoothing.inverted > 0 || together.empty();
        const auto first = at_once ? suspects.begin() : suspects.end() - 1;
        without.insert(without.end(), first, suspects.end());
        suspects.erase(first, suspects.end());
        if (at_once) together.clear();
        bare = std::all_of(all.begin(), all.end(),
                           [&](const auto& name) { return std::find(without.begin(), without.end(), name) != without.end(); });
      } else if (!bare && best.smoothing.inverted == 0 && !best.worth.sound() && best.sheets.inserted > 0) {
        without = all;
        bare = true;
      } else {
        break;
      }
    }
    SheetTrial next;
    const auto make = [&] { next = mesh_without(without, run_through); };
    if (trial == 0 || best.smoothing.inverted > 0)
      make();
    else if (run_with_share(context, kShareForBetter, make))
      break;
    if (trial == 0 && may_be_too_long(next) && !(next.smoothing.inverted > 0 && rules.once)) {
      SheetTrial shorter;
      const auto make_shorter = [&] { shorter = mesh_without(without, false); };
      bool out_of_time = false;
      if (next.smoothing.inverted > 0)
        make_shorter();
      else
        out_of_time = run_with_share(context, kShareForBetter, make_shorter).has_value();
      if (!out_of_time && is_better(shorter, next)) {
        next = std::move(shorter);
        run_through = false;
      }
    }
    if (trial > 0 && best.smoothing.inverted == 0 && !next.again) work += next.mesh.hex_count();
    for (const std::vector<int>& name : next.sheets.names)
      if (std::find(all.begin(), all.end(), name) == all.end()) all.push_back(name);
    if (trial > 0 && !is_better(next, best)) continue;
    left_out = std::move(without);
    best = std::move(next);
    const bool inverted = best.smoothing.inverted > 0;
    suspects = inverted || best.smoothing.min_sj < kGoodEnough ? best.suspects : SheetNames{};
    together = suspects.size() > 1 ? suspects : SheetNames{};
    if (inverted && rules.once) break;
    if (best.worth.edges_lost && rules.another_way) break;
  }
  return best;
}

}  // namespace hexfeature
