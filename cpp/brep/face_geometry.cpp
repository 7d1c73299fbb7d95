// HexFeatureWB - LGPL-2.1-or-later
#include "brep/face_geometry.h"

#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Plane.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <algorithm>
#include <cmath>

#include "brep/occt.h"

namespace hexfeature {

FaceGeometry::FaceGeometry(const TopoDS_Face& face) {
  surface = BRep_Tool::Surface(face);
  while (true) {
    const auto trimmed = Handle(Geom_RectangularTrimmedSurface)::DownCast(surface);
    if (trimmed.IsNull()) break;
    surface = trimmed->BasisSurface();
  }
  reversed = face.Orientation() == TopAbs_REVERSED;
  BRepTools::UVBounds(face, lower[0], upper[0], lower[1], upper[1]);
  surface->Bounds(domain_lower[0], domain_upper[0], domain_lower[1], domain_upper[1]);
  if (surface->IsUPeriodic()) period[0] = surface->UPeriod();
  if (surface->IsVPeriodic()) period[1] = surface->VPeriod();

  const auto take = [&](const gp_Ax3& a) {
    origin = to_eigen(a.Location());
    x = to_eigen(a.XDirection());
    y = to_eigen(a.YDirection());
    z = to_eigen(a.Direction());
    handed = x.cross(y).dot(z) < 0 ? -1 : 1;
  };
  if (const auto s = Handle(Geom_Plane)::DownCast(surface); !s.IsNull()) {
    native = SurfaceKind::Plane;
    take(s->Position());
  } else if (const auto c = Handle(Geom_CylindricalSurface)::DownCast(surface); !c.IsNull()) {
    native = SurfaceKind::Cylinder;
    take(c->Position());
    radius = c->Radius();
  } else if (const auto k = Handle(Geom_ConicalSurface)::DownCast(surface); !k.IsNull()) {
    native = SurfaceKind::Cone;
    take(k->Position());
    radius = k->RefRadius();
    sine = std::sin(k->SemiAngle());
    cosine = std::cos(k->SemiAngle());
  } else if (const auto b = Handle(Geom_SphericalSurface)::DownCast(surface); !b.IsNull()) {
    native = SurfaceKind::Sphere;
    take(b->Position());
    radius = b->Radius();
  } else if (const auto t = Handle(Geom_ToroidalSurface)::DownCast(surface); !t.IsNull() && t->MajorRadius() > t->MinorRadius()) {
    native = SurfaceKind::Torus;
    take(t->Position());
    radius = t->MajorRadius();
    radius2 = t->MinorRadius();
  }
}

SurfaceJet FaceGeometry::jet2(const Vec2& uv) const {
  gp_Pnt p;
  gp_Vec du, dv, duu, dvv, duv;
  surface->D2(uv[0], uv[1], p, du, dv, duu, dvv, duv);
  return {to_eigen(p), to_eigen(du), to_eigen(dv), to_eigen(duu), to_eigen(duv), to_eigen(dvv)};
}

SurfaceJet FaceGeometry::jet1(const Vec2& uv) const {
  const double u = uv[0], v = uv[1];
  const Vec3 none = Vec3::Zero();
  if (native == SurfaceKind::Plane) return {origin + u * x + v * y, x, y, none, none, none};
  if (native == SurfaceKind::Other) {
    gp_Pnt p;
    gp_Vec du, dv;
    surface->D1(u, v, p, du, dv);
    return {to_eigen(p), to_eigen(du), to_eigen(dv), none, none, none};
  }
  const Vec3 radial = std::cos(u) * x + std::sin(u) * y, around = std::cos(u) * y - std::sin(u) * x;
  switch (native) {
    case SurfaceKind::Cylinder:
      return {origin + radius * radial + v * z, radius * around, z, none, none, none};
    case SurfaceKind::Cone: {
      const double r = radius + v * sine;
      return {origin + r * radial + v * cosine * z, r * around, sine * radial + cosine * z, none, none, none};
    }
    case SurfaceKind::Sphere: {
      const double c = std::cos(v), s = std::sin(v);
      return {origin + radius * (c * radial + s * z), radius * c * around, radius * (c * z - s * radial), none, none, none};
    }
    default: {
      const double c = std::cos(v), s = std::sin(v), r = radius + radius2 * c;
      return {origin + r * radial + radius2 * s * z, r * around, radius2 * (c * z - s * radial), none, none, none};
    }
  }
}

Vec3 FaceGeometry::point(const Vec2& uv) const {
  if (native != SurfaceKind::Other) return jet1(uv).p;
  gp_Pnt p;
  surface->D0(uv[0], uv[1], p);
  return to_eigen(p);
}

Vec3 FaceGeometry::normal(const Vec2& uv) const {
  const double sign = (reversed ? -1 : 1) * handed;
  const double u = uv[0], v = uv[1];
  const Vec3 radial = native == SurfaceKind::Other ? Vec3::Zero() : Vec3(std::cos(u) * x + std::sin(u) * y);
  switch (native) {
    case SurfaceKind::Plane:
      return sign * z;
    case SurfaceKind::Cylinder:
      return sign * radial;
    case SurfaceKind::Cone:
      return (radius + v * sine < -1e-9 * (1 + std::abs(radius)) ? -sign : sign) * (cosine * radial - sine * z);
    case SurfaceKind::Sphere:
    case SurfaceKind::Torus:
      return sign * (std::cos(v) * radial + std::sin(v) * z);
    default:
      break;
  }
  const SurfaceJet j = jet1(uv);
  const Vec3 n = j.du.cross(j.dv);
  const double scale = j.du.norm() * j.dv.norm(), length = n.norm();
  const Vec2 extent = upper - lower;
  const double a = j.du.norm() * extent[0], b = j.dv.norm() * extent[1];
  if (!(length > 1e-8 * scale) || !(std::min(a, b) > 1e-6 * std::max(a, b))) return Vec3::Zero();
  return (reversed ? -1 / length : 1 / length) * n;
}

Vec3 FaceGeometry::normal_towards(const Vec2& uv, const Vec2& inside) const {
  if (native == SurfaceKind::Cone) {
    // At the apex only u decides; a little inside, the right nappe does too.
    return normal(uv + 0.01 * (inside - uv));
  }
  Vec3 n = normal(uv);
  for (double s = 0.001; n.isZero() && s < 0.5; s *= 8) n = normal(uv + s * (inside - uv));
  return n;
}

Vec2 FaceGeometry::nearest_turn(Vec2 uv, const Vec2& reference) const {
  for (int k = 0; k < 2; ++k)
    if (period[k] > 0) uv[k] += period[k] * std::round((reference[k] - uv[k]) / period[k]);
  return uv;
}

bool FaceGeometry::closest(const Vec3& p, const Vec2& guess, Vec2& uv) const {
  const Vec3 d = p - origin;
  const double a = d.dot(x), b = d.dot(y), c = d.dot(z), rho = std::hypot(a, b);
  const double tiny = 1e-12 * (radius + rho);
  switch (native) {
    case SurfaceKind::Plane:
      uv = {a, b};
      return true;
    case SurfaceKind::Cylinder:
      uv = {rho > tiny ? std::atan2(b, a) : guess[0], c};
      break;
    case SurfaceKind::Cone: {
      // In the half plane through the axis the cone is a line; its other nappe is the line of the opposite direction.
      const double u = rho > tiny ? std::atan2(b, a) : guess[0];
      const double near_v = (rho - radius) * sine + c * cosine, far_v = (-rho - radius) * sine + c * cosine;
      const double v_middle = 0.5 * (lower[1] + upper[1]);
      const bool positive = radius + v_middle * sine >= 0;
      const double v = positive ? near_v : far_v;
      // Beyond the apex the closest point is the apex itself.
      const double apex = sine != 0 ? -radius / sine : 0;
      const bool beyond = sine != 0 && (radius + v * sine >= 0) != positive;
      uv = {positive ? u : u + EIGEN_PI, beyond ? apex : v};
      break;
    }
    case SurfaceKind::Sphere:
      uv = {rho > tiny ? std::atan2(b, a) : guess[0], std::atan2(c, rho)};
      break;
    case SurfaceKind::Torus: {
      const double w = rho - radius;
      uv = {rho > tiny ? std::atan2(b, a) : guess[0], std::hypot(w, c) > tiny ? std::atan2(c, w) : guess[1]};
      break;
    }
    default:
      uv = guess;
      return newton(p, uv);
  }
  uv = nearest_turn(uv, guess);
  return true;
}

// Newton on the gradient of half the squared distance; Gauss-Newton where the Hessian is not positive (far inside a
// concave side), a halved step where the distance would grow, and at the ends of the domain in the free parameter alone.
bool FaceGeometry::newton(const Vec3& p, Vec2& uv) const {
  const Vec2 extent = (upper - lower).cwiseMax(1e-300);
  const auto clamp = [&](Vec2& w) {
    for (int k = 0; k < 2; ++k)
      if (period[k] <= 0) w[k] = std::clamp(w[k], domain_lower[k], domain_upper[k]);
  };
  clamp(uv);
  SurfaceJet j = jet2(uv);
  double distance2 = (j.p - p).squaredNorm();
  const double scale = std::max({j.du.norm() * extent[0], j.dv.norm() * extent[1], 1e-30});
  for (int iteration = 0; iteration < 30; ++iteration) {
    const Vec3 r = j.p - p;
    const double gu = r.dot(j.du), gv = r.dot(j.dv);
    bool fixed[2] = {false, false};
    for (int k = 0; k < 2; ++k) {
      const double g = k == 0 ? gu : gv;
      if (period[k] <= 0) fixed[k] = (uv[k] <= domain_lower[k] && g > 0) || (uv[k] >= domain_upper[k] && g < 0);
    }
    const double euu = j.du.squaredNorm(), euv = j.du.dot(j.dv), evv = j.dv.squaredNorm();
    double huu = euu + r.dot(j.duu), huv = euv + r.dot(j.duv), hvv = evv + r.dot(j.dvv);
    if (!(huu > 0.05 * euu && hvv > 0.05 * evv && huu * hvv - huv * huv > 0.05 * (euu * evv - euv * euv))) {
      huu = euu;
      huv = euv;
      hvv = evv;
    }
    Vec2 step = Vec2::Zero();
    if (fixed[0] && fixed[1]) return true;
    if (fixed[0])
      step[1] = hvv > 0 ? -gv / hvv : 0;
    else if (fixed[1])
      step[0] = huu > 0 ? -gu / huu : 0;
    else {
      const double det = huu * hvv - huv * huv;
      if (det > 1e-14 * huu * hvv)
        step = Vec2(-hvv * gu + huv * gv, huv * gu - huu * gv) / det;
      else
        step = Vec2(huu > 1e-20 * scale * scale ? -gu / huu : 0, hvv > 1e-20 * scale * scale ? -gv / hvv : 0);  // a pole
    }
    if (!step.allFinite()) return false;
    const double longest = std::max(std::abs(step[0]) / extent[0], std::abs(step[1]) / extent[1]);
    if (longest > 0.3) step *= 0.3 / longest;
    Vec2 next = uv + step;
    clamp(next);
    SurfaceJet k = jet2(next);
    double next2 = (k.p - p).squaredNorm();
    for (int halving = 0; next2 > distance2 * (1 + 1e-12) + 1e-28 * scale * scale && halving < 12; ++halving) {
      step *= 0.5;
      next = uv + step;
      clamp(next);
      k = jet2(next);
      next2 = (k.p - p).squaredNorm();
    }
    const double moved = (k.p - j.p).norm(),
                 parameter = std::max(std::abs(next[0] - uv[0]) / extent[0], std::abs(next[1] - uv[1]) / extent[1]);
    uv = next;
    j = k;
    distance2 = next2;
    if (moved < 1e-11 * scale || parameter < 1e-14) return true;
  }
  return false;
}

}  // namespace hexfeature
