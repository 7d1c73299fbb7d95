// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include <TopoDS_Shape.hxx>
#include <string>
#include <utility>
#include <vector>

#include "base/context.h"

namespace hexfeature {

/// What a file holds.
struct ReadShape {
  TopoDS_Shape shape;
  std::vector<std::pair<TopoDS_Shape, std::string>> names;  ///< of solids that the file names
  std::vector<std::string> warnings;
};

/// The shape in a STEP or IGES file, lengths in millimetres as OCCT (and FreeCAD) has them, whatever the file's unit. OCCT's readers trust
/// much of what they read: what can be told from the text and from the loaded entities is checked before the shape is built.
/// Throws MeshingError(BadInput, "read").
ReadShape read_step(const std::string& path, Context& context);
ReadShape read_iges(const std::string& path, Context& context);

}  // namespace hexfeature
