// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>

namespace hexfeature {

using Vec2 = Eigen::Vector2d;
using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;

/// Assigned direction of a triangle, region or chart: 0..5 = +X -X +Y -Y +Z -Z.
using Label = std::int8_t;
constexpr Label kNoLabel = -1;

constexpr int axis_of(Label l) { return l / 2; }
constexpr int sign_of(Label l) { return l % 2 == 0 ? 1 : -1; }
constexpr Label opposite(Label l) { return static_cast<Label>(l ^ 1); }
constexpr Label make_label(int axis, int sign) { return static_cast<Label>(2 * axis + (sign < 0 ? 1 : 0)); }
inline Vec3 direction(Label l) { return sign_of(l) * Vec3::Unit(axis_of(l)); }
/// The axis that is neither a nor b (a != b).
constexpr int third_axis(int a, int b) { return 3 - a - b; }

}  // namespace hexfeature
