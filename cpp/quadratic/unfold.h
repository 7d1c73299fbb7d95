// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include <vector>

#include "base/context.h"
#include "mesh/projector.h"
#include "quadratic/bows.h"

namespace hexfeature {

/// Make bad second-order elements good without taking a mid-side node off the CAD: those inside move freely, those on a
/// CAD face slide on it, those on a CAD curve along it.
///
/// The Jacobian determinant is linear in the place of one node, so are its Bernstein coefficients: the sum of the squares of
/// what they lack to a small positive share of the element's volume is convex in one node, and Newton's method minimises it, node
/// after node, round after round. Few elements are bad, so few nodes move.
///
/// bad: elements that proves_positive() refuses. Returns the ones that it refuses still, sorted; an element beside them may be
/// among these, and then the bows may be worse than before. Deterministic. Throws Cancelled through the context.
std::vector<int> unfold(const HexComplex& complex, const MeshEdges& edges, const Projector& projector, const std::vector<int>& bad,
                        Bows& bows, Context& context);

}  // namespace hexfeature
