// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include <vector>

#include "base/context.h"
#include "mesh/hex_complex.h"
#include "mesh/projector.h"

namespace hexfeature {

struct SmoothOptions {
  double size = 1;             ///< target element size h
  double theta = 0.1;          ///< weight of the volume term g against the shape term f
  int untangle_rounds = 20;    ///< soft rounds of <= 40 L-BFGS iterations
  bool worst_stage = true;     ///< the stage that lifts the worst element
  int threads = 2;             ///< results do not depend on it, bit for bit
  double least_target = 0.25;  ///< elements want to be no smaller than this many h
  /// Where most elements are poor by nature: untangling looks anew for bad ones time and again, points slide only if some stay inverted,
  /// and the mass of the elements is lifted only a little.
  bool brief = false;
  std::vector<int> held;  ///< points that stay where they are; they must lie on their CAD entity already
  /// Of a smoothed mesh only these points are new: untangling and sliding move what is near them, the stages after that bad elements
  /// wherever they are. Empty: everything.
  std::vector<int> around;
};

struct SmoothReport {
  double min_sj_before = 0, min_sj = 0, mean_sj = 0;
  int inverted_before = 0, inverted = 0;  ///< elements not proved positive (`proves_positive`)
  int rounds = 0;
  double deviation = 0;  ///< largest distance of a boundary node from its CAD entity at the end
};

/// Untangle and smooth (design 3.9, experiments B5). Boundary nodes slide on their CAD entity (place.dim 0 fixed, 1 on the curve,
/// 2 on the surface) and end exactly on it; place.uv is kept up to date. Changes points and place only. Deterministic.
SmoothReport smooth(HexComplex& complex, const Projector& projector, const SmoothOptions& options, Context& context);

/// Lift the mean scaled Jacobian of a smoothed mesh without inverted elements. The worst element stays as good as it is or gains, and poor
/// ones lose little. Points slide as they do in `smooth`, so what the mesh keeps of the CAD may change a little.
SmoothReport smooth_mean(HexComplex& complex, const Projector& projector, const SmoothOptions& options, Context& context);

}  // namespace hexfeature
