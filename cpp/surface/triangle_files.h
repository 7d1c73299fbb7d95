// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include <array>
#include <string>
#include <vector>

#include "base/types.h"

namespace hexfeature {

/// Triangles as a file has them: points may repeat.
struct TriangleSoup {
  std::vector<Vec3> points;
  std::vector<std::array<int, 3>> triangles;
};

/// Read .stl (ASCII, binary), .obj (polygons are cut into fans) or .ply (ASCII, binary of either byte order).
/// Throws MeshingError(BadInput, "read") on anything that is missing, truncated, not finite or out of range.
TriangleSoup read_triangle_file(const std::string& path);

/// The same from the file's content; `ending` is .stl, .obj or .ply.
TriangleSoup parse_triangles(const std::string& text, const std::string& ending);

}  // namespace hexfeature
