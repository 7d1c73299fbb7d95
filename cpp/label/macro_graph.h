// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include <array>
#include <vector>

#include "label/regions.h"
#include "shape/partition.h"

namespace hexfeature {

/// The sites and their borders as flat arrays: all that the label search looks at (experiments A4). Costs that do not depend
/// on the neighbours' labels are computed once, from every triangle and every mesh edge, so that nothing is lost to means.
struct MacroGraph {
  struct Edge {
    int left = -1, right = -1;                      ///< sites
    int start = -1, end = -1;                       ///< nodes; -1 when closed without one
    Vec3 first = Vec3::Zero();                      ///< its first point
    Vec3 displacement = Vec3::Zero();               ///< of the last point from the first
    Vec3 low = Vec3::Zero(), high = Vec3::Zero();   ///< least and greatest displacement on the way, per axis
    Vec3 fall = Vec3::Zero(), rise = Vec3::Zero();  ///< greatest way back down, and up, from start to end, per axis
    double length = 0;
    double dihedral = 0;     ///< length-weighted mean, signed, radians
    double differ = 0;       ///< energy when the two sites' labels differ
    double same = 0;         ///< ... when they are equal
    double opposed = 0;      ///< ... added when they are opposite
    double same_defect = 0;  ///< soft defect when they are equal
    double lost = 0;         ///< energy when they are equal and no mesh edge can follow a sharp edge here
  };
  double total_area = 0;
  // Per site.
  std::vector<double> area;
  std::vector<int> face;                        ///< 1-based CAD face
  std::vector<Vec3> low, high;                  ///< bounding box
  std::vector<double> tilt;                     ///< 0: all triangles face a frame axis; 1: none does
  std::vector<std::array<double, 6>> cosine;    ///< area-weighted mean of n.l
  std::vector<std::array<double, 6>> fidelity;  ///< energy of each label
  std::vector<std::array<double, 6>> defect;    ///< soft defect of each label
  std::vector<int> site_first, site_darts;      ///< darts with the site on the left
  std::vector<Edge> edges;
  std::vector<int> node_first, node_darts;  ///< outgoing darts, counter-clockwise

  int site_count() const { return static_cast<int>(area.size()); }
  int edge_count() const { return static_cast<int>(edges.size()); }
  int node_count() const { return static_cast<int>(node_first.size()) - 1; }
  int left_of(int dart) const { return dart % 2 == 0 ? edges[dart / 2].left : edges[dart / 2].right; }
  int right_of(int dart) const { return left_of(dart ^ 1); }
  int start_of(int dart) const { return dart % 2 == 0 ? edges[dart / 2].start : edges[dart / 2].end; }
  int end_of(int dart) const { return start_of(dart ^ 1); }
};

/// `partition` must be make_partition(regions.mesh, regions.site); `size` is the element size h.
///
/// Energy (experiments A5), in fractions of the part's area, l = min(h, sqrt of the smaller site's area):
///   label l on a site: sum over triangles of A (1 - n.l + 2 max(0, 0.1 - n.l));
///   labels differ: 0.5 len l k, k = 1 below 20 degrees, 0.4 below 50, else 0.1; opposite: 4 len l more;
///   labels equal: 3 len l above 63 degrees, 0.3 len l from 40 to 63; above 20 degrees 0.3 len l more where the edge ends in a corner at
///   which the chart has a single quad (LabelScorer).
/// Soft defects: a site with mean n.l < 0.17: 0.6 min(1, 1/4 + A/h^2) min(1.5, (0.17 - n.l) / 0.17);
///   equal labels across more than 63 degrees: 0.4 min(1, 0.3 + len/h).
///
/// With `parent`, the graph from which one split of `changed` made `regions`: other sites' own costs are taken from there.
MacroGraph make_macro_graph(const Regions& regions, const Partition& partition, double size, const MacroGraph* parent = nullptr,
                            int changed = -1);

}  // namespace hexfeature
