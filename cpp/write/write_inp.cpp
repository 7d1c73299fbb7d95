// HexFeatureWB - LGPL-2.1-or-later
// Format: CalculiX CrunchiX user's manual, *NODE, *ELEMENT, *NSET, *SURFACE. Abaqus numbers the nodes of C3D8 and C3D20 as
// VTK does, and its face S1..S6 is kHexFaces[0..5].
#include <algorithm>
#include <string>

#include "base/error.h"
#include "write/cad_groups.h"
#include "write/output_file.h"
#include "write/write.h"

namespace hexfeature {
namespace {
constexpr int kEntriesPerLine = 16;
constexpr int kNumberWidth = 20;  // CalculiX reads no more of a number

std::string element_type(const MeshView& view, const WriteOptions& options) {
  const std::vector<std::string> known =
      view.second_order() ? std::vector<std::string>{"C3D20R", "C3D20"} : std::vector<std::string>{"C3D8", "C3D8R", "C3D8I"};
  if (options.element_type.empty()) return known[0];
  if (std::find(known.begin(), known.end(), options.element_type) != known.end()) return options.element_type;
  std::string all;
  for (const auto& name : known) all += (all.empty() ? "" : ", ") + name;
  throw MeshingError(Failure::Usage, "write", "element type '" + options.element_type + "' does not fit the order of the mesh",
                     "use one of " + all);
}

/// Comma-separated, 16 to a line; a line that goes on ends with a comma.
template <class Items>
void write_list(OutputFile& out, const Items& items, int first_column, bool continued) {
  int column = first_column;
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (column == kEntriesPerLine) {
      out << (continued ? ",\n" : "\n");
      column = 0;
    } else if (column > 0) {
      out << ",";
    }
    out << items[i] + 1;
    ++column;
  }
  out << "\n";
}

void write_node_sets(OutputFile& out, const char* kind, const std::vector<CadGroup>& groups) {
  for (const CadGroup& group : groups) {
    out << "*NSET, NSET=" << kind << group.number << "\n";
    write_list(out, group.items, 0, false);
  }
}

template <class Cells>
void write_elements(OutputFile& out, const Cells& cells, const std::vector<CadGroup>& solids, const std::string& type) {
  for (const CadGroup& solid : solids) {
    out << "*ELEMENT, TYPE=" << type << ", ELSET=Solid" << solid.number << "\n";
    for (int h : solid.items) {
      out << h + 1;
      write_list(out, cells[h], 1, true);
    }
  }
}
}  // namespace

void write_inp(const MeshView& view, const std::string& path, const WriteOptions& options) {
  const HexComplex& mesh = view.mesh;
  const std::string type = element_type(view, options);
  const CadGroups groups = group_by_cad(view);
  const auto sides = sides_of_quads(mesh);

  OutputFile out(path);
  out << "** HexFeatureWB\n*NODE, NSET=Nodes\n";
  for (int n = 0; n < mesh.point_count(); ++n) {
    out << n + 1;
    for (int k = 0; k < 3; ++k) {
      out << ",";
      out.number(mesh.points[n][k], kNumberWidth);
    }
    out << "\n";
  }
  if (view.second_order())
    write_elements(out, view.hexes20, groups.solid_hexes, type);
  else
    write_elements(out, mesh.hexes, groups.solid_hexes, type);

  for (const NamedSolids& named : named_solids(view.solid_names)) {
    out << "*ELSET, ELSET=" << named.name << "\n";
    for (int s : named.solids) out << "Solid" << s << "\n";
  }
  write_node_sets(out, "Face", groups.face_nodes);
  write_node_sets(out, "Edge", groups.edge_nodes);
  write_node_sets(out, "Vertex", groups.vertex_nodes);
  for (const CadGroup& face : groups.face_quads) {
    out << "*SURFACE, NAME=Face" << face.number << ", TYPE=ELEMENT\n";
    for (int q : face.items)
      if (sides[q][0] >= 0) out << sides[q][0] + 1 << ",S" << sides[q][1] + 1 << "\n";
  }
  out.commit();
}

}  // namespace hexfeature
