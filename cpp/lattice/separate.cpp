// HexFeatureWB - LGPL-2.1-or-later
#include "lattice/separate.h"

#include <algorithm>
#include <limits>
#include <tuple>

namespace hexfeature {

std::vector<Separation> separations_for(const FeatureShape& shape, const Polycube& polycube, const Raster& raster,
                                        const std::vector<Clash>& clashes, int limit) {
  // A pair of charts that clashes in many cells says the same thing in each row: the first place is enough.
  std::vector<Clash> pairs = clashes;
  for (auto& c : pairs)
    if (c.first > c.second) std::swap(c.first, c.second);
  std::sort(pairs.begin(), pairs.end(), [](const Clash& a, const Clash& b) {
    return std::tie(a.first, a.second, a.at) < std::tie(b.first, b.second, b.at);
  });
  pairs.erase(std::unique(pairs.begin(), pairs.end(), [](const Clash& a, const Clash& b) { return a.first == b.first && a.second == b.second; }),
              pairs.end());

  std::vector<Separation> result;
  for (const auto& c : pairs) {
    if (static_cast<int>(result.size()) >= limit) break;
    Separation best;
    double most = -std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis)
      for (int order = 0; order < 2; ++order) {
        const int below = order == 0 ? c.first : c.second, above = order == 0 ? c.second : c.first;
        const int low = chart_beside(shape, raster, below, c.at, axis, 1), high = chart_beside(shape, raster, above, c.at, axis, -1);
        if (low < 0 || high < 0 || low == high || polycube.coordinate[high] > polycube.coordinate[low]) continue;
        const double apart = shape.charts[high].centroid[axis] - shape.charts[low].centroid[axis];
        if (apart > most) {
          most = apart;
          best = {low, high, 1};
        }
      }
    if (best.low >= 0) result.push_back(best);
  }
  const auto key = [](const Separation& s) { return std::make_tuple(s.low, s.high, s.gap); };
  std::sort(result.begin(), result.end(), [&](const Separation& a, const Separation& b) { return key(a) < key(b); });
  result.erase(std::unique(result.begin(), result.end(), [&](const Separation& a, const Separation& b) { return key(a) == key(b); }), result.end());
  return result;
}

}  // namespace hexfeature
