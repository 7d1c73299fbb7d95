// HexFeatureWB - LGPL-2.1-or-later
// Round solids for the unit tests, with their CAD tables and an analytic projector: no OCCT needed.
#pragma once
#include <cmath>
#include <memory>
#include <vector>

#include "mesh/geometry.h"
#include "mesh/surface_mesh.h"

namespace fixtures {

/// A cylinder (face 1; caps 2 bottom, 3 top; edges 1 bottom, 2 top), a sphere (face 1) or a torus (face 1) about an axis
/// through the origin: the local z axis, turned by `turn`.
struct RoundSolid : hexfeature::Projector {
  hexfeature::SurfaceMesh mesh;
  std::vector<hexfeature::CadFace> faces;
  std::vector<hexfeature::CadEdge> edges;
  std::vector<hexfeature::CadVertex> vertices;
  hexfeature::Mat3 turn = hexfeature::Mat3::Identity();
  double radius = 1, minor = 0.3, height = 2;

  hexfeature::Geometry geometry() const { return {&faces, &edges, &vertices, this}; }

  hexfeature::FacePoint project_to_face(int face, const hexfeature::Vec3& world, const hexfeature::Vec2*) const override {
    using namespace hexfeature;
    const Vec3 p = turn.transpose() * world;
    const Vec3 radial = Vec3(p[0], p[1], 0).normalized();
    FacePoint on;
    on.uv = Vec2(std::atan2(p[1], p[0]), p[2]);
    if (face > 1) {
      on.normal = Vec3(0, 0, face == 2 ? -1 : 1);
      on.point = Vec3(p[0], p[1], face == 2 ? 0 : height);
    } else if (faces[0].kind == SurfaceKind::Cylinder) {
      on.normal = radial;
      on.point = radius * radial + Vec3(0, 0, p[2]);
    } else if (faces[0].kind == SurfaceKind::Torus) {
      on.normal = (p - radius * radial).normalized();
      on.point = radius * radial + minor * on.normal;
    } else {
      on.normal = p.normalized();
      on.point = radius * on.normal;
    }
    on.point = turn * on.point;
    on.normal = turn * on.normal;
    return on;
  }
  hexfeature::CurvePoint project_to_edge(int edge, const hexfeature::Vec3& world, const double*) const override {
    const hexfeature::Vec3 p = turn.transpose() * world;
    return edge_point(edge, std::atan2(p[1], p[0]));
  }
  hexfeature::Vec3 vertex_point(int) const override { return hexfeature::Vec3::Zero(); }
  hexfeature::CurvePoint edge_point(int edge, double t) const override {
    using namespace hexfeature;
    return {turn * Vec3(radius * std::cos(t), radius * std::sin(t), edge == 1 ? 0 : height), turn * Vec3(-std::sin(t), std::cos(t), 0), t};
  }

  int add_point(const hexfeature::Vec3& local, int dim, int entity) {
    mesh.points.push_back(turn * local);
    mesh.place.push_back({dim, entity, hexfeature::Vec2(std::atan2(local[1], local[0]), local[2])});
    return static_cast<int>(mesh.points.size()) - 1;
  }
  void add_triangle(int a, int b, int c, int face) {
    if (a == b || b == c || c == a) return;
    mesh.triangles.push_back({a, b, c});
    mesh.triangle_face.push_back(face);
    for (int v : {a, b, c}) mesh.corner_normals.push_back(project_to_face(face, mesh.points[v], nullptr).normal);
    const int v[4] = {a, b, c, a};
    for (int k = 0; k < 3; ++k) {
      const auto &p = mesh.place[v[k]], &q = mesh.place[v[k + 1]];
      mesh.halfedge_edge.push_back(p.dim == 1 && q.dim == 1 && p.entity == q.entity ? p.entity : 0);
    }
  }
};

inline std::unique_ptr<RoundSolid> round_cylinder(int around, int along, double radius, double height,
                                                  const hexfeature::Mat3& turn = hexfeature::Mat3::Identity(), double phase = 0.1) {
  using namespace hexfeature;
  auto solid = std::make_unique<RoundSolid>();
  solid->turn = turn;
  solid->radius = radius;
  solid->height = height;
  solid->faces.resize(3);
  solid->edges.resize(2);
  solid->faces[0].kind = SurfaceKind::Cylinder;
  solid->faces[1].kind = solid->faces[2].kind = SurfaceKind::Plane;
  for (auto& f : solid->faces) f.axis = turn * Vec3::UnitZ();
  solid->faces[0].radius = radius;
  const int bottom = solid->add_point(Vec3(0, 0, 0), 2, 2), top = solid->add_point(Vec3(0, 0, height), 2, 3);
  const auto ring = [&](int j, int i) { return 2 + j * around + i % around; };
  for (int j = 0; j <= along; ++j)
    for (int i = 0; i < around; ++i) {
      const double t = phase + 2 * EIGEN_PI * i / around;
      solid->add_point(Vec3(radius * std::cos(t), radius * std::sin(t), height * j / along), j % along == 0 ? 1 : 2,
                       j == 0       ? 1
                       : j == along ? 2
                                    : 1);
    }
  for (int i = 0; i < around; ++i) {
    solid->add_triangle(bottom, ring(0, i + 1), ring(0, i), 2);
    solid->add_triangle(top, ring(along, i), ring(along, i + 1), 3);
    for (int j = 0; j < along; ++j) {
      solid->add_triangle(ring(j, i), ring(j, i + 1), ring(j + 1, i + 1), 1);
      solid->add_triangle(ring(j, i), ring(j + 1, i + 1), ring(j + 1, i), 1);
    }
  }
  connect(solid->mesh);
  return solid;
}

inline std::unique_ptr<RoundSolid> round_sphere(int around, double radius, const hexfeature::Mat3& turn = hexfeature::Mat3::Identity()) {
  using namespace hexfeature;
  auto solid = std::make_unique<RoundSolid>();
  solid->turn = turn;
  solid->radius = radius;
  solid->faces.resize(1);
  solid->faces[0].kind = SurfaceKind::Sphere;
  const int rows = around / 2;
  const int south = solid->add_point(Vec3(0, 0, -radius), 2, 1), north = solid->add_point(Vec3(0, 0, radius), 2, 1);
  const auto at = [&](int j, int i) { return j == 0 ? south : j == rows ? north : 2 + (j - 1) * around + i % around; };
  for (int j = 1; j < rows; ++j)
    for (int i = 0; i < around; ++i) {
      const double t = 0.07 + 2 * EIGEN_PI * i / around, s = -EIGEN_PI / 2 + EIGEN_PI * j / rows;
      solid->add_point(radius * Vec3(std::cos(s) * std::cos(t), std::cos(s) * std::sin(t), std::sin(s)), 2, 1);
    }
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < around; ++i) {
      solid->add_triangle(at(j, i), at(j, i + 1), at(j + 1, i + 1), 1);
      solid->add_triangle(at(j, i), at(j + 1, i + 1), at(j + 1, i), 1);
    }
  connect(solid->mesh);
  return solid;
}

inline std::unique_ptr<RoundSolid> round_torus(int around, int across, double radius, double minor,
                                               const hexfeature::Mat3& turn = hexfeature::Mat3::Identity()) {
  using namespace hexfeature;
  auto solid = std::make_unique<RoundSolid>();
  solid->turn = turn;
  solid->radius = radius;
  solid->minor = minor;
  solid->faces.resize(1);
  solid->faces[0].kind = SurfaceKind::Torus;
  solid->faces[0].axis = turn * Vec3::UnitZ();
  const auto at = [&](int j, int i) { return (j % across) * around + i % around; };
  for (int j = 0; j < across; ++j)
    for (int i = 0; i < around; ++i) {
      const double t = 0.07 + 2 * EIGEN_PI * i / around, s = 0.05 + 2 * EIGEN_PI * j / across, r = radius + minor * std::cos(s);
      solid->add_point(Vec3(r * std::cos(t), r * std::sin(t), minor * std::sin(s)), 2, 1);
    }
  for (int j = 0; j < across; ++j)
    for (int i = 0; i < around; ++i) {
      solid->add_triangle(at(j, i), at(j, i + 1), at(j + 1, i + 1), 1);
      solid->add_triangle(at(j, i), at(j + 1, i + 1), at(j + 1, i), 1);
    }
  connect(solid->mesh);
  return solid;
}

}  // namespace fixtures
