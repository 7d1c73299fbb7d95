// HexFeatureWB - LGPL-2.1-or-later
#include "pipeline/solid.h"

#include <algorithm>
#include <optional>

#include "base/share.h"
#include "tetsplit/tets_ahead.h"

namespace hexfeature {
namespace {

std::vector<const Method*> chosen_methods(const std::vector<Method>& all, const std::string& name) {
  std::vector<const Method*> chosen;
  for (const Method& m : all)
    if (name == "auto" || name == m.name) chosen.push_back(&m);
  return chosen;
}

/// The run's result describes this candidate.
HexComplex take(Candidate& best, Result& result) {
  if (result.method.find(best.method) == std::string::npos) result.method += (result.method.empty() ? "" : ", ") + best.method;
  result.labels = std::move(best.labels);
  result.adaptation = std::move(best.adaptation);
  result.polycube = std::move(best.polycube);
  result.sheets = std::move(best.sheets);
  result.smoothing = best.smoothing;
  result.rotation = best.rotation;
  return std::move(best.mesh);
}

}  // namespace

HexComplex mesh_solid(Part& part, int solid, const std::vector<Mat3>& frames, Run& run, const std::vector<Method>& methods) {
  const SolidTask task{part, solid, frames, run};
  std::optional<Candidate> best;
  std::optional<MeshingError> failure;  // the first that is not for want of time
  const auto gave_up = [&](const MeshingError& error) {
    if (!failure || failure->kind == Failure::Cancelled) failure = error;
  };
  const std::vector<const Method*> chosen = chosen_methods(methods, run.options.method);
  for (const Method* method : chosen) {
    const auto start = Context::Clock::now();
    const auto mark_others = [&](const std::string& name) {
      for (Attempt& a : run.result.attempts)
        if (a.solid == solid && a.method == name && a.reason.empty()) {
          a.step = "quality";
          a.reason = "the mesh of another method is better";
        }
    };
    const auto try_method = [&] {
      Candidate candidate = method->mesh(task);
      if (best && !candidate.worth.better_than(best->worth)) {
        mark_others(candidate.method);
      } else {
        if (best) mark_others(best->method);
        best = std::move(candidate);
      }
    };
    try {
      // The last one may take all the time, when there is nothing yet that the rest of the run could go on with. The others leave as much
      // for each solid that comes.
      const double share = best || method != chosen.back() ? kShareForBetter / (part.solid_count() - solid + 1) : 1;
      const auto spent = run_with_share(run.context, share, try_method);
      if (spent) {
        Attempt attempt;
        attempt.method = method->name;
        attempt.blame(*spent);
        task.record(attempt, start);
        gave_up(*spent);
      }
    } catch (const MeshingError& error) {
      if (error.kind != Failure::NoMesh) throw;
      gave_up(error);
    }
    if (best && best->worth.sufficient()) break;
  }
  run.tets_ahead.reset();
  if (!best) throw *failure;
  return take(*best, run.result);
}

}  // namespace hexfeature
