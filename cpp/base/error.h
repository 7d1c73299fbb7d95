// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace hexfeature {

/// What kind of failure; each has its own exit code on the command line.
enum class Failure {
  Usage,      ///< an option is impossible (exit 2)
  BadInput,   ///< the part cannot be read or is not a closed solid (exit 3)
  NoMesh,     ///< a step of the method could not go on (exit 4)
  Output,     ///< a file could not be written (exit 5)
  Cancelled,  ///< the user or a time limit stopped it (exit 130)
};

/// The one error type: which step gave up, why, which CAD faces are to blame
/// (1-based, TopExp::MapShapes order = FreeCAD's FaceN), and what to try.
class MeshingError : public std::runtime_error {
 public:
  MeshingError(Failure kind_, std::string step_, std::string reason_, std::string hint_ = {}, std::vector<int> cad_faces_ = {})
      : std::runtime_error(step_ + ": " + reason_),
        kind(kind_),
        step(std::move(step_)),
        reason(std::move(reason_)),
        hint(std::move(hint_)),
        cad_faces(std::move(cad_faces_)) {}
  Failure kind;
  std::string step, reason, hint;
  std::vector<int> cad_faces;
};

}  // namespace hexfeature
