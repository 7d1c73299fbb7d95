// HexFeatureWB - LGPL-2.1-or-later
#include "sheet/edge_angle.h"

#include <algorithm>
#include <cmath>

namespace hexfeature {
namespace {

// Unit vector in quad q away from its edge (a, b), perpendicular to it.
Vec3 inward(const HexComplex& complex, int q, int a, int b, const Vec3& along) {
  Vec3 far = Vec3::Zero();
  for (int v : complex.quads[q])
    if (v != a && v != b) far += 0.5 * complex.points[v];
  const Vec3 d = far - 0.5 * (complex.points[a] + complex.points[b]);
  return (d - d.dot(along) * along).normalized();
}

double turn(double y, double x) {
  const double degrees = std::atan2(y, x) * 180 / EIGEN_PI;
  return degrees < 0 ? degrees + 360 : degrees;
}

}  // namespace

double solid_angle(const HexComplex& complex, const HexTopology::Edge& edge) {
  const auto [a, b] = edge.nodes;
  const Vec3 along = (complex.points[b] - complex.points[a]).normalized();
  const Vec3 d0 = inward(complex, edge.quads[0], a, b, along), d1 = inward(complex, edge.quads[1], a, b, along);
  const Vec3 into_solid = d0.cross(along);  // quads[0] has the edge along a -> b and itself on the left, seen from outside
  return turn(into_solid.dot(d1), d0.dot(d1));
}

double corner_angle(const HexComplex& complex, int q, int i) {
  const auto& n = complex.quads[q];
  const auto at = [&](int k) -> const Vec3& { return complex.points[n[(i + k) % 4]]; };
  const Vec3 normal = (at(2) - at(0)).cross(at(3) - at(1)).normalized();
  const Vec3 out = at(1) - at(0), back = at(3) - at(0);
  return turn(normal.dot(out.cross(back)), out.dot(back));
}

int feature_of(const HexComplex& complex, int a, int b) {
  const std::array<int, 2> key{std::min(a, b), std::max(a, b)};
  const auto it = std::lower_bound(complex.feature_edges.begin(), complex.feature_edges.end(), key);
  return it != complex.feature_edges.end() && *it == key ? complex.feature_edge_cad[it - complex.feature_edges.begin()] : 0;
}

}  // namespace hexfeature
