// HexFeatureWB - LGPL-2.1-or-later
#include "brep/trim.h"

#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <GeomAPI_ProjectPointOnSurf.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
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

/// The closest point of the face's border to a point.
struct BorderFoot {
  const TrimRegion::Piece* piece = nullptr;
  double t = 0;
  Vec3 point = Vec3::Zero();
  bool at_end = false;  ///< at an end of the edge
};

double chord_distance(const TrimRegion::Piece& piece, const Vec3& p, double& s) {
  const Vec3 e = piece.b - piece.a;
  const double e2 = e.squaredNorm();
  s = e2 > 0 ? std::clamp((p - piece.a).dot(e) / e2, 0.0, 1.0) : 0.0;
  return (piece.a + s * e - p).norm();
}

// Chords tell which edges may be the closest, the curves themselves which is.
BorderFoot closest_on_border(const CadTables& cad, const TrimRegion& region, const Vec3& p) {
  double bound = std::numeric_limits<double>::max(), s = 0;
  for (int i = 0; i < region.border_count; ++i) bound = std::min(bound, chord_distance(region.pieces[i], p, s) + region.pieces[i].sag);
  BorderFoot best;
  double best_distance = std::numeric_limits<double>::max();
  int last_edge = 0;
  double last_t = 0;
  for (int i = 0; i < region.border_count; ++i) {
    const TrimRegion::Piece& piece = region.pieces[i];
    if (chord_distance(piece, p, s) - piece.sag > bound) continue;
    const EdgeGeometry& g = cad.edge(piece.edge);
    const double guess = piece.t_a + s * (piece.t_b - piece.t_a);
    double t;
    if (piece.edge == last_edge && (last_t - piece.t_a) * (last_t - piece.t_b) <= 0)
      t = last_t;
    else
      t = g.closest(p, &guess);
    last_edge = piece.edge;
    last_t = t;
    const Vec3 q = g.point(t);
    const double d = (q - p).norm();
    if (d < best_distance) {
      best_distance = d;
      best = {&piece, t, q, !g.closed && (t <= g.t0 || t >= g.t1)};
    }
  }
  return best;
}

/// Is the foot `q` (parameters uv) inside, in a cell that the border crosses?
bool inside_near_border(const CadTables& cad, const TrimRegion& region, const FaceGeometry& g, const Vec3& q, const Vec2& uv) {
  const BorderFoot foot = closest_on_border(cad, region, q);
  const Vec3 d = q - foot.point;
  if (d.norm() < 1e-10 * cad.diagonal) return true;
  if (foot.at_end) return region.inside_polygon(uv);
  const Vec3 along = (foot.piece->t_b > foot.piece->t_a ? 1 : -1) * cad.edge(foot.piece->edge).tangent(foot.t);
  return d.dot(g.normal(uv).cross(along)) >= 0;
}

}  // namespace

TrimRegion::Cell TrimRegion::cell_at(const Vec2& uv) const {
  const double i = (uv[0] - lower[0]) / cell_size[0], j = (uv[1] - lower[1]) / cell_size[1];
  const double slack = 1e-6;
  if (!(i >= -slack && j >= -slack && i <= columns + slack && j <= rows + slack)) return Outside;
  const int column = std::clamp(static_cast<int>(i), 0, columns - 1), row = std::clamp(static_cast<int>(j), 0, rows - 1);
  return static_cast<Cell>(cells[row * columns + column]);
}

bool TrimRegion::inside_polygon(const Vec2& uv) const {
  bool inside = false;
  for (const Piece& p : pieces)
    if ((p.uv_a[1] > uv[1]) != (p.uv_b[1] > uv[1]) &&
        uv[0] < p.uv_a[0] + (uv[1] - p.uv_a[1]) / (p.uv_b[1] - p.uv_a[1]) * (p.uv_b[0] - p.uv_a[0]))
      inside = !inside;
  return inside;
}

FaceFoot closest_on_face(const CadTables& cad, const TrimRegion& region, int face, const Vec3& p, const Vec2* guess) {
  const FaceGeometry& g = cad.face(face);
  const Vec2 middle = 0.5 * (g.lower + g.upper);
  Vec2 uv = into_box(g, surface_foot(g, region, p, guess));
  const auto result = [&] { return FaceFoot{g.point(uv), g.normal_towards(uv, middle), uv}; };
  if (region.border_count == 0) return result();
  // A face whose box is wider than a turn may hold the foot at another turn.
  const Vec2 first = uv;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      constexpr int turns[3] = {0, 1, -1};
      if ((i > 0 && g.period[0] <= 0) || (j > 0 && g.period[1] <= 0)) continue;
      uv = first + Vec2(turns[i] * g.period[0], turns[j] * g.period[1]);
      const TrimRegion::Cell cell = region.cell_at(uv);
      if (cell == TrimRegion::Inside || (cell == TrimRegion::Crossed && inside_near_border(cad, region, g, g.point(uv), uv)))
        return result();
    }
  const BorderFoot foot = closest_on_border(cad, region, p);
  const TrimRegion::Piece& piece = *foot.piece;
  const double range = piece.t_b - piece.t_a;
  const double s = range != 0 ? std::clamp((foot.t - piece.t_a) / range, 0.0, 1.0) : 0.0;
  const Vec2 start = piece.uv_a + s * (piece.uv_b - piece.uv_a);
  if (!g.closest(foot.point, start, uv)) uv = start;
  return result();
}

namespace {

void fill_grid(const FaceGeometry& g, TrimRegion& r) {
  Vec2 low = r.pieces.front().uv_a, high = low;
  for (const auto& p : r.pieces)
    for (const Vec2& uv : {p.uv_a, p.uv_b}) {
      low = low.cwiseMin((uv.array() - 1.5 * p.uv_sag).matrix());
      high = high.cwiseMax((uv.array() + 1.5 * p.uv_sag).matrix());
    }
  const Vec2 extent = (high - low).cwiseMax(1e-12);
  // Cells about square in space; many, so that the border crosses few of them.
  const SurfaceJet jet = g.jet1(0.5 * (g.lower + g.upper));
  const double aspect = std::clamp(jet.du.norm() * extent[0] / std::max(1e-12, jet.dv.norm() * extent[1]), 1.0 / 64, 64.0);
  const double cells = std::clamp(40.0 * static_cast<double>(r.pieces.size()), 400.0, 20000.0);
  r.columns = std::clamp(static_cast<int>(std::sqrt(cells * aspect)), 4, 256);
  r.rows = std::clamp(static_cast<int>(cells / r.columns), 4, 256);
  r.lower = low;
  r.cell_size = {extent[0] / r.columns, extent[1] / r.rows};
  r.cells.assign(static_cast<std::size_t>(r.columns) * r.rows, TrimRegion::Outside);

  for (const auto& p : r.pieces) {
    const Vec2 d = p.uv_b - p.uv_a;
    const int steps =
        std::clamp(static_cast<int>(std::ceil(std::max(std::abs(d[0]) / r.cell_size[0], std::abs(d[1]) / r.cell_size[1]))), 1, 1024);
    const double margin = 1.5 * p.uv_sag;
    for (int s = 0; s < steps; ++s) {
      const Vec2 a = p.uv_a + d * s / steps, b = p.uv_a + d * (s + 1) / steps;
      int from[2], to[2];
      for (int k = 0; k < 2; ++k) {
        const int n = k == 0 ? r.columns : r.rows;
        const double slack = margin + 1e-6 * r.cell_size[k];
        from[k] = std::clamp(static_cast<int>((std::min(a[k], b[k]) - slack - low[k]) / r.cell_size[k]), 0, n - 1);
        to[k] = std::clamp(static_cast<int>((std::max(a[k], b[k]) + slack - low[k]) / r.cell_size[k]), 0, n - 1);
      }
      for (int row = from[1]; row <= to[1]; ++row)
        for (int column = from[0]; column <= to[0]; ++column) r.cells[row * r.columns + column] = TrimRegion::Crossed;
    }
  }
  // The other cells are wholly in or out: even-odd along each row of centres.
  std::vector<double> crossings;
  for (int row = 0; row < r.rows; ++row) {
    const double v = low[1] + (row + 0.5) * r.cell_size[1];
    crossings.clear();
    for (const auto& p : r.pieces)
      if ((p.uv_a[1] > v) != (p.uv_b[1] > v))
        crossings.push_back(p.uv_a[0] + (v - p.uv_a[1]) / (p.uv_b[1] - p.uv_a[1]) * (p.uv_b[0] - p.uv_a[0]));
    std::sort(crossings.begin(), crossings.end());
    std::size_t next = 0;
    for (int column = 0; column < r.columns; ++column) {
      const double u = low[0] + (column + 0.5) * r.cell_size[0];
      while (next < crossings.size() && crossings[next] < u) ++next;
      auto& cell = r.cells[row * r.columns + column];
      if (cell == TrimRegion::Outside && next % 2 == 1) cell = TrimRegion::Inside;
    }
  }
}

}  // namespace

std::vector<TrimRegion> make_trim_regions(const CadTables& cad, const BaseMesh& base) {
  std::vector<TrimRegion> regions(cad.faces.size());
  std::vector<int> solid(cad.faces.size(), 0);  // shared faces: as the first solid has them
  for (int t = 0; t < base.triangle_count(); ++t) {
    const int f = base.triangle_face[t];
    if (solid[f - 1] == 0) solid[f - 1] = base.triangle_solid[t];
    if (solid[f - 1] != base.triangle_solid[t]) continue;
    TrimRegion& r = regions[f - 1];
    const FaceGeometry& g = cad.face(f);
    for (int h = 3 * t; h < 3 * t + 3; ++h) {
      const int e = base.halfedge_edge[h], n = 3 * t + (h % 3 + 1) % 3;
      if (e == 0) continue;
      TrimRegion::Piece p;
      p.edge = e;
      p.seam = base.triangle_face[base.opposite[h] / 3] == f && base.triangle_solid[base.opposite[h] / 3] == base.triangle_solid[t];
      p.uv_a = base.corner_uv[h];
      p.uv_b = base.corner_uv[n];
      p.a = base.points[base.from(h)];
      p.b = base.points[base.to(h)];
      p.t_a = base.halfedge_t[h][0];
      p.t_b = base.halfedge_t[h][1];
      const EdgeGeometry& edge = cad.edge(e);
      if (edge.kind != EdgeGeometry::Kind::Line || g.native != SurfaceKind::Plane) {
        double s = 0;
        for (const double w : {0.25, 0.5, 0.75}) {
          const Vec3 q = edge.point(p.t_a + w * (p.t_b - p.t_a));
          p.sag = std::max(p.sag, 1.3 * chord_distance(p, q, s));
          const Vec2 chord = p.uv_a + w * (p.uv_b - p.uv_a);
          Vec2 uv;
          if (g.closest(q, chord, uv)) p.uv_sag = std::max(p.uv_sag, (uv - chord).norm());
        }
      }
      r.pieces.push_back(p);
    }
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
  for (std::size_t f = 0; f < regions.size(); ++f) {
    TrimRegion& r = regions[f];
    std::stable_partition(r.pieces.begin(), r.pieces.end(), [](const TrimRegion::Piece& p) { return !p.seam; });
    r.border_count = static_cast<int>(std::count_if(r.pieces.begin(), r.pieces.end(), [](const TrimRegion::Piece& p) { return !p.seam; }));
    if (r.border_count == 0) continue;
    // Poles close the polygon in parameter space.
    const TopoDS_Face face = TopoDS::Face(cad.face_map(static_cast<int>(f) + 1));
    for (TopExp_Explorer edges(face, TopAbs_EDGE); edges.More(); edges.Next()) {
      const TopoDS_Edge edge = TopoDS::Edge(edges.Current());
      if (!BRep_Tool::Degenerated(edge)) continue;
      double from, to;
      const Handle(Geom2d_Curve) curve = BRep_Tool::CurveOnSurface(edge, face, from, to);
      if (curve.IsNull()) continue;
      TrimRegion::Piece p;
      p.seam = true;
      p.uv_a = to_eigen(curve->Value(from));
      p.uv_b = to_eigen(curve->Value(to));
      r.pieces.push_back(p);
    }
    fill_grid(cad.faces[f], r);
  }
  return regions;
}

}  // namespace hexfeature
