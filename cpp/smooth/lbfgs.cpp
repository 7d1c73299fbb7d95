// HexFeatureWB - LGPL-2.1-or-later
#include "smooth/lbfgs.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hexfeature {
namespace {

constexpr int kChunk = 2048;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace

/// Vector operations in chunks of fixed length, so that sums do not depend on the number of threads.
class Lbfgs::Algebra {
 public:
  Algebra(int n, Workers& workers) : n_(n), chunks_((n + kChunk - 1) / kChunk), parts_(chunks_), workers_(workers) {}

  double dot(const std::vector<double>& a, const std::vector<double>& b) {
    workers_.run(chunks_, 8, [&](int begin, int end) {
      for (int c = begin; c < end; ++c) {
        double sum[4] = {0, 0, 0, 0};
        const int last = std::min(n_, (c + 1) * kChunk);
        int i = c * kChunk;
        for (; i + 4 <= last; i += 4)
          for (int k = 0; k < 4; ++k) sum[k] += a[i + k] * b[i + k];
        for (; i < last; ++i) sum[0] += a[i] * b[i];
        parts_[c] = (sum[0] + sum[1]) + (sum[2] + sum[3]);
      }
    });
    double total = 0;
    for (double p : parts_) total += p;
    return total;
  }
  /// y = a + s x; y may be a.
  void sum(std::vector<double>& y, const std::vector<double>& a, double s, const std::vector<double>& x) {
    workers_.run(n_, 8 * kChunk, [&](int begin, int end) {
      for (int i = begin; i < end; ++i) y[i] = a[i] + s * x[i];
    });
  }
  void multiply(std::vector<double>& y, double s) {
    workers_.run(n_, 8 * kChunk, [&](int begin, int end) {
      for (int i = begin; i < end; ++i) y[i] *= s;
    });
  }
  /// The longest move of a point.
  double longest(const std::vector<double>& d) const {
    double most = 0;
    for (int i = 0; i + 2 < n_; i += 3) most = std::max(most, d[i] * d[i] + d[i + 1] * d[i + 1] + d[i + 2] * d[i + 2]);
    return std::sqrt(most);
  }

 private:
  int n_, chunks_;
  std::vector<double> parts_;
  Workers& workers_;
};

Lbfgs::Lbfgs(int unknowns, Workers& workers)
    : n_(unknowns),
      algebra_(new Algebra(unknowns, workers)),
      memory_(kMemory),
      gradient_(unknowns),
      direction_(unknowns),
      trial_(unknowns),
      trial_gradient_(unknowns) {}

Lbfgs::~Lbfgs() = default;

void Lbfgs::find_direction(const Objective& objective) {
  direction_ = gradient_;
  double alpha[kMemory];
  for (int i = 0; i < stored_; ++i) {
    alpha[i] = recent(i).rho * algebra_->dot(recent(i).s, direction_);
    algebra_->sum(direction_, direction_, -alpha[i], recent(i).y);
  }
  objective.precondition(direction_);
  if (stored_ > 0) algebra_->multiply(direction_, scale_);
  for (int i = stored_ - 1; i >= 0; --i)
    algebra_->sum(direction_, direction_, alpha[i] - recent(i).rho * algebra_->dot(recent(i).y, direction_), recent(i).s);
  objective.constrain(direction_);
}

bool Lbfgs::search(Objective& objective, const std::vector<double>& x, double& value, double slope, double step, int& evaluations) {
  // Backtracking with quadratic interpolation; a step to where the value is not defined is cut in four.
  for (int tries = 0; tries < 14; ++tries) {
    algebra_->sum(trial_, x, -step, direction_);
    const double next = objective.evaluate(trial_, trial_gradient_);
    ++evaluations;
    if (next <= value + 1e-4 * step * slope) {
      value = next;
      return true;
    }
    if (next < kInfinity)
      step = std::clamp(-slope * step * step / (2 * (next - value - slope * step)), 0.1 * step, 0.5 * step);
    else
      step *= 0.25;
  }
  return false;
}

void Lbfgs::learn(const Objective& objective, const std::vector<double>& x) {
  Pair& pair = memory_[(newest_ + 1) % kMemory];
  pair.s.resize(n_);
  pair.y.resize(n_);
  algebra_->sum(pair.s, trial_, -1, x);
  algebra_->sum(pair.y, trial_gradient_, -1, gradient_);
  const double sy = algebra_->dot(pair.s, pair.y);
  if (!(sy > 1e-12 * std::sqrt(algebra_->dot(pair.s, pair.s) * algebra_->dot(pair.y, pair.y)))) return;
  pair.rho = 1 / sy;
  direction_ = pair.y;
  objective.precondition(direction_);
  scale_ = sy / algebra_->dot(pair.y, direction_);
  newest_ = (newest_ + 1) % kMemory;
  stored_ = std::min(stored_ + 1, kMemory);
}

LbfgsResult Lbfgs::descend(Objective& objective, std::vector<double>& x, const LbfgsOptions& options) {
  LbfgsResult result;
  double value = objective.evaluate(x, gradient_);
  result.evaluations = 1;
  result.value = value;
  if (!(value < kInfinity)) return result;
  int idle = 0;
  while (result.iterations < options.iterations) {
    find_direction(objective);
    const double slope = -algebra_->dot(gradient_, direction_), reach = algebra_->longest(direction_);
    const double before = value;
    if (!(slope < 0) || !(reach > 0) ||
        !search(objective, x, value, slope, std::min(1.0, options.step_limit / reach), result.evaluations)) {
      // What was learnt does not help here; without it, this is a minimum as far as numbers go.
      result.converged = stored_ == 0;
      if (stored_ == 0) break;
      forget();
      continue;
    }
    learn(objective, x);
    x.swap(trial_);
    gradient_.swap(trial_gradient_);
    ++result.iterations;
    result.value = value;
    if (objective.enough(x)) break;
    idle = before - value < options.least_decrease * (before - options.floor) ? idle + 1 : 0;
    result.converged = idle >= 3;
    if (result.converged) break;
  }
  return result;
}

}  // namespace hexfeature
