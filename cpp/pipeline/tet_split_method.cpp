// HexFeatureWB - LGPL-2.1-or-later
#include <algorithm>

#include "pipeline/method.h"
#include "tetsplit/tet_split.h"

namespace hexfeature {

Candidate mesh_by_tet_split(const SolidTask& task) {
  Run& run = task.run;
  Attempt attempt;
  attempt.method = "tet-split";
  const auto start = Context::Clock::now();
  try {
    task.place(0);
    run.begin("tet-split");
    TetSplitOptions options;
    options.size = run.options.size;
    options.threads = run.options.threads;
    TetSplitReport report;
    Candidate candidate;
    candidate.method = attempt.method;
    candidate.mesh = tet_split(run.result.surface, task.part.geometry(), options, run.context, report);
    std::fill(candidate.mesh.hex_solid.begin(), candidate.mesh.hex_solid.end(), task.solid);
    run.begin("certificate");
    certify(candidate.mesh, *task.part.geometry().projector, static_cast<int>(task.part.geometry().faces->size()),
            certificate_tolerance(run.result.surface), run.context);
    candidate.smoothing = report.smoothing;
    candidate.worth = worth_of(candidate.mesh, candidate.smoothing, task);
    candidate.rotation = run.result.rotation;
    for (Vec3& p : candidate.mesh.points) p = task.part.to_world(p);
    task.record(attempt, start);
    return candidate;
  } catch (const MeshingError& error) {
    if (error.kind == Failure::NoMesh) {
      attempt.blame(error);
      run.context.log("tet-split gave up in step " + error.step + ": " + error.reason);
      task.record(attempt, start);
    }
    throw;
  }
}

}  // namespace hexfeature
