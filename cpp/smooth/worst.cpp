// HexFeatureWB - LGPL-2.1-or-later
#include <algorithm>
#include <cmath>
#include <vector>

#include "smooth/patch.h"

namespace hexfeature {
namespace {

/// Points of the elements below `limit`, and `rings` elements farther.
std::vector<char> points_near(const HexComplex& mesh, const std::vector<double>& quality, double limit, int rings) {
  std::vector<char> marked(mesh.points.size(), 0);
  for (int h = 0; h < mesh.hex_count(); ++h)
    if (quality[h] < limit)
      for (int v : mesh.hexes[h]) marked[v] = 1;
  for (int ring = 0; ring < rings; ++ring) {
    std::vector<char> next = marked;
    for (const auto& hex : mesh.hexes)
      if (std::any_of(hex.begin(), hex.end(), [&](int v) { return marked[v] != 0; }))
        for (int v : hex) next[v] = 1;
    marked.swap(next);
  }
  return marked;
}

}  // namespace

void lift_worst(HexComplex& mesh, SmoothSetting& setting) {
  const double h = setting.options.size;
  std::vector<double> quality;
  Patch::whole(mesh, setting)
      .measure(
          [&] {
            std::vector<double> x;
            for (const Vec3& p : mesh.points) x.insert(x.end(), {p[0], p[1], p[2]});
            return x;
          }(),
          quality);
  const double worst = *std::min_element(quality.begin(), quality.end());
  if (!(worst > 0)) return;
  const double limit = std::clamp(worst + 0.25, 0.5, 0.8);
  if (worst >= limit) return;
  Patch patch(mesh, points_near(mesh, quality, limit, 2), setting);
  patch.boundary->find_feet(patch.x);
  patch.boundary->snap(patch.x);

  std::vector<double> best = patch.x, gradient(patch.x.size());
  Grade best_grade = patch.grade(best), last = best_grade;
  EnergyTerms terms;
  terms.theta = setting.options.theta;
  terms.shape_weight = 0.5;
  for (int power : {1, 1, 2, 2, 4, 4, 8, 8, 16}) {
    terms.power = power;
    if (!std::isfinite(patch.energy->evaluate(patch.x.data(), terms, gradient.data()).energy)) break;
    patch.boundary->hold_at_rims(gradient);
    PatchObjective objective(patch, terms, 0);
    objective.drift_limit = 0.3 * h;
    LbfgsOptions options;
    options.step_limit = 0.1 * h;
    options.floor = patch.energy->hex_count() * HexEnergy::ideal(terms);
    std::vector<double> moved = patch.x;
    Lbfgs(static_cast<int>(moved.size()), setting.workers).descend(objective, moved, options);
    // Off the tangents some elements may get worse: then go less far.
    std::vector<double> next;
    Grade grade;
    for (int tries = 0; tries < 4; ++tries) {
      next = patch.retract(patch.x, moved);
      grade = patch.grade(next);
      if (grade.inverted == 0 && grade.min_sj >= 0.8 * last.min_sj) break;
      for (std::size_t i = 0; i < moved.size(); ++i) moved[i] = 0.5 * (moved[i] + patch.x[i]);
    }
    if (grade.inverted > 0 || grade.min_sj < 0.8 * last.min_sj) break;
    patch.x = next;
    last = grade;
    if (grade.min_sj > best_grade.min_sj) best = next, best_grade = grade;
  }
  patch.x = best;
  patch.boundary->find_feet(patch.x);
  patch.boundary->snap(patch.x);
  patch.write_back(mesh);
}

}  // namespace hexfeature
