// HexFeatureWB - LGPL-2.1-or-later
#include "quality/skin.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hexfeature {
namespace {

constexpr double kWarped = 15;  // degrees

double degrees_between(const Vec3& a, const Vec3& b) { return std::atan2(a.cross(b).norm(), a.dot(b)) * 180 / EIGEN_PI; }

}  // namespace

SkinReport measure_skin(const HexComplex& complex, const Context& context) {
  SkinReport report;
  std::vector<char> on_boundary(complex.points.size(), 0);
  for (const auto& quad : complex.quads)
    for (int v : quad) on_boundary[v] = 1;
  double lean = 0, thickness = 0;
  int leans = 0, quads = 0, warped = 0;
  report.min_thickness = std::numeric_limits<double>::infinity();
  for (const auto& [h, f] : boundary_faces(complex, context)) {
    if (quads % 8192 == 0) context.check();
    const auto& hex = complex.hexes[h];
    const auto& face = kHexFaces[f];
    const auto at = [&](int corner) -> const Vec3& { return complex.points[hex[corner]]; };
    const Vec3 normal = (at(face[2]) - at(face[0])).cross(at(face[3]) - at(face[1])).normalized();
    Vec3 inward = Vec3::Zero();
    double warp = 0;
    for (int i = 0; i < 4; ++i) {
      const Vec3 own = (at(face[(i + 1) % 4]) - at(face[i])).cross(at(face[(i + 3) % 4]) - at(face[i]));
      warp = std::max(warp, degrees_between(own, normal));
      for (int k = 1; k < 4; ++k) {
        const int far = kHexCorners[face[i]][k];
        if (std::find(face.begin(), face.end(), far) != face.end()) continue;
        const Vec3 edge = at(far) - at(face[i]);
        inward += 0.25 * edge;
        if (on_boundary[hex[far]]) continue;
        const double angle = degrees_between(edge, -normal);
        lean += angle;
        ++leans;
        report.max_lean = std::max(report.max_lean, angle);
      }
    }
    const double thick = -normal.dot(inward);
    thickness += thick;
    report.min_thickness = std::min(report.min_thickness, thick);
    report.max_warp = std::max(report.max_warp, warp);
    warped += warp > kWarped;
    ++quads;
  }
  if (quads == 0) return {};
  report.mean_lean = leans > 0 ? lean / leans : 0;
  report.mean_thickness = thickness / quads;
  report.warped = static_cast<double>(warped) / quads;
  return report;
}

}  // namespace hexfeature
