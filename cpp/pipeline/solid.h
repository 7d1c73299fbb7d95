// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include <vector>

#include "pipeline/method.h"

namespace hexfeature {

/// Mesh one solid: the methods that the options allow, in order. The first mesh that is faithful and has no very bad element
/// (Worth::sufficient) ends the search; otherwise the best of all methods by `Worth` is kept. With a time limit each method but the last
/// gets half of what is left, and so does each that has a mesh to better; one that uses that up, or the memory, is left out. Returns the
/// mesh in world coordinates, with the run's result describing it. Throws MeshingError(NoMesh) of the first method that says why when none
/// gives a certified mesh. `methods`: those there are.
HexComplex mesh_solid(Part& part, int solid, const std::vector<Mat3>& frames, Run& run, const std::vector<Method>& methods = all_methods());

}  // namespace hexfeature
