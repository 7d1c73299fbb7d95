// HexFeatureWB - LGPL-2.1-or-later
#include "smooth/lbfgs.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hexfeature {
namespace {

constexpr int kMemory = 8, kChunk = 2048;

/// Vector operations in chunks of fixed length, so that sums do not depend on the number of threads.
class Algebra {
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
  /// y += s x
  void add(std::vector<double>& y, double s, const std::vector<double>& x) {
    workers_.run(n_, 8 * kChunk, [&](int begin, int end) {
      for (int i = begin; i < end; ++i) y[i] += s * x[i];
    });
  }
  /// y = a + s x
  void sum(std::vector<double>& y, const std::vector<double>& a, double s, const std::vector<double>& x) {
    workers_.run(n_, 8 * kChunk, [&](int begin, int end) {
      for (int i = begin; i < end; ++i) y[i] = a[i] + s * x[i];
    });
  }
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

struct Pair {
  std::vector<double> s, y;
  double rho = 0;
};

}  // namespace

LbfgsResult minimise(Objective& objective, std::vector<double>& x, const LbfgsOptions& options, Workers& workers) {
  const int n = static_cast<int>(x.size());
  Algebra algebra(n, workers);
  LbfgsResult result;
  std::vector<double> gradient(n), trial(n), trial_gradient(n), direction(n);
  double value = objective.evaluate(x, gradient);
  result.evaluations = 1;
  result.value = value;
  if (!(value < std::numeric_limits<double>::infinity())) return result;

  std::vector<Pair> memory(kMemory);
  int stored = 0, newest = -1, idle = 0;
  double scale = 0;  // of the inverse Hessian; 0: not known, the first step is as long as a third of the limit
  while (result.iterations < options.iterations) {
    // Two-loop recursion.
    direction = gradient;
    double alpha[kMemory];
    for (int i = 0; i < stored; ++i) {
      const Pair& m = memory[(newest - i + kMemory) % kMemory];
      alpha[i] = m.rho * algebra.dot(m.s, direction);
      algebra.add(direction, -alpha[i], m.y);
    }
    objective.precondition(direction);
    if (stored > 0)
      workers.run(n, 8 * kChunk, [&](int begin, int end) {
        for (int i = begin; i < end; ++i) direction[i] *= scale;
      });
    for (int i = stored - 1; i >= 0; --i) {
      const Pair& m = memory[(newest - i + kMemory) % kMemory];
      algebra.add(direction, alpha[i] - m.rho * algebra.dot(m.y, direction), m.s);
    }
    const double slope = -algebra.dot(gradient, direction), reach = algebra.longest(direction);
    if (!(slope < 0) || !(reach > 0)) {
      result.converged = slope == 0;
      if (stored == 0) break;
      stored = 0;
      continue;
    }
    double step = stored > 0 ? std::min(1.0, options.step_limit / reach) : options.step_limit / (3 * reach);

    // Backtracking with quadratic interpolation; a step into where the value is not defined is cut in four.
    double next = std::numeric_limits<double>::infinity();
    bool found = false;
    for (int tries = 0; tries < 14 && !found; ++tries) {
      algebra.sum(trial, x, -step, direction);
      next = objective.evaluate(trial, trial_gradient);
      ++result.evaluations;
      if (next <= value + 1e-4 * step * slope) {
        found = true;
      } else if (next < std::numeric_limits<double>::infinity()) {
        const double best = -slope * step * step / (2 * (next - value - slope * step));
        step = std::clamp(best, 0.1 * step, 0.5 * step);
      } else {
        step *= 0.25;
      }
    }
    if (!found) {
      if (stored == 0) {
        result.converged = true;
        break;
      }
      stored = 0;
      continue;
    }

    const int slot = (newest + 1) % kMemory;
    Pair& pair = memory[slot];
    pair.s.resize(n);
    pair.y.resize(n);
    algebra.sum(pair.s, trial, -1, x);
    algebra.sum(pair.y, trial_gradient, -1, gradient);
    const double sy = algebra.dot(pair.s, pair.y);
    if (sy > 1e-12 * std::sqrt(algebra.dot(pair.s, pair.s) * algebra.dot(pair.y, pair.y))) {
      pair.rho = 1 / sy;
      direction = pair.y;
      objective.precondition(direction);
      scale = sy / algebra.dot(pair.y, direction);
      newest = slot;
      stored = std::min(stored + 1, kMemory);
    }
    const double gain = value - next, before = value - options.floor;
    x.swap(trial);
    gradient.swap(trial_gradient);
    value = next;
    ++result.iterations;
    result.value = value;
    if (objective.enough(x)) break;
    idle = gain < options.least_decrease * before ? idle + 1 : 0;
    if (idle >= 3) {
      result.converged = true;
      break;
    }
  }
  return result;
}

}  // namespace hexfeature
