// HexFeatureWB - LGPL-2.1-or-later
#include <algorithm>
#include <tuple>

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
  // Short tries before the long one: where the search gets lost, it often finds its way at once when feature lines that turn back
  // guide it from the start, or when knife edges get rims. Rims come late since they make flat hexahedra: any other cure is better.
  // A labelling with a bad defect is worth another try too.
  constexpr double kShort = 1.0 / 6, kLong = 0.8, kStrict = 0.3, kGood = 0.5;
  struct Try {
    double fold_tolerance, work;
    bool rims;
  };
  const double usual = options.fold_tolerance;
  std::vector<Try> tries = {{usual, kShort, false}};
  if (usual > kStrict) tries.push_back({kStrict, kShort, false});
  tries.push_back({usual, kShort, true});
  tries.push_back({usual, kLong, true});  // with rims only if nothing fills without them
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
  for (const Try& attempt : tries) {
    const bool last = &attempt == &tries.back();
    if (attempt.rims && !last && found.best.filled) continue;  // without rims it would be the first again
    SearchOptions search_options;
    search_options.size = options.size;
    search_options.max_expansions = options.max_expansions;
    search_options.max_work = attempt.work * options.max_work;
    search_options.fold_tolerance = attempt.fold_tolerance;
    search_options.rims = attempt.rims && !found.best.filled;
    if (options.first_look && found.best.labels.empty())
      search_options.first_look = [&](const LabelState& state) { options.first_look(result_of(state)); };
    SearchResult next = LabelSearch(tree, search_options, fill_sites, context).run();
    const auto rank = [](const LabelState& s) { return std::tuple(!s.filled, s.score.violations, s.score.defects); };
    const bool better = rank(next.best) < rank(found.best);
    if (found.best.labels.empty() || better) found = std::move(next);
    if (found.best.filled && found.best.score.defects < kGood) break;
  }

  LabelResult result = result_of(found.best);
  result.expansions = found.expansions;
  context.log("labels: " + std::to_string(tree.graph(found.best.cutting).site_count()) + " sites, " + std::to_string(found.expansions) +
              " expansions, " + std::to_string(found.scored) + " label sets scored, " + std::to_string(found.fills) + " filled");
  return result;
}

}  // namespace hexfeature
