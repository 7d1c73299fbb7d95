// HexFeatureWB - LGPL-2.1-or-later
#include "label/site_parts.h"

#include <algorithm>
#include <map>
#include <numeric>

namespace hexfeature {

void merge_small_sites(const SurfaceMesh& mesh, const std::vector<double>& face_area, double least_share, double least_area,
                       std::vector<int>& site) {
  const int sites = site.empty() ? 0 : 1 + *std::max_element(site.begin(), site.end());
  std::vector<double> area(sites, 0);
  std::vector<int> face(sites, 0);
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    area[site[t]] += mesh.area(t);
    face[site[t]] = mesh.triangle_face[t];
  }
  const auto small = [&](int s) { return area[s] < least_area && area[s] < least_share * face_area[face[s]]; };
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
