// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include <vector>

#include "pipeline/part.h"
#include "pipeline/run.h"

namespace hexfeature {

/// Mesh one solid: proposals (a working frame, and how strictly feature lines are judged) in order. The first mesh that is faithful
/// and has no bad element ends the search; a certified mesh short of that gets one more proposal; the better one by the
/// stated score is kept. Returns it in world coordinates, with the run's result describing it.
/// Throws MeshingError(NoMesh) of the first proposal when none gives a certified mesh.
HexComplex mesh_solid(Part& part, int solid, const std::vector<Mat3>& frames, Run& run);

}  // namespace hexfeature
