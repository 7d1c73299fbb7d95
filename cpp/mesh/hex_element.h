// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include <array>
#include <vector>

#include "base/types.h"

namespace hexfeature {

/// Measures of one trilinear hexahedron (VTK node order, see HexComplex). Dimensionless unless said; NaN coordinates give NaN.

/// Verdict's scaled Jacobian: the least of the 8 corners and the centre of det / product of edge lengths, in [-1, 1].
/// An element with an edge of no length has 0 there.
/// Source: Stimpson et al., "The Verdict Library Reference Manual", Sandia National Laboratories, 2007, section 7.14.
double scaled_jacobian(const std::vector<Vec3>& points, const std::array<int, 8>& hex);
double scaled_jacobian(const std::array<Vec3, 8>& corners);

/// The 27 Bernstein coefficients of the Jacobian determinant of the trilinear map from the unit cube, of degree 2 in each
/// variable (r, s, t); coefficient (i, j, k) is at 9 i + 3 j + k. They bound the determinant from both sides on the whole
/// element, and their mean is exactly its volume. Unit: volume.
/// Source: Johnen, Remacle, Geuzaine, "Geometrical validity of curvilinear finite elements", J. Comput. Phys. 233, 2013.
std::array<double, 27> jacobian_bernstein(const std::vector<Vec3>& points, const std::array<int, 8>& hex);
std::array<double, 27> jacobian_bernstein(const std::array<Vec3, 8>& corners);

/// Least of the 27 Bernstein coefficients over the mean edge length cubed. > 0 proves the element injective.
double bernstein_minimum(const std::vector<Vec3>& points, const std::array<int, 8>& hex);

/// Whether the Jacobian determinant is positive on the whole element: proved by the coefficients, which are made sharper by
/// halving the cube (de Casteljau) where they do not decide, at most `depth` times. False when not proved.
bool proves_positive(const std::vector<Vec3>& points, const std::array<int, 8>& hex, int depth = 4);
bool proves_positive(const std::array<Vec3, 8>& corners, int depth = 4);

/// The scaled Jacobian of an element proved positive; of any other one a number <= 0 (NaN coordinates: -1). What smoothing and
/// the choice of sheets go by, so that they count the same elements as inverted as the certificate does.
double proved_scaled_jacobian(const std::array<Vec3, 8>& corners);
/// The same for all elements of a mesh, one number each.
std::vector<double> proved_scaled_jacobians(const std::vector<Vec3>& points, const std::vector<std::array<int, 8>>& hexes);

/// Exact volume. Unit: volume.
double hex_volume(const std::vector<Vec3>& points, const std::array<int, 8>& hex);

}  // namespace hexfeature
