// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include <string>
#include <vector>

#include "base/context.h"
#include "mesh/hex_complex.h"
#include "polycube/polycube.h"
#include "shape/feature_shape.h"

namespace hexfeature {

/// What went wrong when the polycube was rasterised (V5, V6), and what would keep the colliding charts apart.
struct FillReport {
  bool ok = false;
  std::string reason;
  std::vector<int> charts;              ///< to blame, sorted
  std::vector<Separation> separations;  ///< suggested order constraints, best shown by the part first
  int rounds = 0;                       ///< build_lattice: solve-and-fill rounds, all attempts together
  double size = 0;                      ///< build_lattice: the element size that was used in the end
};

/// The mapping model: unit cells of the polycube's inside, their nodes at integer coordinates (as doubles), boundary
/// quads with their chart, nodes with their place on the feature shape (corner, arc, chart, inside), blocks.
struct Lattice {
  FillReport report;
  HexComplex complex;  ///< empty unless report.ok
  Polycube polycube;   ///< the one that was filled
};

/// Rasterise each chart's rectilinear polygon, fill between opposite charts by parity, check V5 (Euler number) and V6
/// (boundary is exactly the charts' cells, right sides, manifold). Hexahedra and points run x fastest, then y, then z; quads
/// chart by chart. A block is a box between consecutive chart coordinates. Separations of `tried` (sorted) are not suggested again.
Lattice fill_lattice(const FeatureShape& shape, const Polycube& polycube, int solid, Context& context,
                     const std::vector<Separation>& tried = {});

/// quantize + fill with lazy separation: solve, fill, separate what collides, again (<= 25 rounds); should that lead nowhere,
/// anew with one separation a round; then with the charts' positions as orders; then the same with 0.7 h and 0.5 h. Not `thorough`:
/// only the first and the third of these. `wanted` (sorted) are separations to begin with. Never throws for a failed fill: the report
/// says why.
Lattice build_lattice(const SurfaceMesh& mesh, const FeatureShape& shape, const QuantizeOptions& options, Context& context,
                      const std::vector<Separation>& wanted = {});
/// The same with rays sampled before: for a caller that tries many labels on one mesh.
Lattice build_lattice(const SurfaceMesh& mesh, const FeatureShape& shape, const AxisRays& rays, const QuantizeOptions& options,
                      Context& context, bool thorough = true, const std::vector<Separation>& wanted = {});

}  // namespace hexfeature
