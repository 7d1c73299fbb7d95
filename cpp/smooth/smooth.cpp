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

void measure(const HexComplex& mesh, int& inverted, double& min_sj, double& mean_sj) {
  inverted = 0;
  min_sj = mesh.hexes.empty() ? 0 : 1;
  double sum = 0;
  for (const auto& hex : mesh.hexes) {
    double q = scaled_jacobian(mesh.points, hex);
    if (std::isnan(q)) q = -1;
    inverted += !(q > 0);
    min_sj = std::min(min_sj, q);
    sum += q;
  }
  mean_sj = mesh.hexes.empty() ? 0 : sum / mesh.hex_count();
}

}  // namespace

SmoothReport smooth(HexComplex& mesh, const Projector& projector, const SmoothOptions& options, Context& context) {
  check_input(mesh, options);
  context.progress("smooth", 0);
  SmoothReport report;
  measure(mesh, report.inverted_before, report.min_sj_before, report.mean_sj);
  report.min_sj = report.min_sj_before;
  report.inverted = report.inverted_before;
  if (mesh.hexes.empty()) return report;

  Workers workers(options.threads);
  SmoothSetting setting{projector, options, context, workers, target_sizes(mesh, options.size)};
  {
    Patch all = Patch::whole(mesh, setting);
    report.deviation = all.boundary->find_feet(all.x);
    const bool perfect = report.min_sj_before > 0.999 && report.deviation < 1e-9 * options.size;
    if (perfect) return report;
    report.rounds = untangle_softly(all);
    slide(all);
    all.write_back(mesh);
  }
  if (options.worst_stage) lift_worst(mesh, setting);

  measure(mesh, report.inverted, report.min_sj, report.mean_sj);
  report.deviation = Patch::whole(mesh, setting).boundary->find_feet(Patch::whole(mesh, setting).x);
  context.progress("smooth", 1);
  return report;
}

}  // namespace hexfeature
