// HexFeatureWB - LGPL-2.1-or-later
#include "write/write.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "base/error.h"

namespace hexfeature {

const std::vector<std::string>& writable_endings() {
  static const std::vector<std::string> endings = {".vtk", ".inp", ".unv"};
  return endings;
}

void write_mesh(const MeshView& view, const std::string& path, const WriteOptions& options) {
  std::string ending = std::filesystem::path(path).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (ending == ".vtk") return write_vtk(view, path);
  if (ending == ".inp") return write_inp(view, path, options);
  if (ending == ".unv") return write_unv(view, path);
  throw MeshingError(Failure::Usage, "write", "there is no mesh format with the ending '" + ending + "'", "use .vtk, .inp or .unv");
}

}  // namespace hexfeature
