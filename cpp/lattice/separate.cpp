// HexFeatureWB - LGPL-2.1-or-later
#include "lattice/separate.h"

#include <algorithm>
#include <limits>
#include <tuple>

namespace hexfeature {
namespace {

struct Candidate {
  Separation separation;
  double apart = -std::numeric_limits<double>::infinity();  // how far the part itself keeps them apart
};

/// The best of the six ways (axis, which one first) to keep two charts apart at a place; none: low < 0.
Candidate best_separation(const FeatureShape& shape, const Polycube& polycube, const Raster& raster, const ForcedOrders& forced,
                          const Clash& clash, const std::vector<Separation>& tried) {
  Candidate best;
  for (int axis = 0; axis < 3; ++axis)
    for (int order = 0; order < 2; ++order) {
      const int below = order == 0 ? clash.first : clash.second, above = order == 0 ? clash.second : clash.first;
      const Bound low_bound = bound_beside(shape, raster, below, clash.at, axis, 1),
                  high_bound = bound_beside(shape, raster, above, clash.at, axis, -1);
      const int low = low_bound.chart, high = high_bound.chart;
      if (low < 0 || high < 0 || low == high) continue;
      if (axis_of(shape.charts[low].label) != axis || axis_of(shape.charts[high].label) != axis) continue;
      if (polycube.coordinate[high] > polycube.coordinate[low] || !forced.allows(low, high)) continue;
      if (std::binary_search(tried.begin(), tried.end(), Separation{low, high, 1}) ||
          std::binary_search(tried.begin(), tried.end(), Separation{high, low, 1}))
        continue;
      // The arcs say where the charts pass, the centroids keep off arcs that bound the clash in the lattice but lie far from it.
      const double apart =
          high_bound.position - low_bound.position + 0.5 * (shape.charts[high].centroid[axis] - shape.charts[low].centroid[axis]);
      if (apart > best.apart) best = {{low, high, 1}, apart};
    }
  return best;
}

}  // namespace

std::vector<Separation> separations_for(const FeatureShape& shape, const Polycube& polycube, const Raster& raster,
                                        const std::vector<Clash>& clashes, const std::vector<Separation>& tried, int limit) {
  if (clashes.empty()) return {};
  const ForcedOrders forced(shape);
  // A pair of charts that clashes in many cells says the same thing in each row: the first place is enough.
  std::vector<Clash> pairs = clashes;
  for (auto& c : pairs)
    if (c.first > c.second) std::swap(c.first, c.second);
  std::sort(pairs.begin(), pairs.end(),
            [](const Clash& a, const Clash& b) { return std::tie(a.first, a.second, a.at) < std::tie(b.first, b.second, b.at); });
  pairs.erase(
      std::unique(pairs.begin(), pairs.end(), [](const Clash& a, const Clash& b) { return a.first == b.first && a.second == b.second; }),
      pairs.end());
  std::stable_sort(pairs.begin(), pairs.end(), [](const Clash& a, const Clash& b) { return a.at < b.at; });

  // One separation a place: the others there often follow from it, and more would over-constrain.
  std::vector<Candidate> candidates;
  for (std::size_t i = 0; i < pairs.size();) {
    Candidate best;
    const auto at = pairs[i].at;
    for (; i < pairs.size() && pairs[i].at == at; ++i) {
      const Candidate c = best_separation(shape, polycube, raster, forced, pairs[i], tried);
      if (c.separation.low >= 0 && c.apart > best.apart) best = c;
    }
    if (best.separation.low >= 0) candidates.push_back(best);
  }
  std::stable_sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) { return a.apart > b.apart; });
  std::vector<Separation> result;
  for (const auto& c : candidates) {
    // What the part does not show is asked for only when it shows nothing.
    if (static_cast<int>(result.size()) >= limit || (c.apart <= 0 && !result.empty())) break;
    const auto known = [&](const Separation& s) { return std::find(result.begin(), result.end(), s) != result.end(); };
    const Separation& s = c.separation;
    if (!known(s) && !known({s.high, s.low, s.gap})) result.push_back(s);
  }
  return result;
}

}  // namespace hexfeature
