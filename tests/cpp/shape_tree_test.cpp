// HexFeatureWB - LGPL-2.1-or-later
// TriangleTree belongs to the mesh room; the fixtures need the shape room, hence the name.
#include <doctest/doctest.h>

#include <random>

#include "fixtures.h"
#include "mesh/triangle_tree.h"

using namespace hexfeature;
using namespace fixtures;

TEST_CASE("rays along grid lines, through edges and points, keep parity") {
  for (const auto& v : {unit_box(), ell(), plate_with_hole(), hollow_box(), staircase()}) {
    const auto mesh = voxel_surface(v).mesh;
    const TriangleTree tree(mesh);
    std::vector<RayHit> hits;
    for (int axis = 0; axis < 3; ++axis)
      for (double a = -0.5; a < 6; a += 0.25)
        for (double b = -0.5; b < 6; b += 0.25) {
          Vec3 origin;
          origin[axis] = -1;
          origin[(axis + 1) % 3] = a;
          origin[(axis + 2) % 3] = b;
          tree.ray_hits(origin, Vec3::Unit(axis), hits);
          CHECK(hits.size() % 2 == 0);
          for (std::size_t i = 0; i < hits.size(); ++i) CHECK(hits[i].entering == (i % 2 == 0));
        }
  }
}

TEST_CASE("hits and closest points agree with a search over all triangles") {
  auto mesh = voxel_surface(plate_with_boss(), 3).mesh;
  deform(mesh, [](const Vec3& p) { return Vec3(p.x() + 0.2 * std::sin(p.z()), p.y() + 0.1 * p.x() * p.x(), p.z() - 0.2 * p.y()); });
  const TriangleTree tree(mesh);
  std::mt19937 random(7);
  const auto uniform = [&](double lo, double hi) { return lo + (hi - lo) * (random() / 4294967296.0); };
  std::vector<RayHit> hits;
  for (int n = 0; n < 300; ++n) {
    const Vec3 p(uniform(-1, 7), uniform(-1, 7), uniform(-2, 5));
    const bool odd = n % 2 == 1;
    const auto accept = [&](int t) { return !odd || t % 5 == 0; };
    double best = 1e300;
    Vec3 weights;
    for (int t = 0; t < mesh.triangle_count(); ++t) {
      if (!accept(t)) continue;
      const auto& v = mesh.triangles[t];
      best = std::min(best, (closest_on_triangle(p, mesh.points[v[0]], mesh.points[v[1]], mesh.points[v[2]], weights) - p).squaredNorm());
    }
    const auto found = tree.closest_if(p, accept);
    CHECK(found.distance2 == best);
    const auto& v = mesh.triangles[found.triangle];
    const Vec3 q =
        found.barycentric[0] * mesh.points[v[0]] + found.barycentric[1] * mesh.points[v[1]] + found.barycentric[2] * mesh.points[v[2]];
    CHECK((q - found.point).norm() < 1e-12);

    const Vec3 d = Vec3(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1));
    tree.ray_hits(p, d, hits);
    std::size_t count = 0;
    for (int t = 0; t < mesh.triangle_count(); ++t) {
      const auto& w = mesh.triangles[t];
      Mat3 m;
      m << mesh.points[w[1]] - mesh.points[w[0]], mesh.points[w[2]] - mesh.points[w[0]], -d;
      const Vec3 x = m.inverse() * (p - mesh.points[w[0]]);
      count += x[0] >= 0 && x[1] >= 0 && x[0] + x[1] <= 1 && x[2] > 0;
    }
    CHECK(hits.size() == count);
    for (const auto& h : hits) {
      const Vec3 x = p + h.t * d;
      CHECK(tree.closest(x).distance2 < 1e-18);
      CHECK(h.entering == (mesh.area_normal(h.triangle).dot(d) < 0));
    }
  }
}

TEST_CASE("closest point of degenerate triangles, distance limit, empty tree") {
  Vec3 w;
  CHECK((closest_on_triangle(Vec3(2, 1, 0), Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(4, 0, 0), w) - Vec3(2, 0, 0)).norm() < 1e-12);
  CHECK((closest_on_triangle(Vec3(2, 1, 0), Vec3(1, 1, 1), Vec3(1, 1, 1), Vec3(1, 1, 1), w) - Vec3(1, 1, 1)).norm() < 1e-12);
  const auto mesh = voxel_surface(unit_box()).mesh;
  CHECK(TriangleTree(mesh).closest(Vec3(0.5, 0.5, 3), 1.0).triangle == -1);
  CHECK(TriangleTree(mesh, {0, 1}).closest(Vec3(9, 9, 9)).triangle <= 1);
  CHECK(TriangleTree().closest(Vec3(0, 0, 0)).triangle == -1);
}
