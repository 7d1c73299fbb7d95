// HexFeatureWB - LGPL-2.1-or-later
// Format: "VTK File Formats", legacy format version 3.0, which every reader knows.
#include <algorithm>
#include <functional>
#include <string>

#include "write/cad_groups.h"
#include "write/output_file.h"
#include "write/write.h"

namespace hexfeature {
namespace {

template <class Cells>
void write_cells(OutputFile& out, const Cells& cells) {
  for (const auto& cell : cells) {
    out.big_endian(static_cast<int>(cell.size()));
    for (int n : cell) out.big_endian(n);
  }
}

struct IntArray {
  const char* name;
  std::function<int(int)> value;
};

void write_arrays(OutputFile& out, int count, const std::vector<IntArray>& arrays) {
  out << "FIELD FieldData " << static_cast<int>(arrays.size()) << "\n";
  for (const IntArray& array : arrays) {
    out << array.name << " 1 " << count << " int\n";
    for (int i = 0; i < count; ++i) out.big_endian(array.value(i));
    out << "\n";
  }
}

/// Of the hexahedra, then of the quads: a quad belongs to the solid of its hexahedron.
std::vector<int> solid_of_cells(const HexComplex& mesh) {
  std::vector<int> solid = mesh.hex_solid;
  solid.resize(mesh.hexes.size(), 1);
  const bool single = std::all_of(solid.begin(), solid.end(), [](int s) { return s == 1; });
  solid.resize(mesh.hexes.size() + mesh.quads.size(), 1);
  if (single) return solid;
  const auto sides = sides_of_quads(mesh);
  for (std::size_t q = 0; q < sides.size(); ++q)
    if (sides[q][0] >= 0) solid[mesh.hexes.size() + q] = solid[sides[q][0]];
  return solid;
}
}  // namespace

void write_vtk(const MeshView& view, const std::string& path) {
  const HexComplex& mesh = view.mesh;
  const int hexes = mesh.hex_count(), quads = static_cast<int>(mesh.quads.size()), cells = hexes + quads;
  const bool second = view.second_order();

  OutputFile out(path);
  out << "# vtk DataFile Version 3.0\nHexFeatureWB\nBINARY\nDATASET UNSTRUCTURED_GRID\n";
  out << "POINTS " << mesh.point_count() << " double\n";
  for (const Vec3& p : mesh.points)
    for (int k = 0; k < 3; ++k) out.big_endian(p[k]);

  out << "\nCELLS " << cells << " " << (second ? 21 * hexes + 9 * quads : 9 * hexes + 5 * quads) << "\n";
  if (second) {
    write_cells(out, view.hexes20);
    write_cells(out, view.quads8);
  } else {
    write_cells(out, mesh.hexes);
    write_cells(out, mesh.quads);
  }
  out << "\nCELL_TYPES " << cells << "\n";
  for (int c = 0; c < cells; ++c) out.big_endian(c < hexes ? (second ? 25 : 12) : (second ? 23 : 9));

  const std::vector<int> solid = solid_of_cells(mesh);
  out << "\nCELL_DATA " << cells << "\n";
  write_arrays(
      out, cells,
      {{"cad_face", [&](int c) { return c < hexes ? 0 : mesh.quad_face[c - hexes]; }}, {"cad_solid", [&](int c) { return solid[c]; }}});
  if (static_cast<int>(mesh.place.size()) == mesh.point_count()) {
    out << "POINT_DATA " << mesh.point_count() << "\n";
    write_arrays(out, mesh.point_count(),
                 {{"cad_dim", [&](int n) { return mesh.place[n].dim; }}, {"cad_entity", [&](int n) { return mesh.place[n].entity; }}});
  }
  out.commit();
}

}  // namespace hexfeature
