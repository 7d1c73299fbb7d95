// HexFeatureWB - LGPL-2.1-or-later
#include <algorithm>
#include <cmath>
#include <vector>

#include "smooth/patch.h"

namespace hexfeature {
namespace {

/// Better elements are good enough: to make them better still evens out their angles and not their sizes, and stresses get worse.
constexpr double kGood = 0.9;
constexpr double kPoor = 0.5;      ///< elements below it are not to pay ...
constexpr double kGranted = 0.98;  ///< ... more than a little; no element falls below the mesh's worst
constexpr int kRounds = 3, kSteps = 15;

std::vector<double> floors(const Patch& patch, double worst) {
  std::vector<double> floor;
  patch.measure(patch.x, floor);
  for (double& f : floor) f = std::min(f, std::max(worst, kGranted * std::min(f, kPoor)));
  return floor;
}

}  // namespace

void lift_mean(HexComplex& mesh, SmoothSetting& setting) {
  std::vector<double> quality;
  measure(mesh, setting.workers, quality);
  const double worst = *std::min_element(quality.begin(), quality.end());
  if (!(worst > 0) || worst >= kGood) return;
  Patch patch(mesh, points_near(mesh, 1, [&](int h) { return quality[h] < kGood; }), setting);
  patch.boundary->find_feet(patch.x);
  patch.boundary->snap(patch.x);
  const double start = patch.grade().sum_sj;
  const std::vector<double> floor = floors(patch, worst);
  EnergyTerms terms;
  terms.theta = setting.options.theta;
  terms.mean = true;
  terms.worst = worst;
  terms.shape_weight = 0.002;
  Lbfgs descent(static_cast<int>(patch.x.size()), patch.workers);
  std::vector<double> gradient(patch.x.size());
  double sum = start;
  for (int round = 0; round < kRounds; ++round) {
    patch.energy->admit(patch.x.data());
    if (!std::isfinite(patch.energy->evaluate(patch.x.data(), terms, gradient.data()).energy)) break;
    patch.boundary->hold_at_rims(gradient);
    PatchObjective objective(patch, terms, 0);
    objective.drift_limit = 0.3 * setting.options.size;
    LbfgsOptions options;
    options.step_limit = 0.1 * setting.options.size;
    options.iterations = kSteps;
    options.floor = patch.energy->floor(terms);
    std::vector<double> moved = patch.x;
    descent.descend(objective, moved, options);
    const std::vector<double> next = patch.retract(patch.x, moved, floor);
    const Grade grade = patch.grade(next);
    if (grade.inverted > 0 || grade.sum_sj <= sum) break;
    patch.x = next;
    sum = grade.sum_sj;
  }
  if (!(sum > start)) return;
  patch.boundary->find_feet(patch.x);
  patch.boundary->snap(patch.x);
  patch.write_back(mesh);
}

}  // namespace hexfeature
