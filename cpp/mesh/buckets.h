// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include <vector>

namespace hexfeature {

/// A list of items per key 0..n-1 in flat form; items of one key stay in their order.
struct Buckets {
  template <class KeyOf>
  Buckets(int keys, int items, KeyOf key_of) : start(keys + 1, 0), item(items) {
    for (int i = 0; i < items; ++i) ++start[key_of(i) + 1];
    for (int k = 0; k < keys; ++k) start[k + 1] += start[k];
    std::vector<int> next(start.begin(), start.end() - 1);
    for (int i = 0; i < items; ++i) item[next[key_of(i)]++] = i;
  }
  std::vector<int> start, item;
};

}  // namespace hexfeature
