// HexFeatureWB - LGPL-2.1-or-later
#include <algorithm>
#include <chrono>
#include <memory>
#include <new>
#include <optional>
#include <system_error>
#include <utility>

#include "pipeline/method.h"
#include "tetsplit/tets_ahead.h"

namespace hexfeature {
namespace {

/// What labels, lattice and fit may take before it looks as if they might be in vain.
constexpr std::chrono::milliseconds kPatience{150};

/// Triangles of a surface on which so much work in vain would be felt: in memory, and by whoever else uses the processors.
constexpr int kMostTriangles = 200000;

TetSplitOptions options_for(const Options& options) {
  TetSplitOptions o;
  o.size = options.size;
  o.threads = options.threads;
  return o;
}

}  // namespace

void begin_tets_ahead(const SolidTask& task) {
  Run& run = task.run;
  if (run.tets_ahead || run.placed != 0 || !run.another_way() || run.options.threads < 2 || !run.options.stop_after.empty()) return;
  // Memory is for what the run needs, and is not to end with what it may need.
  if (run.options.memory_limit > 0 || run.result.surface.triangle_count() > kMostTriangles) return;
  try {
    run.tets_ahead = std::make_unique<TetsAhead>(run.result.surface, task.part.geometry(), options_for(run.options), kPatience);
  } catch (const std::system_error&) {  // no thread to be had
  } catch (const std::bad_alloc&) {
  }
}

Candidate mesh_by_tet_split(const SolidTask& task) {
  Run& run = task.run;
  Attempt attempt;
  attempt.method = "tet-split";
  const auto start = Context::Clock::now();
  try {
    task.place(0);
    run.begin("tet-split");
    const TetSplitOptions options = options_for(run.options);
    const Geometry geometry = task.part.geometry();
    std::optional<TetSplitStart> begun;
    if (run.tets_ahead) begun = run.tets_ahead->take(run.context);
    if (begun)
      run.context.log("tet-split: its tetrahedra were made ahead");
    else
      begun = begin_tet_split(run.result.surface, geometry, options, run.context);
    TetSplitReport report;
    Candidate candidate;
    candidate.method = attempt.method;
    candidate.mesh = tet_split(std::move(*begun), geometry, options, run.context, report);
    std::fill(candidate.mesh.hex_solid.begin(), candidate.mesh.hex_solid.end(), task.solid);
    run.begin("certificate");
    certify(candidate.mesh, *geometry.projector, static_cast<int>(geometry.faces->size()), certificate_tolerance(run.result.surface),
            run.context);
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
