// HexFeatureWB - LGPL-2.1-or-later
#include "mesh/hex_complex.h"

#include <algorithm>

namespace hexfeature {

std::vector<std::array<int, 2>> boundary_faces(const HexComplex& complex) {
  struct Key {
    std::array<int, 4> nodes;
    int face;  // 6 * hex + local face
  };
  std::vector<Key> keys;
  keys.reserve(6 * complex.hexes.size());
  for (int h = 0; h < complex.hex_count(); ++h)
    for (int f = 0; f < 6; ++f) {
      Key k{{}, 6 * h + f};
      for (int i = 0; i < 4; ++i) k.nodes[i] = complex.hexes[h][kHexFaces[f][i]];
      std::sort(k.nodes.begin(), k.nodes.end());
      keys.push_back(k);
    }
  std::sort(keys.begin(), keys.end(), [](const Key& a, const Key& b) { return a.nodes != b.nodes ? a.nodes < b.nodes : a.face < b.face; });
  std::vector<int> single;
  for (std::size_t i = 0; i < keys.size();) {
    std::size_t j = i + 1;
    while (j < keys.size() && keys[j].nodes == keys[i].nodes) ++j;
    if (j == i + 1) single.push_back(keys[i].face);
    i = j;
  }
  std::sort(single.begin(), single.end());
  std::vector<std::array<int, 2>> result;
  result.reserve(single.size());
  for (int f : single) result.push_back({f / 6, f % 6});
  return result;
}

}  // namespace hexfeature
