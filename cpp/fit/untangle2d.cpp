// HexFeatureWB - LGPL-2.1-or-later
#include "fit/untangle2d.h"

#include <Eigen/Core>
#include <Eigen/LU>
#include <cmath>

#include "fit/lbfgs.h"

namespace hexfeature {

namespace {
/// chi and its derivative, without cancellation for d < 0.
void regularised_determinant(double eps2, double d, double& chi, double& slope) {
  const double root = std::sqrt(eps2 + d * d);
  chi = d > 0 ? 0.5 * (d + root) : 0.5 * eps2 / (root - d);
  slope = chi / root;
}
}  // namespace

int untangle(const std::vector<std::array<int, 3>>& triangles, const std::vector<Vec3>& shape, const std::vector<char>& fixed,
             std::vector<Vec2>& flat, const Context& context) {
  using Mat2 = Eigen::Matrix2d;
  const int n = static_cast<int>(flat.size()), count = static_cast<int>(triangles.size());

  // Inverse of each triangle's own shape, laid flat; slivers count as equilateral, or they would rule the energy.
  std::vector<Mat2> inverse(count);
  std::vector<double> weight(count);
  double total = 0, image = 0;
  for (int t = 0; t < count; ++t) {
    const auto& v = triangles[t];
    const Vec3 a = shape[v[1]] - shape[v[0]], b = shape[v[2]] - shape[v[0]];
    const double area = 0.5 * a.cross(b).norm(), longest2 = std::max({a.squaredNorm(), b.squaredNorm(), (a - b).squaredNorm()});
    Mat2 m;
    if (area > 0.05 * longest2) {
      const double l = a.norm(), x = a.dot(b) / l;
      m << l, x, 0, 2 * area / l;
    } else {
      const double l = std::sqrt(longest2) * 0.4;
      m << l, 0.5 * l, 0, 0.866 * l;
    }
    weight[t] = 0.5 * m.determinant();
    total += weight[t];
    inverse[t] = m;
    image += 0.5 * cross2(flat[v[1]] - flat[v[0]], flat[v[2]] - flat[v[0]]);
  }
  if (!(total > 0) || !(image > 0)) return count;
  const double scale = std::sqrt(image / total);
  for (int t = 0; t < count; ++t) {
    inverse[t] = (scale * inverse[t]).inverse().eval();
    weight[t] /= total;
  }

  std::vector<int> variable(n, -1);
  int variables = 0;
  for (int i = 0; i < n; ++i)
    if (!fixed[i]) variable[i] = variables++;
  Eigen::VectorXd x(2 * variables);
  for (int i = 0; i < n; ++i)
    if (variable[i] >= 0) x.segment<2>(2 * variable[i]) = flat[i];

  const auto worst = [&](int& folded) {
    double least = 1e300;
    folded = 0;
    for (int t = 0; t < count; ++t) {
      const auto& v = triangles[t];
      Mat2 q;
      q.col(0) = flat[v[1]] - flat[v[0]];
      q.col(1) = flat[v[2]] - flat[v[0]];
      const double d = (q * inverse[t]).determinant();
      least = std::min(least, d);
      folded += d <= 0;
    }
    return least;
  };
  constexpr double kTheta = 0.3;
  double eps2 = 0;
  const auto energy = [&](const Eigen::VectorXd& y, Eigen::VectorXd& gradient) {
    gradient.setZero();
    double sum = 0;
    const auto at = [&](int i) -> Vec2 { return variable[i] >= 0 ? Vec2(y.segment<2>(2 * variable[i])) : flat[i]; };
    for (int t = 0; t < count; ++t) {
      const auto& v = triangles[t];
      const Vec2 q0 = at(v[0]);
      Mat2 q;
      q.col(0) = at(v[1]) - q0;
      q.col(1) = at(v[2]) - q0;
      const Mat2 j = q * inverse[t];
      const double d = j.determinant(), f = j.squaredNorm();
      double chi, slope;
      regularised_determinant(eps2, d, chi, slope);
      const double numerator = f + kTheta * (1 + d * d);
      sum += weight[t] * numerator / chi;
      Mat2 adjugate;
      adjugate << j(1, 1), -j(1, 0), -j(0, 1), j(0, 0);
      const Mat2 dj = (2 * j + (2 * kTheta * d - numerator / chi * slope) * adjugate) / chi;
      const Mat2 dq = weight[t] * dj * inverse[t].transpose();
      for (int k = 0; k < 3; ++k) {
        const int i = variable[v[k]];
        if (i < 0) continue;
        if (k == 0)
          gradient.segment<2>(2 * i) -= dq.col(0) + dq.col(1);
        else
          gradient.segment<2>(2 * i) += dq.col(k - 1);
      }
    }
    return sum;
  };

  int folded = 0;
  double least = worst(folded), last_eps2 = 1e300, best = least;
  int stalled = 0;
  for (int round = 0; round < 40 && folded > 0 && variables > 0 && stalled < 5; ++round) {
    context.check();
    eps2 = std::min(last_eps2, 1e-6 + 0.04 * std::min(least, 0.0) * std::min(least, 0.0));
    if (round > 10) eps2 = std::min(eps2, 0.5 * last_eps2);
    last_eps2 = eps2;
    minimise_lbfgs(x, energy, 60, 2.0, 1e-4);
    for (int i = 0; i < n; ++i)
      if (variable[i] >= 0) flat[i] = x.segment<2>(2 * variable[i]);
    least = worst(folded);
    stalled = least > best + 0.3 * std::abs(best) ? 0 : stalled + 1;
    best = std::max(best, least);
  }
  return folded;
}

}  // namespace hexfeature
