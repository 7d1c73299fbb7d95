// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include "mesh/hex_complex.h"
#include "pipeline/method.h"

namespace hexfeature {

/// How the labeller is asked to work: see LabelOptions.
struct LabelEffort {
  double fold_tolerance = LabelOptions{}.fold_tolerance;
  double max_work = LabelOptions{}.max_work;
};

/// A certified complex in the working frame, and what it is worth.
struct FeatureLineMesh {
  HexComplex mesh;
  Worth worth;
};

/// With another method to come, the fit found no mesh edges for many sharp CAD edges: other labels would hardly find them.
struct LeavesOutEdges : MeshingError {
  using MeshingError::MeshingError;
};

/// The feature-line method on one solid, placed in its working frame (design, section 3; the paper's steps 3-2 to 3-7
/// and 1-1 to 1-3): labels, feature shape, polycube, lattice, boundary fitting, O-grid sheets, smoothing. Returns a certified
/// complex. Throws MeshingError(NoMesh) naming the step that could not go on, Stopped at Options::stop_after.
FeatureLineMesh feature_line(const SolidTask& task, const LabelEffort& effort);

}  // namespace hexfeature
