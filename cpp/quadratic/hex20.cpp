// HexFeatureWB - LGPL-2.1-or-later
#include "quadratic/hex20.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace hexfeature {
namespace {

/// Reference coordinates in [-1, 1]^3 of the 20 nodes.
constexpr std::array<std::array<int, 3>, 20> kNodes{
    {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1}, {-1, -1, 1}, {1, -1, 1}, {1, 1, 1},   {-1, 1, 1}, {0, -1, -1}, {1, 0, -1},
     {0, 1, -1},   {-1, 0, -1}, {0, -1, 1}, {1, 0, 1},   {0, 1, 1},   {-1, 0, 1}, {-1, -1, 0}, {1, -1, 0}, {1, 1, 0},   {-1, 1, 0}}};

using Gradients = std::array<Vec3, 20>;

/// Gradients of the serendipity shape functions at a reference point.
Gradients shape_gradients(const Vec3& x) {
  Gradients g;
  for (int n = 0; n < 20; ++n) {
    const Vec3 c(kNodes[n][0], kNodes[n][1], kNodes[n][2]);
    // Factors (1 + c x), or (1 - x^2) along a mid-side node's own direction.
    Vec3 factor, slope;
    bool corner = true;
    for (int a = 0; a < 3; ++a)
      if (c[a] == 0) {
        corner = false;
        factor[a] = 1 - x[a] * x[a];
        slope[a] = -2 * x[a];
      } else {
        factor[a] = 1 + c[a] * x[a];
        slope[a] = c[a];
      }
    for (int a = 0; a < 3; ++a) {
      const int b = (a + 1) % 3, d = (a + 2) % 3;
      if (corner)  // 1/8 product of factors times (c.x - 2)
        g[n][a] = 0.125 * factor[b] * factor[d] * (slope[a] * (c.dot(x) - 2) + factor[a] * c[a]);
      else
        g[n][a] = 0.25 * slope[a] * factor[b] * factor[d];
    }
  }
  return g;
}

Mat3 jacobian(const Hex20& nodes, const Gradients& g) {
  Mat3 j = Mat3::Zero();
  for (int n = 0; n < 20; ++n) j += nodes[n] * g[n].transpose();
  return j;
}

double determinant(const Hex20& nodes, const Gradients& g) { return jacobian(nodes, g).determinant(); }

/// Derivative of the determinant by the place of one node: cofactors times the node's gradient.
Vec3 determinant_slope(const Hex20& nodes, const Gradients& g, int node) {
  const Mat3 j = jacobian(nodes, g);
  return j.col(1).cross(j.col(2)) * g[node][0] + j.col(2).cross(j.col(0)) * g[node][1] + j.col(0).cross(j.col(1)) * g[node][2];
}

std::vector<Gradients> grid(std::initializer_list<double> values) {
  std::vector<Gradients> points;
  for (double r : values)
    for (double s : values)
      for (double t : values) points.push_back(shape_gradients(Vec3(r, s, t)));
  return points;
}

constexpr int kSamples = 6;  // of a polynomial of degree 5
template <class Value>
using Grid = std::array<Value, kSamples * kSamples * kSamples>;
using Coefficients = Grid<double>;

/// From values at six points of an interval to Bernstein coefficients of degree 5.
struct Interpolation {
  std::array<double, kSamples> at;  // in [-1, 1], Chebyshev's points: well conditioned
  Eigen::Matrix<double, kSamples, kSamples> to_bernstein;
  Interpolation() {
    Eigen::Matrix<double, kSamples, kSamples> values;
    constexpr double binomial[kSamples] = {1, 5, 10, 10, 5, 1};
    for (int i = 0; i < kSamples; ++i) {
      at[i] = -std::cos(M_PI * (2 * i + 1) / (2 * kSamples));
      const double u = 0.5 * (1 + at[i]);
      for (int k = 0; k < kSamples; ++k) values(i, k) = binomial[k] * std::pow(u, k) * std::pow(1 - u, kSamples - 1 - k);
    }
    to_bernstein = values.inverse();
  }
};

/// Apply a function to each line of six along one direction (stride 36, 6 or 1).
template <class Value, class Function>
void along(Grid<Value>& b, int stride, const Function& function) {
  for (int i = 0; i < static_cast<int>(b.size()); ++i) {
    if (i / stride % kSamples != 0) continue;
    Value line[kSamples];
    for (int k = 0; k < kSamples; ++k) line[k] = b[i + k * stride];
    function(line);
    for (int k = 0; k < kSamples; ++k) b[i + k * stride] = line[k];
  }
}

const Interpolation& interpolation() {
  static const Interpolation once;
  return once;
}

/// Gradients at the grid of sampling points.
const std::vector<Gradients>& samples() {
  static const std::vector<Gradients> once = [] {
    std::vector<Gradients> points;
    for (double r : interpolation().at)
      for (double s : interpolation().at)
        for (double t : interpolation().at) points.push_back(shape_gradients(Vec3(r, s, t)));
    return points;
  }();
  return once;
}

/// From values at the grid to Bernstein coefficients in all three variables.
template <class Value>
Grid<Value> to_bernstein(Grid<Value> b) {
  const auto& matrix = interpolation().to_bernstein;
  for (int stride : {36, 6, 1})
    along(b, stride, [&](Value* line) {
      Value result[kSamples];
      for (int i = 0; i < kSamples; ++i) {
        result[i] = matrix(i, 0) * line[0];
        for (int k = 1; k < kSamples; ++k) result[i] += matrix(i, k) * line[k];
      }
      std::copy(result, result + kSamples, line);
    });
  return b;
}

/// Halve the coefficients along one variable by de Casteljau's scheme: the lower or the upper half.
void halve(Coefficients& b, int stride, bool upper) {
  along(b, stride, [&](double* line) {
    for (int level = 1; level < kSamples; ++level)
      if (upper)
        for (int k = 0; k + level < kSamples; ++k) line[k] = 0.5 * (line[k] + line[k + 1]);
      else
        for (int k = kSamples - 1; k >= level; --k) line[k] = 0.5 * (line[k] + line[k - 1]);
  });
}

bool positive(const Coefficients& b, int depth) {
  double least = std::numeric_limits<double>::max();
  for (double c : b) least = std::min(least, c);
  if (least > 0) return true;
  // The corner coefficients are values of the determinant itself: one that is not positive disproves.
  for (int i : {0, 5, 30, 35, 180, 185, 210, 215})
    if (!(b[i] > 0)) return false;
  if (depth == 0) return false;
  for (int half = 0; half < 8; ++half) {
    Coefficients part = b;
    halve(part, 36, half & 1);
    halve(part, 6, half & 2);
    halve(part, 1, half & 4);
    if (!positive(part, depth - 1)) return false;
  }
  return true;
}

}  // namespace

double least_jacobian(const Hex20& nodes) {
  static const std::vector<Gradients> full = grid({-std::sqrt(0.6), 0.0, std::sqrt(0.6)});
  static const std::vector<Gradients> reduced = grid({-std::sqrt(1.0 / 3), std::sqrt(1.0 / 3)});
  static const std::vector<Gradients> at_nodes = [] {
    std::vector<Gradients> points;
    for (const auto& n : kNodes) points.push_back(shape_gradients(Vec3(n[0], n[1], n[2])));
    return points;
  }();
  double least = std::numeric_limits<double>::max(), mean = 0;
  const auto take = [&](double value) {
    if (!(value >= least)) least = value;  // lets NaN through
    return value;
  };
  for (const Gradients& g : reduced) mean += take(determinant(nodes, g)) / 8;
  for (const Gradients& g : full) take(determinant(nodes, g));
  for (const Gradients& g : at_nodes) take(determinant(nodes, g));
  return mean > 0 ? least / mean : std::min(least, mean);
}

std::array<double, 216> jacobian_bernstein(const Hex20& nodes) {
  Coefficients b;
  for (std::size_t i = 0; i < b.size(); ++i) b[i] = determinant(nodes, samples()[i]);
  return to_bernstein(b);
}

std::array<Vec3, 216> jacobian_bernstein_slopes(const Hex20& nodes, int node) {
  Grid<Vec3> b;
  for (std::size_t i = 0; i < b.size(); ++i) b[i] = determinant_slope(nodes, samples()[i], node);
  return to_bernstein(b);
}

bool proves_positive(const Hex20& nodes, int depth) {
  const Coefficients b = jacobian_bernstein(nodes);
  for (double c : b)
    if (!std::isfinite(c)) return false;
  return positive(b, depth);
}

}  // namespace hexfeature
