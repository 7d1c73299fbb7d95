// HexFeatureWB - LGPL-2.1-or-later
#include "sheet/sheet.h"

#include <doctest/doctest.h>

#include "round_parts.h"
#include "sheet/edge_angle.h"
#include "sheet/quad_faces.h"
#include "sheet/shrink_set.h"
#include "sheet/topology.h"

using namespace hexfeature;
using namespace fixtures;

namespace {

SheetReport run(HexPart& part, SheetOptions options = {}) {
  Context context;
  return insert_sheets(part.complex, part.shape, part.geometry(), options, context);
}

std::vector<SheetGroup> groups_of(const HexPart& part, const SheetOptions& options = {}) {
  return find_sheet_groups(part.complex, make_topology(part.complex), part.geometry(), options, {});
}

// Number of hexahedra round the edges between two CAD faces: least, most.
std::array<int, 2> hexes_round(const HexPart& part, int f, int g) {
  const HexTopology t = make_topology(part.complex);
  std::array<int, 2> range{1000, 0};
  for (const auto& e : t.edges) {
    const int a = part.complex.quad_face[e.quads[0]], b = part.complex.quad_face[e.quads[1]];
    if (std::min(a, b) != std::min(f, g) || std::max(a, b) != std::max(f, g)) continue;
    range = {std::min(range[0], e.count), std::max(range[1], e.count)};
  }
  return range;
}

// The fault that a sheet cures: one hexahedron at an edge that is flat in the solid.
int flat_edges(const HexPart& part, double degrees = 135) {
  const HexTopology t = make_topology(part.complex);
  int n = 0;
  for (const auto& e : t.edges) n += e.count == 1 && solid_angle(part.complex, e) > degrees;
  return n;
}

// A plate whose top is cut by a straight CAD edge that is followed by mesh edges with two turns to the left and two to the right.
struct StairPart : HexPart {
  int cad_edge = 0;
  std::vector<int> line;  // its nodes
};

StairPart stair_part() {
  const std::vector<std::array<int, 2>> stairs{{0, 1}, {1, 1}, {2, 1}, {2, 2}, {3, 2}, {4, 2}, {4, 3}, {5, 3}, {6, 3}};
  const auto map = [&](const Vec3& p) -> Vec3 {
    for (std::size_t k = 0; k < stairs.size(); ++k)
      if (p[0] == stairs[k][0] && p[1] == stairs[k][1]) return {0.75 * k, 1 + 0.25 * k, p[2]};
    return p;
  };
  StairPart part;
  static_cast<HexPart&>(part) =
      make_hex_part(box({0, 0, 0}, {6, 4, 2}), 1, map,
                    {plane({6, 0, 0}, Vec3::UnitX()), plane(Vec3::Zero(), -Vec3::UnitX()), plane({0, 4, 0}, Vec3::UnitY()),
                     plane(Vec3::Zero(), -Vec3::UnitY()), plane({0, 0, 2}, Vec3::UnitZ()), plane(Vec3::Zero(), -Vec3::UnitZ())},
                    [](Label l, const Vec3&) { return l + 1; });
  HexComplex& c = part.complex;
  part.projector.faces.push_back(plane({0, 1, 0}, {-0.25, 0.75, 0}));
  part.projector.edges.push_back({5, 7});
  CadEdge edge;
  edge.faces = {5, 5};
  edge.sharp = false;
  part.edges.push_back(edge);
  part.cad_edge = static_cast<int>(part.edges.size());
  std::vector<std::pair<std::array<int, 2>, int>> features;
  for (std::size_t i = 0; i < c.feature_edges.size(); ++i) features.push_back({c.feature_edges[i], c.feature_edge_cad[i]});
  for (std::size_t k = 0; k < stairs.size(); ++k) {
    const Vec3 at(0.75 * k, 1 + 0.25 * k, 2);
    const auto here = std::find_if(c.points.begin(), c.points.end(), [&](const Vec3& p) { return (p - at).norm() < 1e-9; });
    const int v = static_cast<int>(here - c.points.begin());
    if (k > 0) features.push_back({{std::min(part.line.back(), v), std::max(part.line.back(), v)}, part.cad_edge});
    part.line.push_back(v);
    if (k > 0 && k + 1 < stairs.size()) c.place[v] = {1, part.cad_edge, Vec2(at[0], 0)};
  }
  std::sort(features.begin(), features.end());
  c.feature_edges.clear();
  c.feature_edge_cad.clear();
  for (const auto& [nodes, cad] : features) {
    c.feature_edges.push_back(nodes);
    c.feature_edge_cad.push_back(cad);
  }
  return part;
}

}  // namespace

TEST_CASE("fixtures are sound complexes") {
  for (const auto& part :
       {cylinder_part(), sphere_part(), boss_part(), flange_part(), shaft_part(), block_part(), drilled_part(), pocket_part()})
    CHECK(check_complex(part.complex) == "");
}

TEST_CASE("angles in the solid: 90 at a box edge, 270 in a pocket, 180 on a cylinder's side") {
  const auto block = block_part();
  for (const auto& e : make_topology(block.complex).edges) {
    const double angle = solid_angle(block.complex, e);
    CHECK((std::abs(angle - 90) < 1e-9 || std::abs(angle - 180) < 1e-9));
  }
  const auto pocket = pocket_part();
  for (const auto& e : make_topology(pocket.complex).edges)
    if (e.count == 3 && pocket.complex.quad_face[e.quads[0]] != pocket.complex.quad_face[e.quads[1]])
      CHECK(solid_angle(pocket.complex, e) == doctest::Approx(270).epsilon(0.1));
}

TEST_CASE("largest minimum cut") {
  // 0 -5- 1 -5- 2 -5- 3: three cuts of the same cost; the largest set leaves only the sink.
  const auto chain = [](std::array<long long, 3> c) {
    std::vector<CutArc> arcs;
    for (int i = 0; i < 3; ++i) {
      arcs.push_back({i, i + 1, c[i]});
      arcs.push_back({i + 1, i, c[i]});
    }
    return largest_minimum_cut(4, arcs, 0, 3);
  };
  CHECK(chain({5, 5, 5}) == std::vector<char>{1, 1, 1, 0});
  CHECK(chain({5, 2, 5}) == std::vector<char>{1, 1, 0, 0});
}

TEST_CASE("nothing round, no sheet") {
  for (auto part : {block_part(), drilled_part()}) {
    const int before = part.complex.hex_count();
    const SheetReport report = run(part);
    CHECK(report.inserted == 0);
    CHECK(report.refused == 0);
    CHECK(part.complex.hex_count() == before);
  }
}

TEST_CASE("cylinder: one sheet along the side, out through both caps") {
  auto part = cylinder_part(3);
  CHECK(flat_edges(part) > 0);
  const int hexes = part.complex.hex_count(), quads = static_cast<int>(part.complex.quads.size());
  const SheetReport report = run(part);
  CHECK(report.inserted == 1);
  CHECK(report.refused == 0);
  REQUIRE(report.chart_groups.size() == 1);
  CHECK(report.chart_groups[0].size() == 4);
  CHECK(check_complex(part.complex) == "");
  CHECK(part.complex.hex_count() == hexes + 24 * 6);
  CHECK(static_cast<int>(part.complex.quads.size()) == quads + 2 * 24);
  CHECK(flat_edges(part) == 0);
  CHECK(hexes_round(part, 1, 2) == std::array<int, 2>{1, 1});  // the caps' rims stay sharp
  CHECK(groups_of(part).empty());
  // Every node is still on its CAD entity; the rims are followed all round.
  for (int v = 0; v < part.complex.point_count(); ++v)
    if (part.complex.place[v].dim == 2) {
      const Vec3 p = part.projector.project_to_face(part.complex.place[v].entity, part.complex.points[v], nullptr).point;
      CHECK((p - part.complex.points[v]).norm() < 1e-12);
    }
  CHECK(part.complex.feature_edges.size() == 2 * 24);
}

TEST_CASE("sphere: a sheet all round, which leaves nowhere") {
  auto part = sphere_part(2);
  const int quads = static_cast<int>(part.complex.quads.size()), hexes = part.complex.hex_count();
  const SheetReport report = run(part);
  CHECK(report.inserted == 1);
  CHECK(check_complex(part.complex) == "");
  CHECK(static_cast<int>(part.complex.quads.size()) == quads);
  CHECK(part.complex.hex_count() == hexes + quads);
  CHECK(flat_edges(part) == 0);
}

TEST_CASE("boss on a plate: the sheet goes on under the boss and out at the bottom") {
  auto part = boss_part();
  const SheetReport report = run(part);
  CHECK(report.inserted == 1);
  CHECK(check_complex(part.complex) == "");
  CHECK(flat_edges(part) == 0);
  const auto foot = hexes_round(part, 7, 5);
  CHECK(foot[0] == 3);
  CHECK(foot[1] == 3);
  // New quads at the bottom (exit) and on the boss' top: as many as there are edges round the boss.
  int bottom = 0;
  for (std::size_t q = 0; q < part.complex.quads.size(); ++q) bottom += part.complex.quad_face[q] == 6;
  CHECK(bottom == 16 * 16 + 16);
}

TEST_CASE("flange and shaft: one sheet for each cylinder, each through its own faces") {
  auto flange = flange_part();
  SheetReport report = run(flange);
  CHECK(report.inserted == 2);
  CHECK(report.refused == 0);
  CHECK(check_complex(flange.complex) == "");
  CHECK(flat_edges(flange) == 0);
  auto shaft = shaft_part();
  report = run(shaft);
  CHECK(report.inserted == 2);  // the shoulder, and the two ends together
  CHECK(report.refused == 0);
  CHECK(check_complex(shaft.complex) == "");
  CHECK(flat_edges(shaft) == 0);
}

TEST_CASE("stepped shaft: each sheet runs through the whole part, unless it may end inside where that is shorter") {
  const int n = 2;
  SheetOptions shorter;
  shorter.run_through = false;
  for (const bool run_through : {true, false}) {
    auto shaft = stepped_shaft_part(n);
    const SheetReport report = run(shaft, run_through ? SheetOptions{} : shorter);
    CHECK(report.inserted == 3);
    CHECK(report.refused == 0);
    CHECK(report.run_through == (run_through ? 1 : 0));  // the others run through either way
    CHECK(check_complex(shaft.complex) == "");
    CHECK(flat_edges(shaft) == 0);
    // Round the narrow end's square, 8 n edges, along the part's 7 n layers; or the 2 n of that end, n under it and its square.
    const auto& faces = shaft.complex.quad_face;
    const int narrow = shaft.complex.quad_chart[std::find(faces.begin(), faces.end(), 1) - faces.begin()];
    for (std::size_t i = 0; i < report.hexes.size(); ++i) {
      const auto& charts = report.chart_groups[i];
      if (std::find(charts.begin(), charts.end(), narrow) != charts.end())
        CHECK(report.hexes[i][1] - report.hexes[i][0] == (run_through ? 8 * n * 7 * n : 8 * n * 4 * n + 2 * n * 2 * n));
    }
  }
}

TEST_CASE("cam: at its step the sheet wraps the tip's edge, unless that is acute; then it goes straight into the solid") {
  for (const double below : {-0.5, 1.0}) {
    CAPTURE(below);
    auto part = cam_part(below);
    CHECK(check_complex(part.complex) == "");
    CHECK(hexes_round(part, 1, 3) == std::array<int, 2>{1, 1});  // the tip, 100 or 72 degrees
    const SheetReport report = run(part);
    CHECK(report.inserted == 1);
    CHECK(report.refused == 0);
    CHECK(check_complex(part.complex) == "");
    CHECK(flat_edges(part) == 0);
    const int tip = below > 0 ? 1 : 2, foot = below > 0 ? 3 : 2;
    CHECK(hexes_round(part, 1, 3) == std::array<int, 2>{tip, tip});
    CHECK(hexes_round(part, 2, 3) == std::array<int, 2>{foot, foot});
  }
}

TEST_CASE("tee: a sheet along the main pipe, under the branch; another along the branch") {
  auto part = tee_part();
  CHECK(check_complex(part.complex) == "");
  const SheetReport report = run(part);
  CHECK(report.inserted == 2);
  CHECK(report.refused == 0);
  CHECK(check_complex(part.complex) == "");
  CHECK(flat_edges(part) == 0);
}

TEST_CASE("blind round pocket: its floor gets a sheet, down and out at the bottom") {
  auto part = pocket_part();
  const SheetReport report = run(part);
  CHECK(report.inserted == 1);
  CHECK(report.refused == 0);
  CHECK(check_complex(part.complex) == "");
  CHECK(groups_of(part).empty());
  int floor = 0;
  for (int f : part.complex.quad_face) floor += f == 8;
  CHECK(floor == 4 * 4 + 16);
}

TEST_CASE("at most so many sheets; a refused sheet leaves the complex alone; the same again gives the same") {
  auto part = flange_part();
  SheetOptions options;
  options.max_sheets = 0;
  CHECK(run(part, options).inserted == 0);
  options.max_sheets = 1;
  CHECK(run(part, options).inserted == 1);
  CHECK(check_complex(part.complex) == "");
  auto again = flange_part();
  run(again, options);
  CHECK(again.complex.hexes == part.complex.hexes);
  CHECK(again.complex.quads == part.complex.quads);
  CHECK(again.complex.points == part.complex.points);
  // A group without smooth edges has nothing to shrink.
  Context context;
  const auto before = part.complex.hexes;
  CHECK(insert_sheet(part.complex, make_topology(part.complex), part.shape, part.geometry(), SheetGroup{}, {}, context) != "");
  CHECK(part.complex.hexes == before);
}

namespace {

/// What becomes of a sheet round everything but one hexahedron of a pocket's part: the middle one of three at an edge of the floor's rim.
LayerRefusal leave_along_the_rim(HexPart& part, const SheetOptions& options = {}) {
  const HexTopology t = make_topology(part.complex);
  ShrinkSet set;
  set.inside.assign(part.complex.hexes.size(), 1);
  set.covered.assign(part.shape.chart_count(), 0);
  for (const auto& e : t.edges) {
    const int f = part.complex.quad_face[e.quads[0]], g = part.complex.quad_face[e.quads[1]];
    if (e.count != 3 || std::min(f, g) != 7 || std::max(f, g) != 8) continue;
    if (part.complex.shape_place[e.nodes[0]].dim == 0 || part.complex.shape_place[e.nodes[1]].dim == 0) continue;
    for (int i = 0; i < e.count; ++i) {
      const int h = t.edge_hexes[e.first + i];
      if (h != t.hex_of_quad(e.quads[0]) && h != t.hex_of_quad(e.quads[1])) set.inside[h] = 0;
    }
    break;
  }
  return insert_layer(part.complex, t, part.shape, part.geometry(), set, options, {});
}

}  // namespace

TEST_CASE("a sheet that leaves along a CAD edge and turns off it within one quad is refused") {
  auto part = pocket_part(3);
  const auto before = part.complex.hexes;
  const LayerRefusal refusal = leave_along_the_rim(part);
  CAPTURE(refusal.reason);
  CHECK(refusal.reason.find("one quad") != std::string::npos);
  CHECK(!refusal.together.empty());
  CHECK(part.complex.hexes == before);
}

TEST_CASE("... unless the quad's two edges on it are long enough for the arc to turn off by itself") {
  auto part = pocket_part(2);
  SheetOptions thick;
  thick.thickness = 1.5;  // 22 degrees of the rim to one side, 34 to the other: a corner of 152
  const LayerRefusal refusal = leave_along_the_rim(part, thick);
  CAPTURE(refusal.reason);
  CHECK(refusal.reason.find("one quad") == std::string::npos);
}

TEST_CASE("sheets are left out by name, one by one; those near bad elements are found") {
  auto part = flange_part();
  const auto before = part.complex.hexes;
  auto again = flange_part();
  const SheetReport all = run(part);
  REQUIRE(all.names.size() == 2);
  CHECK(all.names[0] != all.names[1]);
  CHECK(all.hexes[0][0] == static_cast<int>(before.size()));
  CHECK(all.hexes[0][1] == all.hexes[1][0]);
  CHECK(all.hexes[1][1] == part.complex.hex_count());

  std::vector<double> quality(part.complex.hexes.size(), 1.0);
  CHECK(sheets_near(part.complex, all, quality, 0.5).empty());
  quality[all.hexes[1][0]] = 0.1;
  const std::vector<int> near = sheets_near(part.complex, all, quality, 0.5);
  CHECK(std::count(near.begin(), near.end(), 1) == 1);

  SheetOptions options;
  options.without = {all.names[0]};
  const SheetReport rest = run(again, options);
  CHECK(rest.names == std::vector<std::vector<int>>{all.names[1]});
  CHECK(check_complex(again.complex) == "");
  auto none = flange_part();
  options.without = all.names;
  CHECK(run(none, options).inserted == 0);
  CHECK(none.complex.hexes == before);
}

TEST_CASE("a CAD edge followed with turns: one floor on each side, along the whole line, whatever turns it meets") {
  const StairPart part = stair_part();
  const HexComplex& c = part.complex;
  REQUIRE(check_complex(c) == "");
  const std::vector<SheetGroup> groups = groups_of(part);
  REQUIRE(groups.size() == 2);
  CHECK(groups[0].left != groups[1].left);
  for (const SheetGroup& g : groups) {
    CHECK(g.cad_edge == part.cad_edge);
    CHECK(g.floor_chart == part.charts_of(4).front());
    REQUIRE(g.floor_quads.size() == g.floor_edges.size());
    std::set<std::array<int, 2>> edges(g.floor_edges.begin(), g.floor_edges.end());
    CHECK(edges.size() == part.line.size() - 1);  // two turns its way, two the other: none ends it
    for (std::size_t i = 0; i < g.floor_edges.size(); ++i) {
      const auto& quad = c.quads[g.floor_quads[i]];
      Vec3 centre = Vec3::Zero();
      for (int v : quad) centre += 0.25 * c.points[v];
      for (int v : g.floor_edges[i]) CHECK(std::count(quad.begin(), quad.end(), v) == 1);
      CHECK((Vec3(-0.25, 0.75, 0).dot(centre - Vec3(0, 1, 0)) > 0) == g.left);
    }
  }
}

TEST_CASE("a CAD edge followed with turns: another CAD edge that it meets ends the floor") {
  StairPart part = stair_part();
  // The last three edges belong to another one.
  part.edges.push_back(part.edges.back());
  part.projector.edges.push_back(part.projector.edges.back());
  for (std::size_t k = 5; k + 1 < part.line.size(); ++k)
    for (std::size_t i = 0; i < part.complex.feature_edges.size(); ++i) {
      const auto& e = part.complex.feature_edges[i];
      if (e == std::array<int, 2>{std::min(part.line[k], part.line[k + 1]), std::max(part.line[k], part.line[k + 1])})
        part.complex.feature_edge_cad[i] = part.cad_edge + 1;
    }
  std::map<int, std::size_t> longest;
  for (const SheetGroup& g : groups_of(part)) longest[g.cad_edge] = std::max(longest[g.cad_edge], g.floor_edges.size());
  CHECK(longest[part.cad_edge] == 5);
  CHECK(longest[part.cad_edge + 1] == 3);
}

TEST_CASE("a CAD edge followed with turns: sheets take its flat corners away") {
  StairPart part = stair_part();
  const auto flat_corners = [&] {
    const HexComplex& c = part.complex;
    int flat = 0;
    for (int q = 0; q < static_cast<int>(c.quads.size()); ++q)
      for (int i = 0; i < 4; ++i) {
        const auto& n = c.quads[q];
        flat += feature_of(c, n[i], n[(i + 1) % 4]) == part.cad_edge && feature_of(c, n[(i + 3) % 4], n[i]) == part.cad_edge &&
                corner_angle(c, q, i) > 140;
      }
    return flat;
  };
  CHECK(flat_corners() == 4);
  const SheetReport report = run(part);
  CHECK(report.inserted == 2);
  CHECK(check_complex(part.complex) == "");
  CHECK(flat_corners() == 0);
}

TEST_CASE("an edge that is sharp in the CAD needs no sheet, however its quads lie") {
  auto part = cylinder_part(3);
  for (auto& e : part.edges) e.dihedral = 0;  // the rims would count as smooth now
  CHECK(groups_of(part).size() == 1);
  SheetOptions strict;
  strict.crease_angle = 0;  // nothing is smooth
  CHECK(groups_of(part, strict).empty());
}

TEST_CASE("quads along a sharp CAD edge lie on its two faces, whatever face a sheet left them with") {
  auto part = block_part();
  HexComplex& c = part.complex;
  const std::vector<int> right = c.quad_face;
  CHECK(face_quads_at_sharp_edges(c, part.geometry()) == 0);
  CHECK(c.quad_face == right);

  // A quad with one side on a sharp edge and a wrong face is put right.
  const HexTopology topology = make_topology(c);
  const auto sides_on_edges = [&](int q) {
    int n = 0;
    for (int k = 0; k < 4; ++k) n += feature_of(c, c.quads[q][k], c.quads[q][(k + 1) % 4]) > 0;
    return n;
  };
  int changed = 0;
  for (std::size_t e = 0; e < c.feature_edges.size(); ++e) {
    const auto* edge = topology.find_edge(c.feature_edges[e][0], c.feature_edges[e][1]);
    REQUIRE(edge);
    const int q = edge->quads[0];
    if (sides_on_edges(q) != 1) continue;
    for (int wrong = 1; wrong <= static_cast<int>(part.faces.size()); ++wrong) {
      if (wrong == right[q] || wrong == right[edge->quads[1]]) continue;
      c.quad_face[q] = wrong;
      CHECK(face_quads_at_sharp_edges(c, part.geometry()) == 1);
      CHECK(c.quad_face == right);
      ++changed;
    }
  }
  CHECK(changed > 0);
  // Along a tangent edge nothing says where a quad lies.
  for (CadEdge& e : part.edges) e.sharp = false;
  const int q = topology.find_edge(c.feature_edges[0][0], c.feature_edges[0][1])->quads[0];
  c.quad_face[q] = right[q] % 6 + 1;
  CHECK(face_quads_at_sharp_edges(c, part.geometry()) == 0);
  CHECK(c.quad_face[q] == right[q] % 6 + 1);
}

TEST_CASE("a complex that is none is an error") {
  auto part = block_part();
  part.complex.quads.pop_back();
  part.complex.quad_chart.pop_back();
  part.complex.quad_face.pop_back();
  CHECK_THROWS_AS(run(part), MeshingError);
}
