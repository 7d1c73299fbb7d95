// HexFeatureWB - LGPL-2.1-or-later
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "brep/model_impl.h"

namespace hexfeature {
namespace {

/// Circle through points of a plane given by two directions (Kasa's algebraic fit). Returns false when they are collinear.
bool fit_circle(const std::vector<Vec3>& points, const Vec3& e1, const Vec3& e2, Vec2& centre, double& radius) {
  Mat3 a = Mat3::Zero();
  Vec3 b = Vec3::Zero();
  for (const Vec3& p : points) {
    const Vec3 row(p.dot(e1), p.dot(e2), 1);
    a += row * row.transpose();
    b += row * -(row[0] * row[0] + row[1] * row[1]);
  }
  const Eigen::FullPivLU<Mat3> lu(a);
  if (lu.rank() < 3) return false;
  const Vec3 s = lu.solve(b);
  centre = -0.5 * s.head<2>();
  const double r2 = centre.squaredNorm() - s[2];
  radius = r2 > 0 ? std::sqrt(r2) : 0;
  return r2 > 0;
}

}  // namespace

void recognise(const std::vector<Vec3>& world, const std::vector<Vec3>& normals, double tolerance, CadFace& face) {
  const int n = static_cast<int>(world.size());
  if (n < 4) return;
  constexpr double kAngle = 1e-4;  // normals: splines are seldom better
  Vec3 middle = Vec3::Zero(), mean = Vec3::Zero();
  for (int i = 0; i < n; ++i) {
    middle += world[i] / n;
    mean += normals[i] / n;
  }
  std::vector<Vec3> points(n);
  for (int i = 0; i < n; ++i) points[i] = world[i] - middle;

  if (mean.norm() > 0.5) {  // plane
    const Vec3 axis = mean.normalized();
    bool flat = true;
    for (int i = 0; i < n && flat; ++i) flat = (normals[i] - axis).norm() < kAngle && std::abs(points[i].dot(axis)) < tolerance;
    if (flat) {
      face.kind = SurfaceKind::Plane;
      face.origin = middle;
      face.axis = axis;
      return;
    }
  }
  {  // sphere: p - r n is one point; r from the regression of p on n
    double up = 0, down = 0;
    for (int i = 0; i < n; ++i) {
      up += points[i].dot(normals[i] - mean);
      down += (normals[i] - mean).squaredNorm();
    }
    const double r = down > 1e-6 * n ? up / down : 0;
    const Vec3 centre = -r * mean;
    bool fits = r != 0;
    for (int i = 0; i < n && fits; ++i) fits = (points[i] - r * normals[i] - centre).norm() < tolerance + kAngle * std::abs(r);
    if (fits) {
      face.kind = SurfaceKind::Sphere;
      face.origin = middle + centre;
      face.radius = std::abs(r);
      return;
    }
  }
  // Cylinder, cone: the normals make one angle with the axis, so their tips lie in a plane.
  Mat3 spread = Mat3::Zero();
  for (int i = 0; i < n; ++i) spread += (normals[i] - mean) * (normals[i] - mean).transpose() / n;
  const Eigen::SelfAdjointEigenSolver<Mat3> eigen(spread);
  Vec3 axis = eigen.eigenvectors().col(0);
  bool cone = eigen.eigenvalues()[1] > 1e-8;
  const double tilt = mean.dot(axis);
  for (int i = 0; i < n && cone; ++i) cone = std::abs(normals[i].dot(axis) - tilt) < kAngle;
  if (cone && std::abs(tilt) < 0.9998) {
    const Vec3 e1 = axis.unitOrthogonal(), e2 = axis.cross(e1);
    Vec2 centre = Vec2::Zero();
    if (std::abs(tilt) < kAngle) {
      double radius = 0;
      bool fits = fit_circle(points, e1, e2, centre, radius);
      for (int i = 0; i < n && fits; ++i)
        fits = std::abs((Vec2(points[i].dot(e1), points[i].dot(e2)) - centre).norm() - radius) < tolerance;
      if (fits) {
        face.kind = SurfaceKind::Cylinder;
        face.origin = middle + centre[0] * e1 + centre[1] * e2;
        face.axis = axis;
        face.radius = radius;
        return;
      }
    } else {
      // The apex lies in all tangent planes: n . (p - apex) = 0.
      Mat3 a = Mat3::Zero();
      Vec3 b = Vec3::Zero();
      for (int i = 0; i < n; ++i) {
        a += normals[i] * normals[i].transpose();
        b += normals[i] * normals[i].dot(points[i]);
      }
      const Eigen::FullPivLU<Mat3> lu(a);
      if (lu.rank() == 3) {
        const Vec3 apex = lu.solve(b);
        bool fits = true;
        for (int i = 0; i < n && fits; ++i) fits = std::abs(normals[i].dot(points[i] - apex)) < tolerance;
        if (fits) {
          // Axis towards growing radius; origin: the foot of the points' middle, radius there.
          if ((-apex).dot(axis) < 0) axis = -axis;
          const double height = (-apex).dot(axis);
          face.half_angle = std::asin(std::min(1.0, std::abs(tilt)));
          face.kind = SurfaceKind::Cone;
          face.origin = middle + apex + height * axis;
          face.axis = axis;
          face.radius = height * std::tan(face.half_angle);
          return;
        }
      }
    }
  }
  {  // Torus: the normals' lines all meet the axis: n . m + (p x n) . a = 0 for its direction a and moment m.
    double size = 0;
    for (const Vec3& p : points) size = std::max(size, p.norm());
    using Vec6 = Eigen::Matrix<double, 6, 1>;
    Eigen::Matrix<double, 6, 6> a = Eigen::Matrix<double, 6, 6>::Zero();
    for (int i = 0; i < n; ++i) {
      Vec6 row;
      row << points[i].cross(normals[i]) / size, normals[i];
      a += row * row.transpose() / n;
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>> lines(a);
    const Vec3 direction = lines.eigenvectors().col(0).head<3>(), moment = lines.eigenvectors().col(0).tail<3>() * size;
    if (direction.norm() < 1e-3) return;
    const Vec3 unit = direction.normalized(), foot = unit.cross(moment / direction.norm());
    std::vector<Vec3> meridian(n);
    for (int i = 0; i < n; ++i) {
      const Vec3 d = points[i] - foot;
      meridian[i] = {d.cross(unit).norm(), d.dot(unit), 0};
    }
    Vec2 centre;
    double radius = 0;
    bool fits = fit_circle(meridian, Vec3::UnitX(), Vec3::UnitY(), centre, radius) && centre[0] > radius;
    for (int i = 0; i < n && fits; ++i) {
      const Vec3 d = points[i] - foot, ring = foot + centre[1] * unit + centre[0] * (d - d.dot(unit) * unit).normalized();
      const Vec3 away = points[i] - ring;
      fits = std::abs(away.norm() - radius) < tolerance && normals[i].cross(away).norm() < 10 * kAngle * radius;
    }
    if (fits) {
      face.kind = SurfaceKind::Torus;
      face.origin = middle + foot + centre[1] * unit;
      face.axis = unit;
      face.radius = centre[0];
      face.radius2 = radius;
    }
  }
}

}  // namespace hexfeature
