// HexFeatureWB - LGPL-2.1-or-later
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>

#include "mesh/frame_search.h"
#include "surface/surface.h"

namespace hexfeature {
namespace {

constexpr std::size_t kHeaviest = 200;

/// The directions that most of a curved face's area looks to, sign ignored: flat parts that no crease divides from their fillets.
/// Normals are gathered in cells of about half a degree on a cube.
std::vector<WeightedDirection> heaviest_directions(const std::vector<WeightedDirection>& normals) {
  constexpr double kCell = 0.01;
  struct Entry {
    std::array<int, 3> cell;
    Vec3 sum;
  };
  std::vector<Entry> entries;
  entries.reserve(normals.size());
  for (const WeightedDirection& w : normals) {
    int axis = 0;
    const double largest = w.direction.cwiseAbs().maxCoeff(&axis);
    const Vec3 n = (w.direction[axis] < 0 ? -1 : 1) * w.direction / largest;
    std::array<int, 3> cell;
    for (int k = 0; k < 3; ++k) cell[k] = static_cast<int>(std::lround(n[k] / kCell));
    entries.push_back({cell, w.weight * n.normalized()});
  }
  std::stable_sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) { return a.cell < b.cell; });
  std::vector<WeightedDirection> heaviest;
  for (std::size_t i = 0, j; i < entries.size(); i = j) {
    Vec3 sum = Vec3::Zero();
    for (j = i; j < entries.size() && entries[j].cell == entries[i].cell; ++j) sum += entries[j].sum;
    heaviest.push_back({sum.normalized(), sum.norm()});
  }
  std::stable_sort(heaviest.begin(), heaviest.end(),
                   [](const WeightedDirection& a, const WeightedDirection& b) { return a.weight > b.weight * (1 + 1e-9); });
  if (heaviest.size() > kHeaviest) heaviest.resize(kHeaviest);
  return heaviest;
}

}  // namespace

std::vector<Mat3> find_frames(const TrianglePart& part, int count) {
  std::vector<WeightedDirection> normals, curved, directions;
  std::vector<Mat3> spread(part.faces.size(), Mat3::Zero());  // of a curved face: sum of area * n n^T
  for (const CadFace& f : part.faces)
    if (f.kind == SurfaceKind::Plane) {
      normals.push_back({f.axis, f.area});
      directions.push_back({f.axis, f.area});
    }
  for (int t = 0; t < part.mesh.triangle_count(); ++t) {
    const int f = part.mesh.triangle_face[t] - 1;
    const Vec3 n = part.mesh.area_normal(t).stableNormalized();
    const double area = part.mesh.area(t);
    if (part.faces[f].kind == SurfaceKind::Plane || !(area > 0)) continue;
    curved.push_back({n, area});
    spread[f] += area * n * n.transpose();
  }
  for (const WeightedDirection& w : heaviest_directions(curved)) directions.push_back(w);
  // A cylinder's normals know its axis as the direction that none of them has: the least of the principal directions.
  for (std::size_t f = 0; f < spread.size(); ++f) {
    if (spread[f].isZero()) continue;
    const Eigen::SelfAdjointEigenSolver<Mat3> principal(spread[f]);
    for (int k = 0; k < 3; ++k) directions.push_back({principal.eigenvectors().col(k), (k == 0 ? 0.5 : 0.1) * part.faces[f].area});
  }
  normals.insert(normals.end(), curved.begin(), curved.end());
  return best_frames(normals, directions, count);
}

}  // namespace hexfeature
