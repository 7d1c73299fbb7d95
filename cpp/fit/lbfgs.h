// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <cmath>

namespace hexfeature {

/// Limited-memory BFGS with backtracking (Nocedal & Wright, Numerical Optimization, algorithms 7.4 and 3.1).
/// `energy(x, gradient)` returns the value and fills the gradient; infinity is a wall. The first trial step of each iteration moves
/// no coordinate further than `max_step`. Returns the number of iterations done; x holds the best point.
template <class Energy>
int minimise_lbfgs(Eigen::VectorXd& x, const Energy& energy, int iterations, double max_step, double relative_tolerance = 1e-5) {
  constexpr int kMemory = 6;
  const Eigen::Index n = x.size();
  Eigen::MatrixXd S(n, kMemory), Y(n, kMemory);
  Eigen::VectorXd rho(kMemory), alpha(kMemory), g(n), g_new(n), x_new(n), d(n);
  int stored = 0, newest = -1;
  double f = energy(x, g);
  for (int k = 0; k < iterations; ++k) {
    d = -g;
    for (int i = 0; i < stored; ++i) {
      const int j = (newest - i + kMemory) % kMemory;
      alpha[j] = rho[j] * S.col(j).dot(d);
      d -= alpha[j] * Y.col(j);
    }
    if (stored > 0) d *= S.col(newest).dot(Y.col(newest)) / Y.col(newest).squaredNorm();
    for (int i = stored - 1; i >= 0; --i) {
      const int j = (newest - i + kMemory) % kMemory;
      d += S.col(j) * (alpha[j] - rho[j] * Y.col(j).dot(d));
    }
    double slope = g.dot(d);
    if (!(slope < 0)) {
      d = -g;
      slope = -g.squaredNorm();
      stored = 0;
    }
    const double largest = d.cwiseAbs().maxCoeff();
    if (!(largest > 0) || !std::isfinite(largest)) return k;
    double t = std::min(1.0, max_step / largest), f_new = f;
    bool ok = false;
    for (int trial = 0; trial < 30; ++trial, t *= 0.5) {
      x_new = x + t * d;
      f_new = energy(x_new, g_new);
      if (std::isfinite(f_new) && f_new <= f + 1e-4 * t * slope) {
        ok = true;
        break;
      }
    }
    if (!ok) return k;
    const double sy = t * d.dot(g_new - g);
    if (sy > 1e-12 * t * d.norm() * (g_new - g).norm()) {
      newest = (newest + 1) % kMemory;
      S.col(newest) = x_new - x;
      Y.col(newest) = g_new - g;
      rho[newest] = 1 / sy;
      stored = std::min(stored + 1, kMemory);
    }
    const bool converged = f - f_new < relative_tolerance * std::abs(f_new);
    x.swap(x_new);
    g.swap(g_new);
    f = f_new;
    if (converged) return k + 1;
  }
  return iterations;
}

}  // namespace hexfeature
