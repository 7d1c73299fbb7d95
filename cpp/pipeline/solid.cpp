// HexFeatureWB - LGPL-2.1-or-later
#include "pipeline/solid.h"

#include <algorithm>
#include <optional>

namespace hexfeature {
namespace {

std::vector<const Method*> chosen_methods(const std::vector<Method>& all, const std::string& name) {
  std::vector<const Method*> chosen;
  for (const Method& m : all)
    if (name == "auto" || name == m.name) chosen.push_back(&m);
  return chosen;
}

/// While it lives a method's own deadline holds, when the run has one: half of the time left.
class Budget {
 public:
  Budget(Context& context, bool last) : context_(context), whole_(context.deadline) {
    const auto now = Context::Clock::now();
    if (!last && whole_ != Context::Clock::time_point::max() && whole_ > now) context.deadline = now + (whole_ - now) / 2;
  }
  ~Budget() { context_.deadline = whole_; }
  /// Whether the method's time is up while the run's is not.
  bool spent() const {
    const auto now = Context::Clock::now();
    return context_.deadline < whole_ && now > context_.deadline && now < whole_ && !(context_.is_cancelled && context_.is_cancelled());
  }

 private:
  Context& context_;
  Context::Clock::time_point whole_;
};

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
  std::optional<MeshingError> first_failure;
  const std::vector<const Method*> chosen = chosen_methods(methods, run.options.method);
  for (const Method* method : chosen) {
    const auto start = Context::Clock::now();
    const Budget budget(run.context, method == chosen.back());
    const auto mark_others = [&](const std::string& name) {
      for (Attempt& a : run.result.attempts)
        if (a.solid == solid && a.method == name && a.reason.empty()) {
          a.step = "quality";
          a.reason = "the mesh of another method is better";
        }
    };
    try {
      Candidate candidate = method->mesh(task);
      if (best && !candidate.worth.better_than(best->worth)) {
        mark_others(candidate.method);
      } else {
        if (best) mark_others(best->method);
        best = std::move(candidate);
      }
      if (best->worth.sufficient()) break;
    } catch (const MeshingError& error) {
      const bool out_of_time = error.kind == Failure::Cancelled && budget.spent();
      if (error.kind != Failure::NoMesh && !out_of_time) throw;
      if (out_of_time) {
        Attempt attempt;
        attempt.method = method->name;
        attempt.step = error.step;
        attempt.reason = "its share of the time limit is used up";
        attempt.hint = "raise the time limit";
        task.record(attempt, start);
      }
      if (!first_failure) first_failure = error;
    }
  }
  if (!best) throw *first_failure;
  return take(*best, run.result);
}

}  // namespace hexfeature
