// HexFeatureWB - LGPL-2.1-or-later
#include "tetsplit/tetrahedra.h"

#include <algorithm>
#include <cstdint>
#include <numeric>

#include "tetsplit/child_process.h"

namespace hexfeature {
namespace {

[[noreturn]] void give_up(const std::string& reason) {
  throw MeshingError(Failure::NoMesh, "tetrahedra", reason, "try another element size, or repair the part (it may intersect itself)");
}

template <class T>
void put(std::vector<char>& bytes, const T* data, std::size_t count) {
  const char* p = reinterpret_cast<const char*>(data);
  bytes.insert(bytes.end(), p, p + count * sizeof(T));
}

/// What the program answers, read front to back.
class Answer {
 public:
  explicit Answer(const std::vector<char>& bytes) : bytes_(bytes) {}
  template <class T>
  void take(T* data, std::size_t count) {
    if (count * sizeof(T) > bytes_.size() - at_) give_up("the tetrahedral mesher ended too early");
    std::copy_n(bytes_.data() + at_, count * sizeof(T), reinterpret_cast<char*>(data));
    at_ += count * sizeof(T);
  }

 private:
  const std::vector<char>& bytes_;
  std::size_t at_ = 0;
};

/// The boundary faces of the tetrahedra must be the surface's triangles.
void check_boundary(const TetMesh& mesh, const SurfaceMesh& surface) {
  const auto sorted = [](std::array<int, 3> f) {
    std::sort(f.begin(), f.end());
    return f;
  };
  std::vector<std::array<int, 3>> faces, outer, wanted;
  for (const auto& tet : mesh.tets)
    for (const auto& f : kTetFaces) faces.push_back(sorted({tet[f[0]], tet[f[1]], tet[f[2]]}));
  std::sort(faces.begin(), faces.end());
  for (std::size_t i = 0; i < faces.size();) {
    std::size_t j = i;
    while (j < faces.size() && faces[j] == faces[i]) ++j;
    if (j - i == 1) outer.push_back(faces[i]);
    if (j - i > 2) give_up("the tetrahedra overlap");
    i = j;
  }
  for (const auto& t : surface.triangles) wanted.push_back(sorted(t));
  std::sort(wanted.begin(), wanted.end());
  if (outer != wanted) give_up("the tetrahedra do not fill the surface");
}

}  // namespace

double tet_volume(const std::vector<Vec3>& points, const std::array<int, 4>& tet) {
  const Vec3& p = points[tet[0]];
  return (points[tet[1]] - p).dot((points[tet[2]] - p).cross(points[tet[3]] - p)) / 6;
}

TetMesh fill_with_tetrahedra(const SurfaceMesh& surface, const TetOptions& options, Context& context) {
  // The protocol is that of netgen/main.cpp.
  std::vector<char> question;
  const std::int32_t counts[2] = {surface.point_count(), surface.triangle_count()};
  // Netgen has tolerances of its own, in lengths: it always sees elements of about size 1 near the origin.
  const Vec3 centre = std::accumulate(surface.points.begin(), surface.points.end(), Vec3(Vec3::Zero())) / surface.point_count();
  const double sizes[2] = {1, options.grading};
  put(question, counts, 2);
  put(question, sizes, 2);
  for (const Vec3& p : surface.points) {
    const Vec3 q = (p - centre) / options.longest;
    put(question, q.data(), 3);
  }
  for (const auto& t : surface.triangles) put(question, t.data(), 3);
  const std::string program = options.program.empty() ? program_beside_library("hexfeature-netgen") : options.program;
  const ChildResult child = run_child(program, question, context);
  if (!child.started)
    throw MeshingError(Failure::NoMesh, "tetrahedra", "the tetrahedral mesher cannot be started: " + program,
                       "build with Netgen's library (Debian: libnglib-dev)");
  if (!child.ended_well) give_up("the tetrahedral mesher crashed or ran out of memory");

  Answer answer(child.output);
  std::int32_t head[3];
  answer.take(head, 3);  // status, points, tetrahedra
  if (head[0] != 0) give_up("the tetrahedral mesher gave up");
  if (head[1] < surface.point_count() || head[2] <= 0) give_up("the tetrahedral mesher returned no elements");
  TetMesh mesh;
  mesh.points.resize(head[1]);
  mesh.tets.resize(head[2]);
  for (Vec3& p : mesh.points) {
    answer.take(p.data(), 3);
    p = options.longest * p + centre;
  }
  for (auto& tet : mesh.tets) {
    answer.take(tet.data(), 4);
    for (int v : tet)
      if (v < 0 || v >= head[1]) give_up("the tetrahedral mesher returned nonsense");
  }
  std::copy(surface.points.begin(), surface.points.end(), mesh.points.begin());
  for (const auto& tet : mesh.tets)
    if (!(tet_volume(mesh.points, tet) > 0)) give_up("the tetrahedral mesher returned an inverted element");
  context.check();
  check_boundary(mesh, surface);
  context.check();
  return mesh;
}

}  // namespace hexfeature
