// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include <memory>
#include <utility>
#include <vector>

#include "label/macro_graph.h"
#include "label/regions.h"

namespace hexfeature {

/// One split of one site.
struct SiteCut {
  enum Kind { Strip, Across, Creases, Rim } kind = Across;
  int site = -1;
  int dart = -1;            ///< Strip: along this macro dart, whose left site is `site`
  double width = 0;         ///< Strip, Rim
  int axis = -1;            ///< Across: the plane x[axis] = coordinate; Rim: the axis that its pieces do not face
  double coordinate = 0;    ///< Across
  double degrees = 0;       ///< Creases
  std::vector<int> beyond;  ///< Rim: along the borders with these sites
  bool operator==(const SiteCut& o) const {
    return kind == o.kind && site == o.site && dart == o.dart && width == o.width && axis == o.axis && coordinate == o.coordinate &&
           degrees == o.degrees && beyond == o.beyond;
  }
};

/// The cuttings of the surface that a search visits: the CAD regions, and what splits made of them. Each cutting keeps its macro graph
/// for good; its triangles are kept for a while and made again from its parent when asked for. Each split is tried once.
class CutTree {
 public:
  CutTree(Regions regions, const Geometry& geometry, double size);

  /// The cutting made by `cut` from `parent` (0: the CAD regions), or -1 when a part of the site would be too small.
  /// In the child, old sites keep their numbers; new ones follow.
  int child(int parent, const SiteCut& cut);

  const MacroGraph& graph(int cutting) const { return *nodes_[cutting].graph; }
  /// Per site: the direction that it faces as a piece of the rim that made this cutting; kNoLabel if it is none.
  const std::vector<Label>& rim_labels(int cutting) const { return nodes_[cutting].rim_labels; }
  int splits(int cutting) const { return nodes_[cutting].depth; }
  /// Whether some split of the cutting has the same label on all its parts, so that a state without it says the same.
  bool redundant(int cutting, const std::vector<Label>& labels) const;
  int size() const { return static_cast<int>(nodes_.size()); }

  /// Triangles of a cutting; valid until the next call of a non-const function.
  const Regions& regions(int cutting);
  /// Border halfedges of a macro dart, its left site's.
  std::vector<int> halfedges(int cutting, int dart);
  /// Greatest distance of a point of the dart's left site from the dart.
  double extent(int cutting, int dart);

 private:
  struct Node {
    int parent = -1, depth = 0;
    SiteCut cut;
    std::unique_ptr<MacroGraph> graph;
    std::unique_ptr<Regions> regions;  // null when dropped
    std::unique_ptr<Partition> partition;
    std::vector<std::pair<SiteCut, int>> children;
    std::vector<Label> rim_labels;
    std::vector<double> extent;  // per dart, < 0: not yet known
    long used = 0;
  };
  bool apply(Regions& regions, const Partition& partition, const SiteCut& cut, std::vector<Label>& rim_labels) const;
  void load(int cutting);
  void drop_old(int keep);

  const Geometry& geometry_;
  double size_;
  std::vector<Node> nodes_;
  long clock_ = 0;
};

}  // namespace hexfeature
