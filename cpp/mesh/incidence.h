// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include <array>
#include <cstddef>
#include <numeric>
#include <vector>

namespace hexfeature {

/// The elements (hexahedra, quads) at each point, in rising order.
class Incidence {
 public:
  struct Range {
    const int *first, *last;
    const int* begin() const { return first; }
    const int* end() const { return last; }
  };

  template <std::size_t N>
  Incidence(const std::vector<std::array<int, N>>& elements, std::size_t points) : begin_(points + 1, 0), elements_(N * elements.size()) {
    for (const auto& e : elements)
      for (int v : e) ++begin_[v + 1];
    std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
    std::vector<int> next(begin_.begin(), begin_.end() - 1);
    for (std::size_t i = 0; i < elements.size(); ++i)
      for (int v : elements[i]) elements_[next[v]++] = static_cast<int>(i);
  }
  Range at(int point) const { return {elements_.data() + begin_[point], elements_.data() + begin_[point + 1]}; }

 private:
  std::vector<int> begin_, elements_;
};

}  // namespace hexfeature
