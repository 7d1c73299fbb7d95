// HexFeatureWB - LGPL-2.1-or-later
#include <algorithm>
#include <cmath>
#include <limits>

#include "smooth/patch.h"

namespace hexfeature {
namespace {

/// epsilon^2 from the worst determinant (experiments B5), never rising.
void lower_epsilon(EnergyTerms& terms, double min_det) {
  const double d = std::min(min_det, 0.0);
  terms.epsilon_squared = std::min(terms.epsilon_squared, 1e-6 + 0.04 * d * d);
}

double worst_determinant(Patch& patch, const EnergyTerms& terms) { return patch.energy->evaluate(patch.x.data(), terms, nullptr).min_det; }

LbfgsOptions descent_options(const Patch& patch, const EnergyTerms& terms) {
  LbfgsOptions o;
  o.step_limit = 0.3 * patch.setting.options.size;
  o.floor = patch.energy->floor(terms);
  return o;
}

/// The best of the states seen: fewest inverted elements, then the worst element, then the mean. Differences of the worst
/// that nobody sees (often the CAD's own corner sets it) must not cost the mean.
class Best {
 public:
  void offer(const Patch& patch) {
    const Grade g = patch.grade();
    if (g.inverted < grade_.inverted || g.min_sj > peak_) peak_ = g.min_sj;
    const double slack = peak_ > 0.1 ? 0.003 : 0;
    const bool better =
        g.inverted < grade_.inverted ||
        (g.inverted == grade_.inverted && (g.min_sj > grade_.min_sj + slack || (g.min_sj >= peak_ - slack && g.sum_sj > grade_.sum_sj)));
    if (!better) return;
    x_ = patch.x;
    grade_ = g;
  }
  const std::vector<double>& x() const { return x_; }

 private:
  std::vector<double> x_;
  Grade grade_{std::numeric_limits<int>::max(), -2, 0};
  double peak_ = -2;
};

/// Tells when the soft rounds lead nowhere: neither fewer elements are inverted on the CAD, nor is the worst of them better.
class Standstill {
 public:
  bool after(const Grade& snapped) {
    constexpr int kPatience = 5;
    constexpr double kGain = 0.02;
    const bool fewer = snapped.inverted < least_inverted_;
    const bool better = snapped.inverted == least_inverted_ && snapped.min_sj > best_sj_ + kGain;
    idle_ = fewer || better ? 0 : idle_ + 1;
    if (fewer || better) best_sj_ = snapped.min_sj;
    least_inverted_ = std::min(least_inverted_, snapped.inverted);
    return idle_ >= kPatience;
  }

 private:
  int least_inverted_ = std::numeric_limits<int>::max(), idle_ = 0;
  double best_sj_ = -2;
};

/// The patch as it is where its boundary points are put onto the CAD.
std::vector<double> snapped(Patch& patch) {
  std::vector<double> x = patch.x;
  patch.boundary->place_on_feet(x);
  return x;
}

/// Rounds from `round` on, before `last`; true when no more are needed or they lead nowhere.
bool soft_rounds(Patch& patch, int& round, int last, Standstill& standstill) {
  const SmoothOptions& options = patch.setting.options;
  const double h = options.size;
  EnergyTerms terms;
  terms.theta = options.theta;
  terms.epsilon_squared = std::numeric_limits<double>::infinity();
  Lbfgs descent(static_cast<int>(patch.x.size()), patch.workers);
  for (; round < last; ++round) {
    const double deviation = patch.boundary->find_feet(patch.x);
    const Grade grade = patch.grade();
    if (grade.min_sj > 0.05 && deviation < 0.02 * h) return true;
    const Grade on_cad = patch.grade(snapped(patch));
    if (on_cad.inverted == 0 || standstill.after(on_cad)) return true;
    lower_epsilon(terms, worst_determinant(patch, terms));
    PatchObjective objective(patch, terms, 200 * std::pow(3.0, std::min(round, 6)));
    objective.drift_limit = 0.3 * h;
    descent.descend(objective, patch.x, descent_options(patch, terms));
    patch.setting.context.progress("smooth", 0.5 * (round + 1) / options.untangle_rounds);
  }
  return false;
}

}  // namespace

int untangle_softly(HexComplex& mesh, Patch& patch) {
  // What is inverted after these rounds is stuck in some place, and the other elements have come to rest.
  constexpr int kTogether = 4, kRings = 3;
  const SmoothOptions& options = patch.setting.options;
  const int most = options.untangle_rounds;
  int round = 0;
  Standstill whole, standstill;
  if (soft_rounds(patch, round, std::min(kTogether, most), whole)) return round;
  std::vector<char> stuck(mesh.hexes.size()), may_move(mesh.points.size(), 0);
  for (std::size_t i = 0; i < patch.nodes.size(); ++i) may_move[patch.nodes[i]] = patch.free[i];
  std::vector<double> quality;
  for (bool done = false; !done && round < most;) {
    patch.boundary->find_feet(patch.x);
    patch.measure(snapped(patch), quality);
    std::fill(stuck.begin(), stuck.end(), 0);
    for (std::size_t i = 0; i < quality.size(); ++i) stuck[patch.elements[i]] = !(quality[i] > 0);
    std::vector<char> near = points_near(mesh, kRings, [&](int h) { return stuck[h] != 0; });
    for (std::size_t v = 0; v < near.size(); ++v) near[v] = near[v] && may_move[v];
    const auto moves = [&](int h) { return std::any_of(mesh.hexes[h].begin(), mesh.hexes[h].end(), [&](int v) { return near[v] != 0; }); };
    const bool most_move = 2 * std::count_if(patch.elements.begin(), patch.elements.end(), moves) > static_cast<long>(quality.size());
    if (most_move && !options.brief) {
      soft_rounds(patch, round, most, standstill);
      return round;
    }
    // Only what is stuck moves. Where most is poor something else is soon bad: then another patch each time, that looks closely at it.
    patch.write_back(mesh);
    Patch part(mesh, most_move ? may_move : near, patch.setting);
    done = soft_rounds(part, round, options.brief ? std::min(round + kTogether, most) : most, standstill);
    part.write_back(mesh);
    patch.read(mesh);
  }
  return round;
}

void slide(Patch& patch) {
  const double h = patch.setting.options.size;
  EnergyTerms terms;
  terms.theta = patch.setting.options.theta;
  terms.epsilon_squared = std::numeric_limits<double>::infinity();
  patch.boundary->find_feet(patch.x);
  patch.boundary->snap(patch.x);
  Best best;
  best.offer(patch);
  std::vector<double> gradient(patch.x.size());
  Lbfgs descent(static_cast<int>(patch.x.size()), patch.workers);
  double drift = 0.3 * h;
  int left = 200;
  while (left > 0 && drift > 1e-3 * h) {
    lower_epsilon(terms, worst_determinant(patch, terms));
    const double before = patch.energy->evaluate(patch.x.data(), terms, gradient.data()).energy;
    if (!std::isfinite(before)) break;
    patch.boundary->hold_at_rims(gradient);
    const Boundary::Feet feet = patch.boundary->save();
    PatchObjective objective(patch, terms, 0);
    objective.drift_limit = drift;
    LbfgsOptions options = descent_options(patch, terms);
    options.iterations = std::min(left, 40);
    std::vector<double> moved = patch.x;
    const LbfgsResult result = descent.descend(objective, moved, options);
    left -= std::max(result.iterations, 5);
    moved = patch.retract(patch.x, moved);
    // The tangent spaces are trusted as far as they foretell the energy on the true surface.
    const double after = patch.energy->evaluate(moved.data(), terms, nullptr).energy;
    const double foretold = before - result.value, gain = before - after;
    if (gain > 0.7 * foretold) drift = std::min(h, 1.5 * drift);
    if (gain < 0.3 * foretold) drift *= 0.4;
    const bool accepted = gain > 0;
    if (accepted) {
      patch.x = moved;
      best.offer(patch);
    } else {
      patch.boundary->restore(feet);
      descent.forget();
    }
    patch.setting.context.progress("smooth", 0.5 + 0.3 * (1 - left / 200.0));
    const double floor = patch.energy->floor(terms);
    if (accepted && worst_determinant(patch, terms) > 0 && gain < (result.converged ? 0.01 : 1e-3) * (before - floor)) break;
  }
  patch.x = best.x();
  patch.boundary->find_feet(patch.x);
  patch.boundary->snap(patch.x);
}

}  // namespace hexfeature
