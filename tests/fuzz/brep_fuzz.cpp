// HexFeatureWB - LGPL-2.1-or-later
// The B-rep text that FreeCAD hands over: reading, healing, triangulation, analysis.
#include <chrono>
#include <cstdint>
#include <string>

#include "base/error.h"
#include "brep/cad_model.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  hexfeature::Context context;
  context.deadline = hexfeature::Context::Clock::now() + std::chrono::seconds(5);
  try {
    hexfeature::read_brep_string(std::string(data, data + size), context);
  } catch (const hexfeature::MeshingError&) {
  }
  return 0;
}
