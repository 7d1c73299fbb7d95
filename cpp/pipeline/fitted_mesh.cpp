// HexFeatureWB - LGPL-2.1-or-later
#include "pipeline/fitted_mesh.h"

#include <algorithm>
#include <string>

#include "recover/face_cover.h"
#include "recover/late_edges.h"

namespace hexfeature {

QuantizeOptions quantize_options(const Options& options) {
  QuantizeOptions quantize;
  quantize.size = options.size;
  quantize.minimum_intervals = options.minimum_layers;
  return quantize;
}

namespace {

/// Where few elements stay inverted: points near them taken off the smooth CAD edges that they follow, in growing neighbourhoods; then off
/// sharp ones too, if `sharp`.
void loosen_inverted(SheetTrial& trial, const SolidTask& task, SmoothOptions smoothing, bool sharp) {
  constexpr int kFew = 30, kRounds = 3;
  Run& run = task.run;
  const Geometry geometry = task.part.geometry();
  SheetTrial loose = trial;
  for (int round = 0; round < (sharp ? 2 : 1) * kRounds && loose.smoothing.inverted > 0 && loose.smoothing.inverted <= kFew; ++round) {
    std::vector<char> near = points_of_inverted(loose.mesh);
    smoothing.around.clear();
    for (int v = 0; v < loose.mesh.point_count(); ++v)
      if (near[v]) smoothing.around.push_back(v);
    for (int ring = 0; ring < round % kRounds; ++ring) near = with_neighbours(loose.mesh, near);
    const std::vector<int> off = loosen(loose.mesh, near, geometry, round >= kRounds);
    if (off.empty()) continue;
    loose.smoothing = smooth(loose.mesh, *geometry.projector, smoothing, run.context);
    run.context.log(std::to_string(off.size()) + " points taken off CAD edges, inverted " + std::to_string(loose.smoothing.inverted));
    if (loose.smoothing.inverted < trial.smoothing.inverted) trial = loose;
  }
}

}  // namespace

void smooth_trial(SheetTrial& trial, const SolidTask& task, bool may_lose_edges, const std::vector<int>& around,
                  const std::vector<int>& held) {
  Run& run = task.run;
  const Geometry& geometry = task.part.geometry();
  SmoothOptions smoothing;
  smoothing.size = run.options.size;
  smoothing.threads = run.options.threads;
  smoothing.around = around;
  smoothing.held = held;
  run.begin("smooth");
  trial.smoothing = smooth(trial.mesh, *geometry.projector, smoothing, run.context);
  run.context.log("with " + std::to_string(trial.sheets.inserted) + " sheets: min SJ " + std::to_string(trial.smoothing.min_sj) +
                  ", inverted " + std::to_string(trial.smoothing.inverted) + " of " + std::to_string(trial.mesh.hex_count()));
  if (trial.smoothing.inverted > 0) loosen_inverted(trial, task, smoothing, may_lose_edges);
  if (trial.smoothing.inverted > 0) return;
  const int changed = cover_faces(trial.mesh, run.result.surface, geometry, run.options.size, run.context);
  if (changed > 0) run.context.log(std::to_string(changed) + " quads cover another CAD face better");
  trial.worth = worth_of(trial.mesh, trial.smoothing, task);
}

SheetTrial smooth_with_sheets(const HexComplex& fitted, const MadeFrom& made_from, const SheetRules& rules, int& vain) {
  const SolidTask& task = made_from.task;
  Run& run = task.run;
  const Geometry& geometry = task.part.geometry();
  const auto mesh_without = [&](const SheetNames& without, bool run_through) {
    SheetOptions sheets;
    sheets.size = run.options.size;
    sheets.max_sheets = run.options.sheets ? sheets.max_sheets : 0;
    sheets.without = without;
    sheets.run_through = run_through;
    run.begin("sheets");
    SheetTrial trial;
    trial.mesh = fitted;
    trial.sheets = insert_sheets(trial.mesh, made_from.shape, geometry, sheets, run.context);
    trial.sheets.taken_back = static_cast<int>(without.size());
    if (without.empty() && run_through) run.result.mesh = trial.mesh;
    if (without.empty() && run_through && run.options.sheets) run.complete();
    smooth_trial(trial, task, !run.another_way());
    if (trial.smoothing.inverted > 0) vain += trial.mesh.hex_count();
    for (int s :
         sheets_near(trial.mesh, trial.sheets, proved_scaled_jacobians(trial.mesh.points, trial.mesh.hexes), trial.smoothing.min_sj + 1e-6))
      trial.suspects.push_back(trial.sheets.names[s]);
    return trial;
  };
  return try_sheets(mesh_without, rules, run.context);
}

std::vector<char> points_of_inverted(const HexComplex& complex, double limit) {
  const std::vector<double> quality = proved_scaled_jacobians(complex.points, complex.hexes);
  std::vector<char> marked(complex.points.size(), 0);
  for (int h = 0; h < complex.hex_count(); ++h)
    if (!(quality[h] > 0) || quality[h] < limit)
      for (int v : complex.hexes[h]) marked[v] = 1;
  return marked;
}

std::vector<char> with_neighbours(const HexComplex& complex, const std::vector<char>& marked) {
  std::vector<char> more = marked;
  for (const auto& hex : complex.hexes)
    if (std::any_of(hex.begin(), hex.end(), [&](int v) { return marked[v] != 0; }))
      for (int v : hex) more[v] = 1;
  return more;
}

}  // namespace hexfeature
