// HexFeatureWB - LGPL-2.1-or-later
#include "pipeline/solid.h"

#include <algorithm>
#include <optional>

#include "pipeline/faithfulness.h"
#include "pipeline/feature_line.h"

namespace hexfeature {
namespace {

/// A certified but poor mesh of more elements than this is not tried again: the second look would cost as much as the first.
constexpr int kSecondLook = 10000;

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

/// A certified mesh, what it is worth, and the intermediate results that belong to it.
struct Candidate {
  HexComplex mesh;
  double score = 0;
  bool good = false;
  LabelResult labels;
  std::vector<Vec3> adaptation;
  Polycube polycube;
  SheetReport sheets;
  SmoothReport smoothing;
  Mat3 rotation;
};

/// Score: the worst element's scaled Jacobian (above 0.6 all is well), less what was lost of faces and sharp edges.
void judge(Candidate& candidate, const Geometry& geometry, int solid) {
  constexpr double kSound = 0.2, kFine = 0.6;
  const Faithfulness kept = measure_faithfulness(candidate.mesh, geometry, solid);
  const double min_sj = candidate.smoothing.min_sj;
  candidate.good = kept.complete() && min_sj >= kSound;
  candidate.score = std::min(min_sj, kFine) - 4 * kept.lost_length - 0.1 * static_cast<double>(kept.faces_without_quads.size());
}

}  // namespace

HexComplex mesh_solid(Part& part, int solid, const std::vector<Mat3>& frames, Run& run) {
  Result& result = run.result;
  const std::vector<Proposal> proposals = make_proposals(static_cast<int>(frames.size()), run.options);
  std::optional<Candidate> best;
  std::size_t best_attempt = 0;
  const auto not_taken = [](Attempt& attempt) {
    attempt.step = "quality";
    attempt.reason = "the mesh of another labelling is better";
  };
  std::optional<MeshingError> first_failure;
  int frame = -1;
  for (const Proposal& proposal : proposals) {
    Attempt attempt;
    attempt.method = "feature-line";
    attempt.solid = solid;
    attempt.frame = proposal.frame;
    const auto start = Context::Clock::now();
    const bool second_chance = best.has_value();
    try {
      if (proposal.frame != frame) {
        if (best) break;  // a poor mesh is tried again in its own frame only
        frame = proposal.frame;
        part.place(frames[frame]);
        result.rotation = frames[frame];
        result.centre = part.centre();
        run.begin("surface");
        result.surface = part.surface(run.options.size, run.context);
        if (part.solid_count() > 1) result.surface = surface_of_solid(result.surface, part.geometry(), solid);
        run.complete();
      }
      Candidate candidate;
      candidate.mesh = feature_line(result.surface, part.geometry(), solid, proposal.effort, run);
      candidate.smoothing = result.smoothing;
      judge(candidate, part.geometry(), solid);
      if (best && candidate.score <= best->score) {
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
    } catch (const Stopped& stopped) {
      // A lattice has integer coordinates; from the fit on, the mesh is of the placed part.
      if (stopped.step == "fit" || stopped.step == "sheets" || stopped.step == "smooth")
        for (Vec3& p : result.mesh.points) p = part.to_world(p);
      throw;
    } catch (const MeshingError& error) {
      if (error.kind != Failure::NoMesh) throw;
      attempt.step = error.step;
      attempt.reason = error.reason;
      attempt.hint = error.hint;
      attempt.cad_faces = error.cad_faces;
      run.context.log("feature-line, proposal " + std::to_string(result.attempts.size() + 1) + " gave up in step " + error.step + ": " +
                      error.reason);
      if (!first_failure) first_failure = error;
    }
    attempt.seconds = std::chrono::duration<double>(Context::Clock::now() - start).count();
    result.attempts.push_back(attempt);
    if (best && (best->good || second_chance || best->mesh.hex_count() > kSecondLook)) break;
  }
  if (!best) throw *first_failure;
  result.method = "feature-line";
  result.labels = std::move(best->labels);
  result.adaptation = std::move(best->adaptation);
  result.polycube = std::move(best->polycube);
  result.sheets = std::move(best->sheets);
  result.smoothing = best->smoothing;
  result.rotation = best->rotation;
  return std::move(best->mesh);
}

}  // namespace hexfeature
