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
/// Node order of hexes (VTK's, and Abaqus' once the two last groups of four are seen as top 12-15, vertical 16-19):
/// 0-7 corners; 8-11 mid-sides of 0-1 1-2 2-3 3-0; 12-15 of 4-5 5-6 6-7 7-4; 16-19 of 0-4 1-5 2-6 3-7.
/// Quads: 0-3 corners, 4-7 mid-sides of 0-1 1-2 2-3 3-0.
struct QuadraticMesh {
  std::vector<Vec3> mid_points;  ///< node numbers continue after the complex' points
  std::vector<CadPlace> mid_place;
  std::vector<std::array<int, 20>> hexes;
  std::vector<std::array<int, 8>> quads;
  int straightened = 0;  ///< boundary mid-side nodes moved back towards the chord, because an element would turn bad
};

/// Put mid-side nodes on the CAD: on the curve of a feature edge, on the face of a boundary edge, else at the chord's
/// middle. Where the Jacobian determinant would not be positive at the 27 and 8 integration points of C3D20 and C3D20R and
/// at the nodes, the edges round the element bend along with its curved one, each ring less; where that is not enough, the
/// element's mid-side nodes go back to the chord, by halves.
QuadraticMesh make_quadratic(const HexComplex& complex, const Projector& projector, Context& context);

}  // namespace hexfeature
