// HexFeatureWB - LGPL-2.1-or-later
#include <array>
#include <string>

#include "shape/validity.h"

namespace hexfeature {
namespace {

const char* const kNames[6] = {"+X", "-X", "+Y", "-Y", "+Z", "-Z"};

}  // namespace

// How the four sentences of 3.1.7 are read:
//  1  each of the six directions is the label of some feature surface (a closed recognition model has them all);
//  2  no two neighbouring feature surfaces lie on one axis (equal labels would make them one surface);
//  3  going round a feature surface, each of the four directions of its two own axes occurs among its feature lines;
//  4  no two consecutive feature lines of a loop run in opposite directions of one axis.
std::vector<Violation> check_paper_conditions(const FeatureShape& shape) {
  std::vector<Violation> violations;
  std::array<bool, 6> present{};
  for (const auto& chart : shape.charts)
    if (chart.label >= 0) present[chart.label] = true;
  for (int l = 0; l < 6; ++l)
    if (!present[l]) violations.push_back({1, 1, std::string("no feature surface has direction ") + kNames[l], {}, {}, {}});

  for (int a = 0; a < shape.arc_count(); ++a)
    if (shape.arcs[a].axis < 0) {
      const auto& edge = shape.cells.edges[a];
      violations.push_back({2, 1, "neighbouring feature surfaces lie on one axis", {edge.left, edge.right}, {a}, {}});
    }

  for (int c = 0; c < shape.chart_count(); ++c) {
    std::array<bool, 6> runs{};
    for (const auto& loop : shape.cells.parts[c].loops)
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const Label here = shape.dart_direction(loop[i]), then = shape.dart_direction(loop[(i + 1) % loop.size()]);
        if (here == kNoLabel) continue;
        runs[here] = true;
        if (loop.size() > 1 && then == opposite(here))
          violations.push_back({4,
                                1,
                                "consecutive feature lines run in opposite directions",
                                {c},
                                {loop[i] / 2, loop[(i + 1) % loop.size()] / 2},
                                {shape.cells.end_of(loop[i])}});
      }
    for (int l = 0; l < 6; ++l)
      if (axis_of(static_cast<Label>(l)) != axis_of(shape.charts[c].label) && !runs[l]) {
        violations.push_back({3, 1, std::string("no feature line of a feature surface runs in direction ") + kNames[l], {c}, {}, {}});
        break;
      }
  }
  return violations;
}

}  // namespace hexfeature
