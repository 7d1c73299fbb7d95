// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include <Geom_Surface.hxx>
#include <TopoDS_Face.hxx>

#include "base/types.h"
#include "mesh/geometry.h"

namespace hexfeature {

/// Point and derivatives of a surface.
struct SurfaceJet {
  Vec3 p, du, dv, duu, duv, dvv;
};

/// The untrimmed surface of one CAD face, in the file's frame: evaluation and closest points. Plane, cylinder, cone,
/// sphere and torus in closed form; everything else through OCCT's evaluators (which have no mutable caches, so that
/// all functions are thread-safe). Parameters are OCCT's: those of the face's own (u,v) space.
struct FaceGeometry {
  SurfaceKind native = SurfaceKind::Other;  ///< which closed form holds
  Vec3 origin = Vec3::Zero(), x = Vec3::UnitX(), y = Vec3::UnitY(), z = Vec3::UnitZ();
  double radius = 0, radius2 = 0;                                 ///< cylinder, sphere, cone (at v = 0), torus major; torus minor
  double sine = 0, cosine = 1;                                    ///< cone: of the half angle
  bool reversed = false;                                          ///< outward normal is -(Su x Sv)
  double handed = 1;                                              ///< sign of (x cross y) . z
  Vec2 lower = Vec2::Zero(), upper = Vec2::Zero();                ///< parameter box of the trimmed face
  Vec2 domain_lower = Vec2::Zero(), domain_upper = Vec2::Zero();  ///< of the surface itself (splines end there)
  Vec2 period = Vec2::Zero();                                     ///< 0: not periodic
  Handle(Geom_Surface) surface;

  explicit FaceGeometry(const TopoDS_Face& face);

  Vec3 point(const Vec2& uv) const;
  SurfaceJet jet1(const Vec2& uv) const;  ///< p, du, dv
  SurfaceJet jet2(const Vec2& uv) const;
  /// Outward unit normal; zero where the surface has none (a spline's pole).
  Vec3 normal(const Vec2& uv) const;
  /// Normal as seen from `inside` (parameters of a point of the face nearby): at poles the limit from there.
  Vec3 normal_towards(const Vec2& uv, const Vec2& inside) const;

  /// Parameters of the point of the untrimmed surface closest to `p`, near `guess` (which matters for splines alone, and
  /// for the turn that periodic parameters are given in). Returns false when Newton did not settle.
  bool closest(const Vec3& p, const Vec2& guess, Vec2& uv) const;
  /// `uv` moved by whole periods to lie next to `reference`.
  Vec2 nearest_turn(Vec2 uv, const Vec2& reference) const;

 private:
  void normal_jet(const Vec2& uv, Vec3& n, double& scale) const;
  bool newton(const Vec3& p, Vec2& uv) const;
};

}  // namespace hexfeature
