// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include "cad_shapes.h"
#include "surface/surface.h"

namespace cad_shapes {

/// A model's surface mesh at an element size, everything else as usual.
inline hexfeature::SurfaceMesh surface_of(const hexfeature::CadModel& model, double size) {
  hexfeature::Context context;
  hexfeature::SurfaceOptions options;
  options.size = size;
  return hexfeature::triangulate(model, options, context);
}

}  // namespace cad_shapes
