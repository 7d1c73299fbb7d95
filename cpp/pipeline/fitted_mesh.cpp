// HexFeatureWB - LGPL-2.1-or-later
#include "pipeline/fitted_mesh.h"

#include <algorithm>
#include <cstdint>
#include <set>
#include <string>
#include <utility>

#include "base/fingerprint.h"
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

std::vector<PointGap> gaps_of(const HexComplex& mesh, const SolidTask& task) {
  return point_gaps(mesh, task.run.result.surface, task.part.geometry(), task.run.options.size, task.run.context);
}

/// Where points of a CAD face lie farther from its quads than is nobody's loss, and did not before. `then` is filled when it is needed.
std::vector<Vec3> opened_gaps(const HexComplex& before, const HexComplex& after, const SolidTask& task, std::vector<PointGap>& then) {
  constexpr double kBearable = 0.36;  // of h
  const double bearable = kBearable * task.run.options.size;
  const std::vector<PointGap> now = gaps_of(after, task);
  if (std::all_of(now.begin(), now.end(), [&](const PointGap& g) { return g.gap <= bearable; })) return {};
  if (then.empty()) then = gaps_of(before, task);
  std::vector<Vec3> opened;
  for (std::size_t i = 0; i < now.size(); ++i)
    if (now[i].gap > std::max(bearable, then[i].gap)) opened.push_back(now[i].point);
  return opened;
}

/// Boundary points near any of these places; all of them when there are none.
std::vector<int> boundary_near(const HexComplex& mesh, const std::vector<Vec3>& places, double size, const Context& context) {
  constexpr double kNear = 2;  // h
  std::vector<int> points;
  for (int v = 0; v < mesh.point_count(); ++v) {
    if (v % 256 == 0) context.check();
    const auto near = [&](const Vec3& p) { return (p - mesh.points[v]).squaredNorm() < kNear * kNear * size * size; };
    if (mesh.place[v].dim <= 2 && (places.empty() || std::any_of(places.begin(), places.end(), near))) points.push_back(v);
  }
  return points;
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

void lift_trial_mean(SheetTrial& trial, const SolidTask& task) {
  constexpr int kTries = 3;
  constexpr double kLittle = 0.002;  // of the sharp edges, where all that matters is kept
  Run& run = task.run;
  const Geometry& geometry = task.part.geometry();
  SmoothOptions smoothing;
  smoothing.size = run.options.size;
  smoothing.threads = run.options.threads;
  smoothing.held = trial.held;
  std::vector<PointGap> before;
  run.begin("smooth");
  const double bearable = trial.worth.faithful ? kLittle : 0;
  for (int attempt = 1; attempt <= kTries; ++attempt) {
    SheetTrial other = trial;
    other.smoothing = smooth_mean(other.mesh, *geometry.projector, smoothing, run.context);
    run.context.log("mean SJ " + std::to_string(trial.smoothing.mean_sj) + " -> " + std::to_string(other.smoothing.mean_sj) + ", " +
                    std::to_string(smoothing.held.size()) + " points held");
    if (other.smoothing.inverted > 0 || !(other.smoothing.mean_sj > trial.smoothing.mean_sj)) return;
    std::vector<Vec3> opened = opened_gaps(trial.mesh, other.mesh, task, before);
    if (!opened.empty() && cover_faces(other.mesh, run.result.surface, geometry, run.options.size, run.context) > 0)
      opened = opened_gaps(trial.mesh, other.mesh, task, before);
    if (opened.empty()) {
      other.worth = worth_of(other.mesh, other.smoothing, task);
      other.worth.lost_at_first = trial.worth.lost_at_first;
      if (other.worth.faithful >= trial.worth.faithful && other.worth.lost <= std::max(trial.worth.lost, bearable)) {
        trial = std::move(other);
        return;
      }
    }
    // What it cost lies there; else, or when that was not enough, nothing of the surface moves.
    if (attempt == kTries) return;
    if (attempt + 1 == kTries) opened.clear();
    std::vector<int>& held = smoothing.held;
    for (int v : boundary_near(trial.mesh, opened, run.options.size, run.context)) held.push_back(v);
    std::sort(held.begin(), held.end());
    held.erase(std::unique(held.begin(), held.end()), held.end());
  }
}

SheetTrial smooth_with_sheets(const HexComplex& fitted, const MadeFrom& made_from, const SheetRules& rules, int& vain) {
  const SolidTask& task = made_from.task;
  Run& run = task.run;
  const Geometry& geometry = task.part.geometry();
  std::set<std::uint64_t> made;  // the elements of all choices of sheets: points are fitted alike
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
    Fingerprint elements;
    for (const auto& hex : trial.mesh.hexes)
      for (int v : hex) elements.take(static_cast<std::uint64_t>(v));
    trial.again = !made.insert(elements.value()).second;
    if (trial.again) return trial;
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
