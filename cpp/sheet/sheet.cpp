// HexFeatureWB - LGPL-2.1-or-later
#include "sheet/sheet.h"

#include <algorithm>

#include "sheet/shrink_set.h"

namespace hexfeature {
namespace {

// What tells one group from another from sheet to sheet. A floor: its chart and the least node at its foot (nodes keep their numbers).
std::vector<int> name_of(const SheetGroup& group) {
  return group.floor_chart >= 0 ? std::vector<int>{-1 - group.floor_chart, group.floor_edges.front()[0]} : group.charts;
}

}  // namespace

std::string insert_sheet(HexComplex& complex, const FeatureShape& shape, const Geometry& geometry, const SheetGroup& group,
                         const SheetOptions& options, Context& context, std::vector<int>* covered) {
  const HexTopology topology = make_topology(complex);
  const ShrinkSet set = choose_shrink_set(complex, topology, group, options, context);
  if (!set.refusal.empty()) return set.refusal;
  std::string refusal = insert_layer(complex, topology, shape, geometry, set, options);
  if (refusal.empty() && covered) {
    covered->clear();
    for (int c = 0; c < static_cast<int>(set.covered.size()); ++c)
      if (set.covered[c]) covered->push_back(c);
    if (covered->empty()) *covered = {group.floor_chart};
  }
  return refusal;
}

SheetReport insert_sheets(HexComplex& complex, const FeatureShape& shape, const Geometry& geometry, const SheetOptions& options,
                          Context& context) {
  SheetReport report;
  std::vector<std::vector<int>> done;  // groups tried: a refused one, or one still smooth after its sheet, is not tried again
  while (report.inserted < options.max_sheets) {
    context.progress("sheet", report.inserted / (report.inserted + 2.0));
    const std::vector<SheetGroup> groups = find_sheet_groups(complex, geometry, options);
    const auto next = std::find_if(groups.begin(), groups.end(),
                                   [&](const SheetGroup& g) { return std::find(done.begin(), done.end(), name_of(g)) == done.end(); });
    if (next == groups.end()) break;
    done.push_back(name_of(*next));
    std::vector<int> covered;
    const std::string refusal = insert_sheet(complex, shape, geometry, *next, options, context, &covered);
    if (refusal.empty()) {
      ++report.inserted;
      report.chart_groups.push_back(std::move(covered));
    } else {
      ++report.refused;
      report.refusals.push_back(refusal);
      context.log("sheet refused: " + refusal);
    }
  }
  return report;
}

}  // namespace hexfeature
