// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include <vector>

#include "lattice/lattice.h"
#include "pipeline/sheet_trials.h"

namespace hexfeature {

/// What the meshes of one labelling are made from.
struct MadeFrom {
  const SolidTask& task;
  const SurfaceMesh& mesh;  ///< the labelled surface
  const FeatureShape& shape;
  Lattice& lattice;  ///< a second look may put a finer one here
};

QuantizeOptions quantize_options(const Options& options);

/// The fitted lattice with the sheets that pay, smoothed. `vain` counts the elements of all meshes that stayed inverted.
SheetTrial smooth_with_sheets(const HexComplex& fitted, const MadeFrom& made_from, const SheetRules& rules, int& vain);

/// Smooths the trial's mesh and finds out what it is worth. Where few elements stay inverted, points are taken off smooth CAD edges, and if
/// it `may_lose_edges`, off sharp ones. `around` and `held`: see SmoothOptions.
void smooth_trial(SheetTrial& trial, const SolidTask& task, bool may_lose_edges, const std::vector<int>& around = {},
                  const std::vector<int>& held = {});

/// Lifts the mean scaled Jacobian of a trial's mesh as far as that costs nothing of the part: else with its surface as it is.
void lift_trial_mean(SheetTrial& trial, const SolidTask& task);

/// Marks the points of the elements that are not proved positive, or whose scaled Jacobian is below `limit`.
std::vector<char> points_of_inverted(const HexComplex& complex, double limit = 0);

/// The marked points and all those of their elements.
std::vector<char> with_neighbours(const HexComplex& complex, const std::vector<char>& marked);

}  // namespace hexfeature
