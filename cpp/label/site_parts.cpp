// HexFeatureWB - LGPL-2.1-or-later
#include "label/site_parts.h"

#include <algorithm>
#include <map>
#include <numeric>

namespace hexfeature {
namespace {

/// Share of its outline that a strip has in common with tangent neighbours when it lies along one: nearly half.
constexpr double kBeside = 0.4;

}  // namespace

void merge_small_sites(const SurfaceMesh& mesh, const std::vector<double>& face_area, const Geometry& geometry,
                       const std::vector<char>& tip, const LeastSite& least_site, std::vector<int>& site) {
  const int sites = site.empty() ? 0 : 1 + *std::max_element(site.begin(), site.end());
  std::vector<double> area(sites, 0), outline(sites, 0), tangent(sites, 0);
  std::vector<int> face(sites, 0);
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    area[site[t]] += mesh.area(t);
    face[site[t]] = mesh.triangle_face[t];
  }
  for (int h = 0; h < 3 * mesh.triangle_count(); ++h) {
    const int s = site[h / 3], other = site[mesh.opposite[h] / 3];
    if (s == other) continue;
    const double length = (mesh.points[mesh.to(h)] - mesh.points[mesh.from(h)]).norm();
    outline[s] += length;
    if (geometry.edges && face[s] != face[other] && mesh.halfedge_edge[h] > 0 && !geometry.edge(mesh.halfedge_edge[h]).sharp)
      tangent[s] += length;
  }
  const auto small = [&](int s) {
    const double share = area[s] / face_area[face[s]];
    return (area[s] < least_site.area && share < least_site.share) || (!tip[face[s]] && 2 * area[s] < least_site.width * outline[s] &&
                                                                       share < least_site.strip_share && tangent[s] > kBeside * outline[s]);
  };
  std::vector<int> order;
  for (int s = 0; s < sites; ++s)
    if (small(s)) order.push_back(s);

  std::vector<int> joined(sites);
  std::iota(joined.begin(), joined.end(), 0);
  if (!order.empty()) {
    // Common border lengths of sites of one face, with a small site on one side at least.
    std::vector<std::map<int, double>> border(sites);
    for (int h = 0; h < 3 * mesh.triangle_count(); ++h) {
      const int a = site[h / 3], b = site[mesh.opposite[h] / 3];
      if (a != b && face[a] == face[b]) border[a][b] += (mesh.points[mesh.to(h)] - mesh.points[mesh.from(h)]).norm();
    }
    while (!order.empty()) {
      const auto least =
          std::min_element(order.begin(), order.end(), [&](int a, int b) { return area[a] != area[b] ? area[a] < area[b] : a < b; });
      const int s = *least;
      order.erase(least);
      int best = -1;
      double most = 0;
      for (const auto& [other, length] : border[s])
        if (length > most) most = length, best = other;
      if (best < 0) continue;
      joined[s] = best;
      area[best] += area[s];
      outline[best] += outline[s] - 2 * most;
      tangent[best] += tangent[s];
      for (const auto& [other, length] : border[s]) {
        border[other].erase(s);
        if (other == best) continue;
        border[best][other] += length;
        border[other][best] += length;
      }
      border[s].clear();
      if (!small(best)) order.erase(std::remove(order.begin(), order.end(), best), order.end());
    }
  }
  std::vector<int> number(sites, -1);
  int count = 0;
  for (int& s : site) {
    while (joined[s] != s) s = joined[s];
    if (number[s] < 0) number[s] = count++;
    s = number[s];
  }
}

}  // namespace hexfeature
