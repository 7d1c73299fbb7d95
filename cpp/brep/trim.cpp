// HexFeatureWB - LGPL-2.1-or-later
#include "brep/trim.h"

#include <GeomAPI_ProjectPointOnSurf.hxx>
#include <algorithm>
#include <cmath>
#include <limits>

#include "brep/model_impl.h"
#include "brep/occt.h"

namespace hexfeature {
namespace {

/// Foot on the untrimmed surface, near the face.
Vec2 surface_foot(const FaceGeometry& g, const TrimRegion& region, const Vec3& p, const Vec2* guess) {
  const Vec2 middle = 0.5 * (g.lower + g.upper);
  Vec2 uv;
  if (g.native != SurfaceKind::Other) {
    g.closest(p, guess != nullptr ? *guess : middle, uv);
    return uv;
  }
  if (guess != nullptr) {
    const double before = (g.point(*guess) - p).squaredNorm();
    if (g.closest(p, *guess, uv) && (g.point(uv) - p).squaredNorm() <= before * (1 + 1e-9) + 1e-30) return uv;
  }
  // Start from the nearest samples; keep the closest foot.
  constexpr int kStarts = 3;
  int start[kStarts] = {-1, -1, -1};
  double distance[kStarts];
  for (int i = 0; i < static_cast<int>(region.sample_p.size()); ++i) {
    double d = (region.sample_p[i] - p).squaredNorm();
    int k = i;
    for (int s = 0; s < kStarts; ++s)
      if (start[s] < 0 || d < distance[s]) {
        if (start[s] < 0) {
          start[s] = k;
          distance[s] = d;
          break;
        }
        std::swap(start[s], k);
        std::swap(distance[s], d);
      }
  }
  double best = std::numeric_limits<double>::max();
  bool settled = false;
  Vec2 best_uv = middle;
  for (int s = 0; s < kStarts && start[s] >= 0 && !settled; ++s) {
    const bool ok = g.closest(p, region.sample_uv[start[s]], uv);
    const double d = (g.point(uv) - p).squaredNorm();
    if (d < best) {
      best = d;
      best_uv = uv;
    }
    settled = ok && best <= distance[0] * (1 + 1e-9);
  }
  if (settled) return best_uv;
  try {  // rare: OCCT's global search
    GeomAPI_ProjectPointOnSurf search(to_occt(p), g.surface, g.lower[0], g.upper[0], g.lower[1], g.upper[1]);
    if (search.NbPoints() > 0 && search.LowerDistance() * search.LowerDistance() < best)
      search.LowerDistanceParameters(best_uv[0], best_uv[1]);
  } catch (const Standard_Failure&) {
  }
  return best_uv;
}

/// Bring periodic parameters into the face's own box.
Vec2 into_box(const FaceGeometry& g, Vec2 uv) {
  for (int k = 0; k < 2; ++k)
    if (g.period[k] > 0) {
      const double slack = 1e-9 * g.period[k];
      uv[k] -= g.period[k] * std::floor((uv[k] - g.lower[k] + slack) / g.period[k]);
      // Past the end: the nearer side of the gap.
      if (uv[k] > g.upper[k] + slack && uv[k] - g.upper[k] > g.lower[k] + g.period[k] - uv[k]) uv[k] -= g.period[k];
    }
  return uv;
}

}  // namespace

FaceFoot closest_on_face(const CadTables& cad, const TrimRegion& region, int face, const Vec3& p, const Vec2* guess) {
  const FaceGeometry& g = cad.face(face);
  const Vec2 uv = into_box(g, surface_foot(g, region, p, guess));
  const Vec2 middle = 0.5 * (g.lower + g.upper);
  return {g.point(uv), g.normal_towards(uv, middle), uv};
}

std::vector<TrimRegion> make_trim_regions(const CadTables& cad, const BaseMesh& base) {
  std::vector<TrimRegion> regions(cad.faces.size());
  for (int t = 0; t < base.triangle_count(); ++t) {
    const int f = base.triangle_face[t];
    TrimRegion& r = regions[f - 1];
    const FaceGeometry& g = cad.face(f);
    if (g.native == SurfaceKind::Other) {
      const Vec2 uv = (base.corner_uv[3 * t] + base.corner_uv[3 * t + 1] + base.corner_uv[3 * t + 2]) / 3;
      r.sample_uv.push_back(uv);
      r.sample_p.push_back(g.point(uv));
      for (int c = 0; c < 3; ++c) {
        r.sample_uv.push_back(base.corner_uv[3 * t + c]);
        r.sample_p.push_back(base.points[base.triangles[t][c]]);
      }
    }
  }
  return regions;
}

}  // namespace hexfeature
