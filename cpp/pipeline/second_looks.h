// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include "fit/fit.h"
#include "pipeline/fitted_mesh.h"

namespace hexfeature {

/// A sound mesh that is not faithful, looked at again: points late bound to the CAD edges that it does not follow, or drawn to what it does
/// not cover; lattice lines more; at last a fit with paths of any turns. What is better (is_better) takes the place of `best`; each look
/// has a share of the time left, and when one has used that up there is no other. `fitted` is the complex that `best` was smoothed from,
/// `fit` how; `vain` counts on as for smooth_with_sheets.
void look_again(SheetTrial& best, const HexComplex& fitted, const MadeFrom& made_from, const FitOptions& fit, const SheetRules& rules,
                int& vain);

}  // namespace hexfeature
