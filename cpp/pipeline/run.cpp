// HexFeatureWB - LGPL-2.1-or-later
#include "pipeline/run.h"

#include <algorithm>

#include "base/fingerprint.h"
#include "tetsplit/tets_ahead.h"

namespace hexfeature {

double certificate_tolerance(const SurfaceMesh& surface) {
  Vec3 lo = surface.points.front(), hi = lo;
  for (const Vec3& p : surface.points) {
    lo = lo.cwiseMin(p);
    hi = hi.cwiseMax(p);
  }
  return std::max(1e-8, 1e-9 * (hi - lo).norm());
}

Run::Run(const Options& options_, Context& context_, Result& result_) : options(options_), context(context_), result(result_) {}

Run::~Run() = default;

void Run::leave_off_ahead() {
  if (tets_ahead) tets_ahead->leave_off();
}

bool Run::is_new(const LabelledSurface& labels) {
  Fingerprint print;
  for (const Label l : labels.label) print.take(static_cast<std::uint64_t>(l));
  for (const auto& t : labels.mesh.triangles)
    for (int v : t) print.take(static_cast<std::uint64_t>(v));
  for (const Vec3& p : labels.mesh.points)
    for (int a = 0; a < 3; ++a) print.take(p[a]);
  return seen_.insert(print.value()).second;
}

void Run::begin_solid(int solid) {
  solid_ = solid;
  shown_ = false;
  placed = -1;
  tets_ahead.reset();
}

void Run::show_first(const SurfaceMesh& mesh, const FeatureShape& shape) {
  if (!look || shown_) return;
  LabelResult labels;
  labels.surface.mesh = mesh;
  labels.surface.label.reserve(mesh.triangles.size());
  for (const int chart : shape.cells.triangle_part) labels.surface.label.push_back(shape.charts[chart].label);
  labels.shape = shape;
  shown_ = true;
  show(std::move(labels), false);
}

void Run::show_final() {
  if (look) show(result.labels, true);
}

void Run::show(LabelResult labels, bool final) const {
  // Not all of the result: who looks keeps it, and what has been made up to here may be large.
  auto part = std::make_shared<Result>();
  part->options = result.options;
  part->rotation = result.rotation;
  part->centre = result.centre;
  part->labels = std::move(labels);
  look(std::move(part), solid_, final);
}

void Run::begin(const std::string& step) {
  finish();
  step_ = step;
  since_ = Context::Clock::now();
  context.progress(step, 0);
}

void Run::complete() {
  context.progress(step_, 1);
  reached(step_);
}

void Run::reached(const std::string& name) {
  if (options.stop_after == name) throw Stopped{name};
}

void Run::finish() {
  if (step_.empty()) return;
  const double seconds = std::chrono::duration<double>(Context::Clock::now() - since_).count();
  auto& times = result.times;
  const auto it = std::find_if(times.begin(), times.end(), [&](const StepTime& t) { return t.step == step_; });
  if (it != times.end())
    it->seconds += seconds;
  else
    times.push_back({step_, seconds});
  step_.clear();
}

}  // namespace hexfeature
