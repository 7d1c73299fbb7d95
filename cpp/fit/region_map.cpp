// HexFeatureWB - LGPL-2.1-or-later
#include "fit/region_map.h"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "fit/untangle2d.h"

namespace hexfeature {

namespace {

constexpr double kFolded = 1e-9;  ///< twice the area of an image that counts as folded

/// Cotangent weights of the triangles, clipped to stay positive, and the Dirichlet problem with fixed vertices.
void solve_harmonic(const std::vector<std::array<int, 3>>& triangles, const std::vector<Vec3>& points, const std::vector<char>& fixed,
                    std::vector<Vec2>& flat) {
  const int n = static_cast<int>(points.size());
  std::vector<int> variable(n, -1);
  int variables = 0;
  for (int i = 0; i < n; ++i)
    if (!fixed[i]) variable[i] = variables++;
  if (variables == 0) return;
  struct Entry {
    int a, b;
    double w;
  };
  std::vector<Entry> edges;
  edges.reserve(3 * triangles.size());
  for (const auto& v : triangles)
    for (int k = 0; k < 3; ++k) {
      const int a = v[k], b = v[(k + 1) % 3], c = v[(k + 2) % 3];
      const Vec3 u = points[a] - points[c], w = points[b] - points[c];
      const double area2 = u.cross(w).norm();
      const double cot = u.dot(w) / std::max(area2, 1e-3 * (u.squaredNorm() + w.squaredNorm()));
      edges.push_back({std::min(a, b), std::max(a, b), 0.5 * cot});
    }
  std::sort(edges.begin(), edges.end(), [](const Entry& x, const Entry& y) { return x.a != y.a ? x.a < y.a : x.b < y.b; });
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::MatrixX2d right = Eigen::MatrixX2d::Zero(variables, 2);
  for (std::size_t i = 0; i < edges.size();) {
    const int a = edges[i].a, b = edges[i].b;
    double w = 0;
    for (; i < edges.size() && edges[i].a == a && edges[i].b == b; ++i) w += edges[i].w;
    w = std::clamp(w, 0.05, 20.0);
    const int i0 = variable[a], i1 = variable[b];
    if (i0 >= 0) entries.emplace_back(i0, i0, w);
    if (i1 >= 0) entries.emplace_back(i1, i1, w);
    if (i0 >= 0 && i1 >= 0) entries.emplace_back(std::max(i0, i1), std::min(i0, i1), -w);
    if (i0 >= 0 && i1 < 0) right.row(i0) += w * flat[b].transpose();
    if (i1 >= 0 && i0 < 0) right.row(i1) += w * flat[a].transpose();
  }
  Eigen::SparseMatrix<double> matrix(variables, variables);
  matrix.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(matrix);
  if (solver.info() != Eigen::Success) return;
  const Eigen::MatrixX2d solution = solver.solve(right);
  for (int i = 0; i < n; ++i)
    if (variable[i] >= 0) flat[i] = solution.row(variable[i]).transpose();
}

}  // namespace

RegionMap map_region(const SurfaceMesh& mesh, const std::vector<int>& triangles, const std::vector<int>& border_of,
                     const std::function<Vec2(int)>& border_position, std::vector<Vec2>& corner_flat, const Context& context) {
  RegionMap map;
  const int count = static_cast<int>(triangles.size());
  std::vector<int> local(mesh.triangle_count(), -1);
  for (int i = 0; i < count; ++i) local[triangles[i]] = i;
  const auto corner_of = [&](int h) { return 3 * local[h / 3] + h % 3; };  // local corner at the start of h

  // One local vertex per fan of triangles that hang together inside the region.
  std::vector<int> parent(3 * count);
  std::iota(parent.begin(), parent.end(), 0);
  const auto find = [&](int i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  };
  const auto is_border = [&](int h) { return border_of[h] >= 0 || local[mesh.opposite[h] / 3] < 0; };
  for (int i = 0; i < count; ++i)
    for (int k = 0; k < 3; ++k) {
      const int h = 3 * triangles[i] + k, o = mesh.opposite[h];
      if (is_border(h) || h > o) continue;
      parent[find(corner_of(h))] = find(corner_of(SurfaceMesh::next(o)));
      parent[find(corner_of(SurfaceMesh::next(h)))] = find(corner_of(o));
    }
  std::vector<int> vertex(3 * count, -1);
  std::vector<char> fixed;
  for (int c = 0; c < 3 * count; ++c) {
    const int root = find(c);
    if (vertex[root] < 0) {
      vertex[root] = static_cast<int>(map.points.size());
      map.points.push_back(mesh.points[mesh.triangles[triangles[c / 3]][c % 3]]);
    }
    vertex[c] = vertex[root];
  }
  const int originals = static_cast<int>(map.points.size());
  fixed.assign(originals, 0);
  map.flat.assign(originals, Vec2::Zero());
  for (int i = 0; i < count; ++i)
    for (int k = 0; k < 3; ++k) {
      const int h = 3 * triangles[i] + k;
      if (border_of[h] < 0) continue;
      fixed[vertex[3 * i + k]] = 1;
      map.flat[vertex[3 * i + k]] = border_position(h);
    }

  // Split inner edges between border vertices.
  std::vector<int> middle(3 * count, -1);
  for (int i = 0; i < count; ++i)
    for (int k = 0; k < 3; ++k) {
      const int h = 3 * triangles[i] + k, c = 3 * i + k;
      const int a = vertex[c], b = vertex[3 * i + (k + 1) % 3];
      if (is_border(h) || !fixed[a] || !fixed[b] || middle[c] >= 0) continue;
      middle[c] = middle[corner_of(mesh.opposite[h])] = static_cast<int>(map.points.size());
      map.points.push_back(0.5 * (map.points[a] + map.points[b]));
      map.flat.push_back(0.5 * (map.flat[a] + map.flat[b]));
      fixed.push_back(0);
    }
  for (int i = 0; i < count; ++i) {
    // Corners and middles round the triangle, fanned from a middle so that no piece has three collinear points.
    std::vector<int> ring;
    int start = -1;
    for (int k = 0; k < 3; ++k) {
      ring.push_back(vertex[3 * i + k]);
      if (middle[3 * i + k] >= 0) {
        start = static_cast<int>(ring.size());
        ring.push_back(middle[3 * i + k]);
      }
    }
    const int m = static_cast<int>(ring.size());
    if (m == 6) {
      map.triangles.insert(
          map.triangles.end(),
          {{ring[0], ring[1], ring[5]}, {ring[1], ring[2], ring[3]}, {ring[5], ring[3], ring[4]}, {ring[1], ring[3], ring[5]}});
    } else {
      start = std::max(start, 0);
      for (int k = 1; k + 1 < m; ++k) map.triangles.push_back({ring[start], ring[(start + k) % m], ring[(start + k + 1) % m]});
    }
    map.source.resize(map.triangles.size(), triangles[i]);
  }

  solve_harmonic(map.triangles, map.points, fixed, map.flat);
  const auto count_folded = [&] {
    int folded = 0;
    for (const auto& v : map.triangles) folded += cross2(map.flat[v[1]] - map.flat[v[0]], map.flat[v[2]] - map.flat[v[0]]) <= kFolded;
    return folded;
  };
  map.folded = count_folded();
  // Only the surroundings of folds take part: a big chart with a fold at one corner costs no more than a small one.
  for (const int rings : {5, 15}) {
    if (map.folded == 0) break;
    std::vector<char> near(map.points.size(), 0);
    for (const auto& v : map.triangles)
      if (cross2(map.flat[v[1]] - map.flat[v[0]], map.flat[v[2]] - map.flat[v[0]]) <= kFolded) near[v[0]] = near[v[1]] = near[v[2]] = 1;
    for (char ring = 1; ring <= rings; ++ring)
      for (const auto& v : map.triangles) {
        const bool touches = (near[v[0]] && near[v[0]] <= ring) || (near[v[1]] && near[v[1]] <= ring) || (near[v[2]] && near[v[2]] <= ring);
        for (int k : v)
          if (touches && !near[k]) near[k] = static_cast<char>(ring + 1);
      }
    std::vector<char> held(fixed);
    for (std::size_t i = 0; i < held.size(); ++i) held[i] = held[i] || !near[i];
    std::vector<std::array<int, 3>> part;
    for (const auto& v : map.triangles)
      if (!held[v[0]] || !held[v[1]] || !held[v[2]]) part.push_back(v);
    untangle(part, map.points, held, map.flat, context);
    map.folded = count_folded();
  }
  for (int c = 0; c < 3 * count; ++c) corner_flat[3 * triangles[c / 3] + c % 3] = map.flat[vertex[c]];
  map.build_grid();
  return map;
}

void RegionMap::build_grid() {
  Vec2 lo = Vec2::Constant(1e300), hi = -lo;
  for (const Vec2& q : flat) {
    lo = lo.cwiseMin(q);
    hi = hi.cwiseMax(q);
  }
  origin_ = lo.array().floor().matrix();
  for (int k = 0; k < 2; ++k) cells_[k] = std::clamp(static_cast<int>(std::ceil(hi[k] - origin_[k])), 1, 4096);
  const auto for_cells = [&](int t, auto&& visit) {
    Vec2 a = Vec2::Constant(1e300), b = -a;
    for (int i : triangles[t]) {
      a = a.cwiseMin(flat[i]);
      b = b.cwiseMax(flat[i]);
    }
    int from[2], to[2];
    for (int k = 0; k < 2; ++k) {
      from[k] = std::clamp(static_cast<int>(std::floor(a[k] - origin_[k] - 1e-9)), 0, cells_[k] - 1);
      to[k] = std::clamp(static_cast<int>(std::floor(b[k] - origin_[k] + 1e-9)), 0, cells_[k] - 1);
    }
    for (int j = from[1]; j <= to[1]; ++j)
      for (int i = from[0]; i <= to[0]; ++i) visit(j * cells_[0] + i);
  };
  cell_begin_.assign(cells_[0] * cells_[1] + 1, 0);
  const int count = static_cast<int>(triangles.size());
  for (int t = 0; t < count; ++t) for_cells(t, [&](int c) { ++cell_begin_[c + 1]; });
  std::partial_sum(cell_begin_.begin(), cell_begin_.end(), cell_begin_.begin());
  cell_items_.resize(cell_begin_.back());
  std::vector<int> fill(cell_begin_.begin(), cell_begin_.end() - 1);
  for (int t = 0; t < count; ++t) for_cells(t, [&](int c) { cell_items_[fill[c]++] = t; });
}

RegionMap::Location RegionMap::locate(const Vec2& q) const {
  Location best;
  double best_value = -1e300;
  const auto test = [&](int t) {
    const Vec2 &a = flat[triangles[t][0]], &b = flat[triangles[t][1]], &c = flat[triangles[t][2]];
    const double area = cross2(b - a, c - a);
    if (!(area > 1e-12)) return;
    const Vec3 w(cross2(b - q, c - q) / area, cross2(c - q, a - q) / area, cross2(a - q, b - q) / area);
    // Least weight, scaled to a distance so that slivers do not look far.
    const double value = std::min(0.0, w.minCoeff()) * std::sqrt(area);
    if (value > best_value + 1e-12) {
      best_value = value;
      best = {t, w};
    }
  };
  const int i = std::clamp(static_cast<int>(std::floor(q[0] - origin_[0])), 0, cells_[0] - 1);
  const int j = std::clamp(static_cast<int>(std::floor(q[1] - origin_[1])), 0, cells_[1] - 1);
  const int cell = j * cells_[0] + i;
  for (int k = cell_begin_[cell]; k < cell_begin_[cell + 1]; ++k) test(cell_items_[k]);
  if (best.triangle < 0 || best_value < -1e-6)
    for (int t = 0; t < static_cast<int>(triangles.size()); ++t) test(t);
  if (best.triangle < 0) return {0, Vec3::Constant(1.0 / 3)};
  best.weight = best.weight.cwiseMax(0);
  best.weight /= best.weight.sum();
  return best;
}

}  // namespace hexfeature
