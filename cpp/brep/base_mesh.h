// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include <array>
#include <vector>

#include "base/context.h"
#include "base/types.h"
#include "mesh/surface_mesh.h"

namespace hexfeature {

struct CadTables;

/// The first triangulation of the part, made once on reading (BRepMesh): what the analysis, the frame search, the
/// trimming of projections and the surface mesher start from. In the file's frame, one closed oriented surface per
/// shell; faces that two solids share appear once per solid.
///
/// Every triangle corner has parameters on its own face that are continuous within the triangle (across seams and at
/// poles a point has several), and every halfedge on a CAD edge has that edge's parameters at its two ends.
struct BaseMesh {
  std::vector<Vec3> points;
  std::vector<CadPlace> place;                ///< per point
  std::vector<std::array<int, 3>> triangles;  ///< point indices, counter-clockwise from outside
  std::vector<int> triangle_face;             ///< per triangle: 1-based CAD face
  std::vector<int> triangle_solid;            ///< per triangle: 1-based solid
  std::vector<int> triangle_side;  ///< per triangle: -1 where its solid is on the outward side of the face (shared faces), else 1
  std::vector<Vec2> corner_uv;     ///< 3 per triangle
  std::vector<signed char>
      corner_free;                 ///< 3 per triangle: at a pole of the corner's face, the parameter (0, 1) that is free there; else -1
  std::vector<int> halfedge_edge;  ///< 3 per triangle: 1-based CAD edge or 0
  std::vector<Vec2> halfedge_t;    ///< 3 per triangle: parameters of that edge at the halfedge's start and end
  std::vector<int> opposite;       ///< 3 per triangle

  int triangle_count() const { return static_cast<int>(triangles.size()); }
  /// A pole's free parameter, as the rest of the triangle suggests it.
  void settle_pole(int h) {
    const int k = corner_free[h];
    if (k < 0) return;
    const int a = h - h % 3 + (h + 1) % 3, b = h - h % 3 + (h + 2) % 3;
    corner_uv[h][k] = corner_free[a] == k   ? corner_uv[b][k]
                      : corner_free[b] == k ? corner_uv[a][k]
                                            : 0.5 * (corner_uv[a][k] + corner_uv[b][k]);
  }
  int from(int h) const { return triangles[h / 3][h % 3]; }
  int to(int h) const { return triangles[h / 3][(h + 1) % 3]; }
};

/// Triangulate with BRepMesh and weld along the CAD edges by their numbers, never by distance. Retries finer when
/// BRepMesh leaves a crack; then throws MeshingError(BadInput, "read") naming the faces.
/// Faces of a solid that is inside out are turned in `cad`. With more than one thread OpenCASCADE takes its own pool, with the same result.
BaseMesh make_base_mesh(CadTables& cad, Context& context, int threads);

}  // namespace hexfeature
