// HexFeatureWB - LGPL-2.1-or-later
// Tiny hexahedral complexes with analytic geometry for the unit tests of quality and smooth.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <random>
#include <vector>

#include "mesh/hex_complex.h"
#include "mesh/projector.h"

namespace fixtures {

using hexfeature::CadPlace;
using hexfeature::CurvePoint;
using hexfeature::FacePoint;
using hexfeature::HexComplex;
using hexfeature::Projector;
using hexfeature::Vec2;
using hexfeature::Vec3;

inline constexpr double kPi = 3.14159265358979323846;

/// Quads from the elements' boundary faces; one solid; places of the size of the points (inside).
inline void finish(HexComplex& c) {
  c.hex_solid.assign(c.hexes.size(), 1);
  c.hex_block.assign(c.hexes.size(), 0);
  for (const auto& f : hexfeature::boundary_faces(c)) {
    std::array<int, 4> q;
    for (int k = 0; k < 4; ++k) q[k] = c.hexes[f[0]][hexfeature::kHexFaces[f[1]][k]];
    c.quads.push_back(q);
  }
  c.quad_chart.assign(c.quads.size(), -1);
  c.quad_face.assign(c.quads.size(), 0);
  c.place.resize(c.points.size());
}

/// n[0] x n[1] x n[2] cubes of the unit lattice; `map` moves the lattice points.
inline HexComplex lattice(std::array<int, 3> n, const std::function<Vec3(const Vec3&)>& map) {
  HexComplex c;
  const auto id = [&](int i, int j, int k) { return (k * (n[1] + 1) + j) * (n[0] + 1) + i; };
  for (int k = 0; k <= n[2]; ++k)
    for (int j = 0; j <= n[1]; ++j)
      for (int i = 0; i <= n[0]; ++i) c.points.push_back(map(Vec3(i, j, k)));
  for (int k = 0; k < n[2]; ++k)
    for (int j = 0; j < n[1]; ++j)
      for (int i = 0; i < n[0]; ++i)
        c.hexes.push_back({id(i, j, k), id(i + 1, j, k), id(i + 1, j + 1, k), id(i, j + 1, k), id(i, j, k + 1), id(i + 1, j, k + 1),
                           id(i + 1, j + 1, k + 1), id(i, j + 1, k + 1)});
  finish(c);
  return c;
}

/// The box [0, size]: face 1 + label, edge 1 + 4 axis + 2 (other axes' upper sides), vertex 1 + 4 x + 2 y + z.
class BoxProjector : public Projector {
 public:
  explicit BoxProjector(const Vec3& size) : size_(size) {}
  FacePoint project_to_face(int face, const Vec3& p, const Vec2*) const override {
    const auto label = static_cast<hexfeature::Label>(face - 1);
    const int a = hexfeature::axis_of(label), b = (a + 1) % 3, c = (a + 2) % 3;
    FacePoint r;
    r.point = p.cwiseMax(Vec3::Zero()).cwiseMin(size_);
    r.point[a] = hexfeature::sign_of(label) > 0 ? size_[a] : 0;
    r.normal = hexfeature::direction(label);
    r.uv = Vec2(r.point[b], r.point[c]);
    return r;
  }
  CurvePoint project_to_edge(int edge, const Vec3& p, const double*) const override {
    return edge_point(edge, std::clamp(p[(edge - 1) / 4], 0.0, size_[(edge - 1) / 4]));
  }
  CurvePoint edge_point(int edge, double t) const override {
    const int a = (edge - 1) / 4, b = (a + 1) % 3, c = (a + 2) % 3;
    CurvePoint r;
    r.t = t;
    r.tangent = Vec3::Unit(a);
    r.point[a] = t;
    r.point[b] = (edge - 1) & 2 ? size_[b] : 0;
    r.point[c] = (edge - 1) & 1 ? size_[c] : 0;
    return r;
  }
  Vec3 vertex_point(int v) const override {
    return Vec3((v - 1) & 4 ? size_[0] : 0, (v - 1) & 2 ? size_[1] : 0, (v - 1) & 1 ? size_[2] : 0);
  }

 private:
  Vec3 size_;
};

/// Places of a lattice whose points are still the corners of the box [0, n] (call it before bending).
inline void place_on_box(HexComplex& c, const std::array<int, 3>& n) {
  const int row = n[0] + 1, slab = row * (n[1] + 1);
  for (int v = 0; v < c.point_count(); ++v) {
    const int i[3] = {v % row, v % slab / row, v / slab};
    bool low[3], high[3];
    int sides = 0;
    for (int a = 0; a < 3; ++a) low[a] = i[a] == 0, high[a] = i[a] == n[a], sides += low[a] || high[a];
    CadPlace p;
    p.dim = 3 - sides;
    for (int a = 0; a < 3; ++a) {
      const int b = (a + 1) % 3, d = (a + 2) % 3;
      if (sides == 1 && (low[a] || high[a])) p.entity = 1 + 2 * a + (low[a] ? 1 : 0);
      if (sides == 2 && !low[a] && !high[a]) p.entity = 1 + 4 * a + 2 * high[b] + high[d];
    }
    if (sides == 3) p.entity = 1 + 4 * high[0] + 2 * high[1] + high[2];
    c.place[v] = p;
  }
  for (std::size_t q = 0; q < c.quads.size(); ++q)
    for (int v : c.quads[q])
      if (c.place[v].dim == 2) c.quad_face[q] = c.place[v].entity;
}

/// The box [0, size] cut into n cells a side.
inline HexComplex box_mesh(std::array<int, 3> n, const Vec3& size) {
  HexComplex c = lattice(n, [&](const Vec3& p) { return Vec3(p[0] / n[0] * size[0], p[1] / n[1] * size[1], p[2] / n[2] * size[2]); });
  place_on_box(c, n);
  return c;
}

/// The solid cylinder of radius R round z, 0 <= z <= H: face 1 side, 2 bottom, 3 top; edge 1 bottom rim, 2 top rim (t: angle).
class CylinderProjector : public Projector {
 public:
  CylinderProjector(double radius, double height) : radius_(radius), height_(height) {}
  FacePoint project_to_face(int face, const Vec3& p, const Vec2*) const override {
    FacePoint r;
    const double rho = std::hypot(p[0], p[1]);
    const Vec3 out = rho > 0 ? Vec3(p[0] / rho, p[1] / rho, 0) : Vec3(1, 0, 0);
    if (face == 1) {
      r.point = radius_ * out + Vec3(0, 0, std::clamp(p[2], 0.0, height_));
      r.normal = out;
      r.uv = Vec2(std::atan2(out[1], out[0]), r.point[2]);
    } else {
      r.point = rho > radius_ ? Vec3(radius_ * out) : Vec3(p[0], p[1], 0);
      r.point[2] = face == 2 ? 0 : height_;
      r.normal = Vec3(0, 0, face == 2 ? -1 : 1);
      r.uv = r.point.head<2>();
    }
    return r;
  }
  CurvePoint project_to_edge(int edge, const Vec3& p, const double*) const override { return edge_point(edge, std::atan2(p[1], p[0])); }
  CurvePoint edge_point(int edge, double t) const override {
    CurvePoint r;
    r.t = t;
    r.point = Vec3(radius_ * std::cos(t), radius_ * std::sin(t), edge == 1 ? 0 : height_);
    r.tangent = Vec3(-std::sin(t), std::cos(t), 0);
    return r;
  }
  Vec3 vertex_point(int) const override { return Vec3(radius_, 0, 0); }

 private:
  double radius_, height_;
};

/// A plane quad mesh extruded to hexahedra; a point of the outline (`rim`) lies on the cylinder's side.
inline HexComplex extrude(const std::vector<Vec2>& points, const std::vector<std::array<int, 4>>& quads, const std::vector<char>& rim,
                          int layers, double height) {
  HexComplex c;
  const int n = static_cast<int>(points.size());
  for (int k = 0; k <= layers; ++k)
    for (const Vec2& p : points) c.points.push_back(Vec3(p[0], p[1], height * k / layers));
  for (int k = 0; k < layers; ++k)
    for (const auto& q : quads) {
      std::array<int, 8> h;
      for (int i = 0; i < 4; ++i) h[i] = q[i] + k * n, h[4 + i] = q[i] + (k + 1) * n;
      c.hexes.push_back(h);
    }
  finish(c);
  for (int v = 0; v < c.point_count(); ++v) {
    const bool end = v / n == 0 || v / n == layers;
    const int side = v / n == 0 ? 0 : 1;
    c.place[v].dim = 3 - (end ? 1 : 0) - (rim[v % n] ? 1 : 0);
    c.place[v].entity = end ? (rim[v % n] ? 1 + side : 2 + side) : (rim[v % n] ? 1 : 0);
  }
  for (std::size_t q = 0; q < c.quads.size(); ++q) {
    int bottom = 0, top = 0;
    for (int v : c.quads[q]) bottom += v / n == 0, top += v / n == layers;
    c.quad_face[q] = bottom == 4 ? 2 : top == 4 ? 3 : 1;
  }
  return c;
}

/// The cylinder from one square block of n x n cells: four corner angles of 180 degrees on the rim.
inline HexComplex lattice_cylinder(int n, int layers, double radius, double height) {
  std::vector<Vec2> points;
  std::vector<std::array<int, 4>> quads;
  std::vector<char> rim;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) {
      const double x = 2.0 * i / n - 1, y = 2.0 * j / n - 1;  // square to disc, boundary by arc length
      const double s = std::max(std::abs(x), std::abs(y));
      double angle = 0;
      if (s > 0) angle = std::abs(x) >= std::abs(y) ? kPi / 4 * y / x : kPi / 2 - kPi / 4 * x / y;
      const double turn = std::abs(x) >= std::abs(y) ? (x < 0 ? kPi : 0) : (y < 0 ? kPi : 0);
      points.push_back(radius * s * Vec2(std::cos(angle + turn), std::sin(angle + turn)));
      rim.push_back(i == 0 || j == 0 || i == n || j == n);
    }
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) quads.push_back({j * (n + 1) + i, j * (n + 1) + i + 1, (j + 1) * (n + 1) + i + 1, (j + 1) * (n + 1) + i});
  return extrude(points, quads, rim, layers, height);
}

/// The cylinder as an O-grid: a square core of n x n cells, and `rings` layers round it.
inline HexComplex o_grid_cylinder(int n, int rings, int layers, double radius, double height) {
  std::vector<Vec2> points;
  std::vector<std::array<int, 4>> quads;
  std::vector<char> rim;
  const double half = 0.5 * radius;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) points.push_back(Vec2(half * (2.0 * i / n - 1), half * (2.0 * j / n - 1)));
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) quads.push_back({j * (n + 1) + i, j * (n + 1) + i + 1, (j + 1) * (n + 1) + i + 1, (j + 1) * (n + 1) + i});
  std::vector<int> inner;  // the core's outline, counter-clockwise
  for (int i = 0; i < n; ++i) inner.push_back(i);
  for (int j = 0; j < n; ++j) inner.push_back(j * (n + 1) + n);
  for (int i = n; i > 0; --i) inner.push_back(n * (n + 1) + i);
  for (int j = n; j > 0; --j) inner.push_back(j * (n + 1));
  const int turn = 4 * n;
  const std::vector<int> core = inner;
  for (int r = 1; r <= rings; ++r) {
    std::vector<int> outer;
    for (int k = 0; k < turn; ++k) {
      const double angle = kPi / 2 * k / n - 3 * kPi / 4, s = static_cast<double>(r) / rings;
      outer.push_back(static_cast<int>(points.size()));
      points.push_back((1 - s) * points[core[k]] + s * radius * Vec2(std::cos(angle), std::sin(angle)));
    }
    for (int k = 0; k < turn; ++k) quads.push_back({inner[k], outer[k], outer[(k + 1) % turn], inner[(k + 1) % turn]});
    inner = outer;
  }
  rim.assign(points.size(), 0);
  for (int v : inner) rim[v] = 1;
  return extrude(points, quads, rim, layers, height);
}

/// The ball of radius R round the origin: face 1, (u, v) longitude and latitude.
class SphereProjector : public Projector {
 public:
  explicit SphereProjector(double radius) : radius_(radius) {}
  FacePoint project_to_face(int, const Vec3& p, const Vec2*) const override {
    FacePoint r;
    r.normal = p.norm() > 0 ? p.normalized() : Vec3::UnitZ();
    r.point = radius_ * r.normal;
    r.uv = Vec2(std::atan2(p[1], p[0]), std::asin(std::clamp(r.normal[2], -1.0, 1.0)));
    return r;
  }
  CurvePoint project_to_edge(int, const Vec3&, const double*) const override { return {}; }
  CurvePoint edge_point(int, double) const override { return {}; }
  Vec3 vertex_point(int) const override { return Vec3::Zero(); }

 private:
  double radius_;
};

/// The ball from one cube of n^3 cells, each shell of the cube blown up to a sphere.
inline HexComplex sphere_mesh(int n, double radius) {
  HexComplex c = lattice({n, n, n}, [&](const Vec3& p) {
    const Vec3 q = 2.0 / n * p - Vec3::Ones();
    const double s = q.cwiseAbs().maxCoeff();
    if (s == 0) return Vec3(Vec3::Zero());
    Vec3 r;
    for (int a = 0; a < 3; ++a) r[a] = std::tan(kPi / 4 * q[a] / s);
    return Vec3(radius * s * r.normalized());
  });
  for (const auto& q : c.quads)
    for (int v : q) c.place[v] = {2, 1, Vec2::Zero()};
  c.quad_face.assign(c.quads.size(), 1);
  return c;
}

/// Move the inner nodes by up to `amount`, the same way every time.
inline void shake_inside(HexComplex& c, double amount, unsigned seed = 1) {
  std::mt19937 random(seed);
  for (int v = 0; v < c.point_count(); ++v) {
    Vec3 d;
    for (int a = 0; a < 3; ++a) d[a] = amount * (2.0 * random() / 4294967295.0 - 1);
    if (c.place[v].dim == 3) c.points[v] += d;
  }
}

}  // namespace fixtures
