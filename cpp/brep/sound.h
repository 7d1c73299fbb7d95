// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include <TopoDS_Shape.hxx>

#include "base/context.h"

namespace hexfeature {

/// Refuse a shape on which OCCT's algorithms crash or never end: faces without a surface, edges without any curve, numbers that are
/// not finite or beyond all sense, parameters many periods away. What is merely wrong (gaps, crossings) is left to BRepCheck and
/// ShapeFix. Throws MeshingError(BadInput, "read") naming the CAD faces.
void require_sound(const TopoDS_Shape& shape, Context& context);

}  // namespace hexfeature
