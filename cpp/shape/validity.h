// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include <string>
#include <vector>

#include "shape/feature_shape.h"

namespace hexfeature {

/// One violated condition, with what it blames. V1..V4 are combinatorial (design 3.4); V5 and V6 need the filled lattice.
struct Violation {
  int condition = 0;  ///< 1 opposite or equal axes share a border, loop without corners; 2 corner; 3 turning number; 4 arc monotone / cycle
  double weight = 1;
  std::string reason;
  std::vector<int> charts, arcs, corners;
};

struct ValidityReport {
  std::vector<Violation> violations;
  double cost = 0;       ///< sum of weights, 0 when valid
  double sign_cost = 0;  ///< how much geometry had to be overruled to choose arc signs
  bool valid() const { return violations.empty(); }
};

/// Check V1-V4 and choose every arc's sign: a small constraint problem, started from geometry (displacement and the
/// dihedral's convexity) and solved so that every corner is one of the legal octant configurations where possible.
/// Writes the chosen signs into `shape`. `size` is the element size h. Deterministic.
ValidityReport check_validity(FeatureShape& shape, double size);

/// The paper's four recognition-model generation conditions (3.1.7), literally; used by `--labels paper`.
std::vector<Violation> check_paper_conditions(const FeatureShape& shape);

}  // namespace hexfeature
