// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include <cstdint>
#include <functional>
#include <vector>

namespace hexfeature {

/// One term over integer unknowns x: weight * max(0, gap - (x[to] - x[from])), or, with weight kHardTerm, the constraint
/// x[to] - x[from] >= gap. Every piecewise-linear convex cost of a difference with integer breakpoints is a sum of such terms.
struct DifferenceTerm {
  int from = 0, to = 0;
  int gap = 0;
  std::int64_t weight = 0;
};
constexpr std::int64_t kHardTerm = -1;

struct DifferenceSolution {
  std::vector<int> x;
  std::vector<int> cycle;  ///< indices of hard terms on a positive cycle: there is no solution (x is then empty)
};

/// Minimise the sum of terms exactly. The linear program is the dual of a min-cost flow (R. K. Ahuja, T. L. Magnanti,
/// J. B. Orlin, Network Flows, 1993, section 9.4 and 14.5): a term is an arc from -> to of capacity `weight` and cost -gap,
/// and x are the negated node potentials, integer because the gaps are. Solved by LEMON's network simplex.
/// Hard constraints are first checked by Bellman-Ford. Unknowns that no term reaches are 0. Deterministic.
DifferenceSolution solve_differences(int unknowns, const std::vector<DifferenceTerm>& terms);

/// The sum of soft terms at x (hard terms not counted), to check optimality.
std::int64_t difference_cost(const std::vector<DifferenceTerm>& terms, const std::vector<int>& x);

/// Add the terms of a convex cost(d), d = x[to] - x[from], linearly interpolated between integers (so that fractional targets
/// keep an integer optimum) and linear far from `target`, where its minimum lies. Only d >= minimum matters; cost is asked for
/// d >= minimum. Slopes are rounded to kTermScale-ths.
void add_convex_terms(std::vector<DifferenceTerm>& terms, int from, int to, double target, int minimum,
                      const std::function<double(int)>& cost);
constexpr double kTermScale = 1000;

}  // namespace hexfeature
