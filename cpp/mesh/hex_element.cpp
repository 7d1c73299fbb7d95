// HexFeatureWB - LGPL-2.1-or-later
#include "mesh/hex_element.h"

#include <algorithm>
#include <cmath>

#include "mesh/hex_complex.h"

namespace hexfeature {
namespace {

using Coefficients = std::array<double, 27>;

std::array<Vec3, 8> corners_of(const std::vector<Vec3>& points, const std::array<int, 8>& hex) {
  std::array<Vec3, 8> x;
  for (int k = 0; k < 8; ++k) x[k] = points[hex[k]];
  return x;
}

double scaled_determinant(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double lengths = std::sqrt(a.squaredNorm() * b.squaredNorm() * c.squaredNorm());
  return a.dot(b.cross(c)) / std::max(lengths, 1e-300);
}

/// Halve the coefficients along one variable (stride 9, 3 or 1) at its middle: the lower or the upper half.
Coefficients halved(const Coefficients& b, int stride, bool upper) {
  Coefficients r;
  for (int i = 0; i < 27; ++i) {
    if (i / stride % 3 != 0) continue;
    const double p = b[i], q = b[i + stride], s = b[i + 2 * stride];
    const double pq = 0.5 * (p + q), qs = 0.5 * (q + s), mid = 0.5 * (pq + qs);
    r[i] = upper ? mid : p;
    r[i + stride] = upper ? qs : pq;
    r[i + 2 * stride] = upper ? s : mid;
  }
  return r;
}

bool positive(const Coefficients& b, int depth) {
  double least = b[0];
  for (double c : b) least = std::min(least, c);
  if (least > 0) return true;
  // The eight corner coefficients are values of the determinant itself: one that is not positive disproves.
  for (int i : {0, 2, 6, 8, 18, 20, 24, 26})
    if (!(b[i] > 0)) return false;
  if (depth == 0) return false;
  for (int half = 0; half < 8; ++half)
    if (!positive(halved(halved(halved(b, 9, half & 1), 3, half & 2), 1, half & 4), depth - 1)) return false;
  return true;
}

}  // namespace

double scaled_jacobian(const std::vector<Vec3>& points, const std::array<int, 8>& hex) { return scaled_jacobian(corners_of(points, hex)); }

double scaled_jacobian(const std::array<Vec3, 8>& x) {
  double least = 2;
  for (const auto& c : kHexCorners) {
    const double value = scaled_determinant(x[c[1]] - x[c[0]], x[c[2]] - x[c[0]], x[c[3]] - x[c[0]]);
    if (!(value >= least)) least = value;  // lets NaN through
  }
  const Vec3 r = (x[1] - x[0]) + (x[2] - x[3]) + (x[5] - x[4]) + (x[6] - x[7]);
  const Vec3 s = (x[3] - x[0]) + (x[2] - x[1]) + (x[7] - x[4]) + (x[6] - x[5]);
  const Vec3 t = (x[4] - x[0]) + (x[5] - x[1]) + (x[6] - x[2]) + (x[7] - x[3]);
  const double centre = scaled_determinant(r, s, t);
  return least <= centre ? least : centre;
}

std::array<double, 27> jacobian_bernstein(const std::vector<Vec3>& points, const std::array<int, 8>& hex) {
  return jacobian_bernstein(corners_of(points, hex));
}

std::array<double, 27> jacobian_bernstein(const std::array<Vec3, 8>& corners) {
  // Node of the cube's corner (r, s, t) at 4 r + 2 s + t.
  constexpr int node[8] = {0, 4, 3, 7, 1, 5, 2, 6};
  std::array<Vec3, 8> x;
  for (int k = 0; k < 8; ++k) x[k] = corners[node[k]];
  // Edge vectors along r at (s, t), along s at (r, t), along t at (r, s).
  Vec3 dr[2][2], ds[2][2], dt[2][2];
  for (int a = 0; a < 2; ++a)
    for (int b = 0; b < 2; ++b) {
      dr[a][b] = x[4 + 2 * a + b] - x[2 * a + b];
      ds[a][b] = x[4 * a + 2 + b] - x[4 * a + b];
      dt[a][b] = x[4 * a + 2 * b + 1] - x[4 * a + 2 * b];
    }
  // X_r is linear in (s, t), X_s in (r, t), X_t in (r, s): the product of three Bernstein forms of degree 1 in each variable
  // is one of degree 2, and a coefficient of index 1 is the mean of its two products.
  Coefficients out{};
  for (int i = 0; i < 3; ++i)
    for (int cv = 0; cv < 2; ++cv)
      for (int dv = 0; dv < 2; ++dv) {
        Vec3 cross;
        if (i == 1)
          cross = 0.5 * (ds[0][cv].cross(dt[1][dv]) + ds[1][cv].cross(dt[0][dv]));
        else
          cross = ds[i / 2][cv].cross(dt[i / 2][dv]);
        for (int bu = 0; bu < 2; ++bu)
          for (int bv = 0; bv < 2; ++bv) {
            const int j = bu + dv, k = bv + cv;
            const double weight = (j == 1 ? 0.5 : 1) * (k == 1 ? 0.5 : 1);
            out[9 * i + 3 * j + k] += weight * dr[bu][bv].dot(cross);
          }
      }
  return out;
}

double bernstein_minimum(const std::vector<Vec3>& points, const std::array<int, 8>& hex) {
  const Coefficients b = jacobian_bernstein(points, hex);
  double least = b[0], length = 0;
  for (double c : b)
    if (!(c >= least)) least = c;
  for (const auto& e : kHexEdges) length += (points[hex[e[0]]] - points[hex[e[1]]]).norm();
  length /= 12;
  return least / std::max(length * length * length, 1e-300);
}

bool proves_positive(const std::vector<Vec3>& points, const std::array<int, 8>& hex, int depth) {
  return proves_positive(corners_of(points, hex), depth);
}

bool proves_positive(const std::array<Vec3, 8>& corners, int depth) {
  const Coefficients b = jacobian_bernstein(corners);
  for (double c : b)
    if (!std::isfinite(c)) return false;
  return positive(b, depth);
}

double proved_scaled_jacobian(const std::array<Vec3, 8>& corners) {
  const double q = scaled_jacobian(corners);
  if (std::isnan(q)) return -1;
  return q <= 0 || proves_positive(corners) ? q : 0;
}

std::vector<double> proved_scaled_jacobians(const std::vector<Vec3>& points, const std::vector<std::array<int, 8>>& hexes) {
  std::vector<double> quality;
  quality.reserve(hexes.size());
  for (const auto& hex : hexes) quality.push_back(proved_scaled_jacobian(corners_of(points, hex)));
  return quality;
}

double hex_volume(const std::vector<Vec3>& points, const std::array<int, 8>& hex) {
  double sum = 0;
  for (double c : jacobian_bernstein(points, hex)) sum += c;
  return sum / 27;
}

}  // namespace hexfeature
