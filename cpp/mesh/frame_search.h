// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include <vector>

#include "base/types.h"

namespace hexfeature {

/// A unit vector and its area.
struct WeightedDirection {
  Vec3 direction;
  double weight;
};

/// Working frames for a part of which the surface normals and some directions of its own (normals of planes, axes) are known:
/// rotations that bring pairs of `directions` onto the axes, best first by the sum of area * |R n|_1 over `normals`. At most
/// `count`, no two of which differ by a permutation of the axes alone. The identity is preferred when it ties.
std::vector<Mat3> best_frames(const std::vector<WeightedDirection>& normals, const std::vector<WeightedDirection>& directions, int count);

}  // namespace hexfeature
