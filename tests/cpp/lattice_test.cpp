// HexFeatureWB - LGPL-2.1-or-later
#include <doctest/doctest.h>

#include <algorithm>
#include <chrono>
#include <set>

#include "fixtures.h"
#include "lattice/lattice.h"

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
