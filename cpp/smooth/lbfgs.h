// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include <memory>
#include <vector>

#include "smooth/workers.h"

namespace hexfeature {

/// A function of point coordinates (3 a point) to be made small.
class Objective {
 public:
  virtual ~Objective() = default;
  /// Value at x, infinite where it is not defined; `gradient` is overwritten when the value is finite. Components that
  /// must not change have gradient 0; a linear constraint is kept by gradients within its subspace.
  virtual double evaluate(const std::vector<double>& x, std::vector<double>& gradient) = 0;
  /// r <- M r with a symmetric positive matrix M that resembles the inverse Hessian up to a factor.
  virtual void precondition(std::vector<double>& r) const { (void)r; }
  /// Project a direction onto the subspace of the linear constraints.
  virtual void constrain(std::vector<double>& direction) const { (void)direction; }
  /// Asked after each step: true to end.
  virtual bool enough(const std::vector<double>& x) const {
    (void)x;
    return false;
  }
};

struct LbfgsOptions {
  int iterations = 40;
  double step_limit = 1;         ///< no point moves farther in one step
  double floor = 0;              ///< a lower bound of the value; decreases are judged relative to value - floor
  double least_decrease = 1e-4;  ///< end after three steps in a row that lower value - floor by less than this fraction
};

struct LbfgsResult {
  double value = 0;
  int iterations = 0, evaluations = 0;
  bool converged = false;  ///< ended because hardly anything was left to gain (not: enough(), or iterations used up)
};

/// Limited-memory BFGS with memory 8 and a backtracking line search. What it has learnt about the Hessian stays from one
/// descent to the next, for objectives that differ little (tangent planes sought anew).
/// Source: Nocedal and Wright, "Numerical Optimization", 2nd ed., Springer 2006, algorithms 7.4 and 3.1.
class Lbfgs {
 public:
  Lbfgs(int unknowns, Workers& workers);
  ~Lbfgs();
  /// `x` is changed in place and its value never rises.
  LbfgsResult descend(Objective& objective, std::vector<double>& x, const LbfgsOptions& options);
  void forget() { stored_ = 0; }

 private:
  static constexpr int kMemory = 8;
  struct Pair {
    std::vector<double> s, y;
    double rho = 0;
  };
  const Pair& recent(int i) const { return memory_[(newest_ - i + kMemory) % kMemory]; }
  /// direction = - (approximate inverse Hessian) gradient, with the sign left out.
  void find_direction(const Objective& objective);
  /// Step along -direction_ that lowers the value enough, into trial_; false when there is none.
  bool search(Objective& objective, const std::vector<double>& x, double& value, double slope, double step, int& evaluations);
  void learn(const Objective& objective, const std::vector<double>& x);

  class Algebra;
  int n_;
  std::unique_ptr<Algebra> algebra_;
  std::vector<Pair> memory_;
  int stored_ = 0, newest_ = -1;
  double scale_ = 1;  ///< of the inverse Hessian
  std::vector<double> gradient_, direction_, trial_, trial_gradient_;
};

}  // namespace hexfeature
