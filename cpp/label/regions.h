// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include <vector>

#include "base/context.h"
#include "mesh/geometry.h"
#include "mesh/surface_mesh.h"

namespace hexfeature {

struct RegionOptions {
  double size = 1;            ///< element size h
  double flat_angle = 12;     ///< degrees: a face whose normals stay this near their mean is one site
  double oblique_angle = 15;  ///< degrees: a hole further off every axis is also cut across at mid-length
  double tie = 0.97;          ///< free-form faces are cut where two squared normal components are equal and both >= tie * the third
  double snap = 0.12;         ///< a cut within this fraction of a mesh edge's end takes the vertex there
  double least_share = 0.02;  ///< sites under this share of their face ...
  double least_area = 0.1;    ///< ... and under this many h^2 join a neighbour of their face,
  double strip_share = 0.3;   ///< so do those along a tangent CAD edge that are under this share
  double least_width = 0.3;   ///< ... and narrower than this many h: a chart border on that edge is better than one just beside it
};

/// The part's surface cut into CAD regions: the sites that the default labeller gives labels to (design 3.3).
struct Regions {
  SurfaceMesh mesh;            ///< the input mesh with cut lines added; all its invariants hold
  std::vector<int> site;       ///< per triangle, 0-based; every site is connected and lies in one CAD face
  std::vector<int> site_face;  ///< per site: 1-based CAD face

  int site_count() const { return static_cast<int>(site_face.size()); }
};

/// Cut every curved CAD face where the nearest axis of the working frame (x, y, z) changes.
///  Plane, or any face whose normals stay within `flat_angle` of their mean: one site.
///  Cylinder, cone with axis a: e1 = the frame axis most perpendicular to a, made orthogonal to it, e2 = a x e1; cut where
///  (r.e1)^2 = (r.e2)^2, r the radial direction: four straight strips centred on +-e1, +-e2, turned where place_strips says so. Oblique
///  long ones also across.
///  Torus: the same, and where (n.a)^2 = 1/2. Sphere and all else: where two squared normal components are equal and greatest.
/// Cut functions are evaluated per (face, point), never from (u, v). Deterministic. Linear in the number of triangles.
/// Requires a connected mesh (`opposite`) with corner normals; geometry.projector may be null (new points stay on chords).
Regions cut_regions(const SurfaceMesh& mesh, const Geometry& geometry, const RegionOptions& options, Context& context);

// Splits of one site, for repair. Each edits `regions` in place: the old site keeps its number, new ones get the next
// numbers; a triangle that is cut keeps its number for one piece and the other pieces are appended, so that triangles away
// from the cut stay as they are (border halfedges of the site may be renumbered). Each returns false, and leaves the sites
// as they were, when a part would be empty or smaller than `least_area` (absolute; a sensible value is 0.02 h^2); in rare cases
// the mesh has then gained points all the same.

/// Cut off the strip of points nearer than `width` to the polyline of `halfedges`, a chain of consecutive border halfedges
/// of `site` (as Partition::Edge::halfedges holds them; for a right part: their opposites in reverse order).
bool split_strip(Regions& regions, const Geometry& geometry, int site, const std::vector<int>& halfedges, double width, double least_area);

/// Cut `site` by the plane x[axis] = coordinate.
bool split_across(Regions& regions, const Geometry& geometry, int site, int axis, double coordinate, double least_area);

/// Cut `site` along those of its inner mesh edges whose dihedral exceeds `degrees`.
bool split_creases(Regions& regions, int site, double degrees, double least_area);

/// Cut a rim off `site`: the points nearer than `width` to `halfedges`, border halfedges of it in any order. A rim at an edge between
/// opposite labels is the narrow wall (or, at a concave edge, the floor) that a polycube needs there: it faces across the edge, in the
/// surface, along the nearest axis that is not `axis`. Where that direction changes along the border the rim falls apart.
/// False when there is no room for a rim; a site narrower than `width` becomes rim altogether.
/// `rim_label` gets, per site, the direction of a piece of the rim; kNoLabel for all other sites.
bool split_rim(Regions& regions, const Geometry& geometry, int site, const std::vector<int>& halfedges, int axis, double width,
               double least_area, std::vector<Label>& rim_label);

/// Greatest distance of a point of `site` from the chain: a strip should be at most half as wide.
double strip_extent(const Regions& regions, int site, const std::vector<int>& halfedges);

}  // namespace hexfeature
