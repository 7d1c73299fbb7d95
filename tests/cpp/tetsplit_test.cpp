// HexFeatureWB - LGPL-2.1-or-later
// The tet-split method piece by piece: CAD shapes from OCCT, tetrahedra by hand.
#include <doctest/doctest.h>

#include <chrono>
#include <cmath>
#include <memory>
#include <optional>
#include <random>
#include <thread>

#include "mesh/hex_element.h"
#include "quality/topology.h"
#include "surface_fixtures.h"
#include "tetsplit/child_process.h"
#include "tetsplit/relief.h"
#include "tetsplit/remesh.h"
#include "tetsplit/size_field.h"
#include "tetsplit/split.h"
#include "tetsplit/tet_split.h"
#include "tetsplit/tets_ahead.h"

using namespace hexfeature;
using cad_shapes::surface_of;

namespace {

/// Distance of a point from the CAD entity that it says it lies on.
double off(const CadModel& model, const CadPlace& place, const Vec3& p) {
  if (place.dim == 0) return (model.vertex_point(place.entity) - p).norm();
  if (place.dim == 1) return (model.project_to_edge(place.entity, p, &place.uv[0]).point - p).norm();
  return (model.project_to_face(place.entity, p, &place.uv).point - p).norm();
}

/// Length of the mesh edges that follow each CAD edge, over the CAD edge's own.
std::vector<double> followed(const SurfaceMesh& mesh, const CadModel& model) {
  std::vector<double> length(model.edges.size() + 1, 0);
  for (int h = 0; h < 3 * mesh.triangle_count(); ++h)
    if (mesh.halfedge_edge[h] > 0 && h < mesh.opposite[h])
      length[mesh.halfedge_edge[h]] +=
          (mesh.points[mesh.from(h)] - mesh.points[mesh.to(h)]).norm() / model.edge(mesh.halfedge_edge[h]).length;
  return length;
}

/// The outer triangles of a few tetrahedra.
SurfaceMesh outside_of(const TetMesh& tets) {
  SurfaceMesh surface;
  surface.points = tets.points;
  surface.place.resize(tets.points.size());
  for (const auto& t : tets.tets)
    for (const auto& f : kTetFaces) {
      const std::array<int, 3> face{t[f[0]], t[f[1]], t[f[2]]};
      int same = 0;
      for (const auto& u : tets.tets) {
        int shared = 0;
        for (int v : u) shared += v == face[0] || v == face[1] || v == face[2];
        same += shared == 3;
      }
      if (same == 1) surface.triangles.push_back(face);
    }
  surface.triangle_face.assign(surface.triangles.size(), 1);
  surface.halfedge_edge.assign(3 * surface.triangles.size(), 0);
  connect(surface);
  return surface;
}

double volume(const TetMesh& mesh) {
  double sum = 0;
  for (const auto& t : mesh.tets) sum += tet_volume(mesh.points, t);
  return sum;
}

}  // namespace

TEST_CASE("the faces of a tetrahedron look outward") {
  const std::vector<Vec3> p{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  CHECK(tet_volume(p, {0, 1, 2, 3}) == doctest::Approx(1.0 / 6));
  for (int f = 0; f < 4; ++f) {
    const Vec3 n = (p[kTetFaces[f][1]] - p[kTetFaces[f][0]]).cross(p[kTetFaces[f][2]] - p[kTetFaces[f][0]]);
    CHECK(n.dot(p[kTetFaces[f][0]] - p[f]) > 0);
  }
}

TEST_CASE("hexahedra of any positive tetrahedron are positive and fill it") {
  const auto box = cad_shapes::model_of(cad_shapes::box(1, 1, 1));
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int trial = 0; trial < 2000; ++trial) {
    TetMesh tets;
    for (int k = 0; k < 4; ++k) tets.points.push_back({uniform(random), uniform(random), uniform(random)});
    if (tet_volume(tets.points, {0, 1, 2, 3}) < 0) std::swap(tets.points[0], tets.points[1]);
    if (tet_volume(tets.points, {0, 1, 2, 3}) < 1e-6) continue;
    tets.tets.push_back({0, 1, 2, 3});
    const HexComplex mesh = split_tetrahedra(tets, outside_of(tets), box->geometry());
    REQUIRE(mesh.hex_count() == 4);
    CHECK(mesh.quads.size() == 12);
    double sum = 0;
    for (const auto& hex : mesh.hexes) {
      CHECK(bernstein_minimum(mesh.points, hex) > 0);
      sum += hex_volume(mesh.points, hex);
    }
    CHECK(sum == doctest::Approx(volume(tets)));
  }
}

TEST_CASE("two boundary faces of one tetrahedron that open wide get tetrahedra of their own") {
  // Three tetrahedra round a long axis: at each edge of the girdle two boundary faces of one tetrahedron meet at nearly a straight angle.
  TetMesh tets;
  tets.points = {{0, 0, -4}, {0, 0, 4}, {1, 0, 0}, {-0.5, 0.8, 0}, {-0.5, -0.8, 0}};
  tets.tets = {{0, 2, 3, 1}, {0, 3, 4, 1}, {0, 4, 2, 1}};
  for (const auto& t : tets.tets) REQUIRE(tet_volume(tets.points, t) > 0);
  const SurfaceMesh surface = outside_of(tets);
  const double before = volume(tets);
  Context context;
  CHECK(relieve_boundary(tets, surface, context) == 1);
  CHECK(tets.tets.size() == 6);
  CHECK(tets.points.size() == 6);
  CHECK(volume(tets) == doctest::Approx(before));
  for (const auto& t : tets.tets) CHECK(tet_volume(tets.points, t) > 0);
  CHECK(relieve_boundary(tets, surface, context) == 0);
}

TEST_CASE("remeshing gives the lengths asked for, on the CAD, with every edge followed") {
  Context context;
  for (const auto& shape : {cad_shapes::plate_with_hole(), cad_shapes::cylinder(8, 20), cad_shapes::sphere(10), cad_shapes::cone(8, 15),
                            cad_shapes::torus(12, 4), cad_shapes::as_splines(cad_shapes::cylinder(8, 20))}) {
    const auto model = cad_shapes::model_of(shape);
    const double wanted = 4;
    Remesher remesher(surface_of(*model, 1.5), model->geometry(), 0.01);
    remesher.remesh([&](const Vec3&) { return wanted; }, 6, context);
    const SurfaceMesh mesh = remesher.result({});
    int fitting = 0, edges = 0;
    for (int h = 0; h < 3 * mesh.triangle_count(); ++h) {
      const double length = (mesh.points[mesh.from(h)] - mesh.points[mesh.to(h)]).norm();
      CHECK(length < 2 * wanted);
      fitting += length > 0.5 * wanted && length < 1.5 * wanted;
      ++edges;
    }
    CHECK(fitting > 0.9 * edges);
    for (int v = 0; v < mesh.point_count(); ++v) CHECK(off(*model, mesh.place[v], mesh.points[v]) < 1e-8);
    const std::vector<double> ratio = followed(mesh, *model);
    for (std::size_t e = 1; e <= model->edges.size(); ++e) {
      const CadEdge& edge = model->edge(static_cast<int>(e));
      if (edge.seam || edge.degenerate)
        CHECK(ratio[e] == 0);
      else
        CHECK(ratio[e] > 0.85);
    }
    CHECK(enclosed_volume(mesh) == doctest::Approx(model->volume()).epsilon(0.2));
  }
}

TEST_CASE("the size field is short where a wall is thin or a hole is small, and graded") {
  Context context;
  const auto model =
      cad_shapes::model_of(cad_shapes::cut(cad_shapes::box(40, 40, 20), cad_shapes::moved(cad_shapes::cylinder(2, 60), 10, 10, -5)));
  SizeOptions options;
  options.longest = 9;
  options.least = 1;
  options.least_curve = 1;
  const SizeField field(surface_of(*model, 2), model->geometry(), options, context);
  CHECK(field.at(model->to_frame({12, 10, 0})) < 2.5);
  CHECK(field.at(model->to_frame({38, 38, 20})) > 8);
  const double near = field.at(model->to_frame({14, 10, 0})), far = field.at(model->to_frame({20, 10, 0}));
  CHECK(near < far);
  CHECK(far - near < 0.75 * 6);
  const auto sheet = cad_shapes::model_of(cad_shapes::box(40, 40, 2));
  CHECK(SizeField(surface_of(*sheet, 2), sheet->geometry(), options, context).at(sheet->to_frame({20, 20, 0})) < 4);
}

TEST_CASE("the whole method: parts without a polycube get a certified mesh with every edge") {
  Context context;
  for (const auto& shape : {cad_shapes::cone(8, 15), cad_shapes::plate_with_hole(), cad_shapes::torus(12, 4)}) {
    const auto model = cad_shapes::model_of(shape);
    TetSplitOptions options;
    options.size = 2;
    TetSplitReport report;
    const auto mesh_with = [&](const TetSplitOptions& o, TetSplitReport& r) {
      return tet_split(begin_tet_split(surface_of(*model, o.size), model->geometry(), o, context), model->geometry(), o, context, r);
    };
    const HexComplex mesh = mesh_with(options, report);
    CHECK(mesh.hex_count() == 4 * report.tetrahedra);
    CHECK(check_topology(mesh, context).count == 0);
    double sum = 0;
    for (const auto& hex : mesh.hexes) {
      CHECK(proves_positive(mesh.points, hex));
      sum += hex_volume(mesh.points, hex);
    }
    CHECK(sum == doctest::Approx(model->volume()).epsilon(0.05));
    for (int v = 0; v < mesh.point_count(); ++v)
      if (mesh.place[v].dim < 3) CHECK(off(*model, mesh.place[v], mesh.points[v]) < 1e-8);
    TetSplitOptions one_thread = options;
    one_thread.threads = 1;
    TetSplitReport again;
    const HexComplex same = mesh_with(one_thread, again);
    CHECK(same.points == mesh.points);
    CHECK(same.hexes == mesh.hexes);
  }
}

TEST_CASE("a cancel reaches the tetrahedral mesher's process") {
  const auto model = cad_shapes::model_of(cad_shapes::plate_with_hole());
  const SurfaceMesh surface = surface_of(*model, 1);
  Context context;
  int asked = 0;
  context.is_cancelled = [&] { return ++asked > 3; };
  CHECK_THROWS_AS(fill_with_tetrahedra(surface, {}, context), MeshingError);
}

TEST_CASE("the memory of a child process counts, and it is ended") {
  const std::string text = "x=$(head -c 200000000 /dev/zero | tr '\\0' a); sleep 60\n";
  Context context;
  context.limit_memory(50'000'000);
  CHECK_THROWS_AS(run_child("/bin/sh", {text.begin(), text.end()}, context), MemoryLimit);
}

TEST_CASE("without the tetrahedral mesher the error says what to install") {
  const auto model = cad_shapes::model_of(cad_shapes::box(1, 1, 1));
  Context context;
  TetOptions options;
  options.program = "/nowhere/hexfeature-netgen";
  try {
    fill_with_tetrahedra(surface_of(*model, 1), options, context);
    FAIL("no error");
  } catch (const MeshingError& error) {
    CHECK(error.kind == Failure::NoMesh);
    CHECK(error.step == "tetrahedra");
    CHECK(error.hint.find("libnglib-dev") != std::string::npos);
  }
}

TEST_CASE("what is made ahead is what would be made later, and nothing is there when it was not begun or not wanted") {
  using std::chrono::hours;
  using std::chrono::milliseconds;
  const auto model = cad_shapes::model_of(cad_shapes::plate_with_hole());
  TetSplitOptions options;
  options.size = 2;
  const SurfaceMesh surface = surface_of(*model, options.size);
  Context context;
  const TetSplitStart later = begin_tet_split(surface, model->geometry(), options, context);
  REQUIRE(later.first);

  std::optional<TetSplitStart> ahead;
  for (int wait = 1; !ahead && wait < 5000; wait *= 2) {  // until it has begun
    TetsAhead at_once(surface, model->geometry(), options, milliseconds(0));
    std::this_thread::sleep_for(milliseconds(wait));
    ahead = at_once.take(context);
  }
  REQUIRE(ahead);
  REQUIRE(ahead->first);
  TetSplitReport report;
  const HexComplex by_ahead = tet_split(std::move(*ahead), model->geometry(), options, context, report);
  const HexComplex by_later = tet_split(later, model->geometry(), options, context, report);
  CHECK(by_ahead.points == by_later.points);
  CHECK(by_ahead.hexes == by_later.hexes);

  TetsAhead not_begun(surface, model->geometry(), options, hours(1));
  CHECK(!not_begun.take(context));

  options.netgen = "/nowhere/hexfeature-netgen";
  TetsAhead failing(surface, model->geometry(), options, milliseconds(0));
  std::this_thread::sleep_for(milliseconds(300));  // until it has failed
  CHECK(!failing.take(context));
}

TEST_CASE("who waits for what is made ahead, or no longer wants it, is not kept waiting") {
  using std::chrono::milliseconds;
  const auto model = cad_shapes::model_of(cad_shapes::plate_with_hole());
  TetSplitOptions options;
  options.size = 0.1;  // takes many seconds
  const SurfaceMesh surface = surface_of(*model, 0.5);
  const auto begun = [&] {
    auto ahead = std::make_unique<TetsAhead>(surface, model->geometry(), options, milliseconds(0));
    std::this_thread::sleep_for(milliseconds(300));
    return ahead;
  };
  const auto seconds_since = [](Context::Clock::time_point t) { return std::chrono::duration<double>(Context::Clock::now() - t).count(); };
  constexpr double kSoon = 2;  // 0.2 s on a processor that nobody else uses
  auto ahead = begun();
  auto start = Context::Clock::now();
  Context cancelled;
  cancelled.is_cancelled = [&] { return seconds_since(start) > 0.1; };
  try {
    ahead->take(cancelled);
    CHECK(false);
  } catch (const MeshingError& error) {
    CHECK(error.kind == Failure::Cancelled);
  }
  ahead.reset();
  CHECK(seconds_since(start) < kSoon);
  ahead = begun();
  start = Context::Clock::now();
  Context late;
  late.deadline = start;
  CHECK_THROWS_AS(ahead->take(late), TimeLimit);

  ahead = begun();
  start = Context::Clock::now();
  ahead->stop();
  CHECK(seconds_since(start) < kSoon);
  Context context;
  CHECK(!ahead->take(context));
}

TEST_CASE("a surface that cannot be filled ahead is told by the method itself") {
  const auto model = cad_shapes::model_of(cad_shapes::plate_with_hole());
  TetSplitOptions options;
  options.size = 2;
  options.netgen = "/nowhere/hexfeature-netgen";
  Context context;
  TetSplitStart start = begin_tet_split(surface_of(*model, options.size), model->geometry(), options, context);
  CHECK(!start.first);
  REQUIRE(start.failure);
  CHECK(start.failure->step == "tetrahedra");
  TetSplitReport report;
  CHECK_THROWS_AS(tet_split(std::move(start), model->geometry(), options, context, report), MeshingError);
}
