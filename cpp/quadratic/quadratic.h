// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include <array>
#include <vector>

#include "base/context.h"
#include "mesh/hex_complex.h"
#include "mesh/projector.h"

namespace hexfeature {

/// Second-order elements made from a first-order complex: 20-node hexahedra and 8-node boundary quadrilaterals.
///
/// Node order of hexes (VTK's and Abaqus'):
/// 0-7 corners; 8-11 mid-sides of 0-1 1-2 2-3 3-0; 12-15 of 4-5 5-6 6-7 7-4; 16-19 of 0-4 1-5 2-6 3-7.
/// Quads: 0-3 corners, 4-7 mid-sides of 0-1 1-2 2-3 3-0.
struct QuadraticMesh {
  std::vector<Vec3> mid_points;     ///< node numbers continue after the complex' points
  std::vector<CadPlace> mid_place;  ///< with the parameters of where the node is; inside when it left the CAD
  std::vector<std::array<int, 20>> hexes;
  std::vector<std::array<int, 8>> quads;
  std::vector<int> straightened;        ///< boundary mid-side nodes that left the CAD because an element would turn bad
  std::vector<int> straightened_faces;  ///< CAD faces with such a node, sorted
  double least_jacobian = 0;            ///< over all elements: see hex20.h
  double deviation = 0;                 ///< largest distance of a boundary mid-side node from its CAD, the straightened ones' too
};

/// Put mid-side nodes on the CAD, bent smoothly through the part (place_mid_sides), and prove the Jacobian determinant of
/// every element positive everywhere by the Bernstein coefficients of its second-order map. Where that fails, the element's
/// mid-side nodes inside the part go back to the chord, by halves; where that is not enough, its nodes move inside and on the CAD
/// (unfold); where even that is not enough, one after the other leaves the CAD: then a load that looks for its nodes by geometry
/// misses them. A straight-sided element has the first-order map, which is proved already: so this ends. The last proof is one of all
/// elements. A node is on the CAD within 1e-11 of its edge's length or 16 roundings of its largest coordinate, if that is more.
QuadraticMesh make_quadratic(const HexComplex& complex, const Projector& projector, Context& context);

}  // namespace hexfeature
