// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include <vector>

#include "base/context.h"
#include "lattice/lattice.h"

namespace hexfeature {

/// Lattice lines that CAD edges within charts lack: each row of quads that such an edge runs along is to be one row more, between the
/// nearest charts that bound its chart on either side. `halfedges`: of `mesh`, on CAD edges that lack one, one of each pair; `fitted` is
/// the lattice's complex after boundary fitting, `size` the element size h. Returns separations for build_lattice, sorted; none when no
/// edge runs within a chart and no row is much taller than h.
std::vector<Separation> missing_lines(const std::vector<int>& halfedges, const Lattice& lattice, const HexComplex& fitted,
                                      const SurfaceMesh& mesh, const FeatureShape& shape, double size, const Context& context);

}  // namespace hexfeature
