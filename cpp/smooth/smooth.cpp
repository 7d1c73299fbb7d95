// HexFeatureWB - LGPL-2.1-or-later
#include "smooth/smooth.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

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

/// Target size of each element: the cube root of its volume at the start, within [least, 1.2] h; where an element has an
/// inverted corner, the mean of its sound neighbours'.
std::vector<double> target_sizes(const HexComplex& mesh, double h, double least) {
  std::vector<double> target(mesh.hexes.size(), 0.0), sum(mesh.points.size(), 0.0);
  std::vector<int> count(mesh.points.size(), 0);
  for (int i = 0; i < mesh.hex_count(); ++i) {
    if (!(scaled_jacobian(mesh.points, mesh.hexes[i]) > 0)) continue;
    target[i] = std::clamp(std::cbrt(hex_volume(mesh.points, mesh.hexes[i])), least * h, 1.2 * h);
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

/// The lengths that the mesh edges along CAD curves should keep. Without them points slide along a curve wherever an element
/// gains a little, until neighbours stand 5 h or nothing apart: long chords then cut off the curve that the mesh follows. An edge
/// may stretch until its sag (curvature |e|^2 / 8) is 0.15 h; a nearly straight one to 1.6 times the length that it came with. One that
/// comes with more may keep it, up to 0.2 h: beside a pinned point the fit can hardly do better, but its neighbours can move up.
std::vector<Span> curve_spans(const HexComplex& mesh, const Projector& projector, double h, const Context& context) {
  constexpr double kSag = 0.15, kMostSag = 0.2, kStretch = 1.6, kLong = 1.6;
  const std::size_t n = std::min(mesh.feature_edges.size(), mesh.feature_edge_cad.size());
  // Curvature from the tangents at both ends; of neighbours along one CAD edge the greatest, since points slide from one to the next.
  std::vector<double> curvature(n, 0.0), length(n, 0.0);
  std::map<std::pair<int, int>, double> at_node;  // (CAD edge, point)
  for (std::size_t i = 0; i < n; ++i) {
    if (i % 256 == 0) context.check();
    const auto& e = mesh.feature_edges[i];
    const int cad = mesh.feature_edge_cad[i];
    length[i] = (mesh.points[e[1]] - mesh.points[e[0]]).norm();
    Vec3 tangent[2];
    for (int k = 0; k < 2; ++k) {
      const CadPlace& place = mesh.place[e[k]];
      tangent[k] =
          projector.project_to_edge(cad, mesh.points[e[k]], place.dim == 1 && place.entity == cad ? &place.uv[0] : nullptr).tangent;
    }
    const double half_turn = 0.5 * std::acos(std::clamp(tangent[0].dot(tangent[1]), -1.0, 1.0));
    if (length[i] > 1e-6 * h && std::isfinite(half_turn)) curvature[i] = 2 * std::sin(half_turn) / length[i];
    for (int v : e) {
      double& greatest = at_node[{cad, v}];
      greatest = std::max(greatest, curvature[i]);
    }
  }
  std::vector<Span> spans;
  for (std::size_t i = 0; i < n; ++i) {
    const auto& e = mesh.feature_edges[i];
    const int cad = mesh.feature_edge_cad[i];
    if (!(length[i] > 0)) continue;
    const double bend = std::max(at_node[{cad, e[0]}], at_node[{cad, e[1]}]);
    double longest = std::max(kStretch * length[i], kLong * h), most = length[i];
    if (bend > 0) {
      longest = std::min(longest, std::sqrt(8 * kSag * h / bend));
      most = std::min(most, std::sqrt(8 * kMostSag * h / bend));
    }
    spans.push_back({e[0], e[1], std::max(longest, most), 0.5 * std::min(length[i], h)});
  }
  return spans;
}

/// The whole mesh, or what lies near SmoothOptions::around.
Patch what_moves(const HexComplex& mesh, SmoothSetting& setting) {
  constexpr int kRings = 3;
  if (setting.options.around.empty()) return Patch::whole(mesh, setting);
  std::vector<char> marked(mesh.points.size(), 0);
  for (int v : setting.options.around) marked[v] = 1;
  const auto is_new = [&](int h) { return std::any_of(mesh.hexes[h].begin(), mesh.hexes[h].end(), [&](int v) { return marked[v] != 0; }); };
  return Patch(mesh, points_near(mesh, kRings, is_new), setting);
}

/// Of an untangled mesh whose elements are poor by nature: onto the CAD, and sliding only where that leaves elements inverted. If it does
/// not put all right then again with another patch, as long as that helps: which elements are looked at closely is found out when one is
/// made.
void slide_inverted(HexComplex& mesh, SmoothSetting& setting, Patch& untangled) {
  constexpr int kLooks = 2;
  untangled.boundary->find_feet(untangled.x);
  untangled.boundary->snap(untangled.x);
  Grade best = untangled.grade();
  if (best.inverted > 0) {
    slide(untangled);
    best = untangled.grade();
  }
  untangled.write_back(mesh);
  for (int look = 0; look < kLooks && best.inverted > 0; ++look) {
    Patch closer = what_moves(mesh, setting);
    slide(closer);
    const Grade now = closer.grade();
    if (now.inverted > best.inverted || (now.inverted == best.inverted && now.min_sj <= best.min_sj)) return;
    closer.write_back(mesh);
    best = now;
  }
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

SmoothSetting setting_for(const HexComplex& mesh, const Projector& projector, const SmoothOptions& options, Context& context,
                          Workers& workers) {
  SmoothSetting setting{projector,
                        options,
                        context,
                        workers,
                        target_sizes(mesh, options.size, options.least_target),
                        curve_spans(mesh, projector, options.size, context),
                        std::vector<char>(mesh.points.size(), 0)};
  for (int v : options.held) setting.held[v] = 1;
  return setting;
}

Grade grade_all(const HexComplex& mesh, Workers& workers) {
  std::vector<double> quality;
  measure(mesh, workers, quality);
  return grade_of(quality);
}

void tell_before(const Grade& grade, SmoothReport& report) {
  report.min_sj_before = grade.min_sj;
  report.inverted_before = grade.inverted;
}

void tell_after(const Grade& grade, int hexes, SmoothReport& report) {
  report.min_sj = grade.min_sj;
  report.inverted = grade.inverted;
  report.mean_sj = grade.sum_sj / hexes;
}

}  // namespace

SmoothReport smooth(HexComplex& mesh, const Projector& projector, const SmoothOptions& options, Context& context) {
  check_input(mesh, options);
  context.progress("smooth", 0);
  SmoothReport report;
  if (mesh.hexes.empty()) return report;
  Workers workers(options.threads, context);
  SmoothSetting setting = setting_for(mesh, projector, options, context, workers);
  const Grade before = grade_all(mesh, workers);
  tell_before(before, report);

  Patch all = what_moves(mesh, setting);
  report.deviation = all.boundary->find_feet(all.x);
  const bool perfect = before.min_sj > 0.999 && report.deviation < 1e-9 * options.size;
  if (!perfect) {
    report.rounds = untangle_softly(mesh, all);
    if (options.brief) {
      slide_inverted(mesh, setting, all);
    } else {
      slide(all);
      all.write_back(mesh);
    }
    if (options.worst_stage) {
      lift_worst(mesh, setting);
      lift_places(mesh, setting);
      raise_minimum(mesh, setting);
      polish_worst(mesh, setting);
      if (!options.brief) part_close_points(mesh, setting);
    }
    report.deviation = settle(mesh, setting);
  }

  tell_after(grade_all(mesh, workers), mesh.hex_count(), report);
  context.progress("smooth", 1);
  return report;
}

SmoothReport smooth_mean(HexComplex& mesh, const Projector& projector, const SmoothOptions& options, Context& context) {
  check_input(mesh, options);
  SmoothReport report;
  if (mesh.hexes.empty()) return report;
  Workers workers(options.threads, context);
  SmoothSetting setting = setting_for(mesh, projector, options, context, workers);
  tell_before(grade_all(mesh, workers), report);
  lift_mean(mesh, setting);
  raise_minimum(mesh, setting, true);
  part_close_points(mesh, setting);
  report.deviation = settle(mesh, setting);
  tell_after(grade_all(mesh, workers), mesh.hex_count(), report);
  return report;
}

}  // namespace hexfeature
