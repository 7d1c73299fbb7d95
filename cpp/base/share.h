// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include <functional>
#include <optional>

#include "base/context.h"

namespace hexfeature {

/// The part of the time left for what may make a mesh better that is there already: the rest of the run needs time too.
constexpr double kShareForBetter = 0.5;

/// Runs `work` with `share` (0..1] of the time left until the context's deadline, and with all memory that it allows. When that is used
/// up, the run may go on without the work's result: logs and returns the error that says so (Cancelled for the time, NoMesh for the
/// memory). Lets every other error through, a cancel and the run's own deadline too.
std::optional<MeshingError> run_with_share(Context& context, double share, const std::function<void()>& work);

}  // namespace hexfeature
