// HexFeatureWB - LGPL-2.1-or-later
#include "smooth/smooth.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "mesh/hex_element.h"
#include "smooth/patch.h"

namespace hexfeature {
namespace {

void check_input(const HexComplex& mesh, const SmoothOptions& options) {
  if (!(options.size > 0)) throw MeshingError(Failure::Usage, "smooth", "the element size must be greater than zero");
  if (mesh.place.size() != mesh.points.size())
    throw MeshingError(Failure::NoMesh, "smooth", "the mesh does not know which CAD entity its points lie on");
  for (const auto& hex : mesh.hexes)
    for (int v : hex)
      if (v < 0 || v >= mesh.point_count())
        throw MeshingError(Failure::NoMesh, "smooth", "an element refers to a point that does not exist");
}

/// Target size of each element: the cube root of its volume at the start, within [0.25, 1.2] h; where an element has an
/// inverted corner, the mean of its sound neighbours'.
std::vector<double> target_sizes(const HexComplex& mesh, double h) {
  std::vector<double> target(mesh.hexes.size(), 0.0), sum(mesh.points.size(), 0.0);
  std::vector<int> count(mesh.points.size(), 0);
  for (int i = 0; i < mesh.hex_count(); ++i) {
    if (!(scaled_jacobian(mesh.points, mesh.hexes[i]) > 0)) continue;
    target[i] = std::clamp(std::cbrt(hex_volume(mesh.points, mesh.hexes[i])), 0.25 * h, 1.2 * h);
    for (int v : mesh.hexes[i]) sum[v] += target[i], ++count[v];
  }
  for (int i = 0; i < mesh.hex_count(); ++i) {
    if (target[i] > 0) continue;
    double total = 0;
    int n = 0;
    for (int v : mesh.hexes[i]) total += sum[v], n += count[v];
    target[i] = n > 0 ? total / n : h;
  }
  return target;
}

/// Boundary points exactly onto the CAD: where a projection is not its own foot to the last digits, a few times over.
/// Returns the largest distance left.
double settle(HexComplex& mesh, SmoothSetting& setting) {
  Patch all = Patch::whole(mesh, setting);
  double deviation = 0;
  for (int round = 0; round < 5; ++round) {
    deviation = all.boundary->find_feet(all.x);
    if (deviation <= 1e-12 * setting.options.size) break;
    all.boundary->snap(all.x);
  }
  all.write_back(mesh);
  return deviation;
}

}  // namespace

SmoothReport smooth(HexComplex& mesh, const Projector& projector, const SmoothOptions& options, Context& context) {
  check_input(mesh, options);
  context.progress("smooth", 0);
  SmoothReport report;
  if (mesh.hexes.empty()) return report;
  Workers workers(options.threads);
  SmoothSetting setting{projector, options, context, workers, target_sizes(mesh, options.size)};
  std::vector<double> quality;
  measure(mesh, workers, quality);
  const Grade before = grade_of(quality);
  report.min_sj_before = before.min_sj;
  report.inverted_before = before.inverted;

  Patch all = Patch::whole(mesh, setting);
  report.deviation = all.boundary->find_feet(all.x);
  const bool perfect = before.min_sj > 0.999 && report.deviation < 1e-9 * options.size;
  if (!perfect) {
    report.rounds = untangle_softly(all);
    slide(all);
    all.write_back(mesh);
    if (options.worst_stage) lift_worst(mesh, setting);
    report.deviation = settle(mesh, setting);
  }

  measure(mesh, workers, quality);
  const Grade after = grade_of(quality);
  report.min_sj = after.min_sj;
  report.inverted = after.inverted;
  report.mean_sj = after.sum_sj / mesh.hex_count();
  context.progress("smooth", 1);
  return report;
}

}  // namespace hexfeature
