// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include <cstdint>
#include <vector>

#include "base/types.h"

namespace hexfeature {

struct CadTables;
struct BaseMesh;

/// Where a trimmed face ends: its border as short pieces of CAD edges, and a grid over the face's parameters that tells
/// at once, for most feet, that they are inside. Feet in a cell that the border crosses are judged against the true
/// nearest CAD edge, so that the verdict is as exact as the CAD.
struct TrimRegion {
  /// A chord of a border edge.
  struct Piece {
    int edge = 0;             ///< 1-based CAD edge; 0: a pole
    bool seam = false;        ///< this face on both sides, or a pole: no border
    Vec2 uv_a, uv_b;          ///< parameters of the face at the ends; the face lies to the left of a -> b, seen from outside
    Vec3 a, b;                ///< end points
    double t_a = 0, t_b = 0;  ///< parameters of the edge at the ends
    double sag = 0;           ///< bound on the distance of the curve from its chord
    double uv_sag = 0;        ///< the same in parameters
  };
  std::vector<Piece> pieces;    ///< borders first
  int border_count = 0;         ///< pieces that are borders; 0: the face is its whole surface
  std::vector<Vec2> sample_uv;  ///< points of the face, where Newton may start (splines alone)
  std::vector<Vec3> sample_p;

  enum Cell : std::int8_t { Outside, Inside, Crossed };
  Vec2 lower = Vec2::Zero(), cell_size = Vec2::Ones();
  int columns = 0, rows = 0;
  std::vector<std::int8_t> cells;

  Cell cell_at(const Vec2& uv) const;
  /// Even-odd test against the chords.
  bool inside_polygon(const Vec2& uv) const;
};

/// One region per face.
std::vector<TrimRegion> make_trim_regions(const CadTables& cad, const BaseMesh& base);

/// Closest point of trimmed face `face` (1-based) to `p`, file's frame. The foot on the surface when it lies inside,
/// else the foot on the nearest border edge (put back on the surface).
struct FaceFoot {
  Vec3 point, normal;
  Vec2 uv;
};
FaceFoot closest_on_face(const CadTables& cad, const TrimRegion& region, int face, const Vec3& p, const Vec2* guess);

}  // namespace hexfeature
