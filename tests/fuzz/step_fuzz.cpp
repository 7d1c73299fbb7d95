// HexFeatureWB - LGPL-2.1-or-later
// A STEP file, by way of the file system: OpenCASCADE reads by name.
#include <unistd.h>

#include <chrono>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <string>

#include "base/error.h"
#include "brep/cad_model.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const std::string path =
      (std::filesystem::temp_directory_path() / ("hexfeature_fuzz_" + std::to_string(getpid()) + ".step")).string();
  std::FILE* file = std::fopen(path.c_str(), "wb");
  if (!file) return 0;
  std::fwrite(data, 1, size, file);
  std::fclose(file);
  hexfeature::Context context;
  context.deadline = hexfeature::Context::Clock::now() + std::chrono::seconds(5);
  try {
    hexfeature::read_cad(path, context);
  } catch (const hexfeature::MeshingError&) {
  }
  std::filesystem::remove(path);
  return 0;
}
