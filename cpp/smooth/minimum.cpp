// HexFeatureWB - LGPL-2.1-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "mesh/hex_element.h"
#include "smooth/patch.h"

namespace hexfeature {
namespace {

constexpr double kShortEdge = 0.06;  ///< of h: a mesh edge gets shorter than this only if it nearly was ...
constexpr double kLeastEdge = 0.05;  ///< ... and hardly shorter than this, unless it was
constexpr double kGranted = 0.97;    ///< what "hardly" grants of a length, in one place
constexpr std::array<double, 5> kPowers{12, 24, 48, 96, 192};
constexpr double kPatience = 24;  ///< power by which the least one must have risen, or a raise that is not patient ends

using Corners = Eigen::Matrix<double, 3, 8>;
constexpr int kFrames = 9;  ///< the three edges at each corner, and the axes at the centre

/// The axes at the centre: the edges from corner 0 and those parallel to them, mean. Each corner's share of the three.
const Eigen::Matrix<double, 8, 3>& centre_shares() {
  static const Eigen::Matrix<double, 8, 3> shares = [] {
    constexpr std::array<std::array<int, 8>, 3> kEnd{{{0, 1, 1, 0, 0, 1, 1, 0}, {0, 0, 1, 1, 0, 0, 1, 1}, {0, 0, 0, 0, 1, 1, 1, 1}}};
    Eigen::Matrix<double, 8, 3> all;
    for (int i = 0; i < 3; ++i)
      for (int c = 0; c < 8; ++c) all(c, i) = kEnd[i][c] ? 0.25 : -0.25;
    return all;
  }();
  return shares;
}

Mat3 axes_of(const Corners& corners, int frame) {
  if (frame == 8) return corners * centre_shares();
  Mat3 axes;
  for (int i = 0; i < 3; ++i) axes.col(i) = corners.col(kHexCorners[frame][i + 1]) - corners.col(frame);
  return axes;
}

double lengths_product(const Mat3& axes) {
  return std::sqrt(axes.col(0).squaredNorm() * axes.col(1).squaredNorm() * axes.col(2).squaredNorm());
}

/// The logarithm of the power mean (sum s^-p)^(1/p) of all scaled Jacobians s of a patch: for large p that of 1 / the least one.
/// Barriers, each with little weight, keep edges from becoming short and those along CAD curves from becoming long.
class LeastScaledJacobian : public Objective {
 public:
  explicit LeastScaledJacobian(Patch& patch) : patch_(patch) {
    for (const auto& hex : patch.hexes)
      for (const auto& e : kHexEdges) {
        const int a = std::min(hex[e[0]], hex[e[1]]), b = std::max(hex[e[0]], hex[e[1]]);
        if (patch.free[a] || patch.free[b]) edges_.push_back({a, b, 0});
      }
    std::sort(edges_.begin(), edges_.end(), [](const Edge& x, const Edge& y) { return x.a != y.a ? x.a < y.a : x.b < y.b; });
    edges_.erase(std::unique(edges_.begin(), edges_.end(), [](const Edge& x, const Edge& y) { return x.a == y.a && x.b == y.b; }),
                 edges_.end());
    const double h = patch.setting.options.size;
    for (Edge& e : edges_) {
      const double length = (point(patch.x, e.b) - point(patch.x, e.a)).norm();
      e.least = std::min(kShortEdge * h, std::max(0.9 * length, std::min(kLeastEdge * h, kGranted * length)));
    }
    value_.resize(kFrames * patch.hexes.size());
  }

  double power = 0;

  double evaluate(const std::vector<double>& x, std::vector<double>& gradient) override {
    patch_.setting.context.check();
    double least = 2;
    for (std::size_t h = 0; h < patch_.hexes.size(); ++h) {
      const Corners corners = corners_of(x, h);
      for (int k = 0; k < kFrames; ++k) {
        const Mat3 axes = axes_of(corners, k);
        const double s = axes.determinant() / lengths_product(axes);
        if (!(s > 0)) return kInfinite;
        value_[kFrames * h + k] = s;
        least = std::min(least, s);
      }
    }
    std::fill(gradient.begin(), gradient.end(), 0);
    const double barriers = kSpans * patch_.energy->add_spans(x.data(), true, 1, gradient.data());
    if (!(barriers < kInfinite)) return kInfinite;
    for (double& g : gradient) g *= kSpans;
    const double short_edges = add_short_edges(x, gradient);
    if (!(short_edges < kInfinite)) return kInfinite;
    double sum = 0;
    for (double& s : value_) {
      const double term = std::pow(least / s, power);
      sum += term;
      s = term / s;  // what its gradient counts
    }
    for (std::size_t h = 0; h < patch_.hexes.size(); ++h) {
      const Corners corners = corners_of(x, h);
      for (int k = 0; k < kFrames; ++k) {
        const double weight = value_[kFrames * h + k] / sum;
        if (weight < 1e-9) continue;
        const Mat3 axes = axes_of(corners, k);
        const double lengths = lengths_product(axes), s = axes.determinant() / lengths;
        Mat3 slope;  // of s by the axes
        for (int i = 0; i < 3; ++i)
          slope.col(i) = axes.col((i + 1) % 3).cross(axes.col((i + 2) % 3)) / lengths - s / axes.col(i).squaredNorm() * axes.col(i);
        slope *= -weight;
        const auto& hex = patch_.hexes[h];
        if (k == 8) {
          const Corners by_corner = slope * centre_shares().transpose();
          for (int c = 0; c < 8; ++c) add(gradient, hex[c], by_corner.col(c));
        } else {
          for (int i = 0; i < 3; ++i) add(gradient, hex[kHexCorners[k][i + 1]], slope.col(i));
          add(gradient, hex[k], slope * Vec3::Constant(-1));
        }
      }
    }
    for (std::size_t v = 0; v < patch_.nodes.size(); ++v)
      if (!patch_.free[v]) std::fill_n(gradient.begin() + 3 * static_cast<long>(v), 3, 0.0);
    patch_.boundary->make_tangent(gradient);
    return std::log(sum) / power - std::log(least) + barriers + short_edges;
  }

  void constrain(std::vector<double>& direction) const override { patch_.boundary->make_tangent(direction); }
  bool enough(const std::vector<double>& x) const override { return patch_.boundary->drifted(x, 0.1 * patch_.setting.options.size); }

  /// Whether no edge is shorter than it may be (points that went back onto the CAD are granted a little).
  bool allows(const std::vector<double>& x) const {
    return std::all_of(edges_.begin(), edges_.end(),
                       [&](const Edge& e) { return (point(x, e.b) - point(x, e.a)).norm() >= kGranted * e.least; });
  }

 private:
  static constexpr double kInfinite = std::numeric_limits<double>::infinity();
  static constexpr double kSpans = 0.002, kShort = 0.001, kNear = 0.5;
  struct Edge {
    int a, b;
    double least;
  };

  static Vec3 point(const std::vector<double>& x, int v) { return Eigen::Map<const Vec3>(x.data() + 3 * v); }
  static void add(std::vector<double>& gradient, int v, const Vec3& g) { Eigen::Map<Vec3>(gradient.data() + 3 * v) += g; }
  Corners corners_of(const std::vector<double>& x, std::size_t h) const {
    Corners corners;
    for (int c = 0; c < 8; ++c) corners.col(c) = point(x, patch_.hexes[h][c]);
    return corners;
  }

  /// With r = (least / |e|)^2, for r > kNear: kShort ((r - kNear) / (1 - r))^2.
  double add_short_edges(const std::vector<double>& x, std::vector<double>& gradient) const {
    double total = 0;
    for (const Edge& e : edges_) {
      const Vec3 d = point(x, e.b) - point(x, e.a);
      const double r = e.least * e.least / d.squaredNorm();
      if (r < kNear) continue;
      if (!(r < 1)) return kInfinite;
      const double q = (r - kNear) / (1 - r);
      total += kShort * q * q;
      const Vec3 g = (-4 * kShort * q * (1 - kNear) / ((1 - r) * (1 - r)) * r / d.squaredNorm()) * d;
      add(gradient, e.b, g);
      add(gradient, e.a, -g);
    }
    return total;
  }

  Patch& patch_;
  std::vector<Edge> edges_;
  std::vector<double> value_;
};

/// Leaves the patch in its best state seen, on the CAD; returns how far the least scaled Jacobian rose. Not `patient`: ends early where it
/// does not rise.
double raise(Patch& patch, bool patient) {
  const double h = patch.setting.options.size;
  patch.boundary->find_feet(patch.x);
  patch.boundary->snap(patch.x);
  std::vector<double> best = patch.x, gradient(patch.x.size());
  const double start = patch.grade().min_sj;
  double least = start;
  LeastScaledJacobian objective(patch);
  LbfgsOptions options;
  options.step_limit = 0.03 * h;
  options.iterations = 60;
  options.least_decrease = 1e-5;
  for (double power : kPowers) {
    objective.power = power;
    patch.energy->admit(patch.x.data());
    if (!std::isfinite(objective.evaluate(patch.x, gradient))) break;
    patch.boundary->hold_at_rims(gradient);
    std::vector<double> moved = patch.x;
    Lbfgs(static_cast<int>(moved.size()), patch.workers).descend(objective, moved, options);
    std::vector<double> next = patch.retract(patch.x, moved);
    const Grade grade = patch.grade(next);
    if (grade.inverted > 0 || !objective.allows(next)) break;
    patch.x = next;
    if (grade.min_sj > least) best = next, least = grade.min_sj;
    if (!patient && power >= kPatience && !(least > start)) break;
  }
  patch.x = best;
  patch.boundary->find_feet(patch.x);
  patch.boundary->snap(patch.x);
  return least - start;
}

}  // namespace

void raise_minimum(HexComplex& mesh, SmoothSetting& setting, bool worst_alone) {
  PlaceRules rules;
  rules.limit = worst_alone ? 0 : 0.32;
  rules.goal = 0.9;
  rules.rings = 1;
  rules.least_gain = 0.002;
  rules.progress = 0.97;
  lift_each_place(mesh, setting, rules, [&](Patch& patch) { return raise(patch, !worst_alone); });
}

}  // namespace hexfeature
