// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include <vector>

#include "base/context.h"
#include "mesh/projector.h"
#include "quadratic/hex20.h"
#include "quadratic/mesh_edges.h"

namespace hexfeature {

/// Where the mid-side nodes are: an edge's bow is the vector from the middle of its chord to its mid-side node.
struct Bows {
  std::vector<Vec3> chord;      ///< per edge: the chord's middle
  std::vector<double> length;   ///< per edge: the chord's
  std::vector<Vec3> bow;        ///< per edge
  std::vector<CadPlace> place;  ///< per edge: the CAD curve or face that its middle lies on
};

/// Mid-side nodes on the CAD that bend smoothly through the part: on the curve of a feature edge; on the face of a boundary
/// edge, bent along it as its curved borders are; inside, bow over length, that is how much the edge turns, is the mean of that
/// of the edges opposite in the faces that the edge belongs to: harmonic on every layer of the mesh. So the bow of an element differs from
/// its neighbour's by one order of the element size less than the bow itself, which second-order elements need for third-order accuracy: an
/// element with one curved and one straight side has a term of third degree in its map that does not shrink fast enough.
/// Source of the condition: Ciarlet, Raviart, "Interpolation theory over curved elements, with applications to finite
/// element methods", Comput. Methods Appl. Mech. Engrg. 1, 1972. Deterministic. Throws Cancelled through the context.
Bows place_mid_sides(const HexComplex& complex, const MeshEdges& edges, const Projector& projector, Context& context);

/// Put the middle of a boundary edge that lies on a face exactly there, near chord + bow.
void put_on_face(Bows& bows, int edge, const Projector& projector);
/// The same on a CAD curve.
void put_on_edge(Bows& bows, int edge, const Projector& projector);

/// The nodes of a hexahedron with its mid-side nodes at chord + bow.
Hex20 bent_element(const HexComplex& complex, const MeshEdges& edges, const Bows& bows, int hex);

}  // namespace hexfeature
