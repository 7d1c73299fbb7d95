// HexFeatureWB - LGPL-2.1-or-later
// Format: I-DEAS Test Universal File Format, datasets 164, 2411, 2412 and 2467.
#include <algorithm>
#include <string>

#include "write/cad_groups.h"
#include "write/output_file.h"
#include "write/write.h"

namespace hexfeature {
namespace {
constexpr int kBrick = 115, kBrick20 = 116, kQuad = 94, kQuad8 = 95;  // finite-element descriptors
constexpr int kNodes = 7, kElements = 8;                              // group entity types

// Second order goes round each layer, corner and mid-side in turn (VTK positions).
constexpr std::array<int, 20> kBrick20Order = {0, 8, 1, 9, 2, 10, 3, 11, 16, 17, 18, 19, 4, 12, 5, 13, 6, 14, 7, 15};
constexpr std::array<int, 8> kQuad8Order = {0, 4, 1, 5, 2, 6, 3, 7};

class UnvFile {
 public:
  explicit UnvFile(const std::string& path) : out_(path) {}

  void open(int dataset) {
    out_ << "    -1\n";
    record({dataset}, 6);
  }
  void close() { out_ << "    -1\n"; }
  void record(std::initializer_list<int> values, int width = 10) {
    for (int v : values) out_.padded(v, width);
    out_ << "\n";
  }
  template <class Cell, class Order>
  void element(int label, int descriptor, const Cell& cell, const Order& order) {
    // label, descriptor, physical and material property tables, colour, number of nodes
    record({label, descriptor, 1, 1, 7, static_cast<int>(cell.size())});
    for (std::size_t k = 0; k < cell.size(); ++k) {
      out_.padded(cell[order[k]] + 1, 10);
      if (k % 8 == 7 || k + 1 == cell.size()) out_ << "\n";
    }
  }
  void groups(const char* kind, const std::vector<CadGroup>& groups, int entity_type, int offset) {
    for (const CadGroup& g : groups) group(kind + std::to_string(g.number), g.items, entity_type, offset);
  }
  void group(const std::string& name, const std::vector<int>& items, int entity_type, int offset) {
    record({++group_count_, 0, 0, 0, 0, 0, 0, static_cast<int>(items.size())});
    out_ << name << "\n";
    for (std::size_t i = 0; i < items.size(); ++i) {
      for (int v : {entity_type, items[i] + offset, 0, 0}) out_.padded(v, 10);
      if (i % 2 == 1 || i + 1 == items.size()) out_ << "\n";
    }
  }
  OutputFile& out() { return out_; }

 private:
  OutputFile out_;
  int group_count_ = 0;
};
}  // namespace

void write_unv(const MeshView& view, const std::string& path) {
  const HexComplex& mesh = view.mesh;
  const CadGroups groups = group_by_cad(view);
  UnvFile file(path);
  OutputFile& out = file.out();

  file.open(164);  // the part's own unit is kept: factors 1
  out << "         1  SI: Meter (newton)         2\n";
  for (int i = 0; i < 3; ++i) out.fortran(1);
  out << "\n";
  out.fortran(273.15);
  out << "\n";
  file.close();

  file.open(2411);
  for (int n = 0; n < mesh.point_count(); ++n) {
    file.record({n + 1, 1, 1, 11});
    for (int k = 0; k < 3; ++k) out.fortran(mesh.points[n][k]);
    out << "\n";
  }
  file.close();

  constexpr std::array<int, 8> same = {0, 1, 2, 3, 4, 5, 6, 7};
  const int hexes = mesh.hex_count(), quads = static_cast<int>(mesh.quads.size());
  file.open(2412);
  for (int h = 0; h < hexes; ++h)
    if (view.second_order())
      file.element(h + 1, kBrick20, view.hexes20[h], kBrick20Order);
    else
      file.element(h + 1, kBrick, mesh.hexes[h], same);
  for (int q = 0; q < quads; ++q)
    if (view.second_order())
      file.element(hexes + q + 1, kQuad8, view.quads8[q], kQuad8Order);
    else
      file.element(hexes + q + 1, kQuad, mesh.quads[q], same);
  file.close();

  file.open(2467);
  file.groups("Solid", groups.solid_hexes, kElements, 1);
  for (const NamedSolids& named : named_solids(view.solid_names)) {
    std::vector<int> items;
    for (const CadGroup& solid : groups.solid_hexes)
      if (std::find(named.solids.begin(), named.solids.end(), solid.number) != named.solids.end())
        items.insert(items.end(), solid.items.begin(), solid.items.end());
    if (!items.empty()) file.group(named.name, items, kElements, 1);
  }
  file.groups("Face", groups.face_quads, kElements, hexes + 1);
  file.groups("Edge", groups.edge_nodes, kNodes, 1);
  file.groups("Vertex", groups.vertex_nodes, kNodes, 1);
  file.close();
  out.commit();
}

}  // namespace hexfeature
