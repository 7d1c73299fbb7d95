// HexFeatureWB - LGPL-2.1-or-later
#include "pipeline/method.h"

#include <algorithm>
#include <utility>

#include "pipeline/faithfulness.h"
#include "tetsplit/tets_ahead.h"

namespace hexfeature {

bool Worth::better_than(const Worth& other) const {
  if (faithful != other.faithful) return faithful;
  if (!faithful && lost != other.lost) return lost < other.lost;
  if (sound() != other.sound()) return sound();
  // Above 0.6 the worst element is no longer what a user looks at.
  constexpr double kFine = 0.6;
  const double mine = std::min(min_sj, kFine) + mean_sj, others = std::min(other.min_sj, kFine) + other.mean_sj;
  return mine > others;
}

Worth worth_of(const HexComplex& mesh, const SmoothReport& smoothing, const SolidTask& task) {
  const Faithfulness kept =
      measure_faithfulness(mesh, task.part.geometry(), task.solid, &task.run.result.surface, task.run.options.size, task.run.context);
  Worth worth;
  worth.faithful = kept.complete();
  worth.edges_lost = !kept.edges_kept();
  worth.lost = kept.lost_length + 0.025 * (static_cast<double>(kept.faces_without_quads.size()) + kept.uncovered) +
               0.01 * static_cast<double>(kept.corners_lost.size());
  worth.lost_edges = kept.sharp_edges_not_followed;
  worth.lost_faces = kept.faces_without_quads;
  worth.lost_faces.insert(worth.lost_faces.end(), kept.faces_not_covered.begin(), kept.faces_not_covered.end());
  std::sort(worth.lost_faces.begin(), worth.lost_faces.end());
  worth.largest_gap = kept.largest_gap / task.run.options.size;
  worth.min_sj = smoothing.min_sj;
  worth.mean_sj = smoothing.mean_sj;
  const auto list = [](const std::vector<int>& ids) {
    std::string text;
    for (int id : ids) text += " " + std::to_string(id);
    return ids.empty() ? " none" : text;
  };
  task.run.context.log("CAD faces without quads:" + list(kept.faces_without_quads) + "; not covered:" + list(kept.faces_not_covered) +
                       " (largest gap " + std::to_string(kept.largest_gap) + ")" +
                       "; sharp edges not followed:" + list(kept.sharp_edges_not_followed) + "; corners lost:" + list(kept.corners_lost));
  return worth;
}

void SolidTask::place(int frame) const {
  if (run.placed == frame) return;
  run.placed = -1;
  if (run.tets_ahead) run.tets_ahead->stop();  // it looks at the part where that was
  part.place(frames[frame]);
  run.result.rotation = frames[frame];
  run.result.centre = part.centre();
  run.begin("surface");
  run.result.surface = part.surface(run.options.size, run.context);
  if (part.solid_count() > 1) run.result.surface = surface_of_solid(run.result.surface, part.geometry(), solid);
  run.placed = frame;
  run.complete();
}

void SolidTask::record(Attempt attempt, Context::Clock::time_point start) const {
  attempt.solid = solid;
  attempt.seconds = std::chrono::duration<double>(Context::Clock::now() - start).count();
  run.result.attempts.push_back(std::move(attempt));
}

const std::vector<Method>& all_methods() {
  static const std::vector<Method> methods{{"feature-line", mesh_by_feature_line}, {"tet-split", mesh_by_tet_split}};
  return methods;
}

}  // namespace hexfeature
