// HexFeatureWB - LGPL-2.1-or-later
#include "quadratic/unfold.h"

#include <Eigen/Cholesky>
#include <algorithm>

#include "quadratic/hex20.h"

namespace hexfeature {
namespace {

constexpr int kRounds = 40;
constexpr double kGain = 0.01;  // a round that takes away less of what is lacking is the last
constexpr int kNewton = 10;
constexpr int kShorter = 6;      // times a step is halved
constexpr double kWanted = 0.1;  // least coefficient, of the mean of the straight-sided element's
constexpr double kStay = 1e-4;   // weight of a move, in edge lengths, squared: of two good places the nearer

/// Coefficients of one element around a node, affine in the node's move.
struct Around {
  std::array<double, 216> value;
  std::array<Vec3, 216> slope;
};

class Unfolding {
 public:
  Unfolding(const HexComplex& complex, const MeshEdges& edges, const Projector& projector, Bows& bows, Context& context)
      : complex_(complex), edges_(edges), projector_(projector), bows_(bows), context_(context) {
    scale_.assign(edges.of_hex.size(), 0);
    first_.assign(edges.count() + 1, 0);
    for (const auto& of_hex : edges.of_hex)
      for (int e : of_hex) ++first_[e + 1];
    for (int e = 0; e < edges.count(); ++e) first_[e + 1] += first_[e];
    use_.resize(12 * edges.of_hex.size());
    std::vector<int> at(first_.begin(), first_.end() - 1);
    for (std::size_t h = 0; h < edges.of_hex.size(); ++h)
      for (int k = 0; k < 12; ++k) use_[at[edges.of_hex[h][k]]++] = {static_cast<int>(h), k};
  }

  std::vector<int> run(std::vector<int> bad) {
    for (int round = 0; round < kRounds && !bad.empty(); ++round) {
      std::vector<int> moving;
      for (int h : bad) moving.insert(moving.end(), edges_.of_hex[h].begin(), edges_.of_hex[h].end());
      make_unique(moving);
      std::vector<int> touched = bad;
      lacked_ = gained_ = 0;
      for (int e : moving) {
        context_.check();
        if (!improve(e)) continue;
        for (int u = first_[e]; u < first_[e + 1]; ++u) touched.push_back(use_[u].hex);
      }
      make_unique(touched);
      bad.clear();
      for (int h : touched) {
        context_.check();
        if (!proves_positive(bent_element(complex_, edges_, bows_, h))) bad.push_back(h);
      }
      if (gained_ < kGain * lacked_) break;
    }
    return bad;
  }

 private:
  struct Use {
    int hex, local;  // edge `local` of hexahedron `hex`
  };

  static void make_unique(std::vector<int>& v) {
    std::sort(v.begin(), v.end());
    v.erase(std::unique(v.begin(), v.end()), v.end());
  }

  /// The mean coefficient of the straight-sided element: its volume over 8.
  double scale(int h) {
    if (scale_[h] != 0) return scale_[h];
    Hex20 x = bent_element(complex_, edges_, bows_, h);
    for (int k = 0; k < 12; ++k) x[8 + k] = bows_.chord[edges_.of_hex[h][k]];
    for (double c : jacobian_bernstein(x)) scale_[h] += c / 216;
    return scale_[h];
  }

  /// What the coefficients around lack, squared, after moving the node by d; with its first and second derivatives.
  double lack(const std::vector<Around>& around, const Vec3& d, double length, Vec3* slope, Mat3* curvature) const {
    double sum = kStay * d.squaredNorm() / (length * length);
    if (slope) *slope = 2 * kStay / (length * length) * d;
    if (curvature) *curvature = 2 * kStay / (length * length) * Mat3::Identity();
    for (const Around& a : around)
      for (int c = 0; c < 216; ++c) {
        const double lacking = kWanted - a.value[c] - a.slope[c].dot(d);
        if (lacking <= 0) continue;
        sum += lacking * lacking;
        if (slope) *slope -= 2 * lacking * a.slope[c];
        if (curvature) *curvature += 2 * a.slope[c] * a.slope[c].transpose();
      }
    return sum;
  }

  /// The place of the node of edge e moved by d and put back on the CAD; as a bow.
  Vec3 moved(int e, const Vec3& d) const {
    const CadPlace& place = bows_.place[e];
    const Vec3 p = bows_.chord[e] + bows_.bow[e] + d;
    if (place.dim == 1) return projector_.project_to_edge(place.entity, p, &place.uv[0]).point - bows_.chord[e];
    if (place.dim == 2) return projector_.project_to_face(place.entity, p, &place.uv).point - bows_.chord[e];
    return p - bows_.chord[e];
  }

  /// Directions in which the node of edge e may move, in the first columns; the others are zero.
  Mat3 directions(int e) const {
    const CadPlace& place = bows_.place[e];
    const Vec3 p = bows_.chord[e] + bows_.bow[e];
    Mat3 basis = Mat3::Zero();
    if (place.dim == 1) {
      basis.col(0) = projector_.project_to_edge(place.entity, p, &place.uv[0]).tangent;
    } else if (place.dim == 2) {
      const Vec3 n = projector_.project_to_face(place.entity, p, &place.uv).normal;
      basis.col(0) = n.unitOrthogonal();
      basis.col(1) = n.cross(basis.col(0));
    } else {
      basis.setIdentity();
    }
    return basis;
  }

  /// Move one mid-side node to where the elements around it lack least. False when it stays.
  bool improve(int e) {
    around_.clear();
    for (int u = first_[e]; u < first_[e + 1]; ++u) {
      const auto [h, local] = use_[u];
      const Hex20 x = bent_element(complex_, edges_, bows_, h);
      const double s = 1 / scale(h);
      around_.push_back({jacobian_bernstein(x), jacobian_bernstein_slopes(x, 8 + local)});
      for (double& v : around_.back().value) v *= s;
      for (Vec3& v : around_.back().slope) v *= s;
    }
    const double length = bows_.length[e], before = lack(around_, Vec3::Zero(), length, nullptr, nullptr);
    lacked_ += before;
    const Mat3 basis = directions(e);
    Vec3 d = Vec3::Zero();
    double now = before;
    for (int k = 0; k < kNewton; ++k) {
      Vec3 slope;
      Mat3 curvature;
      lack(around_, d, length, &slope, &curvature);
      // Forbidden directions get a unit curvature and no slope: no step along them.
      Mat3 reduced = basis.transpose() * curvature * basis;
      for (int i = 0; i < 3; ++i)
        if (basis.col(i).isZero(0)) reduced(i, i) = 1;
      Vec3 step = -basis * reduced.ldlt().solve(basis.transpose() * slope);
      double next = lack(around_, d + step, length, nullptr, nullptr);
      for (int half = 0; half < kShorter && !(next < now); ++half) next = lack(around_, d + (step *= 0.5), length, nullptr, nullptr);
      if (!(next < now)) break;
      const bool little = now - next < 1e-3 * now;
      d += step;
      now = next;
      if (little) break;
    }
    const double most = 0.5 * length;
    if (d.norm() > most) d *= most / d.norm();
    // On the CAD the node ends beside where the plane or the line of its directions leads.
    for (int half = 0; half < kShorter; ++half, d *= 0.5) {
      const Vec3 bow = moved(e, d);
      const double after = lack(around_, bow - bows_.bow[e], length, nullptr, nullptr);
      if (!(after < before * (1 - 1e-6))) continue;
      gained_ += before - after;
      bows_.bow[e] = bow;
      if (bows_.place[e].dim == 1) put_on_edge(bows_, e, projector_);
      if (bows_.place[e].dim == 2) put_on_face(bows_, e, projector_);
      return true;
    }
    return false;
  }

  const HexComplex& complex_;
  const MeshEdges& edges_;
  const Projector& projector_;
  Bows& bows_;
  Context& context_;
  std::vector<int> first_;  // of an edge in use_
  std::vector<Use> use_;
  std::vector<Around> around_;
  std::vector<double> scale_;       // of the elements met so far
  double lacked_ = 0, gained_ = 0;  // in this round, over the nodes moved
};

}  // namespace

std::vector<int> unfold(const HexComplex& complex, const MeshEdges& edges, const Projector& projector, const std::vector<int>& bad,
                        Bows& bows, Context& context) {
  if (bad.empty()) return bad;
  return Unfolding(complex, edges, projector, bows, context).run(bad);
}

}  // namespace hexfeature
