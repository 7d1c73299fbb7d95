// HexFeatureWB - LGPL-2.1-or-later
#include <doctest/doctest.h>

#include <BRep_Builder.hxx>
#include <IGESControl_Writer.hxx>
#include <STEPControl_Writer.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Shell.hxx>
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <random>

#include "cad_shapes.h"

using namespace hexfeature;
using namespace cad_shapes;

namespace {
int count(const CadModel& m, SurfaceKind kind) {
  return static_cast<int>(std::count_if(m.faces.begin(), m.faces.end(), [&](const CadFace& f) { return f.kind == kind; }));
}
int sharp_edges(const CadModel& m) {
  return static_cast<int>(std::count_if(m.edges.begin(), m.edges.end(), [](const CadEdge& e) { return e.sharp; }));
}
const CadFace& find(const CadModel& m, SurfaceKind kind) {
  return *std::find_if(m.faces.begin(), m.faces.end(), [&](const CadFace& f) { return f.kind == kind; });
}
int id_of(const CadModel& m, SurfaceKind kind) { return static_cast<int>(&find(m, kind) - m.faces.data()) + 1; }
std::string failure(const std::string& path, Failure kind = Failure::BadInput) {
  Context context;
  try {
    read_cad(path, context);
  } catch (const MeshingError& e) {
    CHECK(e.kind == kind);
    CHECK(e.step == "read");
    CHECK_FALSE(e.hint.empty());
    return e.reason;
  }
  return {};
}
}  // namespace

TEST_CASE("a box: planes, 12 sharp convex edges, 8 hard corners") {
  const auto m = model_of(box(4, 3, 2));
  CHECK(m->faces.size() == 6);
  CHECK(count(*m, SurfaceKind::Plane) == 6);
  CHECK(m->volume() == doctest::Approx(24));
  CHECK(m->diagonal() == doctest::Approx(std::sqrt(29.0)));
  CHECK(sharp_edges(*m) == 12);
  for (const auto& e : m->edges) CHECK(e.dihedral == doctest::Approx(EIGEN_PI / 2));
  for (const auto& v : m->vertices) {
    CHECK(v.hard);
    CHECK(v.edges.size() == 3);
  }
  for (int f = 1; f <= 6; ++f) {  // outward
    const FacePoint p = m->project_to_face(f, Vec3(2, 1.5, 1), nullptr);
    CHECK(p.normal.dot(p.point - Vec3(2, 1.5, 1)) > 0.9);
    CHECK(m->face(f).axis.dot(p.normal) == doctest::Approx(1));
  }
}

TEST_CASE("edges: convex, concave, tangent, seam, degenerate; corners") {
  const auto plate = model_of(plate_with_hole());
  CHECK(find(*plate, SurfaceKind::Cylinder).outward_convex == false);
  const auto pocket = model_of(cut(box(10, 10, 10), moved(box(4, 4, 4), 3, 3, 6)));
  CHECK(std::count_if(pocket->edges.begin(), pocket->edges.end(), [](const CadEdge& e) { return e.dihedral < -1.5; }) == 8);
  CHECK(std::count_if(pocket->edges.begin(), pocket->edges.end(), [](const CadEdge& e) { return e.dihedral > 1.5; }) == 16);

  const auto rod = model_of(cylinder(2, 5));
  CHECK(find(*rod, SurfaceKind::Cylinder).outward_convex);
  CHECK(find(*rod, SurfaceKind::Cylinder).radius == doctest::Approx(2));
  CHECK(std::count_if(rod->edges.begin(), rod->edges.end(), [](const CadEdge& e) { return e.seam; }) == 1);
  CHECK(sharp_edges(*rod) == 2);
  for (const auto& v : rod->vertices) CHECK_FALSE(v.hard);

  const auto ball = model_of(sphere(3));
  CHECK(sharp_edges(*ball) == 0);
  CHECK(std::count_if(ball->edges.begin(), ball->edges.end(), [](const CadEdge& e) { return e.degenerate; }) == 2);
  for (const auto& v : ball->vertices) CHECK_FALSE(v.hard);
  CHECK(ball->volume() == doctest::Approx(36 * EIGEN_PI));

  const auto tip = model_of(cone(2, 4));
  CHECK(std::count_if(tip->vertices.begin(), tip->vertices.end(), [](const CadVertex& v) { return v.hard; }) == 1);

  // A stadium: tangent edges are not sharp.
  const auto stadium = model_of(fuse(fuse(moved(box(6, 4, 3), 0, -2, 0), cylinder(2, 3)), moved(cylinder(2, 3), 6, 0, 0)));
  CHECK(std::count_if(stadium->edges.begin(), stadium->edges.end(),
                      [](const CadEdge& e) { return std::abs(e.dihedral) < 1e-6 && !e.seam; }) >= 4);
}

TEST_CASE("canonical surfaces are recognised behind splines") {
  const auto rod = model_of(as_splines(cylinder(2, 5)));
  CHECK(count(*rod, SurfaceKind::Plane) == 2);
  REQUIRE(count(*rod, SurfaceKind::Cylinder) == 1);
  CHECK(find(*rod, SurfaceKind::Cylinder).radius == doctest::Approx(2));
  CHECK(std::abs(find(*rod, SurfaceKind::Cylinder).axis.z()) == doctest::Approx(1));
  const auto ball = model_of(as_splines(sphere(3)));
  REQUIRE(count(*ball, SurfaceKind::Sphere) == 1);
  CHECK(find(*ball, SurfaceKind::Sphere).origin.norm() < 1e-4);
  const auto tip = model_of(as_splines(BRepPrimAPI_MakeCone(3, 1, 4).Shape()));
  REQUIRE(count(*tip, SurfaceKind::Cone) == 1);
  CHECK(std::tan(find(*tip, SurfaceKind::Cone).half_angle) == doctest::Approx(0.5));
  const auto ring = model_of(as_splines(torus(5, 2)));
  REQUIRE(count(*ring, SurfaceKind::Torus) == 1);
  CHECK(find(*ring, SurfaceKind::Torus).radius == doctest::Approx(5));
  CHECK(find(*ring, SurfaceKind::Torus).radius2 == doctest::Approx(2));
  CHECK(find(*ring, SurfaceKind::Torus).outward_convex);
}

TEST_CASE("projection: the foot, its outward normal and parameters, on closed forms and on splines") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(-1, 1);
  const TopoDS_Shape shapes[] = {cylinder(3, 8), sphere(3), torus(5, 2), BRepPrimAPI_MakeCone(4, 2, 6).Shape(), cone(3, 6)};
  for (const auto& shape : shapes) {
    const auto closed = model_of(shape), spline = model_of(as_splines(shape));
    REQUIRE(closed->faces.size() == spline->faces.size());
    for (int i = 0; i < 200; ++i) {
      const Vec3 p = 6 * Vec3(unit(random), unit(random), unit(random));
      for (int f = 1; f <= static_cast<int>(closed->faces.size()); ++f) {
        const FacePoint a = closed->project_to_face(f, p, nullptr), b = spline->project_to_face(f, p, nullptr);
        CHECK((a.point - p).norm() == doctest::Approx((b.point - p).norm()).epsilon(1e-6));
        CHECK(a.normal.norm() == doctest::Approx(1));
        const FacePoint again = closed->project_to_face(f, a.point, &a.uv);
        CHECK((again.point - a.point).norm() < 1e-9);
      }
    }
  }
}

TEST_CASE("projection stays on the trimmed face") {
  const auto m = model_of(plate_with_hole());
  int top = 0;
  for (int f = 1; f <= static_cast<int>(m->faces.size()); ++f)
    if (m->face(f).kind == SurfaceKind::Plane && m->face(f).axis.z() > 0.9) top = f;
  REQUIRE(top > 0);
  CHECK((m->project_to_face(top, Vec3(30, 20, 9), nullptr).point - Vec3(30, 20, 8)).norm() < 1e-9);
  CHECK((m->project_to_face(top, Vec3(50, 20, 9), nullptr).point - Vec3(40, 20, 8)).norm() < 1e-9);  // beyond a side
  CHECK((m->project_to_face(top, Vec3(50, -20, 9), nullptr).point - Vec3(40, 0, 8)).norm() < 1e-9);  // beyond a corner
  CHECK((m->project_to_face(top, Vec3(17, 15, 9), nullptr).point - Vec3(21, 15, 8)).norm() < 1e-9);  // over the hole
  CHECK((m->project_to_face(top, Vec3(20.999, 15, 9), nullptr).point - Vec3(21, 15, 8)).norm() < 1e-9);
  CHECK((m->project_to_face(top, Vec3(21.001, 15, 9), nullptr).point - Vec3(21.001, 15, 8)).norm() < 1e-9);
  const int hole = id_of(*m, SurfaceKind::Cylinder);
  CHECK((m->project_to_face(hole, Vec3(16, 15, 20), nullptr).point - Vec3(21, 15, 8)).norm() < 1e-9);
  CHECK(m->project_to_face(hole, Vec3(16, 15, 4), nullptr).normal.dot(Vec3::UnitX()) == doctest::Approx(-1));
}

TEST_CASE("projection to edges: clamped when open, wrapped when closed") {
  const auto rod = model_of(cylinder(2, 5));
  for (int e = 1; e <= static_cast<int>(rod->edges.size()); ++e) {
    const CadEdge& edge = rod->edge(e);
    if (edge.vertices[0] != edge.vertices[1]) {
      CHECK(rod->project_to_edge(e, Vec3(0, 0, 99), nullptr).point.z() == doctest::Approx(5));
      continue;
    }
    const CurvePoint p = rod->project_to_edge(e, Vec3(5, -0.01, 0), nullptr), q = rod->project_to_edge(e, Vec3(5, 0.01, 0), nullptr);
    CHECK((p.point - q.point).norm() < 0.02);
    CHECK(p.point.head<2>().norm() == doctest::Approx(2));
    CHECK(edge.length == doctest::Approx(4 * EIGEN_PI));
  }
}

TEST_CASE("a placed model answers in its frame") {
  const auto m = model_of(plate_with_hole());
  const Mat3 r = Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()).toRotationMatrix();
  const FacePoint before = m->project_to_face(1, Vec3(3, 4, 5), nullptr);
  m->place(r, Vec3(20, 15, 4));
  CHECK((m->to_world(m->to_frame(Vec3(1, 2, 3))) - Vec3(1, 2, 3)).norm() < 1e-12);
  const FacePoint after = m->project_to_face(1, m->to_frame(Vec3(3, 4, 5)), nullptr);
  CHECK((m->to_world(after.point) - before.point).norm() < 1e-12);
  CHECK((after.normal - r * before.normal).norm() < 1e-12);
  m->place(Mat3::Identity(), Vec3::Zero());
  CHECK(m->vertex(1).point == m->vertex_point(1));
  CHECK((m->project_to_face(1, Vec3(3, 4, 5), nullptr).point - before.point).norm() < 1e-12);
}

TEST_CASE("frames: the identity for an aligned part, the turned axes for a turned one") {
  CHECK(find_frames(*model_of(plate_with_hole()))[0].isIdentity(1e-12));
  CHECK(find_frames(*model_of(sphere(2)))[0].isIdentity(1e-12));
  CHECK(find_frames(*model_of(cylinder(2, 5)))[0].isIdentity(1e-12));
  for (const TopoDS_Shape& shape : {plate_with_hole(), cylinder(2, 9)}) {
    const auto m = model_of(turned(shape, 17, 31, 8));
    const Mat3 frame = find_frames(*m)[0];
    CHECK(frame.determinant() == doctest::Approx(1));
    m->place(frame, Vec3::Zero());
    for (const auto& f : m->faces) CHECK(f.axis.cwiseAbs().maxCoeff() == doctest::Approx(1).epsilon(1e-6));
    CHECK(find_frames(*m)[0].isApprox(frame));  // however it is placed
  }
}

TEST_CASE("several solids, voids, an inside-out solid, a closed shell, stray faces") {
  TopoDS_Compound two;
  BRep_Builder builder;
  builder.MakeCompound(two);
  builder.Add(two, box(1, 1, 1));
  builder.Add(two, moved(box(1, 1, 1), 3, 0, 0));
  const auto pair = model_of(two);
  CHECK(pair->solid_count == 2);
  CHECK(pair->faces.size() == 12);
  CHECK(pair->face(12).solid == 2);
  CHECK(pair->volume() == doctest::Approx(2));

  CHECK(model_of(cut(box(4, 4, 4), moved(box(2, 2, 2), 1, 1, 1)))->volume() == doctest::Approx(56));

  const auto inverted = model_of(box(2, 2, 2).Reversed());
  CHECK(inverted->volume() == doctest::Approx(8));
  CHECK(inverted->project_to_face(1, Vec3(1, 1, 1), nullptr)
            .normal.dot(inverted->project_to_face(1, Vec3(1, 1, 1), nullptr).point - Vec3(1, 1, 1)) > 0);

  const auto shell = model_of(TopExp_Explorer(box(1, 2, 3), TopAbs_SHELL).Current());
  CHECK(shell->volume() == doctest::Approx(6));
  CHECK(shell->warnings.size() == 1);

  TopoDS_Compound stray;
  builder.MakeCompound(stray);
  builder.Add(stray, moved(TopExp_Explorer(box(1, 1, 1), TopAbs_FACE).Current(), 9, 9, 9));
  builder.Add(stray, box(1, 1, 1));
  const auto alone = model_of(stray);
  CHECK(alone->faces.size() == 6);
  CHECK(alone->warnings.size() == 1);
}

TEST_CASE("STEP, IGES and BREP files") {
  const auto folder = std::filesystem::temp_directory_path() / "hexfeature_brep_files";
  std::filesystem::create_directories(folder);
  const TopoDS_Shape shape = plate_with_hole();
  STEPControl_Writer step;
  step.Transfer(shape, STEPControl_AsIs);
  step.Write((folder / "part.STEP").c_str());
  IGESControl_Writer solid("MM", 1), faces("MM", 0);
  solid.AddShape(shape);
  solid.Write((folder / "solid.igs").c_str());
  faces.AddShape(shape);
  faces.Write((folder / "faces.iges").c_str());
  BRepTools::Write(shape, (folder / "part.brep").c_str());
  for (const char* name : {"part.STEP", "solid.igs", "faces.iges", "part.brep"}) {
    Context context;
    const auto m = read_cad((folder / name).string(), context);
    CHECK(m->faces.size() == 7);
    CHECK(m->volume() == doctest::Approx(40 * 30 * 8 - 36 * EIGEN_PI * 8).epsilon(1e-4));
    CHECK(count(*m, SurfaceKind::Cylinder) >= 1);
  }
  std::ifstream in(folder / "part.STEP");
  const std::string whole(std::istreambuf_iterator<char>(in), {});
  for (const double part : {0.1, 0.5, 0.99}) {
    std::ofstream(folder / "cut.step") << whole.substr(0, static_cast<std::size_t>(part * static_cast<double>(whole.size())));
    CHECK(failure((folder / "cut.step").string()).find("truncated") != std::string::npos);
    // The same with its last line in place: what is missing must not pass for a part.
    std::ofstream(folder / "patched.step") << whole.substr(0, static_cast<std::size_t>(part * static_cast<double>(whole.size())))
                                           << ";\nENDSEC;\nEND-ISO-10303-21;\n";
    const std::string said = failure((folder / "patched.step").string());  // at 0.99 the geometry may still be whole
    if (part < 0.9) CHECK_FALSE(said.empty());
  }
  TopoDS_Shell open;
  BRep_Builder builder;
  builder.MakeShell(open);
  int n = 0;
  for (TopExp_Explorer f(shape, TopAbs_FACE); f.More() && n < 5; f.Next(), ++n) builder.Add(open, f.Current());
  STEPControl_Writer open_step;
  open_step.Transfer(open, STEPControl_AsIs);
  open_step.Write((folder / "open.step").c_str());
  CHECK(failure((folder / "open.step").string()).find("not closed") != std::string::npos);
  std::filesystem::remove_all(folder);
}

TEST_CASE("bad input is said, with a hint") {
  const auto folder = std::filesystem::temp_directory_path() / "hexfeature_brep_test";
  std::filesystem::create_directories(folder);
  const auto write = [&](const std::string& name, const std::string& text) {
    std::ofstream(folder / name) << text;
    return (folder / name).string();
  };
  CHECK(failure((folder / "missing.step").string()).find("no file") != std::string::npos);
  CHECK(failure(folder.string()).find("directory") != std::string::npos);
  CHECK(failure(write("empty.step", "")).find("empty") != std::string::npos);
  CHECK_FALSE(failure(write("text.step", "hello")).empty());
  CHECK(failure(write("cut.step", "ISO-10303-21;\nHEADER;\nENDSEC;\nDATA;\n#1=CARTESIAN_POINT('',(0.,")).find("truncated") !=
        std::string::npos);
  CHECK_FALSE(failure(write("none.step", "ISO-10303-21;\nHEADER;\nENDSEC;\nDATA;\nENDSEC;\nEND-ISO-10303-21;\n")).empty());
  CHECK_FALSE(failure(write("text.iges", "hello")).empty());
  CHECK_FALSE(failure(write("text.brep", "hello")).empty());
  CHECK_FALSE(failure(write("part.doc", "hello")).empty());
  Context context;
  CHECK_THROWS_AS(read_brep_string("garbage", context), MeshingError);
  CHECK_THROWS_AS(model_of(TopExp_Explorer(box(1, 1, 1), TopAbs_FACE).Current()), MeshingError);
  CHECK_THROWS_AS(model_of(TopExp_Explorer(box(1, 1, 1), TopAbs_EDGE).Current()), MeshingError);
  TopoDS_Shell open;
  BRep_Builder builder;
  builder.MakeShell(open);
  int n = 0;
  for (TopExp_Explorer f(box(1, 1, 1), TopAbs_FACE); f.More() && n < 5; f.Next(), ++n) builder.Add(open, f.Current());
  CHECK_THROWS_AS(model_of(open), MeshingError);
  const std::string whole = text_of(plate_with_hole());
  for (const double part : {0.2, 0.5, 0.9})
    CHECK_THROWS_AS(read_brep_string(whole.substr(0, static_cast<std::size_t>(part * whole.size())), context), MeshingError);
  context.is_cancelled = [] { return true; };
  try {
    read_brep_string(whole, context);
    CHECK(false);
  } catch (const MeshingError& e) {
    CHECK(e.kind == Failure::Cancelled);
  }
  std::filesystem::remove_all(folder);
}
