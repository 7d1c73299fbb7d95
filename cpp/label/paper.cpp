// HexFeatureWB - LGPL-2.1-or-later
// The paper's labeller: "Automatic Hexahedral Mesh Generation with Feature Line Extraction", steps 3-2 to 3-7b.
#include <tuple>

#include "label/group_rules.h"
#include "label/labels.h"

namespace hexfeature {
namespace {

/// Step 3-2: the unit normal of each mesh face.
std::vector<Vec3> initial_adaptation(const SurfaceMesh& mesh) {
  std::vector<Vec3> p(mesh.triangle_count());
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    const Vec3 n = mesh.area_normal(t);
    p[t] = n.norm() > 0 ? Vec3(n.normalized()) : mesh.mean_normal(t);
  }
  return p;
}

/// Step 3-3: the axis of the largest component and its sign (a tie goes to the earlier axis).
Label assigned_direction(const Vec3& p) {
  int axis;
  p.cwiseAbs().maxCoeff(&axis);
  return make_label(axis, p[axis] < 0 ? -1 : 1);
}

/// Step 3-7b, equations (1) and (2): every mesh face takes beta times the mean of its neighbours on, then unit length.
void smooth_adaptation(const SurfaceMesh& mesh, double beta, std::vector<Vec3>& p, std::vector<Vec3>& before) {
  before = p;
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    const Vec3 sum = before[mesh.opposite[3 * t] / 3] + before[mesh.opposite[3 * t + 1] / 3] + before[mesh.opposite[3 * t + 2] / 3];
    const Vec3 q = before[t] + beta / 3 * sum;
    const double length = q.norm();
    if (length > 1e-9) p[t] = q / length;  // opposite neighbours may cancel at beta = 1: stay as before
  }
}

}  // namespace

PaperLabelResult label_paper(const SurfaceMesh& mesh, const LabelOptions& options, const FillCheck& fill, Context& context) {
  std::vector<Vec3> adaptation = initial_adaptation(mesh), scratch;
  PaperLabelResult best;
  best.surface.mesh = mesh;
  LabelledSurface trial{mesh, {}};
  std::vector<Label> last;
  // Better: it fills; then it is valid; then fewer of the paper's conditions broken; then the exact conditions' cost.
  std::tuple<bool, bool, std::size_t, double> best_rank;
  for (int round = 0; round <= options.max_smoothing_rounds; ++round) {
    context.progress("label", static_cast<double>(round) / (options.max_smoothing_rounds + 1));
    if (round > 0) smooth_adaptation(mesh, options.beta, adaptation, scratch);
    trial.label.resize(adaptation.size());
    for (std::size_t t = 0; t < adaptation.size(); ++t) trial.label[t] = assigned_direction(adaptation[t]);
    correct_groups(mesh, adaptation, options.size, trial.label, context);
    if (trial.label == last) continue;  // the same groups as a round ago
    last = trial.label;

    FeatureShape shape = make_feature_shape(trial);
    const std::size_t broken = check_paper_conditions(shape).size();
    ValidityReport validity = check_validity(shape, options.size);
    const bool filled = validity.valid() && (!fill || fill(mesh, shape, true).ok);
    const std::tuple rank{!filled, !validity.valid(), broken, validity.cost};
    if (best.surface.label.empty() || rank < best_rank) {
      best_rank = rank;
      best.surface.label = trial.label;
      best.shape = std::move(shape);
      best.validity = std::move(validity);
      best.filled = filled;
      best.adaptation = adaptation;
      best.smoothing_rounds = round;
    }
    if (filled && broken == 0) break;
  }
  best.sites = best.shape.cells.triangle_part;
  return best;
}

}  // namespace hexfeature
