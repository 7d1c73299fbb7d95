// HexFeatureWB - LGPL-2.1-or-later
#include "surface/surface.h"

#include <doctest/doctest.h>

#include <BRep_Builder.hxx>
#include <TopoDS_Compound.hxx>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>

#include "surface_fixtures.h"

using namespace hexfeature;
using namespace cad_shapes;

namespace {
int euler(const SurfaceMesh& m) { return m.point_count() - m.triangle_count() / 2; }

/// What holds for every surface mesh of a CAD model.
void check_mesh(const CadModel& model, const SurfaceMesh& m, double size, int expected_euler, double least_cosine = 0.9) {
  CHECK(euler(m) == expected_euler);
  CHECK(enclosed_volume(m) == doctest::Approx(model.volume()).epsilon(0.02));
  double longest = 0, cosine = 1, off = 0;
  std::vector<double> area(model.faces.size() + 1, 0), length(model.edges.size() + 1, 0);
  for (int h = 0; h < 3 * m.triangle_count(); ++h) {
    const int f = m.triangle_face[h / 3], e = m.halfedge_edge[h];
    const double l = (m.points[m.to(h)] - m.points[m.from(h)]).norm();
    longest = std::max(longest, l / (model.face(f).kind == SurfaceKind::Plane && e == 0 ? 1.5 : 0.6));
    cosine = std::min(cosine, m.corner_normals[h].dot(m.area_normal(h / 3).normalized()));
    CHECK(m.halfedge_edge[m.opposite[h]] == e);
    if (m.triangle_face[m.opposite[h] / 3] != f) CHECK(e > 0);
    length[e] += 0.5 * l;
    off = std::max(off, (model.project_to_face(f, m.points[m.from(h)], nullptr).point - m.points[m.from(h)]).norm());
  }
  CHECK(longest <= size * 1.0000001);
  CHECK(cosine > least_cosine);
  CHECK(off < 1e-7 * model.diagonal());
  for (int t = 0; t < m.triangle_count(); ++t) area[m.triangle_face[t]] += m.area(t);
  for (std::size_t f = 1; f < area.size(); ++f) CHECK(area[f] == doctest::Approx(model.faces[f - 1].area).epsilon(0.03));
  for (std::size_t e = 1; e < length.size(); ++e) CHECK(length[e] == doctest::Approx(model.edges[e - 1].length).epsilon(0.02));
  for (int p = 0; p < m.point_count(); ++p) {
    const CadPlace& place = m.place[p];
    Vec3 q = m.points[p];
    if (place.dim == 0) q = model.vertex_point(place.entity);
    if (place.dim == 1) q = model.edge_point(place.entity, place.uv[0]).point;
    if (place.dim == 2) q = model.project_to_face(place.entity, q, &place.uv).point;
    CHECK((q - m.points[p]).norm() < 1e-9 * model.diagonal());
    CHECK(place.dim < 3);
  }
}

std::string write(const std::string& name, const std::string& text) {
  const auto folder = std::filesystem::temp_directory_path() / "hexfeature_surface_test";
  std::filesystem::create_directories(folder);
  std::ofstream(folder / name, std::ios::binary) << text;
  return (folder / name).string();
}
TrianglePart read(const std::string& path) {
  Context context;
  return read_triangles(path, 30, context);
}
std::string reason(const std::string& path) {
  try {
    read(path);
  } catch (const MeshingError& e) {
    CHECK(e.kind == Failure::BadInput);
    CHECK_FALSE(e.hint.empty());
    return e.reason;
  }
  return {};
}
std::string ascii_stl(const SurfaceMesh& m, int skip = -1) {
  std::ostringstream out;
  out.precision(9);
  out << "solid x\n";
  for (int t = 0; t < m.triangle_count(); ++t) {
    if (t == skip) continue;
    out << "facet normal 0 0 0\n outer loop\n";
    for (const int v : m.triangles[t]) out << "  vertex " << m.points[v].transpose() << "\n";
    out << " endloop\nendfacet\n";
  }
  out << "endsolid x\n";
  return out.str();
}
std::string binary_stl(const SurfaceMesh& m) {
  std::string out(80, ' ');
  const std::uint32_t n = m.triangle_count();
  out.append(reinterpret_cast<const char*>(&n), 4);
  for (const auto& t : m.triangles) {
    float data[12] = {0, 0, 0};
    for (int c = 0; c < 3; ++c)
      for (int k = 0; k < 3; ++k) data[3 + 3 * c + k] = static_cast<float>(m.points[t[c]][k]);
    out.append(reinterpret_cast<const char*>(data), 48);
    out.append(2, '\0');
  }
  return out;
}
std::string obj(const SurfaceMesh& m) {
  std::ostringstream out;
  out.precision(17);
  for (const Vec3& p : m.points) out << "v " << p.transpose() << "\n";
  for (const auto& t : m.triangles) out << "f " << t[0] + 1 << "//1 " << t[1] + 1 << "//1 " << t[2] + 1 << "//1\r\n";
  return out.str();
}
std::string ply(const SurfaceMesh& m, bool binary) {
  std::ostringstream out;
  out.precision(17);
  out << "ply\nformat " << (binary ? "binary_little_endian" : "ascii") << " 1.0\nelement vertex " << m.points.size()
      << "\nproperty double x\nproperty double y\nproperty double z\nelement face " << m.triangles.size()
      << "\nproperty list uchar int vertex_indices\nend_header\n";
  for (const Vec3& p : m.points) {
    if (binary)
      out.write(reinterpret_cast<const char*>(p.data()), 24);
    else
      out << p.transpose() << "\n";
  }
  for (const auto& t : m.triangles) {
    if (binary) {
      out.put(3);
      out.write(reinterpret_cast<const char*>(t.data()), 12);
    } else {
      out << "3 " << t[0] << " " << t[1] << " " << t[2] << "\n";
    }
  }
  return out.str();
}
}  // namespace

TEST_CASE("closed forms, seams and poles: closed, oriented, true normals") {
  const struct {
    TopoDS_Shape shape;
    int euler;
  } cases[] = {{box(4, 3, 2), 2}, {cylinder(2, 5), 2}, {sphere(3), 2}, {torus(5, 2), 0}, {cone(2, 4), 2}, {plate_with_hole(), 0}};
  for (const auto& c : cases)
    for (const double size : {3.0, 0.8}) {
      const auto model = model_of(c.shape);
      check_mesh(*model, surface_of(*model, size), size, c.euler);
    }
  for (const auto& c : cases) {
    const auto model = model_of(as_splines(c.shape));
    check_mesh(*model, surface_of(*model, 1), 1, c.euler, 0.7);
  }
}

TEST_CASE("sphere and apex normals are the surface's own") {
  const auto ball = model_of(sphere(3));
  const SurfaceMesh m = surface_of(*ball, 1);
  for (int h = 0; h < 3 * m.triangle_count(); ++h) CHECK((m.corner_normals[h] - m.points[m.from(h)] / 3).norm() < 1e-9);
  const auto tip = model_of(cone(2, 4));
  const SurfaceMesh n = surface_of(*tip, 1);
  for (int h = 0; h < 3 * n.triangle_count(); ++h)
    if (tip->face(n.triangle_face[h / 3]).kind == SurfaceKind::Cone) CHECK(n.corner_normals[h].z() == doctest::Approx(1 / std::sqrt(5.0)));
}

TEST_CASE("dihedral angles of mesh edges are those of the CAD") {
  const auto model = model_of(plate_with_hole());
  const SurfaceMesh m = surface_of(*model, 4);
  for (int h = 0; h < 3 * m.triangle_count(); ++h) {
    const int e = m.halfedge_edge[h];
    if (e > 0 && model->edge(e).sharp) CHECK(m.dihedral(h) == doctest::Approx(EIGEN_PI / 2).epsilon(0.02));
    if (e > 0 && model->edge(e).seam) CHECK(std::abs(m.dihedral(h)) < 0.02);
  }
}

TEST_CASE("several solids and voids are several shells") {
  const auto hollow = model_of(cut(box(4, 4, 4), moved(sphere(1), 2, 2, 2)));
  check_mesh(*hollow, surface_of(*hollow, 1), 1, 4);
  TopoDS_Compound two;
  BRep_Builder builder;
  builder.MakeCompound(two);
  builder.Add(two, box(1, 1, 1));
  builder.Add(two, moved(cylinder(1, 1), 5, 0, 0));
  const auto pair = model_of(two);
  check_mesh(*pair, surface_of(*pair, 1), 1, 4);
}

TEST_CASE("the mesh is in the working frame") {
  const auto model = model_of(plate_with_hole());
  model->place(Eigen::AngleAxisd(1, Vec3(1, 2, 3).normalized()).toRotationMatrix(), Vec3(20, 15, 4));
  check_mesh(*model, surface_of(*model, 4), 4, 0);
}

TEST_CASE("sizes that cannot be") {
  const auto model = model_of(box(4, 3, 2));
  for (const double size : {0.0, -1.0, std::nan(""), 1e-9, HUGE_VAL}) CHECK_THROWS_AS(surface_of(*model, size), MeshingError);
  CHECK(surface_of(*model, 1e6).triangle_count() == 12);
  Context context;
  context.is_cancelled = [] { return true; };
  SurfaceOptions options;
  CHECK_THROWS_AS(triangulate(*model, options, context), MeshingError);
}

TEST_CASE("the same mesh every time") {
  const auto a = model_of(plate_with_hole()), b = model_of(plate_with_hole());
  const SurfaceMesh m = surface_of(*a, 2), n = surface_of(*b, 2);
  CHECK(m.triangles == n.triangles);
  CHECK(m.points == n.points);
}

TEST_CASE("triangle files: a box in every format becomes 6 planes, 12 edges, 8 corners") {
  const SurfaceMesh m = surface_of(*model_of(box(4, 3, 2)), 1);
  const std::string paths[] = {write("box.stl", ascii_stl(m)), write("box_binary.stl", binary_stl(m)), write("box.obj", obj(m)),
                               write("box.ply", ply(m, false)), write("box_binary.ply", ply(m, true))};
  for (const std::string& path : paths) {
    const TrianglePart part = read(path);
    CHECK(part.mesh.triangle_count() == m.triangle_count());
    CHECK(part.mesh.point_count() == m.point_count());
    CHECK(enclosed_volume(part.mesh) == doctest::Approx(24));
    CHECK(part.faces.size() == 6);
    CHECK(part.edges.size() == 12);
    CHECK(part.vertices.size() == 8);
    for (const auto& f : part.faces) {
      CHECK(f.kind == SurfaceKind::Plane);
      CHECK(f.edges.size() == 4);
    }
    for (const auto& e : part.edges) {
      CHECK(e.dihedral == doctest::Approx(EIGEN_PI / 2));
      CHECK(e.vertices[0] != e.vertices[1]);
    }
    for (const auto& v : part.vertices) CHECK((v.hard && v.edges.size() == 3));
    for (int p = 0; p < part.mesh.point_count(); ++p) {
      const CadPlace& place = part.mesh.place[p];
      const Projector& on = *part.projector;
      const Vec3 q = place.dim == 0   ? on.vertex_point(place.entity)
                     : place.dim == 1 ? on.edge_point(place.entity, place.uv[0]).point
                                      : on.project_to_face(place.entity, part.mesh.points[p], &place.uv).point;
      CHECK((q - part.mesh.points[p]).norm() < 1e-9);
    }
  }
}

TEST_CASE("triangle parts: closed creases, projection, normals") {
  const SurfaceMesh m = surface_of(*model_of(cylinder(2, 5)), 0.8);
  const TrianglePart part = read(write("rod.stl", ascii_stl(m)));
  CHECK(part.faces.size() == 3);
  CHECK(part.edges.size() == 2);
  CHECK(part.vertices.empty());
  for (int e = 1; e <= 2; ++e) {
    CHECK(part.edges[e - 1].vertices[0] == 0);
    const CurvePoint p = part.projector->project_to_edge(e, Vec3(3, 1, 0), nullptr);
    CHECK(p.point.head<2>().norm() == doctest::Approx(2).epsilon(0.01));
    CHECK((part.projector->edge_point(e, p.t).point - p.point).norm() < 1e-9);
  }
  for (int h = 0; h < 3 * part.mesh.triangle_count(); ++h) {
    const int f = part.mesh.triangle_face[h / 3];
    if (part.faces[f - 1].kind == SurfaceKind::Plane) continue;
    const Vec3 p = part.mesh.points[part.mesh.from(h)];
    CHECK(part.mesh.corner_normals[h].dot(Vec3(p.x(), p.y(), 0).normalized()) > 0.99);
  }
}

TEST_CASE("triangle files: orientation is repaired, holes and nonsense are said") {
  SurfaceMesh m = surface_of(*model_of(box(4, 3, 2)), 3);
  CHECK(reason(write("hole.stl", ascii_stl(m, 0))).find("3 open edges") != std::string::npos);
  for (std::size_t t = 0; t < m.triangles.size(); t += 2) std::swap(m.triangles[t][0], m.triangles[t][1]);
  CHECK(enclosed_volume(read(write("mixed.stl", ascii_stl(m))).mesh) == doctest::Approx(24));
  const SurfaceMesh hollow = surface_of(*model_of(cut(box(4, 4, 4), moved(box(2, 2, 2), 1, 1, 1))), 4);
  SurfaceMesh inside = hollow;
  for (auto& t : inside.triangles) std::swap(t[0], t[1]);
  CHECK(enclosed_volume(read(write("hollow.stl", ascii_stl(inside))).mesh) == doctest::Approx(56));

  CHECK_FALSE(reason(write("none.stl", "solid x\nendsolid x\n")).empty());
  CHECK_FALSE(reason(write("empty.stl", "")).empty());
  CHECK_FALSE(reason(write("garbage.stl", std::string(500, '\x7f'))).empty());
  CHECK_FALSE(reason(write("nan.obj", "v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")).empty());
  CHECK_FALSE(reason(write("index.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 7\n")).empty());
  CHECK_FALSE(reason(write("huge.ply", "ply\nformat ascii 1.0\nelement vertex 99999999999\nproperty float x\nend_header\n1\n")).empty());
  CHECK_FALSE(reason(write("header.ply", "ply\nformat ascii 1.0\n")).empty());
  const std::string whole = binary_stl(hollow), ply_text = ply(hollow, true);
  for (const double part : {0.01, 0.3, 0.7, 0.99}) {
    CHECK_FALSE(reason(write("cut.stl", whole.substr(0, static_cast<std::size_t>(part * whole.size())))).empty());
    CHECK_FALSE(reason(write("cut.ply", ply_text.substr(0, static_cast<std::size_t>(part * ply_text.size())))).empty());
  }
  std::filesystem::remove_all(std::filesystem::temp_directory_path() / "hexfeature_surface_test");
}

TEST_CASE("a surface that touches itself in a point is refused") {
  // Two tetrahedra with one point in common.
  SurfaceMesh mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}};
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}, {0, 4, 5}, {0, 6, 4}, {0, 5, 6}, {4, 6, 5}};
  try {
    connect(mesh);
    FAIL("accepted");
  } catch (const MeshingError& error) {
    CHECK(error.kind == Failure::BadInput);
    CHECK(error.reason.find("point") != std::string::npos);
  }
}
