// HexFeatureWB - LGPL-2.1-or-later
// The mean scaled Jacobian of a trial's mesh is lifted as far as that costs nothing of the part.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "hex_fixtures.h"
#include "pipeline/fitted_mesh.h"
#include "pipeline_fixtures.h"
#include "recover/face_cover.h"

using namespace hexfeature;
using namespace fixtures;

namespace {

constexpr double kRadius = 5;

/// A ball of one CAD face, or of two that are no neighbours of each other.
struct Ball : NoPart {
  explicit Ball(int faces_) : faces(faces_) {
    for (CadFace& f : faces) f.kind = SurfaceKind::Sphere;
  }
  Geometry geometry() const override { return {&faces, &edges, &vertices, &projector}; }

  SphereProjector projector{kRadius};
  std::vector<CadFace> faces;
  std::vector<CadEdge> edges;
  std::vector<CadVertex> vertices;
};

/// Points of the CAD: those of a mesh's quads, on the quads' faces; those of face 2 `above` them.
SurfaceMesh sampled(const HexComplex& c, double above) {
  SurfaceMesh s;
  for (std::size_t q = 0; q < c.quads.size(); ++q)
    for (int k = 1; k <= 2; ++k) {
      const int first = s.point_count(), face = c.quad_face[q];
      for (int v : {c.quads[q][0], c.quads[q][k], c.quads[q][k + 1]}) {
        s.points.push_back((face == 2 ? 1 + above / kRadius : 1) * c.points[v]);
        s.place.push_back({2, face, Vec2::Zero()});
      }
      s.triangles.push_back({first, first + 1, first + 2});
      s.triangle_face.push_back(face);
    }
  s.halfedge_edge.assign(3 * s.triangles.size(), 0);
  return s;
}

}  // namespace

TEST_CASE("the mean of a trial's mesh is lifted, and what uncovers a CAD face is held") {
  Context context;
  SmoothOptions smoothing;
  smoothing.size = 1;
  SheetTrial smoothed;
  smoothed.mesh = sphere_mesh(10, kRadius);
  smoothed.smoothing = smooth(smoothed.mesh, SphereProjector(kRadius), smoothing, context);
  HexComplex freely = smoothed.mesh;
  smooth_mean(freely, SphereProjector(kRadius), smoothing, context);
  // The quad whose points slide the most.
  std::size_t moved = 0;
  double most = 0;
  for (std::size_t q = 0; q < freely.quads.size(); ++q) {
    double sum = 0;
    for (int v : freely.quads[q]) sum += (freely.points[v] - smoothed.mesh.points[v]).norm();
    if (sum > most) most = sum, moved = q;
  }
  REQUIRE(most > 0.4);
  for (const bool two : {false, true}) {
    CAPTURE(two);
    SheetTrial trial = smoothed;
    if (two) trial.mesh.quad_face[moved] = 2;
    Ball ball(two ? 2 : 1);
    Options options;
    options.size = 1;
    Result result;
    result.surface = sampled(trial.mesh, 0.355);
    Run run(options, context, result);
    const std::vector<Mat3> frames = ball.frames();
    const SolidTask task{ball, 1, frames, run};
    trial.worth = worth_of(trial.mesh, trial.smoothing, task);
    REQUIRE(trial.worth.faithful);
    lift_trial_mean(trial, task);
    CHECK(trial.smoothing.mean_sj > smoothed.smoothing.mean_sj + 0.01);
    CHECK(trial.smoothing.min_sj >= smoothed.smoothing.min_sj - 1e-9);
    CHECK(trial.worth.faithful);
    CHECK(trial.worth.mean_sj == trial.smoothing.mean_sj);
    double slid = 0, gap = 0;
    for (int v : trial.mesh.quads[moved]) slid = std::max(slid, (trial.mesh.points[v] - smoothed.mesh.points[v]).norm());
    for (const PointGap& g : point_gaps(trial.mesh, result.surface, ball.geometry(), 1, context)) gap = std::max(gap, g.gap);
    CHECK((slid > 1e-9) == !two);
    CHECK(gap < 0.361);
  }
}
