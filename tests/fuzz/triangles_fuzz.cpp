// HexFeatureWB - LGPL-2.1-or-later
// The readers of STL, OBJ and PLY and what makes a closed surface of them. The first byte says which.
#include <cstdint>
#include <string>

#include "base/error.h"
#include "surface/triangle_files.h"
#include "surface/weld.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < 2) return 0;
  static const char* const endings[3] = {".stl", ".obj", ".ply"};
  try {
    hexfeature::weld(hexfeature::parse_triangles(std::string(data + 1, data + size), endings[data[0] % 3]));
  } catch (const hexfeature::MeshingError&) {
  }
  return 0;
}
