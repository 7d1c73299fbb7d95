// HexFeatureWB - LGPL-2.1-or-later
#include "smooth/boundary.h"

#include <algorithm>
#include <cmath>

namespace hexfeature {
namespace {

inline Eigen::Map<const Vec3> at(const std::vector<double>& x, int v) { return Eigen::Map<const Vec3>(x.data() + 3 * v); }
inline Eigen::Map<Vec3> at(std::vector<double>& x, int v) { return Eigen::Map<Vec3>(x.data() + 3 * v); }

}  // namespace

Boundary::Boundary(const std::vector<CadPlace>& place, const std::vector<char>& free, const Projector& projector, double size,
                   Workers& workers, const Context& context)
    : projector_(projector), size_(size), workers_(workers), context_(context) {
  for (int v = 0; v < static_cast<int>(place.size()); ++v) {
    if (!free[v] || place[v].dim == 0) fixed_.push_back(v);
    if (!free[v] || place[v].dim < 0 || place[v].dim > 2) continue;
    node_.push_back(v);
    entity_.push_back(place[v].entity);
    dim_.push_back(static_cast<char>(place[v].dim));
    feet_.motion.push_back(place[v].dim == 0 ? Motion::Fixed : place[v].dim == 1 ? Motion::Line : Motion::Plane);
    feet_.parameter.push_back(place[v].uv);
  }
  const std::size_t n = node_.size();
  feet_.clamped.assign(n, 0);
  for (auto* list : {&feet_.foot, &feet_.origin, &feet_.axis, &feet_.outward, &feet_.line}) list->assign(n, Vec3::Zero());
}

void Boundary::find_foot(int i, const Vec3& p) {
  feet_.origin[i] = p;
  feet_.clamped[i] = 0;
  if (dim_[i] == 0) {
    feet_.foot[i] = projector_.vertex_point(entity_[i]);
    return;
  }
  if (dim_[i] == 1) {
    const CurvePoint c = projector_.project_to_edge(entity_[i], p, &feet_.parameter[i][0]);
    if (!c.point.allFinite() || !c.tangent.allFinite()) return;  // defective geometry: the last foot stays
    feet_.foot[i] = c.point;
    feet_.axis[i] = feet_.line[i] = c.tangent;
    feet_.parameter[i][0] = c.t;
    feet_.motion[i] = Motion::Line;
    const double along = c.tangent.dot(p - c.point), across = (p - c.point - along * c.tangent).norm();
    feet_.clamped[i] = std::abs(along) > 1e-3 * size_ && std::abs(along) > 0.3 * across;
    if (feet_.clamped[i]) feet_.outward[i] = along > 0 ? c.tangent : Vec3(-c.tangent);
    return;
  }
  const FacePoint f = projector_.project_to_face(entity_[i], p, &feet_.parameter[i]);
  if (!f.point.allFinite() || !f.normal.allFinite()) return;
  feet_.foot[i] = f.point;
  feet_.axis[i] = f.normal;
  feet_.parameter[i] = f.uv;
  feet_.motion[i] = Motion::Plane;
  // Without trimming, points would run along the plane's extension (experiments B7).
  const double height = f.normal.dot(p - f.point);
  const Vec3 side = p - f.point - height * f.normal;
  const double offset = side.norm();
  feet_.clamped[i] = offset > 1e-3 * size_ && offset > 0.3 * std::abs(height);
  if (feet_.clamped[i]) feet_.outward[i] = side / offset;
}

double Boundary::find_feet(const std::vector<double>& x) {
  const int n = static_cast<int>(node_.size());
  workers_.run(n, 64, [&](int begin, int end) {
    for (int i = begin; i < end; ++i) {
      breathe(i);
      find_foot(i, at(x, node_[i]));
    }
  });
  double deviation = 0;
  for (int i = 0; i < n; ++i) deviation = std::max(deviation, (feet_.foot[i] - feet_.origin[i]).squaredNorm());
  return std::sqrt(deviation);
}

void Boundary::find_feet(const std::vector<double>& x, const std::vector<char>& which) {
  workers_.run(static_cast<int>(node_.size()), 64, [&](int begin, int end) {
    for (int i = begin; i < end; ++i) {
      breathe(i);
      if (which[node_[i]]) find_foot(i, at(x, node_[i]));
    }
  });
}

void Boundary::snap(std::vector<double>& x) {
  for (std::size_t i = 0; i < node_.size(); ++i) at(x, node_[i]) = feet_.origin[i] = feet_.foot[i];
}

void Boundary::place_on_feet(std::vector<double>& x) const {
  for (std::size_t i = 0; i < node_.size(); ++i) at(x, node_[i]) = feet_.foot[i];
}

void Boundary::hold_at_rims(const std::vector<double>& gradient) {
  for (std::size_t i = 0; i < node_.size(); ++i) {
    if (dim_[i] == 0) continue;
    const bool outward = feet_.clamped[i] && at(gradient, node_[i]).dot(feet_.outward[i]) < 0;
    if (dim_[i] == 1) {
      feet_.motion[i] = outward ? Motion::Fixed : Motion::Line;
    } else {
      feet_.motion[i] = outward ? Motion::Line : Motion::Plane;
      if (outward) feet_.line[i] = feet_.axis[i].cross(feet_.outward[i]);
    }
  }
}

void Boundary::make_tangent(std::vector<double>& gradient) const {
  fix_corners(gradient);
  for (std::size_t i = 0; i < node_.size(); ++i) {
    auto g = at(gradient, node_[i]);
    if (feet_.motion[i] == Motion::Fixed)
      g.setZero();
    else if (feet_.motion[i] == Motion::Line)
      g = feet_.line[i].dot(g) * feet_.line[i];
    else
      g -= feet_.axis[i].dot(g) * feet_.axis[i];
  }
}

void Boundary::fix_corners(std::vector<double>& gradient) const {
  for (int v : fixed_) at(gradient, v).setZero();
}

/// The part of an offset that is penalised: off the plane, off the line; all of it where the foot is on the rim.
Vec3 Boundary::penalised(int i, const Vec3& d) const {
  if (feet_.clamped[i]) return d;
  const Vec3 along = feet_.axis[i].dot(d) * feet_.axis[i];
  return dim_[i] == 2 ? along : Vec3(d - along);
}

double Boundary::add_penalty(const std::vector<double>& x, double weight, std::vector<double>& gradient) const {
  const double factor = weight / (size_ * size_);
  double energy = 0;
  for (std::size_t i = 0; i < node_.size(); ++i) {
    if (dim_[i] == 0) continue;
    const Vec3 off = penalised(static_cast<int>(i), at(x, node_[i]) - feet_.foot[i]);
    energy += off.squaredNorm();
    at(gradient, node_[i]) += 2 * factor * off;
  }
  return factor * energy;
}

void Boundary::invert_stiffness(const std::vector<double>& stiffness, double weight, std::vector<double>& inverse) const {
  const int n = static_cast<int>(stiffness.size()) / 6;
  inverse.resize(stiffness.size());
  const auto block = [&](int v) {
    const double* s = stiffness.data() + 6 * v;
    Mat3 k;
    k << s[0], s[5], s[4], s[5], s[1], s[3], s[4], s[3], s[2];
    // A little of the trace: the blocks are sums of few terms.
    const double trace = k.trace();
    k.diagonal().array() += trace > 0 && std::isfinite(trace) ? 1e-3 * trace : 1;
    return k;
  };
  const auto put = [&](int v, const Mat3& m) {
    double* r = inverse.data() + 6 * v;
    if (m.allFinite())
      r[0] = m(0, 0), r[1] = m(1, 1), r[2] = m(2, 2), r[3] = m(1, 2), r[4] = m(0, 2), r[5] = m(0, 1);
    else
      r[0] = r[1] = r[2] = r[3] = r[4] = r[5] = 0;
  };
  workers_.run(n, 512, [&](int begin, int end) {
    for (int v = begin; v < end; ++v) put(v, block(v).inverse());
  });
  const double extra = 2 * weight / (size_ * size_);
  for (std::size_t i = 0; i < node_.size(); ++i) {
    const int v = node_[i];
    Mat3 k = block(v);
    if (weight > 0) {
      if (dim_[i] == 0) continue;
      const Mat3 along = feet_.axis[i] * feet_.axis[i].transpose();
      k += extra * (feet_.clamped[i] ? Mat3(Mat3::Identity()) : dim_[i] == 2 ? along : Mat3(Mat3::Identity() - along));
      put(v, k.inverse());
    } else if (feet_.motion[i] == Motion::Plane) {
      const Mat3 m = k.inverse();
      const Vec3 u = m * feet_.axis[i];
      put(v, m - u * u.transpose() / feet_.axis[i].dot(u));
    } else if (feet_.motion[i] == Motion::Line) {
      put(v, feet_.line[i] * feet_.line[i].transpose() / feet_.line[i].dot(k * feet_.line[i]));
    }
  }
  for (int v : fixed_) put(v, Mat3::Zero());
}

bool Boundary::drifted(const std::vector<double>& x, double limit) const {
  for (std::size_t i = 0; i < node_.size(); ++i)
    if ((at(x, node_[i]) - feet_.origin[i]).squaredNorm() > limit * limit) return true;
  return false;
}

void Boundary::store(std::vector<CadPlace>& place) const {
  for (std::size_t i = 0; i < node_.size(); ++i)
    if (dim_[i] > 0) place[node_[i]].uv = feet_.parameter[i];
}

void Boundary::load(const std::vector<CadPlace>& place) {
  for (std::size_t i = 0; i < node_.size(); ++i)
    if (dim_[i] > 0) feet_.parameter[i] = place[node_[i]].uv;
}

}  // namespace hexfeature
