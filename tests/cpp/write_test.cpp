// HexFeatureWB - LGPL-2.1-or-later
#include "write/write.h"

#include <doctest/doctest.h>
#include <sys/resource.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <map>

#include "base/error.h"
#include "write/cad_groups.h"

using namespace hexfeature;
namespace fs = std::filesystem;

namespace {
/// A 2 x 1 x 1 bar of two unit hexahedra, CAD faces 1..6 = -X +X -Y +Y -Z +Z, with the CAD edge 1 along x at y = z = 0.
struct Bar {
  HexComplex mesh;
  std::vector<std::array<int, 20>> hexes20;
  std::vector<std::array<int, 8>> quads8;
  MeshView view() const { return {mesh, hexes20, quads8}; }

  explicit Bar(bool second_order = false) {
    for (int z = 0; z < 2; ++z)
      for (int y = 0; y < 2; ++y)
        for (int x = 0; x < 3; ++x) mesh.points.push_back(Vec3(x, y, z));
    const auto node = [](int x, int y, int z) { return x + 3 * y + 6 * z; };
    for (int x = 0; x < 2; ++x)
      mesh.hexes.push_back({node(x, 0, 0), node(x + 1, 0, 0), node(x + 1, 1, 0), node(x, 1, 0), node(x, 0, 1), node(x + 1, 0, 1),
                            node(x + 1, 1, 1), node(x, 1, 1)});
    mesh.hex_solid = {1, 1};
    for (const auto& [hex, side] : boundary_faces(mesh)) {
      std::array<int, 4> quad;
      for (int k = 0; k < 4; ++k) quad[k] = mesh.hexes[hex][kHexFaces[side][k]];
      constexpr std::array<int, 6> cad = {5, 6, 3, 2, 4, 1};
      mesh.quads.push_back(quad);
      mesh.quad_face.push_back(cad[side]);
    }
    mesh.place.resize(mesh.points.size());
    mesh.place[0] = {0, 1, Vec2::Zero()};
    mesh.place[1] = {1, 1, Vec2::Zero()};
    mesh.feature_edges = {{0, 1}, {1, 2}};
    mesh.feature_edge_cad = {1, 1};
    if (second_order) add_middles();
  }

  void add_middles() {
    std::map<std::array<int, 2>, int> middle;
    const auto between = [&](int a, int b) {
      const std::array<int, 2> key{std::min(a, b), std::max(a, b)};
      const auto [it, is_new] = middle.insert({key, mesh.point_count()});
      if (is_new) {
        mesh.points.push_back((mesh.points[a] + mesh.points[b]) / 2);
        mesh.place.push_back({});
      }
      return it->second;
    };
    for (const auto& h : mesh.hexes) {
      std::array<int, 20> cell{};
      std::copy(h.begin(), h.end(), cell.begin());
      for (int e = 0; e < 12; ++e) cell[8 + e] = between(h[kHexEdges[e][0]], h[kHexEdges[e][1]]);
      hexes20.push_back(cell);
    }
    for (const auto& q : mesh.quads) {
      std::array<int, 8> cell{};
      std::copy(q.begin(), q.end(), cell.begin());
      for (int k = 0; k < 4; ++k) cell[4 + k] = between(q[k], q[(k + 1) % 4]);
      quads8.push_back(cell);
    }
  }
};

struct Folder {
  fs::path path = fs::temp_directory_path() / ("hexfeature_write_test_" + std::to_string(std::rand()));
  Folder() { fs::create_directories(path); }
  ~Folder() { fs::remove_all(path); }
  std::string file(const std::string& name) const { return (path / name).string(); }
  int count() const { return static_cast<int>(std::distance(fs::directory_iterator(path), fs::directory_iterator())); }
};

std::string text_of(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}
bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

Failure failure_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const MeshingError& e) {
    CHECK(e.step == "write");
    CHECK(!e.hint.empty());
    return e.kind;
  }
  FAIL("no error");
  return Failure::NoMesh;
}
}  // namespace

TEST_CASE("groups by CAD entity hold every node and quad of it, mid-side nodes too") {
  for (const bool second : {false, true}) {
    const Bar bar(second);
    const CadGroups groups = group_by_cad(bar.view());
    REQUIRE(groups.face_quads.size() == 6);
    CHECK(groups.face_quads[2].number == 3);
    CHECK(groups.face_quads[2].items.size() == 2);  // -Y: two quads
    CHECK(groups.face_nodes[2].items.size() == (second ? 13 : 6));
    REQUIRE(groups.edge_nodes.size() == 1);
    CHECK(groups.edge_nodes[0].items.size() == (second ? 5 : 3));
    REQUIRE(groups.vertex_nodes.size() == 1);
    CHECK(groups.vertex_nodes[0].items == std::vector<int>{0});
    CHECK(groups.solid_hexes[0].items == std::vector<int>{0, 1});
  }
}

TEST_CASE("a quad's side is the hexahedron's face with the same nodes") {
  const Bar bar;
  const auto sides = sides_of_quads(bar.mesh);
  for (std::size_t q = 0; q < sides.size(); ++q)
    for (int k = 0; k < 4; ++k) CHECK(bar.mesh.hexes[sides[q][0]][kHexFaces[sides[q][1]][k]] == bar.mesh.quads[q][k]);
}

TEST_CASE("inp: sets, surfaces and numbers that CalculiX can read") {
  const Folder folder;
  Bar bar;
  bar.mesh.points[1] = Vec3(-1.2345678901234567e-5, 1.0 / 3.0, 12345678.901234567);
  write_mesh(bar.view(), folder.file("bar.inp"));
  const std::string text = text_of(folder.file("bar.inp"));
  CHECK(contains(text, "*ELEMENT, TYPE=C3D8, ELSET=Solid1\n1,1,2,5,4,7,8,11,10\n"));
  CHECK(contains(text, "*NSET, NSET=Face1\n1,4,7,10\n"));
  CHECK(contains(text, "*NSET, NSET=Edge1\n1,2,3\n"));
  CHECK(contains(text, "*SURFACE, NAME=Face1, TYPE=ELEMENT\n1,S6\n"));
  CHECK(contains(text, "*SURFACE, NAME=Face2, TYPE=ELEMENT\n2,S4\n"));
  const auto line = text.substr(text.find("\n2,") + 3);
  const auto x = line.substr(0, line.find(','));
  CHECK(x.size() <= 20);
  CHECK(std::stod(x) == doctest::Approx(-1.2345678901234567e-5).epsilon(1e-12));
}

TEST_CASE("inp: second order continues its lines, and the element type must fit") {
  const Folder folder;
  const Bar bar(true);
  write_mesh(bar.view(), folder.file("bar.inp"), {"C3D20"});
  const std::string text = text_of(folder.file("bar.inp"));
  const auto start = text.find("*ELEMENT, TYPE=C3D20, ELSET=Solid1\n");
  REQUIRE(start != std::string::npos);
  const auto line = text.substr(text.find('\n', start) + 1);
  CHECK(line[line.find('\n') - 1] == ',');
  CHECK(failure_of([&] { write_mesh(bar.view(), folder.file("bar.inp"), {"C3D8"}); }) == Failure::Usage);
}

TEST_CASE("no half-written file: what was there stays, and nothing is left behind") {
  const Folder folder;
  const Bar bar;
  CHECK(failure_of([&] { write_mesh(bar.view(), folder.file("missing/bar.vtk")); }) == Failure::Output);
  fs::create_directory(folder.file("folder.vtk"));
  CHECK(failure_of([&] { write_mesh(bar.view(), folder.file("folder.vtk")); }) == Failure::Output);
  CHECK(failure_of([&] { write_mesh(bar.view(), folder.file("bar.xyz")); }) == Failure::Usage);
  CHECK(folder.count() == 1);

  write_mesh(bar.view(), folder.file("bar.unv"));
  const std::string before = text_of(folder.file("bar.unv"));
  // A limit on file size stands in for a full disk.
  std::signal(SIGXFSZ, SIG_IGN);
  rlimit old_limit{};
  getrlimit(RLIMIT_FSIZE, &old_limit);
  const rlimit small{512, old_limit.rlim_max};
  setrlimit(RLIMIT_FSIZE, &small);
  const Failure kind = failure_of([&] { write_mesh(bar.view(), folder.file("bar.unv")); });
  setrlimit(RLIMIT_FSIZE, &old_limit);
  CHECK(kind == Failure::Output);
  CHECK(text_of(folder.file("bar.unv")) == before);
  CHECK(folder.count() == 2);
}
