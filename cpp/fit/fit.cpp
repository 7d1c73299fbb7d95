// HexFeatureWB - LGPL-2.1-or-later
#include "fit/fit.h"

#include "fit/boundary_fit.h"

namespace hexfeature {

int fit_boundary(HexComplex& complex, const SurfaceMesh& mesh, const FeatureShape& shape, const Geometry& geometry,
                 const FitOptions& options, Context& context) {
  context.progress("fit", 0);
  BoundaryFit fit(complex, mesh, shape, geometry, options, context);
  fit.start();
  context.progress("fit", 0.1);
  if (options.inner_edges) fit.route_cad_edges();
  fit.finish();
  context.progress("fit", 0.8);
  fit_interior(complex, context);
  context.progress("fit", 1);
  return fit.freely_turned;
}

}  // namespace hexfeature
