// HexFeatureWB - LGPL-2.1-or-later
#include <algorithm>
#include <optional>

#include "base/share.h"
#include "pipeline/feature_line.h"

namespace hexfeature {
namespace {

/// A certified but poor mesh of more elements than this is not tried again: the second look would cost as much as the first.
constexpr int kSecondLook = 10000;

/// With another method to come, a mesh of more elements than this that could not be untangled is not tried in another way.
constexpr int kUntangleOnce = 5000;

/// With another method to come, a mesh that lost more (Worth::lost_at_first) is not tried with other labels: they would hardly bring back
/// all.
constexpr double kLostTooMuch = 0.1;

struct Proposal {
  int frame = 0;
  LabelEffort effort;
};

/// The usual tolerance first; then feature lines that turn back are repaired early, which costs time and is needed rarely; the
/// same in the next frame.
std::vector<Proposal> make_proposals(int frames, const Options& options) {
  constexpr double kStrict = 0.3, kStrictWork = 2e7;
  std::vector<Proposal> proposals;
  for (int f = 0; f < frames; ++f) {
    proposals.push_back({f, {}});
    if (options.labels == "regions") proposals.push_back({f, {kStrict, kStrictWork}});
  }
  return proposals;
}

}  // namespace

Candidate mesh_by_feature_line(const SolidTask& task) {
  Run& run = task.run;
  Result& result = run.result;
  Part& part = task.part;
  std::optional<Candidate> best;
  std::size_t best_attempt = 0;
  const auto not_taken = [](Attempt& attempt) {
    attempt.step = "quality";
    attempt.reason = "the mesh of another labelling is better";
  };
  std::optional<MeshingError> first_failure;
  int frame = -1;
  for (const Proposal& proposal : make_proposals(static_cast<int>(task.frames.size()), run.options)) {
    Attempt attempt;
    attempt.method = "feature-line";
    attempt.frame = proposal.frame;
    const auto start = Context::Clock::now();
    const bool second_chance = best.has_value();
    if (second_chance && proposal.frame != frame) break;  // a poor mesh is tried again in its own frame only
    bool hopeless = false;
    const auto try_proposal = [&] {
      if (proposal.frame != frame) {
        frame = proposal.frame;
        task.place(frame);
        begin_tets_ahead(task);
      }
      Candidate candidate;
      candidate.method = attempt.method;
      FeatureLineMesh made = feature_line(task, proposal.effort);
      candidate.mesh = std::move(made.mesh);
      candidate.worth = std::move(made.worth);
      candidate.smoothing = result.smoothing;
      if (best && !candidate.worth.better_than(best->worth)) {
        not_taken(attempt);
      } else {
        if (best) not_taken(result.attempts[best_attempt]);
        best_attempt = result.attempts.size();
        for (Vec3& p : candidate.mesh.points) p = part.to_world(p);
        candidate.labels = std::move(result.labels);
        candidate.adaptation = std::move(result.adaptation);
        candidate.polycube = std::move(result.polycube);
        candidate.sheets = result.sheets;
        candidate.rotation = result.rotation;
        best = std::move(candidate);
      }
    };
    try {
      if (!second_chance)
        try_proposal();
      else if (const auto spent = run_with_share(run.context, kShareForBetter, try_proposal))
        attempt.blame(*spent);
    } catch (const Stopped& stopped) {
      // A lattice has integer coordinates; from the fit on, the mesh is of the placed part.
      if (stopped.step == "fit" || stopped.step == "sheets" || stopped.step == "smooth")
        for (Vec3& p : result.mesh.points) p = part.to_world(p);
      throw;
    } catch (const MeshingError& error) {
      if (error.kind != Failure::NoMesh) throw;
      attempt.blame(error);
      run.context.log("feature-line, proposal " + std::to_string(result.attempts.size() + 1) + " gave up in step " + error.step + ": " +
                      error.reason);
      if (!first_failure) first_failure = error;
      const bool large = error.step == "smooth" && result.mesh.hex_count() > kUntangleOnce;
      hopeless = run.another_way() && (large || dynamic_cast<const LeavesOutEdges*>(&error) != nullptr);
    }
    task.record(attempt, start);
    if (hopeless) break;
    if (best && (best->worth.good() || second_chance || best->mesh.hex_count() > kSecondLook)) break;
    if (best && !best->worth.faithful && best->worth.lost_at_first > kLostTooMuch && run.another_way()) break;
  }
  if (!best) throw *first_failure;
  return std::move(*best);
}

}  // namespace hexfeature
