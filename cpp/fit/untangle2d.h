// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include <array>
#include <vector>

#include "base/context.h"
#include "base/types.h"

namespace hexfeature {

/// Make a planar map of a triangle mesh fold-free: minimise f + theta*g over the free vertices,
/// f = tr(JtJ)/chi(eps, d), g = (1 + d^2)/chi(eps, d), chi = (d + sqrt(eps^2 + d^2))/2, d = det J, with eps shrinking as
/// the worst triangle gets better (V. Garanzha et al., Foldover-free maps in 50 lines of code, ACM TOG 40(4), 2021, eqs. 3-7;
/// here the eps rule of design 3.9). J maps the triangle's own 3D shape to its image.
/// Returns the number of triangles still folded.
int untangle(const std::vector<std::array<int, 3>>& triangles, const std::vector<Vec3>& shape, const std::vector<char>& fixed,
             std::vector<Vec2>& flat, const Context& context);

/// Twice the signed area of a planar triangle.
inline double cross2(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

}  // namespace hexfeature
