// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include <string>
#include <vector>

#include "sheet/sheet.h"
#include "sheet/topology.h"

namespace hexfeature {

/// The hexahedra that shrink to make room for a sheet.
struct ShrinkSet {
  std::vector<char> inside;   ///< per hexahedron
  std::vector<char> covered;  ///< per chart: the sheet runs along the quads of `inside` on it; through the others it leaves
  long long cost = 0;         ///< of the cut
  int rows = 0;               ///< of hexahedra that stay, parted from blocks that shrink
  std::string refusal;        ///< not empty: there is none, and why
};

/// Minimum cut over blocks (experiments B2). Source: the blocks at the group's smooth edges. At the foot of the group's wall (a
/// border with a free chart, three or more hexahedra round it, or two and nearly flat) the free face's block is sink and the
/// blocks under the foot are source, so that the sheet goes on straight into the solid instead of closing under the wall like
/// a cup. A block wanted on both sides: the free charts concerned join the group, and again; but where the sheet would then wrap an acute
/// edge, the hexahedra along the free chart become a block of their own, which stays. Costs per lattice face: between blocks 100,
/// covered 5, leaving through a free one 0; leaving at a concave edge so that too few hexahedra stay there, 3000 per edge; with
/// SheetOptions::run_through ending inside across walls that close all round along one direction, as a shaft's do, 10000: a sheet that
/// closes like a cup has nodes where three inner edges of three hexahedra meet, a scaled Jacobian of 0.770, and one that runs from end
/// to end 0.866. Of all minimum cuts the one with the largest set. Deterministic.
/// `together`: sets of hexahedra of which all must shrink or all stay.
ShrinkSet choose_shrink_set(const HexComplex& complex, const HexTopology& topology, const SheetGroup& group, const SheetOptions& options,
                            Context& context, const std::vector<std::vector<int>>& together = {});

struct CutArc {
  int from, to;
  long long capacity;  ///< paid when `from` is on the source's side and `to` is not
};
/// Largest source side of all minimum cuts between a source and a sink, by maximum flow (push-relabel). Returns per node: on the
/// source's side.
std::vector<char> largest_minimum_cut(int node_count, std::vector<CutArc> arcs, int source, int sink);

/// Why the local rules forbid a sheet.
struct LayerRefusal {
  std::string reason;  ///< empty: they do not
  /// Sets of hexahedra, each round the place where it goes wrong: with none of them cut apart it would not.
  std::vector<std::vector<int>> together;

  bool refused() const { return !reason.empty(); }
};

/// Fill the gap between `set` and the rest with one hexahedron per face of the sheet (experiments B3). When it is refused, `complex` is as
/// it was.
LayerRefusal insert_layer(HexComplex& complex, const HexTopology& topology, const FeatureShape& shape, const Geometry& geometry,
                          const ShrinkSet& set, const SheetOptions& options, const Context& context);

}  // namespace hexfeature
