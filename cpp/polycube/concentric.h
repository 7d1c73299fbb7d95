// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include <array>
#include <vector>

#include "mesh/surface_mesh.h"
#include "polycube/difference_lp.h"
#include "shape/feature_shape.h"

namespace hexfeature {

/// Charts all round a surface of revolution: of its charts between smooth arcs along `axis`, the largest one towards either end of
/// either of the two other axes, (axis + 1) % 3 and (axis + 2) % 3.
struct Ring {
  std::array<int, 2> low{-1, -1}, high{-1, -1};  ///< charts, per other axis
};

/// Rings about one line along an axis, two or more.
struct Concentric {
  int axis = 0;
  std::vector<Ring> rings;
};

/// The rings of a feature shape, by the line that their normals pass through (within 5% of the element size, area-weighted root mean
/// square, which leaves out rounded boxes and slots). Ordered by axis, then by first chart.
std::vector<Concentric> find_concentric(const SurfaceMesh& mesh, const FeatureShape& shape, double size);

/// Concentric rings as unknowns: per ring those of its low and its high charts on the two axes.
struct ConcentricUnknowns {
  std::array<int, 2> axes{0, 0};
  std::vector<std::array<std::array<int, 2>, 2>> rings;  ///< [ring][which axis][low, high]
};

/// Two rings are even when all four sides of one lie inside those of the other, all in their planes, or all outside: then a sheet along one
/// wall runs through the part past the other wall, or is that wall's too. With 7 and 8 intervals they cannot be: two sides lie in one plane
/// and two do not. Where `x` (optimal without this wish, per axis) has uneven rings, they are made concentric, x[low] + x[high] the
/// same for all. A network LP cannot hold a sum of four unknowns: so widths of one parity are chosen by the terms between the
/// rings' own unknowns, for either parity; the distances that follow are differences again, solved for with all the terms. The best of
/// the three solutions becomes `x`: `cost` is that of an uneven side. What holds the rings where they came to lie is added to `terms`.
void make_concentric(const ConcentricUnknowns& group, std::int64_t cost, std::array<std::vector<DifferenceTerm>, 3>& terms,
                     std::array<std::vector<int>, 3>& x);

}  // namespace hexfeature
