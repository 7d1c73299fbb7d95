// HexFeatureWB - LGPL-2.1-or-later
#include "quadratic/bows.h"

#include <algorithm>
#include <utility>

namespace hexfeature {
namespace {

using Pair = std::array<int, 2>;

/// Edges opposite each other in a face of a hexahedron (kHexEdges: two rings of four, then the uprights).
constexpr std::array<Pair, 12> kOpposite{
    {{0, 2}, {4, 6}, {1, 3}, {5, 7}, {0, 4}, {1, 5}, {2, 6}, {3, 7}, {8, 9}, {9, 10}, {10, 11}, {11, 8}}};

/// Minimise the sum of |value[a] - value[b]|^2 over the pairs, over the values that are not fixed: conjugate gradients with
/// Jacobi's preconditioner, from the given values. Each connected set of free values without a fixed one keeps its mean.
void solve_harmonic(const std::vector<Pair>& pairs, const std::vector<char>& fixed, std::vector<Vec3>& value, Context& context) {
  constexpr int kRounds = 300;
  constexpr double kTolerance = 1e-4;  // of the residual: bows matter to their size, no more
  const std::size_t n = value.size();
  std::vector<double> degree(n, 0);
  for (const Pair& p : pairs)
    for (int i : p) ++degree[i];
  const auto apply = [&](const std::vector<Vec3>& x, std::vector<Vec3>& y) {
    std::fill(y.begin(), y.end(), Vec3::Zero());
    for (const auto& [a, b] : pairs) {
      const Vec3 d = x[a] - x[b];
      y[a] += d;
      y[b] -= d;
    }
    for (std::size_t i = 0; i < n; ++i)
      if (fixed[i]) y[i].setZero();
  };
  std::vector<Vec3> residual(n), direction(n), image(n);
  apply(value, residual);
  const auto precondition = [&](std::size_t i) -> Vec3 { return residual[i] / std::max(degree[i], 1.0); };
  double product = 0;
  for (std::size_t i = 0; i < n; ++i) {
    residual[i] = -residual[i];
    direction[i] = precondition(i);
    product += residual[i].dot(direction[i]);
  }
  const double enough = kTolerance * kTolerance * product;
  for (int round = 0; round < kRounds && product > enough; ++round) {
    context.check();
    apply(direction, image);
    double curvature = 0;
    for (std::size_t i = 0; i < n; ++i) curvature += direction[i].dot(image[i]);
    if (!(curvature > 0)) break;
    const double step = product / curvature;
    double next = 0;
    for (std::size_t i = 0; i < n; ++i) {
      value[i] += step * direction[i];
      residual[i] -= step * image[i];
      next += residual[i].dot(precondition(i));
    }
    for (std::size_t i = 0; i < n; ++i) direction[i] = precondition(i) + next / product * direction[i];
    product = next;
  }
}

/// The part of a vector along a face whose unit normal is given.
Vec3 along(const Vec3& v, const Vec3& normal) { return v - v.dot(normal) * normal; }

/// Bend the edges on faces as the faces' borders are bent. A bow across the face is the face's own; one along it (the border is a
/// circle on a plane) is known at the border, and harmonic over the face's quads.
void bend_along_faces(const HexComplex& complex, const MeshEdges& edges, const Projector& projector, Bows& bows, Context& context) {
  std::vector<std::pair<int, int>> slots;  // (CAD face, edge): an edge between two faces is one of each
  for (std::size_t q = 0; q < complex.quads.size(); ++q)
    for (int e : edges.of_quad[q])
      if (complex.quad_face[q] > 0) slots.push_back({complex.quad_face[q], e});
  std::sort(slots.begin(), slots.end());
  slots.erase(std::unique(slots.begin(), slots.end()), slots.end());
  const auto slot = [&](int face, int edge) {
    return static_cast<int>(std::lower_bound(slots.begin(), slots.end(), std::make_pair(face, edge)) - slots.begin());
  };
  std::vector<Pair> pairs;
  for (std::size_t q = 0; q < complex.quads.size(); ++q)
    for (int k = 0; k < 2 && complex.quad_face[q] > 0; ++k)
      pairs.push_back({slot(complex.quad_face[q], edges.of_quad[q][k]), slot(complex.quad_face[q], edges.of_quad[q][k + 2])});

  std::vector<Vec3> value(slots.size(), Vec3::Zero());
  std::vector<char> fixed(slots.size(), 0);
  for (std::size_t i = 0; i < slots.size(); ++i) {
    const auto [face, e] = slots[i];
    const bool own = bows.place[e].dim == 2 && bows.place[e].entity == face;
    fixed[i] = !own;
    if (i % 256 == 0) context.check();
    if (own) continue;
    const FacePoint p = projector.project_to_face(face, bows.chord[e] + bows.bow[e], nullptr);
    value[i] = along(bows.bow[e], p.normal) / bows.length[e];
  }
  solve_harmonic(pairs, fixed, value, context);
  for (std::size_t i = 0; i < slots.size(); ++i) {
    const auto [face, e] = slots[i];
    if (fixed[i]) continue;
    if (i % 256 == 0) context.check();
    const FacePoint p = projector.project_to_face(face, bows.chord[e], nullptr);
    const Vec3 across = (p.point - bows.chord[e]).dot(p.normal) * p.normal;
    bows.bow[e] = across + bows.length[e] * value[i];
    put_on_face(bows, e, projector);
  }
}

}  // namespace

void put_on_face(Bows& bows, int e, const Projector& projector) {
  const FacePoint p = projector.project_to_face(bows.place[e].entity, bows.chord[e] + bows.bow[e], nullptr);
  bows.bow[e] = p.point - bows.chord[e];
  bows.place[e].uv = p.uv;
}

void put_on_edge(Bows& bows, int e, const Projector& projector) {
  const CurvePoint p = projector.project_to_edge(bows.place[e].entity, bows.chord[e] + bows.bow[e], nullptr);
  bows.bow[e] = p.point - bows.chord[e];
  bows.place[e].uv = Vec2(p.t, 0);
}

Hex20 bent_element(const HexComplex& complex, const MeshEdges& edges, const Bows& bows, int h) {
  Hex20 x;
  for (int n = 0; n < 8; ++n) x[n] = complex.points[complex.hexes[h][n]];
  for (int e = 0; e < 12; ++e) x[8 + e] = bows.chord[edges.of_hex[h][e]] + bows.bow[edges.of_hex[h][e]];
  return x;
}

Bows place_mid_sides(const HexComplex& complex, const MeshEdges& edges, const Projector& projector, Context& context) {
  Bows bows;
  bows.bow.assign(edges.count(), Vec3::Zero());
  bows.place.assign(edges.count(), CadPlace{});
  bows.chord.resize(edges.count());
  bows.length.resize(edges.count());
  for (int e = 0; e < edges.count(); ++e) {
    const Vec3 &a = complex.points[edges.nodes[e][0]], &b = complex.points[edges.nodes[e][1]];
    bows.chord[e] = 0.5 * (a + b);
    bows.length[e] = (b - a).norm();
  }

  for (std::size_t q = 0; q < complex.quads.size(); ++q)
    for (int e : edges.of_quad[q])
      if (bows.place[e].dim > 2 && complex.quad_face[q] > 0) bows.place[e] = {2, complex.quad_face[q], Vec2::Zero()};
  context.check();
  for (std::size_t i = 0; i < complex.feature_edges.size(); ++i) {
    if (complex.feature_edge_cad[i] <= 0) continue;
    if (i % 256 == 0) context.check();
    const int e = edges.find(complex.feature_edges[i][0], complex.feature_edges[i][1]);
    const CurvePoint p = projector.project_to_edge(complex.feature_edge_cad[i], bows.chord[e], nullptr);
    bows.bow[e] = p.point - bows.chord[e];
    bows.place[e] = {1, complex.feature_edge_cad[i], Vec2(p.t, 0)};
  }
  bend_along_faces(complex, edges, projector, bows, context);

  context.check();
  std::vector<Pair> pairs;
  pairs.reserve(12 * edges.of_hex.size());
  for (const auto& e : edges.of_hex)
    for (const auto& [a, b] : kOpposite) pairs.push_back({e[a], e[b]});
  std::vector<char> fixed(edges.count());
  for (int e = 0; e < edges.count(); ++e) fixed[e] = bows.place[e].dim < 3;
  std::vector<Vec3> turn(edges.count());
  for (int e = 0; e < edges.count(); ++e) turn[e] = bows.bow[e] / bows.length[e];
  solve_harmonic(pairs, fixed, turn, context);
  for (int e = 0; e < edges.count(); ++e)
    if (!fixed[e]) bows.bow[e] = bows.length[e] * turn[e];
  return bows;
}

}  // namespace hexfeature
