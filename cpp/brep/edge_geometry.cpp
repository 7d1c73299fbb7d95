// HexFeatureWB - LGPL-2.1-or-later
#include "brep/edge_geometry.h"

#include <BRep_Tool.hxx>
#include <GCPnts_AbscissaPoint.hxx>
#include <GeomAdaptor_Curve.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_Circle.hxx>
#include <Geom_Line.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <algorithm>
#include <cmath>
#include <limits>

#include "brep/occt.h"

namespace hexfeature {

EdgeGeometry::EdgeGeometry(const TopoDS_Edge& edge) {
  if (BRep_Tool::Degenerated(edge)) {
    BRep_Tool::Range(edge, t0, t1);
    return;
  }
  curve = BRep_Tool::Curve(edge, t0, t1);
  if (curve.IsNull()) {
    BRep_Tool::Range(edge, t0, t1);
    return;
  }
  while (true) {
    const auto trimmed = Handle(Geom_TrimmedCurve)::DownCast(curve);
    if (trimmed.IsNull()) break;
    curve = trimmed->BasisCurve();
  }
  kind = Kind::Other;
  if (const auto line = Handle(Geom_Line)::DownCast(curve); !line.IsNull()) {
    kind = Kind::Line;
    origin = to_eigen(line->Position().Location());
    x = to_eigen(line->Position().Direction());
  } else if (const auto circle = Handle(Geom_Circle)::DownCast(curve); !circle.IsNull()) {
    kind = Kind::Circle;
    origin = to_eigen(circle->Position().Location());
    x = to_eigen(circle->Position().XDirection());
    y = to_eigen(circle->Position().YDirection());
    radius = circle->Radius();
  }
  int samples = 32;
  if (const auto spline = Handle(Geom_BSplineCurve)::DownCast(curve); !spline.IsNull())
    samples = std::clamp(4 * spline->NbKnots(), 32, 512);
  Vec3 last = point(t0);
  for (int i = 0; i <= samples; ++i) {
    const double t = i == samples ? t1 : t0 + (t1 - t0) * i / samples;
    const Vec3 p = point(t);
    size += (p - last).norm();
    last = p;
    if (kind == Kind::Other) {
      sample_t.push_back(t);
      sample_p.push_back(p);
    }
  }
  closed = (point(t0) - point(t1)).norm() < 1e-6 * size;
}

Vec3 EdgeGeometry::point(double t) const {
  switch (kind) {
    case Kind::Line:
      return origin + t * x;
    case Kind::Circle:
      return origin + radius * (std::cos(t) * x + std::sin(t) * y);
    case Kind::Other:
      return to_eigen(curve->Value(t));
    default:
      return origin;
  }
}

Vec3 EdgeGeometry::derivative(double t) const {
  switch (kind) {
    case Kind::Line:
      return x;
    case Kind::Circle:
      return radius * (std::cos(t) * y - std::sin(t) * x);
    case Kind::Other: {
      gp_Pnt p;
      gp_Vec d;
      curve->D1(t, p, d);
      return to_eigen(d);
    }
    default:
      return Vec3::Zero();
  }
}

Vec3 EdgeGeometry::tangent(double t) const {
  const Vec3 d = derivative(t);
  const double range = t1 - t0, n = d.norm();
  if (n * range > 1e-9 * size) return d / n;
  const double e = 1e-4 * range;
  const Vec3 chord = point(std::min(t + e, t1)) - point(std::max(t - e, t0));
  return chord.norm() > 0 ? Vec3(chord.normalized()) : Vec3::Zero();
}

double EdgeGeometry::closest(const Vec3& p, const double* guess) const {
  if (kind == Kind::None) return t0;
  if (kind == Kind::Line) return std::clamp((p - origin).dot(x), t0, t1);
  if (kind == Kind::Circle) {
    const Vec3 d = p - origin;
    const double a = d.dot(x), b = d.dot(y), turn = 2 * EIGEN_PI;
    if (std::hypot(a, b) < 1e-12 * radius) return guess != nullptr ? std::clamp(*guess, t0, t1) : t0;
    double t = std::atan2(b, a);
    t += turn * std::ceil((t0 - t) / turn);
    if (t <= t1) return t;
    return t - t1 < t0 + turn - t ? t1 : t0;  // in the gap: the nearer end
  }
  if (guess != nullptr) {
    double t = std::clamp(*guess, t0, t1);
    const double before = (point(t) - p).squaredNorm();
    if (newton(p, t) && (point(t) - p).squaredNorm() <= before * (1 + 1e-9) + 1e-24 * size * size) return t;
  }
  return from_samples(p);
}

double EdgeGeometry::from_samples(const Vec3& p) const {
  // The closest piece of the polyline, and its neighbours: a curve may come close to itself.
  double best_t = t0, best = std::numeric_limits<double>::max();
  const auto offer = [&](double t) {
    const double d = (point(t) - p).squaredNorm();
    if (d < best) {
      best = d;
      best_t = t;
    }
  };
  std::size_t nearest = 0;
  double nearest2 = std::numeric_limits<double>::max();
  for (std::size_t i = 0; i + 1 < sample_p.size(); ++i) {
    const Vec3 e = sample_p[i + 1] - sample_p[i];
    const double s = std::clamp(e.squaredNorm() > 0 ? (p - sample_p[i]).dot(e) / e.squaredNorm() : 0.0, 0.0, 1.0);
    const double d = (sample_p[i] + s * e - p).squaredNorm();
    if (d < nearest2) {
      nearest2 = d;
      nearest = i;
    }
  }
  for (const std::size_t i : {nearest, nearest + 1}) {
    double t = sample_t[i];
    offer(t);
    newton(p, t);
    offer(t);
  }
  double t = 0.5 * (sample_t[nearest] + sample_t[nearest + 1]);
  newton(p, t);
  offer(t);
  return best_t;
}

bool EdgeGeometry::newton(const Vec3& p, double& t) const {
  const double range = t1 - t0;
  gp_Pnt q;
  gp_Vec d1, d2;
  const auto wrap = [&](double s) {
    if (closed) return s - range * std::floor((s - t0) / range);
    return std::clamp(s, t0, t1);
  };
  for (int iteration = 0; iteration < 30; ++iteration) {
    curve->D2(t, q, d1, d2);
    const Vec3 r = to_eigen(q) - p, c1 = to_eigen(d1), c2 = to_eigen(d2);
    const double g = r.dot(c1), e = c1.squaredNorm();
    double h = e + r.dot(c2);
    if (!(h > 0.05 * e)) h = e;
    if (!(h > 0)) return false;
    double step = std::clamp(-g / h, -0.2 * range, 0.2 * range);
    double next = wrap(t + step);
    const double before = r.squaredNorm();
    for (int halving = 0; halving < 12; ++halving) {
      if ((point(next) - p).squaredNorm() <= before * (1 + 1e-12) + 1e-28 * size * size) break;
      step *= 0.5;
      next = wrap(t + step);
    }
    const double moved = std::abs(next - t);
    t = next;
    if (std::min(moved, std::abs(range - moved)) < 1e-13 * range || moved * std::sqrt(e) < 1e-12 * size) return true;
  }
  return false;
}

double EdgeGeometry::length(double a, double b) const {
  if (kind == Kind::None) return 0;
  if (kind == Kind::Line) return b - a;
  if (kind == Kind::Circle) return radius * (b - a);
  if (a <= t0 && b >= t1) return GCPnts_AbscissaPoint::Length(GeomAdaptor_Curve(curve), t0, t1);
  // Gauss, 4 points on each of 8 pieces.
  constexpr double node[4] = {-0.8611363115940526, -0.3399810435848563, 0.3399810435848563, 0.8611363115940526};
  constexpr double weight[4] = {0.3478548451374538, 0.6521451548625461, 0.6521451548625461, 0.3478548451374538};
  double sum = 0;
  const double half = (b - a) / 16;
  for (int i = 0; i < 8; ++i)
    for (int k = 0; k < 4; ++k) sum += weight[k] * half * derivative(a + half * (2 * i + 1 + node[k])).norm();
  return sum;
}

}  // namespace hexfeature
