// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include <string>
#include <vector>

#include "base/types.h"
#include "mesh/surface_mesh.h"
#include "shape/partition.h"

namespace hexfeature {

/// A surface mesh with a label per triangle: what a labeller returns. The mesh may have been cut (points added)
/// with respect to the one that went in.
struct LabelledSurface {
  SurfaceMesh mesh;
  std::vector<Label> label;  ///< per triangle
};

/// The paper's feature-shape model (steps 3-5, 3-6; Table 3): feature faces (charts), feature lines (arcs) and
/// feature points (corners), a B-rep of its own. Charts, arcs and corners are the parts, edges and nodes of `cells`,
/// with the same numbers and the same darts.
struct FeatureShape {
  struct Chart {
    Label label = kNoLabel;
    double area = 0;
    Vec3 centroid = Vec3::Zero();
    Vec3 normal = Vec3::Zero();  ///< area-weighted mean normal (length <= 1: how flat it is)
    std::vector<int> cad_faces;  ///< sorted, 1-based
  };
  struct Arc {
    int axis = -1;                     ///< the axis that is neither of its charts' (the paper's Table 2); -1 when they share one
    int sign = 0;                      ///< +1: start -> end runs along +axis; -1 against; from geometry, corrected by validity
    double length = 0;                 ///< of the polyline
    Vec3 displacement = Vec3::Zero();  ///< end - start
    Vec3 centroid = Vec3::Zero();      ///< of the polyline
    double dihedral = 0;               ///< length-weighted mean signed dihedral (SurfaceMesh::dihedral)
  };
  Partition cells;
  std::vector<Chart> charts;
  std::vector<Arc> arcs;

  int chart_count() const { return static_cast<int>(charts.size()); }
  int arc_count() const { return static_cast<int>(arcs.size()); }
  int corner_count() const { return static_cast<int>(cells.nodes.size()); }
  /// Direction that a dart runs along as a label (2*axis + (sign<0)); kNoLabel when its arc has no axis.
  Label dart_direction(int dart) const {
    const Arc& a = arcs[dart / 2];
    if (a.axis < 0 || a.sign == 0) return kNoLabel;
    return make_label(a.axis, dart % 2 == 0 ? a.sign : -a.sign);
  }
};

/// Build the feature shape of a labelled surface: charts = connected components of one label; arc axes and signs
/// (sign of the displacement along the axis; 0 never: a tie takes +1).
FeatureShape make_feature_shape(const LabelledSurface& surface);

}  // namespace hexfeature
