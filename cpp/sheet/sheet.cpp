// HexFeatureWB - LGPL-2.1-or-later
#include "sheet/sheet.h"

#include <algorithm>

#include "sheet/quad_faces.h"
#include "sheet/shrink_set.h"

namespace hexfeature {
namespace {

constexpr double kConflictFactor = 2;  // see join_groups

// What tells one group from another from sheet to sheet. A floor: its chart, and the least node at its foot (nodes keep their numbers) or
// the side of the CAD edge (whose nodes are others after another sheet crossed it).
std::vector<int> name_of(const SheetGroup& group) {
  if (group.floor_chart < 0) return group.charts;
  if (group.cad_edge > 0) return {-1 - group.floor_chart, -1 - 2 * group.cad_edge - group.left};
  return {-1 - group.floor_chart, (*std::min_element(group.floor_edges.begin(), group.floor_edges.end()))[0]};
}

bool same_sheet(const SheetGroup& a, const SheetGroup& b) { return name_of(a) == name_of(b); }

bool is_left_out(const SheetGroup& group, const SheetOptions& options) {
  return std::find(options.without.begin(), options.without.end(), name_of(group)) != options.without.end();
}

SheetGroup united(const SheetGroup& a, const SheetGroup& b) {
  SheetGroup u = a;
  u.charts.insert(u.charts.end(), b.charts.begin(), b.charts.end());
  std::sort(u.charts.begin(), u.charts.end());
  u.smooth_edges.insert(u.smooth_edges.end(), b.smooth_edges.begin(), b.smooth_edges.end());
  return u;
}

// Do charts of the two groups meet? At a sharp edge, as they are two groups: one sheet for both would wrap that edge.
bool touching(const HexComplex& complex, const HexTopology& topology, const SheetGroup& a, const SheetGroup& b) {
  const auto in = [](const SheetGroup& g, int chart) { return std::binary_search(g.charts.begin(), g.charts.end(), chart); };
  return std::any_of(topology.edges.begin(), topology.edges.end(), [&](const HexTopology::Edge& e) {
    const int c = complex.quad_chart[e.quads[0]], d = complex.quad_chart[e.quads[1]];
    return (in(a, c) && in(b, d)) || (in(a, d) && in(b, c));
  });
}

// Groups that are cheaper to serve by one sheet than by one each: both ends of a shaft whose shoulder the sheet runs through; not a boss
// and the disc it stands on. Two sheets would leave through each other's smooth walls.
SheetGroup join_groups(const HexComplex& complex, const HexTopology& topology, const SheetGroup& first,
                       const std::vector<SheetGroup>& groups, const SheetOptions& options, Context& context) {
  context.check();
  SheetGroup joined = first;
  ShrinkSet set = choose_shrink_set(complex, topology, joined, options, context);
  for (const SheetGroup& other : groups) {
    if (!set.refusal.empty()) break;
    if (other.floor_chart >= 0 || same_sheet(other, first) || is_left_out(other, options) || touching(complex, topology, joined, other))
      continue;
    const ShrinkSet alone = choose_shrink_set(complex, topology, other, options, context);
    const SheetGroup both = united(joined, other);
    ShrinkSet together = choose_shrink_set(complex, topology, both, options, context);
    if (!alone.refusal.empty() || !together.refusal.empty()) continue;
    // Charts that only their conflict would bring in speak against it: the sheet would wrap the sharp edges between those and theirs. A
    // row that is parted instead counts the same.
    const auto size = [](const ShrinkSet& x) { return std::count(x.covered.begin(), x.covered.end(), 1) + x.rows; };
    const bool conflict = size(together) > size(set) + size(alone);
    if (conflict && options.run_through) continue;
    if ((conflict ? kConflictFactor : 1) * together.cost >= set.cost + alone.cost) continue;
    joined = both;
    set = std::move(together);
  }
  return joined;
}

// Would the sheet for `group`, which `first` grew to, be another one if it might end inside?
bool could_end_inside(const HexComplex& complex, const HexTopology& topology, const SheetGroup& first,
                      const std::vector<SheetGroup>& groups, const SheetGroup& group, const SheetOptions& options, Context& context) {
  SheetOptions shorter = options;
  shorter.run_through = false;
  if (first.floor_chart < 0 && join_groups(complex, topology, first, groups, shorter, context).charts != group.charts) return true;
  return choose_shrink_set(complex, topology, group, options, context).inside !=
         choose_shrink_set(complex, topology, group, shorter, context).inside;
}

}  // namespace

std::string insert_sheet(HexComplex& complex, const HexTopology& topology, const FeatureShape& shape, const Geometry& geometry,
                         const SheetGroup& group, const SheetOptions& options, Context& context, std::vector<int>* covered) {
  constexpr int kCuts = 12;
  context.check();
  std::vector<std::vector<int>> together;
  LayerRefusal refusal;
  for (int cut = 0; cut < kCuts; ++cut) {
    const ShrinkSet set = choose_shrink_set(complex, topology, group, options, context, together);
    if (!set.refusal.empty()) return refusal.refused() ? refusal.reason : set.refusal;
    refusal = insert_layer(complex, topology, shape, geometry, set, options, context);
    if (!refusal.refused()) {
      if (!covered) return {};
      covered->clear();
      for (int c = 0; c < static_cast<int>(set.covered.size()); ++c)
        if (set.covered[c]) covered->push_back(c);
      if (covered->empty()) *covered = {group.floor_chart};
      return {};
    }
    // Elsewhere, then: past the places where it went wrong.
    const std::size_t known = together.size();
    for (const auto& hexes : refusal.together)
      if (std::find(together.begin(), together.end(), hexes) == together.end()) together.push_back(hexes);
    if (together.size() == known) break;
  }
  return refusal.reason;
}

SheetReport insert_sheets(HexComplex& complex, const FeatureShape& shape, const Geometry& geometry, const SheetOptions& options,
                          Context& context) {
  SheetReport report;
  std::vector<std::vector<int>> done = options.without;  // a refused group, or one still smooth after its sheet, is not tried again
  HexTopology topology;
  bool stale = true;  // the complex has changed since
  while (report.inserted < options.max_sheets) {
    context.progress("sheet", report.inserted / (report.inserted + 2.0));
    if (stale) topology = make_topology(complex, context);
    stale = false;
    const std::vector<SheetGroup> groups = find_sheet_groups(complex, topology, geometry, options, context);
    const auto next = std::find_if(groups.begin(), groups.end(),
                                   [&](const SheetGroup& g) { return std::find(done.begin(), done.end(), name_of(g)) == done.end(); });
    if (next == groups.end()) break;
    done.push_back(name_of(*next));
    const SheetGroup group = next->floor_chart >= 0 ? *next : join_groups(complex, topology, *next, groups, options, context);
    report.run_through =
        report.run_through || (options.run_through && could_end_inside(complex, topology, *next, groups, group, options, context));
    std::vector<int> covered;
    const int begin = complex.hex_count();
    const std::string refusal = insert_sheet(complex, topology, shape, geometry, group, options, context, &covered);
    if (!refusal.empty()) covered = group.floor_chart >= 0 ? std::vector<int>{group.floor_chart} : group.charts;
    std::string where = group.floor_chart >= 0 ? "sheet under the floor of chart" : "sheet along charts";
    for (int c : covered) where += " " + std::to_string(c);
    if (!refusal.empty()) {
      ++report.refused;
      report.refusals.push_back(refusal);
      context.log(where + " refused: " + refusal);
      continue;
    }
    context.log(where + ": " + std::to_string(complex.hex_count() - begin) + " hexahedra");
    stale = true;
    ++report.inserted;
    report.chart_groups.push_back(std::move(covered));
    report.names.push_back(done.back());
    report.hexes.push_back({begin, complex.hex_count()});
  }
  if (report.inserted > 0) face_quads_at_sharp_edges(complex, geometry);
  return report;
}

std::vector<int> sheets_near(const HexComplex& complex, const SheetReport& report, const std::vector<double>& quality, double limit) {
  std::vector<char> bad(complex.points.size(), 0);
  for (int h = 0; h < complex.hex_count(); ++h)
    if (quality[h] < limit)
      for (int v : complex.hexes[h]) bad[v] = 1;
  std::vector<char> near = bad;
  for (const auto& hex : complex.hexes)
    if (std::any_of(hex.begin(), hex.end(), [&](int v) { return bad[v] != 0; }))
      for (int v : hex) near[v] = 1;
  std::vector<int> sheets;
  for (std::size_t s = 0; s < report.hexes.size(); ++s)
    if (std::any_of(complex.hexes.begin() + report.hexes[s][0], complex.hexes.begin() + report.hexes[s][1],
                    [&](const auto& hex) { return std::any_of(hex.begin(), hex.end(), [&](int v) { return near[v] != 0; }); }))
      sheets.push_back(static_cast<int>(s));
  return sheets;
}

}  // namespace hexfeature
