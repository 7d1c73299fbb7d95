// HexFeatureWB - LGPL-2.1-or-later
#include "smooth/energy.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mesh/hex_complex.h"

namespace hexfeature {
namespace {

constexpr double kSpanWeight = 6;
constexpr double kMeanSpans = 0.002;  // the spans' share in the mean-element energy: that counts elements, not the powers of their corners

}  // namespace

int HexEnergy::frame_count(int group, const EnergyTerms& terms) const { return thorough_[group] && !terms.mean ? kAllFrames : kCorners; }

double HexEnergy::floor(const EnergyTerms& terms) const {
  const double shape = (1 - terms.theta) * 3 + terms.theta * 2;
  const double one = terms.shape_alone() ? shape : (terms.mean ? 0 : 1) + terms.shape_weight * shape;
  double total = 0;
  for (std::size_t g = 0; g < thorough_.size(); ++g)
    for (int l = 0; l < kLanes; ++l)
      total += weight_[g * kLanes + l] * one * (kCorners + kMixedWeight * (frame_count(static_cast<int>(g), terms) - kCorners));
  return total;
}

HexEnergy::HexEnergy(const std::vector<std::array<int, 8>>& hexes, int points, const std::vector<double>& target,
                     const std::vector<double>& shortest, const std::vector<double>& least, const std::vector<char>& thorough,
                     Workers& workers)
    : hexes_(static_cast<int>(hexes.size())), points_(points), workers_(workers) {
  const int groups = (hexes_ + kLanes - 1) / kLanes;
  nodes_.resize(8 * kLanes * groups);
  inverse_size_.resize(kLanes * groups);
  shortest_.resize(kLanes * groups);
  least_.resize(kLanes * groups);
  weight_.assign(kLanes * groups, 0.0);
  thorough_.assign(groups, 0);
  parts_.resize(groups);
  start_.assign(points + 1, 0);
  incident_.resize(8 * hexes_);
  if (hexes_ == 0) return;
  // Thorough elements first, so that they share groups.
  std::vector<int> order;
  order.reserve(hexes_);
  for (char kind : {1, 0})
    for (int h = 0; h < hexes_; ++h)
      if ((thorough[h] != 0) == (kind != 0)) order.push_back(h);
  for (int i = 0; i < kLanes * groups; ++i) {
    const int h = order[std::min(i, hexes_ - 1)], lane = i % kLanes, group = i / kLanes;
    const double ratio = shortest[h] / target[h];
    inverse_size_[i] = 1 / target[h];
    shortest_[i] = ratio * ratio;
    least_[i] = (least[h] / target[h]) * (least[h] / target[h]);
    weight_[i] = i < hexes_ ? 1 : 0;
    if (thorough[h]) thorough_[group] = 1;
    for (int k = 0; k < 8; ++k) {
      nodes_[(group * 8 + k) * kLanes + lane] = 3 * hexes[h][k];
      if (i < hexes_) ++start_[hexes[h][k] + 1];
    }
  }
  for (int v = 0; v < points; ++v) start_[v + 1] += start_[v];
  std::vector<int> next(start_.begin(), start_.end() - 1);
  for (int i = 0; i < hexes_; ++i)
    for (int k = 0; k < 8; ++k) incident_[next[hexes[order[i]][k]]++] = (i / kLanes * 8 + k) * 3 * kLanes + i % kLanes;
}

void HexEnergy::set_spans(std::vector<Span> spans, const double* x) {
  constexpr double kBarrier = 1.2;
  spans_ = std::move(spans);
  limit_.assign(spans_.size(), kBarrier);
  admit(x);
}

void HexEnergy::admit(const double* x) {
  for (std::size_t i = 0; i < spans_.size(); ++i) {
    const Span& s = spans_[i];
    const double length2 = (Eigen::Map<const Vec3>(x + 3 * s.b) - Eigen::Map<const Vec3>(x + 3 * s.a)).squaredNorm();
    limit_[i] = std::max(limit_[i], 1.02 * length2 / (s.longest * s.longest));
  }
}

double HexEnergy::add_spans(const double* x, bool barrier, double share, double* gradient) const {
  const double weight = share * kSpanWeight;
  double energy = 0;
  for (std::size_t i = 0; i < spans_.size(); ++i) {
    const Span& s = spans_[i];
    const Vec3 e = Eigen::Map<const Vec3>(x + 3 * s.b) - Eigen::Map<const Vec3>(x + 3 * s.a);
    const double length2 = e.squaredNorm(), longest2 = s.longest * s.longest, shortest2 = s.shortest * s.shortest;
    double slope = 0;  // of the energy by |e|^2
    if (length2 > longest2) {
      const double r = length2 / longest2, over = r - 1;
      if (barrier) {
        const double left = limit_[i] - r;
        if (!(left > 0)) return std::numeric_limits<double>::infinity();
        const double q = over / left;
        energy += weight * q * q;
        slope = 2 * weight * q * (limit_[i] - 1) / (left * left * longest2);
      } else {
        energy += weight * over * over;
        slope = 2 * weight * over / longest2;
      }
    } else if (length2 < shortest2) {
      const double square = std::max(length2, 1e-4 * shortest2), r = shortest2 / square;
      energy += weight * (r - 1) * (r - 1);
      slope = length2 < square ? 0 : -2 * weight * (r - 1) * r / square;
    }
    if (!gradient || slope == 0) continue;
    Eigen::Map<Vec3>(gradient + 3 * s.b) += 2 * slope * e;
    Eigen::Map<Vec3>(gradient + 3 * s.a) -= 2 * slope * e;
  }
  return energy;
}

EnergyValue HexEnergy::evaluate(const double* x, const EnergyTerms& terms, double* gradient) {
  const int groups = static_cast<int>(parts_.size());
  if (gradient) slots_.resize(static_cast<std::size_t>(24) * kLanes * groups);
  double* slots = gradient ? slots_.data() : nullptr;
  workers_.run(groups, 64, [&](int begin, int end) {
    for (int g = begin; g < end; ++g)
      parts_[g] = evaluate_group({nodes_.data() + 8 * kLanes * g, inverse_size_.data() + kLanes * g, weight_.data() + kLanes * g,
                                  shortest_.data() + kLanes * g, least_.data() + kLanes * g, frame_count(g, terms)},
                                 x, terms, slots ? slots + static_cast<std::size_t>(24) * kLanes * g : nullptr);
  });
  EnergyValue value{0, std::numeric_limits<double>::infinity()};
  for (const GroupValue& part : parts_) {
    value.energy += part.energy;
    value.min_det = std::min(value.min_det, part.min_det);
  }
  if (!(value.energy < std::numeric_limits<double>::infinity()) || (!terms.shape_alone() && !(value.min_det > 0))) {
    value.energy = std::numeric_limits<double>::infinity();
    return value;
  }
  if (gradient)
    workers_.run(points_, 512, [&](int begin, int end) {
      for (int v = begin; v < end; ++v) {
        double gx = 0, gy = 0, gz = 0;
        for (int i = start_[v]; i < start_[v + 1]; ++i) {
          const double* s = slots + incident_[i];
          gx += s[0], gy += s[kLanes], gz += s[2 * kLanes];
        }
        gradient[3 * v] = gx, gradient[3 * v + 1] = gy, gradient[3 * v + 2] = gz;
      }
    });
  value.energy += add_spans(x, !terms.shape_alone(), terms.mean ? kMeanSpans : 1, gradient);
  return value;
}

namespace {

/// Second derivatives at one corner, in the scaled edges: alpha[i] I for the change of edge i alone, and
/// curvature * g g^T for a change along g, the concatenated `along`.
struct CornerStiffness {
  double alpha[3], curvature;
  Vec3 along[3];
};

CornerStiffness corner_stiffness(const Vec3 (&e)[3], const EnergyTerms& terms) {
  CornerStiffness r;
  r.along[0] = e[1].cross(e[2]);
  r.along[1] = e[2].cross(e[0]);
  r.along[2] = e[0].cross(e[1]);
  const double d = e[0].dot(r.along[0]), sum = e[0].squaredNorm() + e[1].squaredNorm() + e[2].squaredNorm();
  if (terms.shape_alone()) {
    const double root = std::sqrt(terms.epsilon_squared + d * d), outer = root + std::abs(d);
    const double chi = d >= 0 ? 0.5 * outer : 0.5 * terms.epsilon_squared / outer;
    const double y = 1 / std::cbrt(chi), y2 = y * y, slope = chi / root;
    for (double& a : r.alpha) a = 2 * (1 - terms.theta) * y2;
    r.curvature = slope * slope / (chi * chi) * ((1 - terms.theta) * (10.0 / 9.0) * sum * y2 + 2 * terms.theta * (1 + d * d) / chi);
    return r;
  }
  // q = e^u, u = Sum log |e_i| - log d: (q^p)'' = p^2 q^p u' u'^T + p q^p u''.
  double lengths = 1;
  for (const Vec3& v : e) lengths *= v.norm();
  if (!(d > 0)) {
    for (int i = 0; i < 3; ++i) r.alpha[i] = 1, r.along[i].setZero();
    r.curvature = 0;
    return r;
  }
  // The mean-element energy resembles that of the worst with p = 2, but for a factor.
  const double p = terms.mean ? 2 : terms.power, shape = terms.mean ? 0.5 : terms.shape_weight, power = std::pow(lengths / d, p);
  for (int i = 0; i < 3; ++i) {
    const double square = std::max(e[i].squaredNorm(), 1e-30);
    r.along[i] = e[i] / square - r.along[i] / d;
    r.alpha[i] = p * power / square + 2 * shape;
  }
  r.curvature = p * (p + 1) * power;
  return r;
}

}  // namespace

void HexEnergy::stiffness(const double* x, const EnergyTerms& terms, std::vector<double>& blocks) const {
  const int groups = static_cast<int>(parts_.size());
  std::vector<double> per_node(static_cast<std::size_t>(48) * kLanes * groups);  // slots_' layout with 6 numbers
  workers_.run(groups, 64, [&](int begin, int end) {
    for (int group = begin; group < end; ++group)
      for (int lane = 0; lane < kLanes; ++lane) {
        const double inverse = inverse_size_[kLanes * group + lane];
        Vec3 p[8];
        Eigen::Matrix<double, 6, 1> sum[8];
        for (int k = 0; k < 8; ++k) {
          p[k] = inverse * Eigen::Map<const Vec3>(x + nodes_[(8 * group + k) * kLanes + lane]);
          sum[k].setZero();
        }
        const auto add = [&](int k, double alpha, double curvature, const Vec3& g) {
          sum[k].head<3>() += Vec3::Constant(alpha) + curvature * g.cwiseProduct(g);
          sum[k].tail<3>() += curvature * Vec3(g[1] * g[2], g[0] * g[2], g[0] * g[1]);
        };
        for (int i = 0; i < frame_count(group, terms); ++i) {
          const Frame& frame = hex_frames().frame[i];
          Vec3 edges[3];
          for (int k = 0; k < 3; ++k) edges[k] = p[frame.to[k]] - p[frame.from[k]];
          const CornerStiffness s = corner_stiffness(edges, terms);
          if (i < kCorners) {
            for (int k = 0; k < 3; ++k) add(frame.to[k], s.alpha[k], s.curvature, s.along[k]);
            add(frame.from[0], s.alpha[0] + s.alpha[1] + s.alpha[2], s.curvature, s.along[0] + s.along[1] + s.along[2]);
          } else {  // two of the edges meet in a node: its curvature is taken as the sum of theirs
            for (int k = 0; k < 3; ++k)
              for (int v : {frame.from[k], frame.to[k]}) add(v, kMixedWeight * s.alpha[k], kMixedWeight * s.curvature, s.along[k]);
          }
        }
        for (int k = 0; k < 8; ++k)
          for (int i = 0; i < 6; ++i) per_node[((8 * group + k) * 6 + i) * kLanes + lane] = sum[k][i] * inverse * inverse;
      }
  });
  blocks.resize(6 * points_);
  workers_.run(points_, 512, [&](int begin, int end) {
    for (int v = begin; v < end; ++v)
      for (int c = 0; c < 6; ++c) {
        double total = 0;
        for (int i = start_[v]; i < start_[v + 1]; ++i) {
          const int lane = incident_[i] % kLanes;
          total += per_node[2 * (incident_[i] - lane) + c * kLanes + lane];
        }
        blocks[6 * v + c] = total;
      }
  });
}

}  // namespace hexfeature
