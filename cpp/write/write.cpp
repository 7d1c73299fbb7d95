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

std::vector<NamedSolids> named_solids(const std::vector<std::string>& solid_names) {
  constexpr std::size_t kLongest = 64;
  std::vector<NamedSolids> groups;
  for (std::size_t s = 0; s < solid_names.size(); ++s) {
    std::string name = solid_names[s].substr(0, kLongest);
    for (char& c : name)
      if (!std::isalnum(static_cast<unsigned char>(c)) && c != '-') c = '_';
    if (name.find_first_not_of('_') == std::string::npos) continue;
    for (const std::string own : {"Solid", "Face", "Edge", "Vertex", "Nall", "Eall"})
      if (name.compare(0, own.size(), own) == 0 && name.find_first_not_of("0123456789", own.size()) == std::string::npos) name += "_";
    if (std::isdigit(static_cast<unsigned char>(name[0]))) name = "_" + name;
    auto it = std::find_if(groups.begin(), groups.end(), [&](const NamedSolids& group) { return group.name == name; });
    if (it == groups.end()) it = groups.insert(groups.end(), {name, {}});
    it->solids.push_back(static_cast<int>(s) + 1);
  }
  return groups;
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
