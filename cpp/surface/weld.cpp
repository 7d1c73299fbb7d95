// HexFeatureWB - LGPL-2.1-or-later
#include "surface/weld.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>

#include "base/error.h"

namespace hexfeature {
namespace {

/// Representative of each point: the first of those at the same place.
std::vector<int> weld_exactly(const std::vector<Vec3>& points) {
  std::vector<int> order(points.size()), to(points.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](int a, int b) {
    for (int k = 0; k < 3; ++k)
      if (points[a][k] != points[b][k]) return points[a][k] < points[b][k];
    return a < b;
  });
  for (std::size_t i = 0; i < order.size(); ++i)
    to[order[i]] = i > 0 && points[order[i]] == points[order[i - 1]] ? to[order[i - 1]] : order[i];
  return to;
}

/// The same within `tolerance`: a grid of that size, looked up in the neighbouring cells.
std::vector<int> weld_near(const std::vector<Vec3>& points, double tolerance) {
  using Key = std::array<std::int64_t, 3>;
  struct Entry {
    Key key;
    int point;
  };
  const auto less = [](const Entry& a, const Entry& b) { return a.key != b.key ? a.key < b.key : a.point < b.point; };
  const auto key_of = [&](const Vec3& p) {
    Key k;
    for (int i = 0; i < 3; ++i) k[i] = static_cast<std::int64_t>(std::floor(p[i] / tolerance));
    return k;
  };
  std::vector<int> to = weld_exactly(points);
  std::vector<Entry> entries;
  for (int i = 0; i < static_cast<int>(points.size()); ++i)
    if (to[i] == i) entries.push_back({key_of(points[i]), i});
  std::sort(entries.begin(), entries.end(), less);
  std::vector<int> root(points.size());
  std::iota(root.begin(), root.end(), 0);
  const auto find = [&](int i) {
    while (root[i] != i) i = root[i] = root[root[i]];
    return i;
  };
  for (const Entry& e : entries)
    for (int dx = -1; dx <= 1; ++dx)
      for (int dy = -1; dy <= 1; ++dy)
        for (int dz = -1; dz <= 1; ++dz) {
          const Key key{e.key[0] + dx, e.key[1] + dy, e.key[2] + dz};
          for (auto it = std::lower_bound(entries.begin(), entries.end(), Entry{key, -1}, less); it != entries.end() && it->key == key;
               ++it)
            if ((points[it->point] - points[e.point]).norm() <= tolerance) {
              const int a = find(e.point), b = find(it->point);
              root[std::max(a, b)] = std::min(a, b);
            }
        }
  for (int& i : to) i = find(i);
  return to;
}

SurfaceMesh compress(const TriangleSoup& soup, const std::vector<int>& to) {
  SurfaceMesh mesh;
  std::vector<int> number(soup.points.size(), -1);
  std::vector<std::array<int, 4>> sorted;  // corners in order, and the triangle
  for (int t = 0; t < static_cast<int>(soup.triangles.size()); ++t) {
    std::array<int, 3> v = soup.triangles[t];
    for (int& i : v) i = to[i];
    if (v[0] == v[1] || v[1] == v[2] || v[2] == v[0]) continue;
    std::array<int, 3> s = v;
    std::sort(s.begin(), s.end());
    sorted.push_back({s[0], s[1], s[2], t});
  }
  std::sort(sorted.begin(), sorted.end());
  std::vector<int> kept;
  for (std::size_t i = 0; i < sorted.size(); ++i)
    if (i == 0 || !std::equal(sorted[i].begin(), sorted[i].begin() + 3, sorted[i - 1].begin())) kept.push_back(sorted[i][3]);
  std::sort(kept.begin(), kept.end());
  for (const int t : kept) {
    std::array<int, 3> v = soup.triangles[t];
    for (int& i : v) {
      i = to[i];
      if (number[i] < 0) {
        number[i] = mesh.point_count();
        mesh.points.push_back(soup.points[i]);
      }
      i = number[i];
    }
    mesh.triangles.push_back(v);
  }
  return mesh;
}

struct Side {
  int a, b, halfedge;
};

std::vector<Side> sorted_sides(const SurfaceMesh& mesh) {
  std::vector<Side> sides(3 * mesh.triangles.size());
  for (int h = 0; h < static_cast<int>(sides.size()); ++h) {
    const int a = mesh.from(h), b = mesh.to(h);
    sides[h] = {std::min(a, b), std::max(a, b), h};
  }
  std::sort(sides.begin(), sides.end(), [](const Side& p, const Side& q) {
    return p.a != q.a ? p.a < q.a : p.b != q.b ? p.b < q.b : p.halfedge < q.halfedge;
  });
  return sides;
}

/// How many edges have one triangle, and how many more than two.
std::array<int, 2> count_faults(const std::vector<Side>& sides) {
  std::array<int, 2> faults{0, 0};
  for (std::size_t i = 0, j; i < sides.size(); i = j) {
    for (j = i; j < sides.size() && sides[j].a == sides[i].a && sides[j].b == sides[i].b;) ++j;
    if (j - i == 1) ++faults[0];
    if (j - i > 2) ++faults[1];
  }
  return faults;
}

/// Turn neighbours alike, shell by shell, and every shell so that the solid is behind it.
void orient(SurfaceMesh& mesh, const std::vector<Side>& sides) {
  const int n = mesh.triangle_count();
  std::vector<int> across(3 * n);  // halfedges facing each other, whichever way they run
  for (std::size_t i = 0; i + 1 < sides.size(); i += 2) {
    across[sides[i].halfedge] = sides[i + 1].halfedge;
    across[sides[i + 1].halfedge] = sides[i].halfedge;
  }
  std::vector<int> shell(n, -1), stack;
  std::vector<char> turned(n, 0);
  int shells = 0;
  bool as_read = true;
  for (int seed = 0; seed < n; ++seed) {
    if (shell[seed] >= 0) continue;
    shell[seed] = shells;
    stack.assign(1, seed);
    while (!stack.empty()) {
      const int t = stack.back();
      stack.pop_back();
      for (int h = 3 * t; h < 3 * t + 3; ++h) {
        const int g = across[h], s = g / 3;
        const bool alike = mesh.from(h) == mesh.to(g);
        const char want = alike ? turned[t] : !turned[t];
        if (shell[s] < 0) {
          shell[s] = shells;
          turned[s] = want;
          stack.push_back(s);
          if (!alike) as_read = false;
        } else if (turned[s] != want) {
          throw MeshingError(Failure::BadInput, "read", "the surface cannot be oriented (it is one-sided)", "repair the surface");
        }
      }
    }
    ++shells;
  }
  for (int t = 0; t < n; ++t)
    if (turned[t]) std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
  std::vector<double> volume(shells, 0);
  const Vec3 origin = mesh.points.front();
  for (int t = 0; t < n; ++t) {
    const auto& v = mesh.triangles[t];
    volume[shell[t]] += (mesh.points[v[0]] - origin).dot((mesh.points[v[1]] - origin).cross(mesh.points[v[2]] - origin)) / 6;
  }
  std::vector<char> flip(shells, 0);
  if (as_read && shells > 1 && std::accumulate(volume.begin(), volume.end(), 0.0) > 0) {
    // Several consistent shells, outward on the whole: the file knows its voids.
  } else {
    // A shell inside an odd number of others is a void. Parity along a ray in a direction that no CAD edge has.
    const Vec3 ray = Vec3(0.8017, 0.3361, 0.4943).normalized();
    std::vector<int> first(shells, -1);
    for (int t = n - 1; t >= 0; --t) first[shell[t]] = t;
    for (int s = 0; s < shells; ++s) {
      bool inside = false;
      const Vec3 p = mesh.centroid(first[s]);
      for (int t = 0; shells > 1 && t < n; ++t) {
        if (shell[t] == s) continue;
        const Vec3 a = mesh.points[mesh.triangles[t][0]] - p, b = mesh.points[mesh.triangles[t][1]] - p,
                   c = mesh.points[mesh.triangles[t][2]] - p;
        const double x = ray.dot(a.cross(b)), y = ray.dot(b.cross(c)), z = ray.dot(c.cross(a));
        if (((x > 0) != (y > 0)) || ((y > 0) != (z > 0))) continue;
        const Vec3 normal = (b - a).cross(c - a);
        const double along = ray.dot(normal);
        if (along != 0 && a.dot(normal) / along > 0) inside = !inside;
      }
      flip[s] = (volume[s] > 0) == inside;
    }
  }
  for (int t = 0; t < n; ++t)
    if (flip[shell[t]]) std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
}

}  // namespace

SurfaceMesh weld(const TriangleSoup& soup) {
  Vec3 low = soup.points.front(), high = low;
  for (const auto& t : soup.triangles)
    for (const int v : t) {
      low = low.cwiseMin(soup.points[v]);
      high = high.cwiseMax(soup.points[v]);
    }
  const double diagonal = (high - low).norm();
  if (!(diagonal > 0)) throw MeshingError(Failure::BadInput, "read", "the surface has no extent", "export the surface again");
  SurfaceMesh mesh;
  std::vector<Side> sides;
  std::array<int, 2> faults{};
  for (int attempt = 0; attempt < 3; ++attempt) {
    SurfaceMesh next =
        compress(soup, attempt == 0 ? weld_exactly(soup.points) : weld_near(soup.points, diagonal * (attempt == 1 ? 1e-6 : 1e-5)));
    std::vector<Side> next_sides = sorted_sides(next);
    const std::array<int, 2> now = count_faults(next_sides);
    if (attempt == 0 || now[0] + now[1] < faults[0] + faults[1]) {
      mesh = std::move(next);
      sides = std::move(next_sides);
      faults = now;
    }
    if (faults[0] + faults[1] == 0) break;
  }
  if (mesh.triangles.empty())
    throw MeshingError(Failure::BadInput, "read", "the surface has no triangles of any size", "export the surface again");
  if (faults[0] > 0)
    throw MeshingError(Failure::BadInput, "read", "the surface is not closed: " + std::to_string(faults[0]) + " open edges",
                       "close the holes (FreeCAD: Mesh > Fill holes)");
  if (faults[1] > 0)
    throw MeshingError(Failure::BadInput, "read",
                       "the surface is not a manifold: " + std::to_string(faults[1]) + " edges have more than two triangles",
                       "repair the surface (FreeCAD: Mesh > Evaluate and repair)");
  orient(mesh, sides);
  connect(mesh);
  return mesh;
}

}  // namespace hexfeature
