// HexFeatureWB - LGPL-2.1-or-later
#include "pipeline/feature_line.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "base/share.h"
#include "fit/fit.h"
#include "pipeline/sheet_trials.h"

namespace hexfeature {
namespace {

/// With another method to come, elements of all the meshes of one labelling that stay inverted before it is given up.
constexpr int kVainWork = 12000;

/// A mesh that lost this much (Worth::lost) is not mended by a few lines more.
constexpr double kHopeless = 0.2;

std::vector<int> cad_faces_of(const FeatureShape& shape, const std::vector<int>& charts) {
  std::set<int> faces;
  for (int c : charts) faces.insert(shape.charts[c].cad_faces.begin(), shape.charts[c].cad_faces.end());
  return {faces.begin(), faces.end()};
}

QuantizeOptions quantize_options(const Options& options) {
  QuantizeOptions quantize;
  quantize.size = options.size;
  quantize.minimum_intervals = options.minimum_layers;
  return quantize;
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

/// The fitted lattice with the sheets that pay, smoothed. `vain` counts the elements of all meshes that stayed inverted.
SheetTrial smooth_with_sheets(const HexComplex& fitted, const FeatureShape& shape, const SolidTask& task, const SheetRules& rules,
                              int& vain) {
  Run& run = task.run;
  const Geometry& geometry = task.part.geometry();
  const auto mesh_without = [&](const SheetNames& without, bool run_through) {
    SheetOptions sheets;
    sheets.size = run.options.size;
    sheets.max_sheets = run.options.sheets ? sheets.max_sheets : 0;
    sheets.without = without;
    sheets.run_through = run_through;
    SmoothOptions smoothing;
    smoothing.size = run.options.size;
    smoothing.threads = run.options.threads;
    run.begin("sheets");
    SheetTrial trial;
    trial.mesh = fitted;
    trial.sheets = insert_sheets(trial.mesh, shape, geometry, sheets, run.context);
    trial.sheets.taken_back = static_cast<int>(without.size());
    if (without.empty() && run_through) run.result.mesh = trial.mesh;
    if (without.empty() && run_through && run.options.sheets) run.complete();
    run.begin("smooth");
    trial.smoothing = smooth(trial.mesh, *geometry.projector, smoothing, run.context);
    run.context.log("with " + std::to_string(trial.sheets.inserted) + " sheets: min SJ " + std::to_string(trial.smoothing.min_sj) +
                    ", inverted " + std::to_string(trial.smoothing.inverted) + " of " + std::to_string(trial.mesh.hex_count()));
    if (trial.smoothing.inverted == 0) trial.worth = worth_of(trial.mesh, trial.smoothing, task);
    if (trial.smoothing.inverted > 0) vain += trial.mesh.hex_count();
    for (int s :
         sheets_near(trial.mesh, trial.sheets, proved_scaled_jacobians(trial.mesh.points, trial.mesh.hexes), trial.smoothing.min_sj + 1e-6))
      trial.suspects.push_back(trial.sheets.names[s]);
    return trial;
  };
  return try_sheets(mesh_without, rules, run.context);
}

/// Marks the points of the elements that are not proved positive.
std::vector<char> points_of_inverted(const HexComplex& complex) {
  const std::vector<double> quality = proved_scaled_jacobians(complex.points, complex.hexes);
  std::vector<char> marked(complex.points.size(), 0);
  for (int h = 0; h < complex.hex_count(); ++h)
    if (!(quality[h] > 0))
      for (int v : complex.hexes[h]) marked[v] = 1;
  return marked;
}

/// CAD edges that run inside a chart, are followed by a chain of mesh edges, and touch an inverted element or a neighbour of one:
/// letting them go is what may make it valid. Tangent ones first: a mesh loses less without them. Sorted.
std::vector<int> edges_to_release(const HexComplex& complex, const Geometry& geometry) {
  const std::vector<char> near = points_of_inverted(complex);
  std::vector<char> ring = near;
  for (const auto& hex : complex.hexes)
    if (std::any_of(hex.begin(), hex.end(), [&](int v) { return near[v] != 0; }))
      for (int v : hex) ring[v] = 1;
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

/// The CAD edges that a mesh should have followed and did not: the sharp ones it lost, and all borders of the faces it does not cover.
/// Sorted.
std::vector<int> edges_to_insist_on(const Worth& worth, const Geometry& geometry) {
  std::vector<int> edges = worth.lost_edges;
  for (int e = 1; e <= static_cast<int>(geometry.edges->size()); ++e)
    for (int f : geometry.edge(e).faces)
      if (std::binary_search(worth.lost_faces.begin(), worth.lost_faces.end(), f)) edges.push_back(e);
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

/// Boundary fitting, sheets and smoothing, first with free turns; where elements stay inverted with these, without. Where elements stay
/// inverted, again without the inner CAD edges beside them, as long as that makes fewer. Throws MeshingError(NoMesh, "smooth") when some
/// stay.
HexComplex fit_and_smooth(const HexComplex& lattice, const SurfaceMesh& mesh, const FeatureShape& shape, const SolidTask& task) {
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
  // A mesh that is not faithful: once more, with paths of any turns for what it lost; kept when it is better.
  const auto insist = [&](SheetTrial& best) {
    FitOptions stubborn = fit;
    const std::vector<int> wanted = edges_to_insist_on(best.worth, geometry);
    std::set_difference(wanted.begin(), wanted.end(), fit.released.begin(), fit.released.end(), std::back_inserter(stubborn.insisted));
    if (stubborn.insisted.empty()) return;
    SheetRules quick = rules;
    quick.once = true;
    quick.most = 2;
    try {
      run_with_share(run.context, kShareForBetter, [&] {
        run.begin("fit");
        HexComplex complex = lattice;
        fit_boundary(complex, mesh, shape, geometry, stubborn, run.context);
        SheetTrial other = smooth_with_sheets(complex, shape, task, quick, vain);
        if (is_better(other, best)) best = std::move(other);
      });
    } catch (const MeshingError& error) {
      if (error.kind != Failure::NoMesh) throw;
      run.context.log("fit: insisting gave up in step " + error.step + ": " + error.reason);
    }
  };
  for (int round = 1, least = std::numeric_limits<int>::max();; ++round) {
    run.begin("fit");
    HexComplex complex = lattice;
    const int turned = fit_boundary(complex, mesh, shape, geometry, fit, run.context);
    run.result.mesh = complex;
    run.complete();
    rules.once = turned > 0;
    SheetTrial best = smooth_with_sheets(complex, shape, task, rules, vain);
    const int inverted = best.smoothing.inverted;
    const bool in_vain = rules.another_way && vain > kVainWork;
    if (turned > 0 && inverted > 0 && !in_vain) {
      fit.free_turns = false;
      --round;
      continue;
    }
    if (inverted == 0 && !best.worth.faithful && best.worth.lost < kHopeless && fit.free_turns) insist(best);
    complex = std::move(best.mesh);
    run.result.sheets = std::move(best.sheets);
    run.result.smoothing = best.smoothing;
    if (inverted == 0) return complex;
    std::vector<int> released = fit.released;
    for (int e : edges_to_release(complex, geometry)) released.push_back(e);
    if (round == kRounds || in_vain || inverted >= least || released.size() == fit.released.size()) {
      run.result.mesh = complex;
      throw MeshingError(Failure::NoMesh, "smooth", std::to_string(inverted) + " elements stay inverted or folded",
                         "try another element size, or simplify the faces named", faces_near_inverted(complex));
    }
    least = inverted;
    std::sort(released.begin(), released.end());
    fit.released = std::move(released);
  }
}

}  // namespace

HexComplex feature_line(const SolidTask& task, const LabelEffort& effort) {
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

  HexComplex complex = fit_and_smooth(lattice.complex, mesh, shape, task);
  result.mesh = complex;
  run.complete();

  run.begin("certificate");
  certify(complex, *geometry.projector, static_cast<int>(geometry.faces->size()), certificate_tolerance(mesh), run.context);
  return complex;
}

}  // namespace hexfeature
