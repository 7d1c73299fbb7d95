// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include <array>

#include "base/types.h"

namespace hexfeature {

/// The map of a 20-node serendipity hexahedron from the reference cube. Node order as in QuadraticMesh.
using Hex20 = std::array<Vec3, 20>;

/// Least Jacobian determinant at the 27 integration points of C3D20, the 8 of C3D20R and the 20 nodes, over the mean of the
/// 8's; not positive: a solver stops there. NaN coordinates give NaN.
double least_jacobian(const Hex20& nodes);

/// The 216 Bernstein coefficients of the Jacobian determinant, of degree 5 in each variable (r, s, t) of the cube [-1, 1]^3;
/// coefficient (i, j, k) is at 36 i + 6 j + k. They bound the determinant from both sides on the whole element.
/// Source: Johnen, Remacle, Geuzaine, "Geometrical validity of curvilinear finite elements", J. Comput. Phys. 233, 2013.
std::array<double, 216> jacobian_bernstein(const Hex20& nodes);

/// Derivatives of these coefficients by the place of node `node`; they do not depend on that place, as a determinant is linear
/// in one node.
std::array<Vec3, 216> jacobian_bernstein_slopes(const Hex20& nodes, int node);

/// Whether the determinant is positive on the whole element: proved by the coefficients, on halves of the cube where they do
/// not decide, at most `depth` times. False when not proved.
bool proves_positive(const Hex20& nodes, int depth = 3);

}  // namespace hexfeature
