// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include <array>
#include <vector>

#include "base/context.h"
#include "mesh/surface_mesh.h"
#include "shape/feature_shape.h"

namespace hexfeature {

/// Is this halfedge on a sharp CAD edge (over 20 degrees, as CadEdge::sharp), which mesh edges must follow?
bool on_sharp_edge(const SurfaceMesh& mesh, int halfedge);

/// Where lines along the axes cross the surface one after the other, through solid or across a gap: depends on the mesh alone,
/// so that a labeller that tries many labels on one mesh samples once.
struct AxisRays {
  struct Crossing {
    int low = -1, high = -1;  ///< triangles; `high` follows `low` along +axis
    int axis = 0;
    double gap = 0;      ///< distance; less when the line meets the surface aslant (times the mean cosine): a slab's thickness
    double area = 0;     ///< cross-section of the part that this crossing stands for; 0 through air
    bool solid = false;  ///< through the part, else through air
  };
  std::vector<Crossing> crossings;
};

/// Shoot about `count` lines from points spread over the surface: half by area, half evenly over the triangles, so that small
/// features get their share. Fixed sequence: the same mesh gives the same rays.
AxisRays sample_axis_rays(const SurfaceMesh& mesh, int count, Context& context);

/// Rays of the mesh that was asked for last, for a caller that tries many labels: samples anew only when the mesh has changed.
class AxisRayCache {
 public:
  const AxisRays& rays(const SurfaceMesh& mesh, int count, Context& context);

 private:
  std::vector<Vec3> points_;
  std::vector<std::array<int, 3>> triangles_;
  int count_ = 0;
  AxisRays rays_;
};

/// The part says that chart `low` lies below chart `high` on their common axis, at this distance.
struct ChartOrder {
  int low = -1, high = -1;
  double gap = 0;    ///< weighted median
  int count = 0;     ///< samples that said so
  int pieces = 1;    ///< intervals that the CAD asks for between them: one more than the sharp CAD edges that run across
  double lines = 0;  ///< how many lines of elements run between the two: cross-section / h^2 inside, width / h on a chart
};

/// Orders between the charts of a feature shape (experiments A8): from rays between opposite labels, and from walks over a
/// chart, along its two axes, from random points to the arcs either way, whose neighbour charts must come in that order
/// (this keeps inner loops inside outer ones). Sorted by (low, high).
std::vector<ChartOrder> chart_orders(const SurfaceMesh& mesh, const FeatureShape& shape, const AxisRays& rays, double size,
                                     Context& context);

/// A chain of orders by the charts' positions alone: every chart below the next one higher up on its axis (by centroid, at least
/// `tolerance` apart). Too much to ask for in general - it gives each of them a layer of its own - but a polycube that keeps
/// them all cannot collide where the part is nearly one itself: the last resort before a finer lattice.
std::vector<ChartOrder> position_orders(const FeatureShape& shape, double tolerance);

}  // namespace hexfeature
