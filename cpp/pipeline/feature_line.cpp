// HexFeatureWB - LGPL-2.1-or-later
#include "pipeline/feature_line.h"

#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "base/share.h"
#include "fit/fit.h"
#include "pipeline/faithfulness.h"
#include "pipeline/second_looks.h"

namespace hexfeature {
namespace {

/// With another method to come, elements that may be folded by the fit alone: sheets and smoothing hardly ever put so many right.
constexpr int kFoldedByFit = 120;

/// To follow so many CAD edges inside charts takes long: with another method to come, a fit without them tells first whether it is in vain.
constexpr int kManyInnerEdges = 120;

/// With another method to come, the share of the sharp edges' length that the fit may leave without mesh edges: second looks bring back
/// some edges, never many.
constexpr double kLeftOutByFit = 0.025;

/// Elements of all the meshes of one labelling that stay inverted before it is given up, with another method to come and without.
constexpr int kVainWork = 12000, kVainWorkAlone = 45000;

std::vector<int> cad_faces_of(const FeatureShape& shape, const std::vector<int>& charts) {
  std::set<int> faces;
  for (int c : charts) faces.insert(shape.charts[c].cad_faces.begin(), shape.charts[c].cad_faces.end());
  return {faces.begin(), faces.end()};
}

LabelResult label(const SurfaceMesh& surface, const Geometry& geometry, const LabelEffort& effort, Run& run) {
  LabelOptions options;
  options.size = run.options.size;
  options.beta = run.options.beta;
  options.max_smoothing_rounds = run.options.smoothing_rounds;
  options.fold_tolerance = effort.fold_tolerance;
  options.max_work = effort.max_work;
  AxisRayCache rays;  // the search tries many labels on few meshes
  const FillCheck fill = [&](const SurfaceMesh& mesh, const FeatureShape& shape, bool thorough) -> FillOutcome {
    run.show_first(mesh, shape);
    const QuantizeOptions quantize = quantize_options(run.options);
    const AxisRays& sampled = rays.rays(mesh, ray_count(mesh, quantize), run.context);
    const FillReport report = build_lattice(mesh, shape, sampled, quantize, run.context, thorough).report;
    if (!report.ok)
      run.context.log("labels: does not fill after " + std::to_string(report.rounds) + " rounds: " + report.reason + ", charts " +
                      std::to_string(report.charts.size()));
    return {report.ok, report.reason, report.charts, report.rounds};
  };
  if (run.options.labels == "paper") {
    PaperLabelResult paper = label_paper(surface, options, fill, run.context);
    run.result.adaptation = std::move(paper.adaptation);
    return std::move(paper);
  }
  if (run.look) options.first_look = [&run](const LabelResult& labels) { run.show_first(labels.surface.mesh, labels.shape); };
  return label_regions(surface, geometry, options, fill, run.context);
}

void require_valid(const LabelResult& labels) {
  if (labels.validity.valid()) return;
  const Violation& worst = *std::max_element(labels.validity.violations.begin(), labels.validity.violations.end(),
                                             [](const Violation& a, const Violation& b) { return a.weight < b.weight; });
  throw MeshingError(Failure::NoMesh, "labels",
                     "no valid recognition model was found: condition V" + std::to_string(worst.condition) + " fails: " + worst.reason,
                     "try a smaller element size, or simplify the faces named", cad_faces_of(labels.shape, worst.charts));
}

/// CAD edges that run inside a chart, are followed by a chain of mesh edges, and touch an inverted element or a neighbour of one:
/// letting them go is what may make it valid. Tangent ones first: a mesh loses less without them. Sorted.
std::vector<int> edges_to_release(const HexComplex& complex, const Geometry& geometry) {
  const std::vector<char> ring = with_neighbours(complex, points_of_inverted(complex));
  // Charts on the two sides of each feature edge: inside a chart when they are the same.
  std::map<std::array<int, 2>, std::set<int>> charts;
  for (const auto& e : complex.feature_edges) charts[e];
  for (std::size_t q = 0; q < complex.quads.size(); ++q)
    for (int k = 0; k < 4; ++k) {
      const int a = complex.quads[q][k], b = complex.quads[q][(k + 1) % 4];
      const auto it = charts.find({std::min(a, b), std::max(a, b)});
      if (it != charts.end()) it->second.insert(complex.quad_chart[q]);
    }
  std::set<int> tangent, sharp;
  for (std::size_t i = 0; i < complex.feature_edges.size(); ++i) {
    const auto& e = complex.feature_edges[i];
    if (charts[e].size() != 1 || !(ring[e[0]] || ring[e[1]])) continue;
    const int cad = complex.feature_edge_cad[i];
    (geometry.edge(cad).sharp ? sharp : tangent).insert(cad);
  }
  const std::set<int>& first = tangent.empty() ? sharp : tangent;
  return {first.begin(), first.end()};
}

/// CAD faces of the quads that share a point with an inverted element.
std::vector<int> faces_near_inverted(const HexComplex& complex) {
  const std::vector<char> near = points_of_inverted(complex);
  std::set<int> faces;
  for (std::size_t q = 0; q < complex.quads.size(); ++q)
    if (std::any_of(complex.quads[q].begin(), complex.quads[q].end(), [&](int v) { return near[v] != 0; }))
      faces.insert(complex.quad_face[q]);
  return {faces.begin(), faces.end()};
}

MeshingError folded_for_good(const HexComplex& complex, int count) {
  return {Failure::NoMesh, "smooth", std::to_string(count) + " elements stay inverted or folded",
          "try another element size, or simplify the faces named", faces_near_inverted(complex)};
}

LeavesOutEdges leaves_out(const std::vector<int>& edges, const Geometry& geometry) {
  std::set<int> faces;
  for (int e : edges)
    for (int f : geometry.edge(e).faces)
      if (f > 0) faces.insert(f);
  return {Failure::NoMesh,
          "fit",
          std::to_string(edges.size()) + " sharp CAD edges have no mesh edges",
          "try a smaller element size, or simplify the faces named",
          {faces.begin(), faces.end()}};
}

/// How many elements a fitted mesh has folded.
int count_folded(const HexComplex& complex) {
  const std::vector<double> quality = proved_scaled_jacobians(complex.points, complex.hexes);
  return static_cast<int>(std::count_if(quality.begin(), quality.end(), [](double q) { return !(q > 0); }));
}

/// How many CAD edges run inside charts.
int count_inner_edges(const SurfaceMesh& mesh, const FeatureShape& shape) {
  const std::vector<int>& chart = shape.cells.triangle_part;
  std::set<int> edges;
  for (int h = 0; h < 3 * mesh.triangle_count(); ++h)
    if (mesh.halfedge_edge[h] > 0 && chart[h / 3] == chart[mesh.opposite[h] / 3]) edges.insert(mesh.halfedge_edge[h]);
  return static_cast<int>(edges.size());
}

/// Boundary fitting, sheets and smoothing, first with free turns; where elements stay inverted with these, without. Where elements stay
/// inverted, again without the inner CAD edges beside them, as long as that makes fewer. Throws MeshingError(NoMesh, "smooth") when some
/// stay. With another method to come, a fit that folds many elements or leaves out many sharp edges is given up at once.
SheetTrial fit_and_smooth(const MadeFrom& made_from) {
  const auto& [task, mesh, shape, lattice] = made_from;
  Run& run = task.run;
  const Geometry& geometry = task.part.geometry();
  constexpr int kRounds = 6;
  FitOptions fit;
  fit.size = run.options.size;
  fit.smooth_edges = run.options.capture == "all";
  fit.free_turns = run.options.sheets;
  SheetRules rules;
  rules.another_way = run.another_way();
  int vain = 0;
  std::optional<MeshingError> folded_with_turns;
  const auto require_few_folded = [&](const HexComplex& complex) {
    const int folded = count_folded(complex);
    if (folded <= kFoldedByFit) return;
    run.begin("smooth");  // which would not put that right
    throw folded_for_good(complex, folded);
  };
  if (rules.another_way && count_inner_edges(mesh, shape) > kManyInnerEdges) {
    run.begin("fit");
    FitOptions bare = fit;
    bare.inner_edges = false;
    run.result.mesh = lattice.complex;
    fit_boundary(run.result.mesh, mesh, shape, geometry, bare, run.context);
    require_few_folded(run.result.mesh);
  }
  for (int round = 1, least = std::numeric_limits<int>::max();; ++round) {
    run.begin("fit");
    HexComplex complex = lattice.complex;
    const int turned = fit_boundary(complex, mesh, shape, geometry, fit, run.context);
    run.result.mesh = complex;
    run.complete();
    if (rules.another_way) {
      const EdgesLeftOut left_out = sharp_edges_left_out(complex, geometry, task.solid);
      if (left_out.share > kLeftOutByFit && fit.released.empty()) {  // not what was let go on purpose
        if (folded_with_turns) throw MeshingError(*folded_with_turns);
        throw leaves_out(left_out.edges, geometry);
      }
      if (turned > 0 && count_folded(complex) > kFoldedByFit) {
        fit.free_turns = false;
        --round;
        continue;
      }
      require_few_folded(complex);
    }
    run.leave_off_ahead();
    rules.once = turned > 0;
    SheetTrial best = smooth_with_sheets(complex, made_from, rules, vain);
    const int inverted = best.smoothing.inverted;
    const bool in_vain = vain > (rules.another_way ? kVainWork : kVainWorkAlone);
    if (turned > 0 && inverted > 0 && !in_vain) {
      folded_with_turns = folded_for_good(best.mesh, inverted);
      fit.free_turns = false;
      --round;
      continue;
    }
    if (inverted == 0 && !best.worth.faithful) look_again(best, complex, made_from, fit, rules, vain);
    // The mesh is there already: it stays when the time for this is used up.
    if (inverted == 0) run_with_share(run.context, kShareForBetter, [&] { lift_trial_mean(best, task); });
    run.result.sheets = best.sheets;
    run.result.smoothing = best.smoothing;
    if (inverted == 0) return best;
    complex = std::move(best.mesh);
    std::vector<int> released = fit.released;
    for (int e : edges_to_release(complex, geometry)) released.push_back(e);
    if (round == kRounds || in_vain || inverted >= least || released.size() == fit.released.size()) {
      run.result.mesh = complex;
      throw folded_for_good(complex, inverted);
    }
    least = inverted;
    std::sort(released.begin(), released.end());
    fit.released = std::move(released);
  }
}

}  // namespace

FeatureLineMesh feature_line(const SolidTask& task, const LabelEffort& effort) {
  Run& run = task.run;
  Result& result = run.result;
  const Geometry& geometry = task.part.geometry();
  result.sheets = {};

  run.begin("labels");
  result.labels = label(result.surface, geometry, effort, run);
  run.show_final();
  run.complete();
  run.reached("shape");
  require_valid(result.labels);
  if (!run.is_new(result.labels.surface)) throw MeshingError(Failure::NoMesh, "labels", "an earlier proposal has these very labels");
  const SurfaceMesh& mesh = result.labels.surface.mesh;
  const FeatureShape& shape = result.labels.shape;

  run.begin("lattice");
  Lattice lattice = build_lattice(mesh, shape, quantize_options(run.options), run.context);
  result.polycube = lattice.polycube;
  if (!lattice.report.ok)
    throw MeshingError(Failure::NoMesh, "lattice", lattice.report.reason, "try a smaller element size",
                       cad_faces_of(shape, lattice.report.charts));
  run.reached("polycube");
  result.mesh = lattice.complex;
  std::fill(lattice.complex.hex_solid.begin(), lattice.complex.hex_solid.end(), task.solid);
  run.complete();

  SheetTrial made = fit_and_smooth({task, mesh, shape, lattice});
  result.polycube = std::move(lattice.polycube);
  result.mesh = made.mesh;
  run.complete();

  run.begin("certificate");
  certify(made.mesh, *geometry.projector, static_cast<int>(geometry.faces->size()), certificate_tolerance(mesh), run.context);
  return {std::move(made.mesh), std::move(made.worth)};
}

}  // namespace hexfeature
