// HexFeatureWB - LGPL-2.1-or-later
#include "pipeline/second_looks.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "base/share.h"
#include "recover/face_cover.h"
#include "recover/late_edges.h"
#include "recover/missing_lines.h"

namespace hexfeature {
namespace {

/// A mesh that lost more (Worth::lost) is not mended by a few lines more.
constexpr double kHopeless = 0.4;

/// What lost more than this lacks lines first of all. A mesh of more elements than that is not fitted again.
constexpr double kMuch = 0.2;
constexpr int kLarge = 10000;

/// With another method to come, lines more may make so many times as many elements, and a fit of any turns brings back this much.
constexpr double kMostGrowth = 2, kInsistBelow = 0.1;

/// To keep more of the part, elements may be as poor as this, or lose this much.
constexpr double kPoor = 0.3, kPoorer = 0.7;

/// Once a face is covered at all, it is to be covered with something to spare: gaps of at most so many h.
constexpr double kComfortable = 0.44;

/// Elements that are poorer than the worst by no more than this are let go together.
constexpr double kNextWorst = 0.02;

constexpr int kTrials = 4, kDraws = 4;  ///< of one kind of look

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

/// Halfedges of the surface mesh on CAD edges that a mesh does not follow: sharp ones that it lost, and others where a face is not covered.
std::vector<int> halfedges_not_followed(const SheetTrial& trial, const SurfaceMesh& mesh, const Geometry& geometry, double size,
                                        const Context& context) {
  constexpr double kGap = 0.5;  // of h
  const std::vector<char> uncovered = uncovered_points(trial.mesh, mesh, geometry, size, kGap, context);
  std::vector<int> halfedges;
  for (int h = 0; h < 3 * mesh.triangle_count(); ++h) {
    const int o = mesh.opposite[h], e = mesh.halfedge_edge[h];
    if (h > o || e <= 0 || mesh.triangle_face[h / 3] == mesh.triangle_face[o / 3]) continue;
    const bool lost = std::binary_search(trial.worth.lost_edges.begin(), trial.worth.lost_edges.end(), e);
    if (lost || (!geometry.edge(e).sharp && (uncovered[mesh.from(h)] || uncovered[mesh.to(h)]))) halfedges.push_back(h);
  }
  return halfedges;
}

class SecondLooks {
 public:
  SecondLooks(SheetTrial& best, const HexComplex& fitted, const MadeFrom& from, const FitOptions& fit, const SheetRules& rules, int& vain)
      : best_(best), fitted_(fitted), from_(from), geometry_(from.task.part.geometry()), fit_(fit), quick_(rules), vain_(vain) {
    quick_.once = true;
    quick_.most = 2;
  }

  void run() {
    const double at_first = best_.smoothing.min_sj;
    if (best_.worth.lost < kMuch) look([&] { follow_late(); });
    look([&] { draw(); });
    bool refined = false;
    const bool large = best_.mesh.hex_count() > kLarge;
    if (!large) look([&] { refined = refine(); });
    if (refined) look([&] { follow_late(); });
    if (refined) look([&] { draw(); });
    if (!large && fit_.free_turns && (!quick_.another_way || best_.worth.lost < kInsistBelow)) look([&] { insist(); });
    if (moved_ && !used_up_ && best_.smoothing.min_sj < kPoorer * at_first) spend([&] { smooth_all(); });
    best_.held = held_;
  }

 private:
  Run& run_state() const { return from_.task.run; }
  Context& context() const { return run_state().context; }
  double size() const { return run_state().options.size; }

  void look(const std::function<void()>& work) {
    if (!best_.worth.faithful && !used_up_) spend(work);
  }
  void spend(const std::function<void()>& work) {
    try {
      // When a share of the time or all memory is used up, the rest is for what must still be done with the mesh that is there.
      used_up_ = run_with_share(context(), kShareForBetter, work).has_value();
    } catch (const MeshingError& error) {
      if (error.kind != Failure::NoMesh) throw;
      context().log("second look gave up in step " + error.step + ": " + error.reason);
    }
  }
  /// What the worst element may be for a mesh that keeps more.
  double bearable() const { return std::min(kPoor, kPoorer * best_.smoothing.min_sj); }
  bool take(SheetTrial& other, double least) {
    if (!is_better(other, best_) || other.smoothing.min_sj < least) return false;
    best_ = std::move(other);
    return true;
  }

  /// Points bound to the CAD edges that the mesh does not follow, but for those that turn elements inverted or poor.
  void follow_late() {
    std::vector<int> edges;
    for (int h : halfedges_not_followed(best_, from_.mesh, geometry_, size(), context())) edges.push_back(from_.mesh.halfedge_edge[h]);
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    std::vector<LateRun> runs = runs_beside_edges(best_.mesh, edges, run_state().result.surface, geometry_, size(), context());
    for (int trial = 0; trial < kTrials && !runs.empty(); ++trial) {
      SheetTrial other = best_;
      bind_points(other.mesh, runs);
      context().log(std::to_string(runs.size()) + " runs of points bound to CAD edges");
      std::vector<int> points;
      for (const LateRun& r : runs) points.insert(points.end(), r.nodes.begin(), r.nodes.end());
      smooth_trial(other, from_.task, false, points, held_);
      const double least = bearable();
      if (take(other, least)) {
        moved_ = true;
        return;
      }
      // Of the poor ones the worst first: their neighbours may be well without them.
      const double worst = other.smoothing.inverted > 0 ? 0 : other.smoothing.min_sj;
      if (!release(runs, points_of_inverted(other.mesh, std::min(least, worst + kNextWorst)))) return;
    }
  }

  /// Points drawn to what is not covered, and held there; smoothing the others may uncover something else, which is next. Not as long as
  /// sharp edges are lost, which that does not bring back.
  void draw() {
    if (best_.worth.edges_lost) return;
    const auto covered = [](const SheetTrial& trial) { return trial.worth.faithful && trial.worth.largest_gap <= kComfortable; };
    SheetTrial now = best_;
    std::vector<int> held = held_;
    for (int trial = 0; trial < kDraws && !covered(best_); ++trial) {
      const std::vector<int> drawn = draw_to_gaps(now.mesh, run_state().result.surface, geometry_, size(), context());
      if (drawn.empty()) return;
      context().log(std::to_string(drawn.size()) + " points drawn to gaps");
      held.insert(held.end(), drawn.begin(), drawn.end());
      smooth_trial(now, from_.task, false, drawn, held);
      if (now.smoothing.inverted > 0) return;
      SheetTrial other = now;
      const double least = bearable();
      const bool closer = best_.worth.faithful && other.worth.faithful && other.worth.largest_gap < best_.worth.largest_gap;
      if (closer && other.smoothing.min_sj >= least)
        best_ = std::move(other);
      else if (!take(other, least))
        continue;
      held_ = held;
      moved_ = true;
    }
  }

  /// A lattice with more lines where CAD edges have none.
  bool refine() {
    const std::vector<Separation> wanted = missing_lines(halfedges_not_followed(best_, from_.mesh, geometry_, size(), context()),
                                                         from_.lattice, fitted_, from_.mesh, from_.shape, size(), context());
    if (wanted.empty()) return false;
    run_state().begin("lattice");
    Lattice finer = build_lattice(from_.mesh, from_.shape, quantize_options(run_state().options), context(), wanted);
    if (!finer.report.ok) return false;
    if (quick_.another_way && finer.complex.hex_count() > kMostGrowth * from_.lattice.complex.hex_count()) return false;
    context().log("lattice: more lines between " + std::to_string(wanted.size()) + " pairs of charts, " +
                  std::to_string(from_.lattice.complex.hex_count()) + " -> " + std::to_string(finer.complex.hex_count()) + " hexahedra");
    std::fill(finer.complex.hex_solid.begin(), finer.complex.hex_solid.end(), from_.task.solid);
    if (!fit_again(finer, fit_)) return false;
    from_.lattice = std::move(finer);
    return true;
  }

  /// Paths of any turns for what the mesh lost.
  void insist() {
    FitOptions stubborn = fit_;
    const std::vector<int> wanted = edges_to_insist_on(best_.worth, geometry_);
    std::set_difference(wanted.begin(), wanted.end(), fit_.released.begin(), fit_.released.end(), std::back_inserter(stubborn.insisted));
    if (!stubborn.insisted.empty()) fit_again(from_.lattice, stubborn);
  }

  bool fit_again(const Lattice& lattice, const FitOptions& fit) {
    run_state().begin("fit");
    HexComplex complex = lattice.complex;
    fit_boundary(complex, from_.mesh, from_.shape, geometry_, fit, context());
    SheetTrial other = smooth_with_sheets(complex, from_, quick_, vain_);
    if (!take(other, 0)) return false;
    held_.clear();
    moved_ = false;
    return true;
  }

  /// What lies around the points bound and drawn has paid for them: all others may help.
  void smooth_all() {
    SheetTrial other = best_;
    smooth_trial(other, from_.task, false, {}, held_);
    take(other, 0);
  }

  SheetTrial& best_;
  const HexComplex& fitted_;
  const MadeFrom& from_;
  const Geometry geometry_;
  const FitOptions& fit_;
  SheetRules quick_;
  int& vain_;
  std::vector<int> held_;  // points of the best mesh that were drawn somewhere
  bool moved_ = false;     // its points were bound or drawn
  bool used_up_ = false;
};

}  // namespace

void look_again(SheetTrial& best, const HexComplex& fitted, const MadeFrom& made_from, const FitOptions& fit, const SheetRules& rules,
                int& vain) {
  const double lost_at_first = best.worth.lost;
  if (best.worth.lost < kHopeless) SecondLooks(best, fitted, made_from, fit, rules, vain).run();
  best.worth.lost_at_first = lost_at_first;
  made_from.task.run.begin("smooth");  // whatever was looked at last, this is the step that has been done
}

}  // namespace hexfeature
