// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include <vector>

#include "base/context.h"
#include "mesh/surface_mesh.h"

namespace hexfeature {

/// How often each rule was applied.
struct GroupCorrections {
  int evened = 0;   ///< triangles that changed group to straighten a border
  int joined = 0;   ///< groups joined to a neighbour (rule 1, and tiny groups)
  int divided = 0;  ///< groups divided (rule 2)
};

/// The paper's step 3-4: correct the surface-mesh groups (connected triangles of one label) until no rule applies.
///  Rule 1 (its condition 1, figure 6): a group with fewer than four neighbours joins the one with the longest shared border.
///  Rule 2 (its condition 2, figure 7): of two neighbours on one axis, one is divided along the shared border; the strip takes
///  the axis that is neither the groups' nor the border's, its sign from the strip's mean normal.
/// "Many other rules are used" there without being told; these are ours:
///  Even borders: a triangle with two neighbours of another group joins it when its adaptation hardly prefers its own label.
///  Tiny groups: a group under 0.02 h^2 joins as by rule 1 however many neighbours it has.
/// Order: islands (one or two neighbours), rule 2, rule 1. Rule 1 only lowers the number of groups and a triangle is recoloured by rule 2
/// once at most, so the rules end. `size` is the element size h. Deterministic.
GroupCorrections correct_groups(const SurfaceMesh& mesh, const std::vector<Vec3>& adaptation, double size, std::vector<Label>& label,
                                const Context& context);

}  // namespace hexfeature
