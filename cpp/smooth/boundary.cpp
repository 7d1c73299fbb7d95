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
                   Workers& workers)
    : projector_(projector), size_(size), workers_(workers) {
  for (int v = 0; v < static_cast<int>(place.size()); ++v) {
    if (!free[v] || place[v].dim == 0) fixed_.push_back(v);
    if (!free[v] || place[v].dim < 0 || place[v].dim > 2) continue;
    node_.push_back(v);
    entity_.push_back(place[v].entity);
    dim_.push_back(static_cast<char>(place[v].dim));
    motion_.push_back(place[v].dim == 0 ? Motion::Fixed : place[v].dim == 1 ? Motion::Line : Motion::Plane);
    parameter_.push_back(place[v].uv);
  }
  const std::size_t n = node_.size();
  clamped_.assign(n, 0);
  for (auto* list : {&foot_, &origin_, &axis_, &outward_, &line_}) list->assign(n, Vec3::Zero());
}

void Boundary::find_foot(int i, const Vec3& p) {
  origin_[i] = p;
  clamped_[i] = 0;
  if (dim_[i] == 0) {
    foot_[i] = projector_.vertex_point(entity_[i]);
    return;
  }
  if (dim_[i] == 1) {
    const CurvePoint c = projector_.project_to_edge(entity_[i], p, &parameter_[i][0]);
    if (!c.point.allFinite() || !c.tangent.allFinite()) return;  // defective geometry: the last foot stays
    foot_[i] = c.point;
    axis_[i] = line_[i] = c.tangent;
    parameter_[i][0] = c.t;
    motion_[i] = Motion::Line;
    const double along = c.tangent.dot(p - c.point), across = (p - c.point - along * c.tangent).norm();
    clamped_[i] = std::abs(along) > 1e-3 * size_ && std::abs(along) > 0.3 * across;
    if (clamped_[i]) outward_[i] = along > 0 ? c.tangent : Vec3(-c.tangent);
    return;
  }
  const FacePoint f = projector_.project_to_face(entity_[i], p, &parameter_[i]);
  if (!f.point.allFinite() || !f.normal.allFinite()) return;
  foot_[i] = f.point;
  axis_[i] = f.normal;
  parameter_[i] = f.uv;
  motion_[i] = Motion::Plane;
  // Without trimming, points would run along the plane's extension (experiments B7).
  const double height = f.normal.dot(p - f.point);
  const Vec3 side = p - f.point - height * f.normal;
  const double offset = side.norm();
  clamped_[i] = offset > 1e-3 * size_ && offset > 0.3 * std::abs(height);
  if (clamped_[i]) outward_[i] = side / offset;
}

double Boundary::find_feet(const std::vector<double>& x) {
  const int n = static_cast<int>(node_.size());
  workers_.run(n, 64, [&](int begin, int end) {
    for (int i = begin; i < end; ++i) find_foot(i, at(x, node_[i]));
  });
  double deviation = 0;
  for (int i = 0; i < n; ++i) deviation = std::max(deviation, (foot_[i] - origin_[i]).squaredNorm());
  return std::sqrt(deviation);
}

void Boundary::find_feet(const std::vector<double>& x, const std::vector<char>& which) {
  workers_.run(static_cast<int>(node_.size()), 64, [&](int begin, int end) {
    for (int i = begin; i < end; ++i)
      if (which[node_[i]]) find_foot(i, at(x, node_[i]));
  });
}

void Boundary::snap(std::vector<double>& x) {
  for (std::size_t i = 0; i < node_.size(); ++i) at(x, node_[i]) = origin_[i] = foot_[i];
}

void Boundary::hold_at_rims(const std::vector<double>& gradient) {
  for (std::size_t i = 0; i < node_.size(); ++i) {
    if (dim_[i] == 0) continue;
    const bool outward = clamped_[i] && at(gradient, node_[i]).dot(outward_[i]) < 0;
    if (dim_[i] == 1) {
      motion_[i] = outward ? Motion::Fixed : Motion::Line;
    } else {
      motion_[i] = outward ? Motion::Line : Motion::Plane;
      if (outward) line_[i] = axis_[i].cross(outward_[i]);
    }
  }
}

void Boundary::make_tangent(std::vector<double>& gradient) const {
  fix_corners(gradient);
  for (std::size_t i = 0; i < node_.size(); ++i) {
    auto g = at(gradient, node_[i]);
    if (motion_[i] == Motion::Fixed)
      g.setZero();
    else if (motion_[i] == Motion::Line)
      g = line_[i].dot(g) * line_[i];
    else
      g -= axis_[i].dot(g) * axis_[i];
  }
}

void Boundary::fix_corners(std::vector<double>& gradient) const {
  for (int v : fixed_) at(gradient, v).setZero();
}

/// The part of an offset that is penalised: off the plane, off the line; all of it where the foot is on the rim.
Vec3 Boundary::penalised(int i, const Vec3& d) const {
  if (clamped_[i]) return d;
  const Vec3 along = axis_[i].dot(d) * axis_[i];
  return dim_[i] == 2 ? along : Vec3(d - along);
}

double Boundary::add_penalty(const std::vector<double>& x, double weight, std::vector<double>& gradient) const {
  const double factor = weight / (size_ * size_);
  double energy = 0;
  for (std::size_t i = 0; i < node_.size(); ++i) {
    if (dim_[i] == 0) continue;
    const Vec3 off = penalised(static_cast<int>(i), at(x, node_[i]) - foot_[i]);
    energy += off.squaredNorm();
    at(gradient, node_[i]) += 2 * factor * off;
  }
  return factor * energy;
}

void Boundary::divide(std::vector<double>& r, const std::vector<double>& stiffness, double weight) const {
  for (int v = 0; v < static_cast<int>(stiffness.size()); ++v) at(r, v) /= stiffness[v];
  if (!(weight > 0)) return;
  const double extra = 2 * weight / (size_ * size_);
  for (std::size_t i = 0; i < node_.size(); ++i) {
    if (dim_[i] == 0) continue;
    const double k = stiffness[node_[i]];
    auto v = at(r, node_[i]);
    v -= extra / (k + extra) * penalised(static_cast<int>(i), v);
  }
}

bool Boundary::drifted(const std::vector<double>& x, double limit) const {
  for (std::size_t i = 0; i < node_.size(); ++i)
    if ((at(x, node_[i]) - origin_[i]).squaredNorm() > limit * limit) return true;
  return false;
}

void Boundary::store(std::vector<CadPlace>& place) const {
  for (std::size_t i = 0; i < node_.size(); ++i)
    if (dim_[i] > 0) place[node_[i]].uv = parameter_[i];
}

}  // namespace hexfeature
