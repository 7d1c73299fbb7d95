// HexFeatureWB - LGPL-2.1-or-later
#include <algorithm>
#include <utility>

#include "lattice/lattice.h"

namespace hexfeature {
namespace {

constexpr int kMostRounds = 25;

/// Solve, fill, separate what collides, again.
Lattice fill_with_separation(const SurfaceMesh& mesh, const FeatureShape& shape, const std::vector<ChartOrder>& orders,
                             const QuantizeOptions& options, const std::vector<Separation>& wanted, bool one_a_round, Context& context) {
  Lattice lattice;
  const Quantizer quantizer(mesh, shape, orders, options);
  std::vector<Separation> separations = wanted;  // sorted
  for (int round = 1; round <= kMostRounds; ++round) {
    lattice = fill_lattice(shape, quantizer.solve(separations, context), 1, context, separations);
    lattice.report.rounds = round;
    lattice.report.size = options.size;
    const auto& more = lattice.report.separations;
    if (lattice.report.ok || more.empty()) break;
    separations.insert(separations.end(), more.begin(), one_a_round ? more.begin() + 1 : more.end());
    std::sort(separations.begin(), separations.end());
  }
  return lattice;
}

}  // namespace

Lattice build_lattice(const SurfaceMesh& mesh, const FeatureShape& shape, const QuantizeOptions& options, Context& context,
                      const std::vector<Separation>& wanted) {
  return build_lattice(mesh, shape, sample_axis_rays(mesh, ray_count(mesh, options), context), options, context, true, wanted);
}

Lattice build_lattice(const SurfaceMesh& mesh, const FeatureShape& shape, const AxisRays& rays, const QuantizeOptions& options,
                      Context& context, bool thorough, const std::vector<Separation>& wanted) {
  Lattice first;
  int rounds = 0;
  try {
    auto orders = chart_orders(mesh, shape, rays, options.size, context);
    auto all_orders = orders;
    const auto by_position = position_orders(shape, 0.02 * options.size);
    all_orders.insert(all_orders.end(), by_position.begin(), by_position.end());
    for (const double factor : {1.0, 0.7, 0.5}) {
      QuantizeOptions finer = options;
      finer.size = factor * options.size;
      for (const auto& [kept, one_a_round] :
           {std::make_pair(&orders, false), std::make_pair(&orders, true), std::make_pair(&all_orders, false)}) {
        if (one_a_round && !thorough) continue;
        Lattice lattice = fill_with_separation(mesh, shape, *kept, finer, wanted, one_a_round, context);
        rounds += lattice.report.rounds;
        lattice.report.rounds = rounds;
        if (lattice.report.ok) return lattice;
        if (first.report.reason.empty()) first = std::move(lattice);
      }
      if (!thorough) break;
    }
  } catch (const PolycubeError& error) {
    first.report.reason = error.reason;
    first.report.charts = error.charts;
  }
  first.report.rounds = std::max(1, rounds);
  return first;  // the failure at the size that was asked for names its causes best
}

}  // namespace hexfeature
