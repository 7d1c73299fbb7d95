// HexFeatureWB - LGPL-2.1-or-later
#include <algorithm>

#include "label/cut_tree.h"
#include "label/label_search.h"
#include "label/labels.h"

namespace hexfeature {
namespace {

LabelledSurface labelled(const Regions& regions, const std::vector<Label>& labels) {
  LabelledSurface surface;
  surface.mesh = regions.mesh;
  surface.label.resize(regions.site.size());
  for (std::size_t t = 0; t < regions.site.size(); ++t) surface.label[t] = labels[regions.site[t]];
  return surface;
}

}  // namespace

LabelResult label_regions(const SurfaceMesh& mesh, const Geometry& geometry, const LabelOptions& options, const FillCheck& fill,
                          Context& context) {
  RegionOptions region_options;
  region_options.size = options.size;
  CutTree tree(cut_regions(mesh, geometry, region_options, context), geometry, options.size);

  const auto fill_sites = [&](int cutting, const std::vector<Label>& labels, bool thorough) {
    LabelSearch::Fill result;
    if (!fill) {
      result.ok = true;
      return result;
    }
    const Regions& regions = tree.regions(cutting);
    const LabelledSurface surface = labelled(regions, labels);
    context.check();
    FeatureShape shape = make_feature_shape(surface);
    context.check();
    if (!check_validity(shape, options.size).valid()) return result;
    const FillOutcome outcome = fill(surface.mesh, shape, thorough);
    result.ok = outcome.ok;
    result.rounds = outcome.rounds;
    for (int c : outcome.charts)
      for (int t : shape.cells.parts[c].triangles) result.sites.push_back(regions.site[t]);
    std::sort(result.sites.begin(), result.sites.end());
    result.sites.erase(std::unique(result.sites.begin(), result.sites.end()), result.sites.end());
    return result;
  };
  // Two short tries before the long one: where the search gets lost, it often finds its way at once when feature lines that turn back
  // guide it from the start. A labelling with a bad defect is worth another try too.
  constexpr double kShort = 1.0 / 6, kStrict = 0.3, kGood = 0.5;
  struct Try {
    double fold_tolerance, work;
  };
  const auto result_of = [&](const LabelState& state) {
    LabelResult result;
    const Regions& regions = tree.regions(state.cutting);
    result.surface = labelled(regions, state.labels);
    result.shape = make_feature_shape(result.surface);
    result.validity = check_validity(result.shape, options.size);
    result.filled = state.filled;
    result.energy = state.score.energy;
    result.defects = state.score.defects;
    result.sites = regions.site;
    return result;
  };
  SearchResult found;
  for (const Try& attempt :
       {Try{options.fold_tolerance, kShort}, Try{std::min(kStrict, options.fold_tolerance), kShort}, Try{options.fold_tolerance, 1.0}}) {
    SearchOptions search_options;
    search_options.size = options.size;
    search_options.max_expansions = options.max_expansions;
    search_options.max_work = attempt.work * options.max_work;
    search_options.fold_tolerance = attempt.fold_tolerance;
    if (options.first_look && found.best.labels.empty())
      search_options.first_look = [&](const LabelState& state) { options.first_look(result_of(state)); };
    SearchResult next = LabelSearch(tree, search_options, fill_sites, context).run();
    const bool better = next.best.filled != found.best.filled ? next.best.filled : next.best.score.defects < found.best.score.defects;
    if (found.best.labels.empty() || better) found = std::move(next);
    if (found.best.filled && (found.best.score.defects < kGood || attempt.work == 1.0)) break;
  }

  LabelResult result = result_of(found.best);
  result.expansions = found.expansions;
  context.log("labels: " + std::to_string(tree.graph(found.best.cutting).site_count()) + " sites, " + std::to_string(found.expansions) +
              " expansions, " + std::to_string(found.scored) + " label sets scored, " + std::to_string(found.fills) + " filled");
  return result;
}

}  // namespace hexfeature
