// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include <array>
#include <string>
#include <vector>

#include "base/context.h"
#include "fit/fit.h"
#include "mesh/hex_complex.h"
#include "shape/feature_shape.h"
#include "sheet/topology.h"

namespace hexfeature {

struct SheetOptions {
  double size = 1;
  double smooth_angle = 135;  ///< degrees in the solid between fitted quads above which a sheet is needed
  double crease_angle = 40;   ///< degrees between the CAD faces' normals above which an edge is not smooth, however the quads lie
  double smooth_share = 0.3;  ///< a border between two charts is smooth when more than this share of its edges is
  double floor_angle = 140;   ///< degrees: a pocket floor's quad with a larger corner at the foot of the wall needs a sheet
  double thickness = 0.3;     ///< of the neighbouring edge, at insertion
  bool run_through = true;    ///< a sheet all round walls of one direction runs on through the part rather than end inside like a cup
  int max_sheets = 64;        ///< insert at most so many: with 0, 1, 2, ... a caller sees what each sheet buys
  std::vector<std::vector<int>> without;  ///< names of sheets (SheetReport::names) that are not to be inserted
};

/// Charts that join smoothly, and where: one sheet is to run along them. Or a floor: the side of a line whose quads would be flat at
/// it, the line being the foot of a pocket's wall or a CAD edge inside a chart that a path of mesh edges with turns follows.
struct SheetGroup {
  std::vector<int> charts;                       ///< sorted; the sheet covers their quads; empty for a floor
  std::vector<std::array<int, 2>> smooth_edges;  ///< boundary edges (smaller node first) whose one cell must shrink away
  std::vector<std::array<int, 2>> floor_edges;   ///< floors only: the edges of the line
  std::vector<int> floor_quads;                  ///< ... and of each the quad on the floor's side
  int floor_chart = -1;                          ///< floors only: their chart; -1: no floor
  int cad_edge = 0;                              ///< floors beside a CAD edge inside the chart: that edge; else 0
  bool left = false;                             ///< ... and whether they lie to its left
};

struct SheetReport {
  int inserted = 0, refused = 0;
  bool run_through = false;                    ///< some, inserted or refused, would be others if SheetOptions::run_through were false
  int taken_back = 0;                          ///< inserted at first, and left out of the mesh because it is better without (by the caller)
  std::vector<std::vector<int>> chart_groups;  ///< per inserted sheet (charts it covers; a floor: that chart)
  std::vector<std::vector<int>> names;         ///< per inserted sheet: what tells it from others, whichever of them are inserted
  std::vector<std::array<int, 2>> hexes;       ///< per inserted sheet: its hexahedra [begin, end)
  std::vector<std::string> refusals;           ///< per refused sheet: why
};

/// Which of the inserted sheets come near (one element away) to a hexahedron whose quality (one per hexahedron) is below `limit`: it may be
/// their doing. Indices into the report's lists.
std::vector<int> sheets_near(const HexComplex& complex, const SheetReport& report, const std::vector<double>& quality, double limit);

/// Where O-grid sheets are needed (experiments B1): borders between charts with one cell inside (so that this cell would be
/// flat), smooth in the fitted quads and not on a sharp CAD edge; joined to groups. The largest group first.
std::vector<SheetGroup> find_sheet_groups(const HexComplex& complex, const HexTopology& topology, const Geometry& geometry,
                                          const SheetOptions& options, const Context& context);

/// Insert one sheet for `group` (found in this very complex): choose the shrink set (minimum cut, experiments B2) and fill the
/// gap it leaves (B3). `topology` is this complex's, and out of date when a sheet was inserted. Returns an empty string, or the reason why
/// it was refused; then `complex` is as it was. `covered` (may be null) receives the charts that the sheet covers: the group's, and those
/// added to settle a conflict.
std::string insert_sheet(HexComplex& complex, const HexTopology& topology, const FeatureShape& shape, const Geometry& geometry,
                         const SheetGroup& group, const SheetOptions& options, Context& context, std::vector<int>* covered = nullptr);

/// Insert O-grid sheets where chart borders lie on smooth surface (design 3.7, experiments B1-B3): one sheet per group of
/// smoothly joined charts, one after another, measured anew after each; its shrink set chosen as a minimum cut over blocks,
/// leaving through sharp faces. `complex` must be fitted (fit_boundary). New nodes get positions, shape and CAD places.
/// A sheet that the local rules forbid is refused and counted.
/// Throws MeshingError(NoMesh, "sheet") only when the complex that comes in is not a conforming one whose boundary is `quads`.
SheetReport insert_sheets(HexComplex& complex, const FeatureShape& shape, const Geometry& geometry, const SheetOptions& options,
                          Context& context);

}  // namespace hexfeature
