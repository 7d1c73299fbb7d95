// HexFeatureWB - LGPL-2.1-or-later
#include "pipeline/run.h"

#include <algorithm>

namespace hexfeature {

double certificate_tolerance(const SurfaceMesh& surface) {
  Vec3 lo = surface.points.front(), hi = lo;
  for (const Vec3& p : surface.points) {
    lo = lo.cwiseMin(p);
    hi = hi.cwiseMax(p);
  }
  return std::max(1e-8, 1e-9 * (hi - lo).norm());
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
