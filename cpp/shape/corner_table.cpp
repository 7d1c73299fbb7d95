// HexFeatureWB - LGPL-2.1-or-later
#include "shape/corner_table.h"

#include <algorithm>
#include <array>
#include <vector>

namespace hexfeature {
namespace {

constexpr std::uint32_t pack(const Label* labels, int valence) {
  std::uint32_t key = 1;  // leading one: sequences of different length never share a key
  for (int i = 0; i < valence; ++i) key = key << 3 | static_cast<std::uint32_t>(labels[i]);
  return key;
}

/// The axis-aligned unit vector `n x e` as a label.
Label cross(Label n, Label e) {
  const int a = axis_of(n), b = axis_of(e);
  const int handed = (b - a + 3) % 3 == 1 ? 1 : -1;
  return make_label(third_axis(a, b), handed * sign_of(n) * sign_of(e));
}

struct Table {
  struct Entry {
    std::uint32_t key;
    int first, last;
  };
  std::vector<Entry> entries;  // sorted by key
  std::vector<std::uint8_t> masks;

  Table() {
    std::vector<std::pair<std::uint32_t, std::uint8_t>> found;
    for (int filling = 1; filling < 255; ++filling) enumerate(filling, found);
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    for (const auto& [key, mask] : found) {
      if (entries.empty() || entries.back().key != key) entries.push_back({key, static_cast<int>(masks.size()), 0});
      masks.push_back(mask);
      entries.back().last = static_cast<int>(masks.size());
    }
  }

  static void enumerate(int filling, std::vector<std::pair<std::uint32_t, std::uint8_t>>& found) {
    const auto filled = [&](const std::array<int, 3>& side) { return (filling >> (side[0] + 2 * side[1] + 4 * side[2])) & 1; };
    // Quarter faces: face[e] is the label of the one that lies left of lattice edge e, next[e] its other edge.
    std::array<Label, 6> face, next;
    face.fill(kNoLabel);
    int faces = 0;
    for (int a = 0; a < 3; ++a)
      for (int quadrant = 0; quadrant < 4; ++quadrant) {
        const int b = (a + 1) % 3, c = (a + 2) % 3;
        std::array<int, 3> low{}, high{};
        low[b] = high[b] = quadrant & 1;
        low[c] = high[c] = quadrant >> 1;
        high[a] = 1;
        if (filled(low) == filled(high)) continue;
        const Label normal = make_label(a, filled(low) ? 1 : -1);
        const Label eb = make_label(b, (quadrant & 1) ? 1 : -1), ec = make_label(c, (quadrant >> 1) ? 1 : -1);
        const Label from = cross(normal, eb) == ec ? eb : ec;
        if (face[from] != kNoLabel) return;  // four faces at one edge
        face[from] = normal;
        next[from] = cross(normal, from);
        ++faces;
      }
    if (faces == 0) return;
    Label start = 0;
    while (face[start] == kNoLabel) ++start;
    std::vector<Label> directions, labels;
    int walked = 0;
    Label e = start, before = kNoLabel;
    for (Label p = 0; p < 6; ++p)
      if (face[p] != kNoLabel && next[p] == start) before = face[p];
    do {
      if (face[e] == kNoLabel) return;
      if (face[e] != before) {
        directions.push_back(e);
        labels.push_back(face[e]);
      }
      before = face[e];
      e = next[e];
      ++walked;
    } while (e != start && walked <= faces);
    if (walked != faces || labels.size() < 3) return;  // several cycles; or flat, or a straight edge
    const int valence = static_cast<int>(labels.size());
    for (int r = 0; r < valence; ++r) {
      std::uint8_t mask = 0;
      for (int i = 0; i < valence; ++i)
        if (sign_of(directions[i]) > 0) mask |= static_cast<std::uint8_t>(1u << i);
      found.emplace_back(pack(labels.data(), valence), mask);
      std::rotate(labels.begin(), labels.begin() + 1, labels.end());
      std::rotate(directions.begin(), directions.begin() + 1, directions.end());
    }
  }
};

}  // namespace

CornerSigns corner_signs(const Label* labels, int valence) {
  static const Table table;
  if (valence < 3 || valence > kMaxCornerValence) return {};
  const std::uint32_t key = pack(labels, valence);
  const auto it =
      std::lower_bound(table.entries.begin(), table.entries.end(), key, [](const Table::Entry& e, std::uint32_t k) { return e.key < k; });
  if (it == table.entries.end() || it->key != key) return {};
  return {table.masks.data() + it->first, table.masks.data() + it->last};
}

}  // namespace hexfeature
