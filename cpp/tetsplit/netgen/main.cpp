// HexFeatureWB - LGPL-2.1-or-later
//
// hexfeature-netgen: fills a closed triangle surface with tetrahedra, by Netgen's library, in a process of its own.
//
// Standard input:  int32 points, triangles; double longest, grading; points x 3 double; triangles x 3 int32 (from 0, outward).
// Standard output: int32 status (0: done), points, tetrahedra; points x 3 double; tetrahedra x 4 int32 (positive volume).
// The points given come first, with the same numbers. Exit code 0 whenever there is an answer.
#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <vector>

namespace nglib {
#include <nglib.h>
}

namespace {

void read_all(void* data, std::size_t bytes) {
  char* p = static_cast<char*>(data);
  while (bytes > 0) {
    const ssize_t n = read(0, p, bytes);
    if (n <= 0) std::_Exit(2);
    p += n;
    bytes -= static_cast<std::size_t>(n);
  }
}

void write_all(int file, const void* data, std::size_t bytes) {
  const char* p = static_cast<const char*>(data);
  while (bytes > 0) {
    const ssize_t n = write(file, p, bytes);
    if (n <= 0) std::_Exit(2);
    p += n;
    bytes -= static_cast<std::size_t>(n);
  }
}

[[noreturn]] void answer(int file, std::int32_t status, const std::vector<double>& points, const std::vector<std::int32_t>& tets) {
  const std::int32_t head[3] = {status, static_cast<std::int32_t>(points.size() / 3), static_cast<std::int32_t>(tets.size() / 4)};
  write_all(file, head, sizeof head);
  write_all(file, points.data(), points.size() * sizeof(double));
  write_all(file, tets.data(), tets.size() * sizeof(std::int32_t));
  // Netgen's global state does not survive its own destructors in all builds.
  std::_Exit(0);
}

}  // namespace

int main() {
  prctl(PR_SET_PDEATHSIG, SIGKILL);  // nobody waits for the answer any more
  // Netgen talks on standard output.
  const int out = dup(1), nowhere = open("/dev/null", O_WRONLY);
  dup2(nowhere, 1);

  std::int32_t counts[2];
  double sizes[2];
  read_all(counts, sizeof counts);
  read_all(sizes, sizeof sizes);
  if (counts[0] < 4 || counts[1] < 4) return 2;
  // On a surface that intersects itself Netgen may search for ever: 81,000 tetrahedra take 7 s, this is many times that.
  const rlimit most{static_cast<rlim_t>(15 + counts[1] / 500), RLIM_INFINITY};
  setrlimit(RLIMIT_CPU, &most);
  std::vector<double> points(3 * static_cast<std::size_t>(counts[0]));
  std::vector<std::int32_t> triangles(3 * static_cast<std::size_t>(counts[1]));
  read_all(points.data(), points.size() * sizeof(double));
  read_all(triangles.data(), triangles.size() * sizeof(std::int32_t));

  using namespace nglib;
  std::vector<std::int32_t> tets;
  try {
    Ng_Init();
    Ng_Mesh* mesh = Ng_NewMesh();
    for (std::size_t i = 0; i < points.size(); i += 3) Ng_AddPoint(mesh, &points[i]);
    for (std::size_t i = 0; i < triangles.size(); i += 3) {
      int corners[3] = {triangles[i] + 1, triangles[i + 1] + 1, triangles[i + 2] + 1};
      Ng_AddSurfaceElement(mesh, NG_TRIG, corners);
    }
    Ng_Meshing_Parameters parameters;
    parameters.maxh = sizes[0];
    parameters.grading = sizes[1];
    parameters.optsteps_3d = 5;
    parameters.check_overlapping_boundary = 1;
    if (Ng_GenerateVolumeMesh(mesh, &parameters) != NG_OK) answer(out, 1, {}, {});
    const int n = Ng_GetNP(mesh);
    points.resize(3 * static_cast<std::size_t>(n));
    for (int i = 0; i < n; ++i) Ng_GetPoint(mesh, i + 1, &points[3 * static_cast<std::size_t>(i)]);
    for (int i = 1; i <= Ng_GetNE(mesh); ++i) {
      std::array<int, NG_VOLUME_ELEMENT_MAXPOINTS> v{};
      if (Ng_GetVolumeElement(mesh, i, v.data()) != NG_TET) answer(out, 1, {}, {});
      for (int k : {0, 2, 1, 3}) tets.push_back(v[static_cast<std::size_t>(k)] - 1);  // Netgen's order is left-handed
    }
  } catch (...) {
    answer(out, 1, {}, {});
  }
  answer(out, 0, points, tets);
}
