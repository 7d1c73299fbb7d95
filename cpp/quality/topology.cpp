// HexFeatureWB - LGPL-2.1-or-later
#include "quality/topology.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "mesh/buckets.h"

namespace hexfeature {
namespace {

using Quad = std::array<int, 4>;

MeshFault check_indices(const HexComplex& complex) {
  MeshFault fault{"elements or quads with nodes that do not exist or are repeated", 0, {}};
  const int n = complex.point_count();
  const auto bad = [n](const int* v, int count) {
    for (int i = 0; i < count; ++i) {
      if (v[i] < 0 || v[i] >= n) return true;
      for (int j = 0; j < i; ++j)
        if (v[i] == v[j]) return true;
    }
    return false;
  };
  for (const auto& h : complex.hexes) fault.count += bad(h.data(), 8);
  for (const auto& q : complex.quads) fault.count += bad(q.data(), 4);
  return fault;
}

MeshFault check_unused(const HexComplex& complex) {
  MeshFault fault{"points that belong to no element", 0, {}};
  std::vector<char> used(complex.points.size(), 0);
  for (const auto& h : complex.hexes)
    for (int v : h) used[v] = 1;
  for (int v = 0; v < complex.point_count(); ++v)
    if (!used[v]) fault.add(&v, 1);
  return fault;
}

/// `quads` are exactly the boundary faces, outward: no face without a quad, no quad without a face, none twice.
MeshFault check_quads(const HexComplex& complex, const std::vector<int>& boundary) {
  const int n = complex.point_count(), faces = static_cast<int>(boundary.size()), quads = static_cast<int>(complex.quads.size());
  const auto least = [](const Quad& q) { return *std::min_element(q.begin(), q.end()); };
  const Buckets by_node(n, faces, [&](int i) { return least(face_nodes(complex, boundary[i])); });
  std::vector<char> covered(faces, 0);
  MeshFault stray{"boundary quads that are not outward faces of exactly one element", 0, {}};
  for (int q = 0; q < quads; ++q) {
    const Quad& quad = complex.quads[q];
    const int key = least(quad);
    bool found = false;
    for (int k = by_node.start[key]; k < by_node.start[key + 1] && !found; ++k) {
      const int i = by_node.item[k];
      if (covered[i] || !same_cycle(quad, face_nodes(complex, boundary[i]), 1)) continue;
      covered[i] = 1;
      found = true;
    }
    if (!found) stray.add(quad.data(), 4);
  }
  if (stray.count) return stray;
  MeshFault open{"boundary faces without a quad", 0, {}};
  for (int i = 0; i < faces; ++i)
    if (!covered[i]) open.add(face_nodes(complex, boundary[i]).data(), 4);
  return open;
}

/// Each boundary edge has exactly two quads, which run along it in opposite directions; the quads round each vertex are one fan.
MeshFault check_manifold(const HexComplex& complex) {
  const int n = complex.point_count(), sides = 4 * static_cast<int>(complex.quads.size());
  const auto from = [&](int s) { return complex.quads[s / 4][s % 4]; };
  const auto to = [&](int s) { return complex.quads[s / 4][(s + 1) % 4]; };
  const Buckets by_node(n, sides, [&](int s) { return std::min(from(s), to(s)); });
  std::vector<int> opposite(sides, -1);
  MeshFault edges{"boundary edges that do not have exactly two quads", 0, {}};
  for (int v = 0; v < n; ++v)
    for (int i = by_node.start[v]; i < by_node.start[v + 1]; ++i) {
      const int s = by_node.item[i];
      int same = 0, mate = -1;
      for (int j = by_node.start[v]; j < by_node.start[v + 1]; ++j) {
        const int t = by_node.item[j];
        if (t == s || std::max(from(t), to(t)) != std::max(from(s), to(s))) continue;
        ++same;
        mate = t;
      }
      if (same == 1 && from(mate) == to(s)) {
        opposite[s] = mate;
      } else {
        const int ends[2] = {from(s), to(s)};
        edges.add(ends, 2);
      }
    }
  if (edges.count) return edges;
  MeshFault fans{"boundary points where the surface touches itself", 0, {}};
  const Buckets by_corner(n, sides, from);
  for (int v = 0; v < n; ++v) {
    const int valence = by_corner.start[v + 1] - by_corner.start[v];
    if (valence == 0) continue;
    const int first = by_corner.item[by_corner.start[v]];
    int s = first, count = 0;
    do {  // the next quad round v shares the side that ends in v
      s = opposite[s - s % 4 + (s + 3) % 4];
      ++count;
    } while (s != first && count <= valence);
    if (count != valence) fans.add(&v, 1);
  }
  return fans;
}

}  // namespace

MeshFault check_topology(const HexComplex& complex, Context& context) {
  MeshFault fault = check_indices(complex);
  if (fault.count) return fault;
  context.check();
  fault = check_unused(complex);
  if (fault.count) return fault;
  const FaceMates faces = match_faces(complex, context);
  context.check();
  MeshFault crowded{"element faces that are not shared by exactly two elements from opposite sides", 0, {}};
  std::vector<int> boundary;
  for (int f = 0; f < static_cast<int>(faces.mate.size()); ++f) {
    if (faces.mate[f] == FaceMates::kCrowded) crowded.add(face_nodes(complex, f).data(), 4);
    if (faces.mate[f] == FaceMates::kBoundary) boundary.push_back(f);
  }
  if (crowded.count) return crowded;
  fault = check_quads(complex, boundary);
  if (fault.count) return fault;
  context.check();
  return check_manifold(complex);
}

MeshFault find_coincident_points(const std::vector<Vec3>& points, double tolerance, Context& context) {
  MeshFault fault{"pairs of points at the same place", 0, {}};
  if (points.empty()) return fault;
  Vec3 low = points[0];
  for (const Vec3& p : points) low = low.cwiseMin(p);
  // Cells of four tolerances, shifted off the round coordinates that meshes like: two points within the tolerance are in one
  // cell or in neighbouring ones, and only a point near a wall need look there.
  const double cell = 4 * std::max(tolerance, 1e-300);
  low -= cell * Vec3(0.3819, 0.4142, 0.3247);
  const auto key = [](const std::array<std::int64_t, 3>& c) {
    std::uint64_t k = 0x9E3779B97F4A7C15u;
    for (std::int64_t i : c) {
      k ^= static_cast<std::uint64_t>(i);
      k *= 0xD6E8FEB86659FD93u;
      k ^= k >> 32;
    }
    return k;
  };
  const auto cell_of = [&](const Vec3& p) {
    std::array<std::int64_t, 3> c;
    for (int a = 0; a < 3; ++a) c[a] = static_cast<std::int64_t>(std::floor(std::min((p[a] - low[a]) / cell, 9e15)));
    return c;
  };
  const int n = static_cast<int>(points.size());
  std::vector<std::pair<std::uint64_t, int>> cells(n);
  for (int i = 0; i < n; ++i) cells[i] = {key(cell_of(points[i])), i};
  std::sort(cells.begin(), cells.end());
  context.check();
  const double limit = tolerance * tolerance;
  for (int i = 0; i < n; ++i) {
    const auto c = cell_of(points[i]);
    std::array<int, 3> first{}, last{};
    for (int a = 0; a < 3; ++a) {
      const double inside = (points[i][a] - low[a]) / cell - static_cast<double>(c[a]);
      first[a] = inside < 0.26 ? -1 : 0;
      last[a] = inside > 0.74 ? 1 : 0;
    }
    for (int dx = first[0]; dx <= last[0]; ++dx)
      for (int dy = first[1]; dy <= last[1]; ++dy)
        for (int dz = first[2]; dz <= last[2]; ++dz) {
          const std::uint64_t k = key({c[0] + dx, c[1] + dy, c[2] + dz});
          // Pairs are found from their larger point.
          for (auto it = std::lower_bound(cells.begin(), cells.end(), std::make_pair(k, -1));
               it != cells.end() && it->first == k && it->second < i; ++it) {
            if ((points[it->second] - points[i]).squaredNorm() > limit) continue;
            const int pair[2] = {it->second, i};
            fault.add(pair, 2);
          }
        }
    if (i % 4096 == 0) context.check();
  }
  return fault;
}

}  // namespace hexfeature
