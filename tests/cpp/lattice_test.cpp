// HexFeatureWB - LGPL-2.1-or-later
#include "lattice/lattice.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <set>

#include "fixtures.h"

using namespace hexfeature;
using namespace fixtures;

namespace {

Lattice build(const LabelledSurface& surface, double size = 1) {
  QuantizeOptions options;
  options.size = size;
  Context context;
  return build_lattice(surface.mesh, make_feature_shape(surface), options, context);
}

Voxels cells_of(const Lattice& lattice) {
  Voxels v;
  for (const auto& hex : lattice.complex.hexes) {
    const Vec3& p = lattice.complex.points[hex[0]];
    v.insert({static_cast<int>(p[0]), static_cast<int>(p[1]), static_cast<int>(p[2])});
  }
  return v;
}

/// A checker of its own, that knows nothing of how the lattice was made.
void check_complex(const Lattice& lattice, const FeatureShape& shape) {
  const auto& c = lattice.complex;
  REQUIRE(lattice.report.ok);
  for (const auto& hex : c.hexes)
    for (const auto& k : kHexCorners) {
      Mat3 m;
      m << c.points[hex[k[1]]] - c.points[hex[k[0]]], c.points[hex[k[2]]] - c.points[hex[k[0]]], c.points[hex[k[3]]] - c.points[hex[k[0]]];
      CHECK(m.determinant() == 1);
    }
  // The quads are the boundary faces, with the same orientation.
  std::set<std::array<int, 4>> quads;
  const auto turned = [](std::array<int, 4> q) {
    std::rotate(q.begin(), std::min_element(q.begin(), q.end()), q.end());
    return q;
  };
  for (const auto& q : c.quads) quads.insert(turned(q));
  const auto boundary = boundary_faces(c);
  CHECK(boundary.size() == c.quads.size());
  for (const auto& [h, f] : boundary) {
    std::array<int, 4> q;
    for (int i = 0; i < 4; ++i) q[i] = c.hexes[h][kHexFaces[f][i]];
    CHECK(quads.count(turned(q)) == 1);
  }
  // Places: a quad's nodes lie on its chart, its arcs, its corners.
  for (std::size_t i = 0; i < c.quads.size(); ++i)
    for (int p : c.quads[i]) {
      const auto place = c.shape_place[p];
      const int chart = c.quad_chart[i];
      if (place.dim == 2) CHECK(place.item == chart);
      if (place.dim == 1) CHECK((shape.cells.edges[place.item].left == chart || shape.cells.edges[place.item].right == chart));
      if (place.dim == 0) {
        bool found = false;
        for (int d : shape.cells.nodes[place.item].darts) found |= shape.cells.left_of(d) == chart;
        CHECK(found);
      }
    }
  CHECK(std::count_if(c.shape_place.begin(), c.shape_place.end(), [](const ShapePlace& p) { return p.dim == 0; }) == shape.corner_count());
}

}  // namespace

TEST_CASE("voxel shapes come back cell by cell when h is a voxel") {
  for (const auto& v : {unit_box(), ell(), plate_with_hole(), plate_with_boss(), blind_pocket(), hollow_box(), staircase()}) {
    const auto surface = voxel_surface(v);
    const auto lattice = build(surface);
    check_complex(lattice, make_feature_shape(surface));
    CHECK(cells_of(lattice) == v);
    CHECK(lattice.report.rounds == 1);
    CHECK(lattice.polycube.length_error == doctest::Approx(0));
  }
}

TEST_CASE("element sizes follow h") {
  const auto surface = voxel_surface(ell());
  CHECK(build(surface, 0.5).complex.hex_count() == 8 * static_cast<int>(ell().size()));
  CHECK(build(surface, 2.0).complex.hex_count() == static_cast<int>(ell().size()) / 8);
}

TEST_CASE("twisted and bent shapes fill") {
  for (const auto& v : {ell(), plate_with_hole(), plate_with_boss(), blind_pocket(), staircase()}) {
    auto surface = voxel_surface(v, 4);
    deform(surface.mesh, [](const Vec3& p) {
      const double a = 0.12 * p.z() + 0.05 * p.x();
      return Vec3(std::cos(a) * p.x() - std::sin(a) * p.y(), std::sin(a) * p.x() + std::cos(a) * p.y(), p.z() + 0.03 * p.x() * p.x());
    });
    check_complex(build(surface), make_feature_shape(surface));
    check_complex(build(surface, 0.4), make_feature_shape(surface));
  }
}

TEST_CASE("blocks are boxes between chart coordinates") {
  const auto lattice = build(voxel_surface(ell()));
  CHECK(*std::max_element(lattice.complex.hex_block.begin(), lattice.complex.hex_block.end()) == 2);
}

TEST_CASE("a polycube that collides is refused, blamed, and separated") {
  // Two bosses with a narrow gap: put the second on top of the first.
  auto surface = voxel_surface(unite(box({0, 0, 0}, {8, 3, 1}), unite(box({1, 1, 1}, {3, 2, 3}), box({5, 1, 1}, {7, 2, 3}))));
  const auto shape = make_feature_shape(surface);
  Context context;
  Polycube bad = quantize(surface.mesh, shape, QuantizeOptions(), {}, context);
  std::set<int> walls;  // the second boss' two walls across x
  for (int c = 0; c < shape.chart_count(); ++c)
    if (axis_of(shape.charts[c].label) == 0 && shape.charts[c].centroid.x() > 4 && shape.charts[c].centroid.x() < 7.5) walls.insert(c);
  REQUIRE(walls.size() == 2);
  for (int c : walls) bad.coordinate[c] -= 3;
  for (int n = 0; n < shape.corner_count(); ++n)
    for (int dart : shape.cells.nodes[n].darts)
      if (walls.count(shape.cells.left_of(dart))) {
        bad.corners[n][0] -= 3;
        break;
      }
  const auto lattice = fill_lattice(shape, bad, 1, context);
  CHECK(!lattice.report.ok);
  CHECK(lattice.complex.hexes.empty());
  CHECK(!lattice.report.reason.empty());
  CHECK(lattice.report.charts.size() < static_cast<std::size_t>(shape.chart_count()));
  REQUIRE(!lattice.report.separations.empty());
  for (const auto& s : lattice.report.separations) CHECK(shape.charts[s.low].centroid.x() < shape.charts[s.high].centroid.x());
  // What is suggested is enough, without any other order.
  const Polycube apart = Quantizer(surface.mesh, shape, {}, QuantizeOptions()).solve(lattice.report.separations, context);
  CHECK(fill_lattice(shape, apart, 1, context).report.ok);
}

TEST_CASE("features thinner than half an element keep a layer of their own") {
  // A pocket whose floor and a wall are a tenth of an element thick, and two slits as narrow.
  auto v = subtract(box({0, 0, 0}, {7, 5, 4}), box({1, 1, 1}, {4, 4, 4}));
  v = subtract(v, unite(box({5, 0, 1}, {6, 5, 4}), box({5, 0, 0}, {6, 1, 1})));
  auto surface = voxel_surface(v);
  deform(surface.mesh, [](const Vec3& p) {
    const auto squeeze = [](double x) { return x < 1 ? 0.1 * x : x < 4 ? 0.1 + (x - 1) : x < 6 ? 3.1 + 0.1 * (x - 4) : 3.3 + (x - 6); };
    return Vec3(squeeze(p.x()), squeeze(p.y()), squeeze(p.z()));
  });
  check_complex(build(surface), make_feature_shape(surface));
}

TEST_CASE("the same surface gives the same lattice") {
  auto surface = voxel_surface(plate_with_boss(), 3);
  deform(surface.mesh, [](const Vec3& p) { return Vec3(1.37 * p.x() + 0.1 * p.z(), 0.77 * p.y(), 1.21 * p.z()); });
  const auto a = build(surface, 0.41), b = build(surface, 0.41);
  CHECK(a.complex.hexes == b.complex.hexes);
  CHECK(a.complex.points == b.complex.points);
  CHECK(a.complex.quads == b.complex.quads);
}

TEST_CASE("bad input is an error, not a crash") {
  const auto surface = voxel_surface(unit_box());
  CHECK_THROWS_AS(build(surface, 0), MeshingError);
  CHECK_THROWS_AS(build(surface, std::nan("")), MeshingError);
  CHECK(!build(surface, 1e-5).report.ok);  // too many cells
  auto shape = make_feature_shape(surface);
  for (auto& arc : shape.arcs) arc.axis = -1;
  Context context;
  CHECK(!build_lattice(surface.mesh, shape, QuantizeOptions(), context).report.ok);
  context.is_cancelled = [] { return true; };
  CHECK_THROWS_AS(build_lattice(surface.mesh, make_feature_shape(surface), QuantizeOptions(), context), MeshingError);
}

TEST_CASE("speed: a staircase of 600 charts, a box of 100,000 cells") {
  Voxels v;
  for (int i = 0; i < 200; ++i) v = unite(v, box({i, 0, i}, {i + 2, 1 + i % 2, i + 1}));
  const auto seconds = [](const std::function<void()>& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  const auto stairs = voxel_surface(v, 1);
  const auto shape = make_feature_shape(stairs);
  Context context;
  Lattice lattice;
  const double stairs_time = seconds([&] { lattice = build_lattice(stairs.mesh, shape, QuantizeOptions(), context); });
  MESSAGE(shape.chart_count() << " charts: " << stairs_time << " s");
  CHECK(cells_of(lattice) == v);
  const auto cube = voxel_surface(unit_box(), 8);
  const double cube_time = seconds([&] { lattice = build(cube, 1.0 / 46); });
  MESSAGE(lattice.complex.hex_count() << " hexahedra: " << cube_time << " s");
  CHECK(lattice.complex.hex_count() == 46 * 46 * 46);
}
