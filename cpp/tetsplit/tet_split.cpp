// HexFeatureWB - LGPL-2.1-or-later
#include "tetsplit/tet_split.h"

#include <algorithm>
#include <array>
#include <optional>

#include "base/share.h"
#include "mesh/hex_element.h"
#include "tetsplit/relief.h"
#include "tetsplit/remesh.h"
#include "tetsplit/size_field.h"
#include "tetsplit/split.h"
#include "tetsplit/tetrahedra.h"

namespace hexfeature {
namespace {

/// CAD edges shorter than this many h may vanish; what is lost is less than any node's tolerance.
constexpr double kTiny = 0.01;
/// Tips of faces are cut where they are narrower than this many h: well within what a sharp edge may stray.
constexpr double kTipWidth = 0.06, kTipLength = 0.48;
/// ... and only where the worst element stays below this with them: a cut costs a little of the two sharp edges.
constexpr double kTipsForbid = 0.1;

/// Large meshes are not made again and again for a little better worst element: elements of all attempts, and what is bearable then.
constexpr int kMostWork = 100000;
constexpr double kBearable = 0.05;

std::vector<Vec3> bad_places(const HexComplex& mesh, double limit, const Context& context) {
  std::vector<Vec3> places;
  for (int h = 0; h < mesh.hex_count(); ++h) {
    if (h % 8192 == 0) context.check();
    const auto& hex = mesh.hexes[h];
    if (scaled_jacobian(mesh.points, hex) >= limit && proves_positive(mesh.points, hex)) continue;
    Vec3 centre = Vec3::Zero();
    for (int v : hex) centre += mesh.points[v] / 8;
    places.push_back(centre);
  }
  return places;
}

FilledSurface remesh_and_fill(Remesher remesher, const SizeField& lengths, const TetSplitOptions& options, Context& context) {
  FilledSurface filled;
  remesher.remesh([&](const Vec3& p) { return lengths.at(p); }, 6, context);
  remesher.cut_ears(context);
  filled.triangles = remesher.result(context, &filled.pinned);
  TetOptions filling;
  filling.longest = SizeOptions().longest * options.size;
  filling.program = options.netgen;
  filled.tets = fill_with_tetrahedra(filled.triangles, filling, context);
  return filled;
}

}  // namespace

TetSplitStart begin_tet_split(const SurfaceMesh& surface, const Geometry& geometry, const TetSplitOptions& options, Context& context) {
  const double h = options.size;
  context.progress("tet-split", 0);
  SizeOptions sizes;
  for (double* length : {&sizes.longest, &sizes.least, &sizes.least_curve, &sizes.least_wall}) *length *= h;
  Remesher whole(surface, geometry, kTiny * h);
  whole.refine([&](const Vec3&) { return h; }, context);
  TetSplitStart start{whole, SizeField(whole.result(context), geometry, sizes, context), {}, {}};
  try {
    start.first = remesh_and_fill(std::move(whole), start.lengths, options, context);
  } catch (const MeshingError& error) {
    if (error.kind != Failure::NoMesh) throw;
    start.failure = error;
  }
  return start;
}

HexComplex tet_split(TetSplitStart start, const Geometry& geometry, const TetSplitOptions& options, Context& context,
                     TetSplitReport& report) {
  // Edge lengths of the attempts over those asked for. The second is finer only where the first was bad, if it gave a mesh; the others
  // are other everywhere, since other elements meet there.
  constexpr double kFiner = 0.6;
  constexpr std::array<double, 5> kLengths{1, kFiner, 1.2, 0.85, 0.72};
  const double h = options.size;
  SmoothOptions smoothing;
  smoothing.size = h;
  smoothing.threads = options.threads;
  smoothing.least_target = 0.02;
  smoothing.brief = true;
  std::optional<HexComplex> best;
  std::optional<Remesher> cut;  // without the tips of faces
  int work = 0;
  std::optional<MeshingError> failure;
  const auto there = [&] { return best && report.smoothing.inverted == 0; };
  const auto fill_for = [&](int attempt) {
    if (attempt == 0 && start.failure) throw MeshingError(*start.failure);
    if (attempt == 0) return std::move(*start.first);
    const bool refining = attempt == 1 && best;
    SizeField lengths = start.lengths.scaled(refining ? 1 : kLengths[std::min<std::size_t>(attempt, kLengths.size() - 1)]);
    if (refining) {
      lengths.refine(bad_places(*best, options.good_enough, context), kFiner, context);
      if (report.smoothing.min_sj < kTipsForbid) {
        cut.emplace(start.surface);
        context.log("tet-split: " + std::to_string(cut->cut_tips(kTipWidth * h, kTipLength * h, context)) + " tips cut");
      }
    }
    return remesh_and_fill(cut ? *cut : start.surface, lengths, options, context);
  };
  const auto make = [&](int attempt) {
    context.progress("tet-split", static_cast<double>(attempt) / options.attempts);
    auto [triangles, pinned, tets] = fill_for(attempt);
    relieve_boundary(tets, triangles, context);
    HexComplex mesh = split_tetrahedra(tets, triangles, geometry, context);
    smoothing.held = pinned;
    const SmoothReport smoothed = smooth(mesh, *geometry.projector, smoothing, context);
    context.log("tet-split, attempt " + std::to_string(attempt + 1) + ": " + std::to_string(triangles.triangle_count()) + " triangles, " +
                std::to_string(tets.tets.size()) + " tetrahedra, worst " + std::to_string(smoothed.min_sj) + ", inverted " +
                std::to_string(smoothed.inverted));
    work += mesh.hex_count();
    const bool better = !best || (smoothed.inverted != report.smoothing.inverted ? smoothed.inverted < report.smoothing.inverted
                                                                                 : smoothed.min_sj > report.smoothing.min_sj);
    if (better) {
      report.smoothing = smoothed;
      report.triangles = triangles.triangle_count();
      report.tetrahedra = static_cast<int>(tets.tets.size());
      best = std::move(mesh);
    } else if (attempt == 1) {
      cut.reset();  // that did not help
    }
  };
  for (int attempt = 0; attempt < options.attempts; ++attempt) {
    ++report.attempts;
    try {
      if (!there())
        make(attempt);
      else if (run_with_share(context, kShareForBetter, [&] { make(attempt); }))
        break;
    } catch (const MeshingError& error) {
      if (error.kind != Failure::NoMesh) throw;
      context.log("tet-split, attempt " + std::to_string(attempt + 1) + " gave up in step " + error.step + ": " + error.reason);
      failure = error;
      if (attempt == 1) cut.reset();
    }
    if (!there()) continue;
    if (report.smoothing.min_sj >= options.good_enough || (report.smoothing.min_sj >= kBearable && work > kMostWork)) break;
  }
  if (!best) throw *failure;
  if (report.smoothing.inverted > 0)
    throw MeshingError(Failure::NoMesh, "tet-split", std::to_string(report.smoothing.inverted) + " elements stay inverted",
                       "try a smaller element size");
  context.progress("tet-split", 1);
  return std::move(*best);
}

}  // namespace hexfeature
