// HexFeatureWB - LGPL-2.1-or-later
#include "mesh/frame_search.h"

#include <algorithm>
#include <array>

namespace hexfeature {
namespace {

/// Directions (lines, sign ignored) within a quarter of a degree are one; weights add up. Heaviest first.
std::vector<WeightedDirection> merge(const std::vector<WeightedDirection>& all) {
  std::vector<WeightedDirection> merged;
  for (const WeightedDirection& w : all) {
    const auto same = std::find_if(merged.begin(), merged.end(),
                                   [&](const WeightedDirection& m) { return m.direction.cross(w.direction).norm() < 4e-3; });
    if (same == merged.end())
      merged.push_back(w);
    else
      same->weight += w.weight;
  }
  std::stable_sort(merged.begin(), merged.end(),
                   [](const WeightedDirection& a, const WeightedDirection& b) { return a.weight > b.weight * (1 + 1e-9); });
  return merged;
}

/// Of the 24 rotations that permute and flip the axes of `r`, the one closest to the identity.
Mat3 upright(const Mat3& r) {
  Mat3 best = r;
  double best_trace = -4;
  constexpr std::array<std::array<int, 3>, 6> orders{{{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}}};
  for (const auto& o : orders)
    for (int signs = 0; signs < 8; ++signs) {
      Mat3 m;
      for (int k = 0; k < 3; ++k) m.row(k) = (signs >> k & 1 ? -1 : 1) * r.row(o[k]);
      if (m.determinant() > 0 && m.trace() > best_trace + 1e-9) {
        best_trace = m.trace();
        best = m;
      }
    }
  return best;
}

/// Same axes up to order and sign?
bool equivalent(const Mat3& a, const Mat3& b) {
  const Mat3 m = (a * b.transpose()).cwiseAbs();
  return m.rowwise().maxCoeff().minCoeff() > 0.9999;
}

}  // namespace

std::vector<Mat3> best_frames(const std::vector<WeightedDirection>& normals, const std::vector<WeightedDirection>& directions, int count) {
  double total = 0;
  for (const WeightedDirection& w : normals) total += w.weight;
  const auto cost = [&](const Mat3& r) {
    double sum = 0;
    for (const WeightedDirection& w : normals) sum += w.weight * (r * w.direction).lpNorm<1>();
    return sum / total;
  };

  struct Candidate {
    Mat3 rotation;
    double cost;
  };
  std::vector<Candidate> candidates{{Mat3::Identity(), cost(Mat3::Identity())}};
  const std::vector<WeightedDirection> d = merge(directions);
  const auto offer = [&](const Vec3& first, Vec3 second) {
    second -= second.dot(first) * first;
    if (second.norm() < 0.02) return;
    second.normalize();
    Mat3 r;
    r << first.transpose(), second.transpose(), first.cross(second).transpose();
    const Mat3 turned = upright(r);
    for (const Candidate& c : candidates)
      if (equivalent(c.rotation, turned)) return;
    candidates.push_back({turned, cost(turned)});
  };
  for (std::size_t i = 0; i < std::min<std::size_t>(12, d.size()); ++i) {
    bool paired = false;
    for (std::size_t j = 0; j < std::min<std::size_t>(25, d.size()); ++j)
      if (i != j && d[i].direction.cross(d[j].direction).norm() > 0.02) {
        offer(d[i].direction, d[j].direction);
        paired = true;
      }
    // Turned about its only direction the part looks the same: any second axis does, that of the file first.
    if (!paired)
      for (int k = 0; k < 3; ++k) offer(d[i].direction, Vec3::Unit(k));
  }
  // The identity comes first and wins ties (stable sort, costs rounded to the tolerance).
  std::stable_sort(candidates.begin() + 1, candidates.end(), [](const Candidate& a, const Candidate& b) { return a.cost < b.cost - 1e-9; });
  if (candidates.size() > 1 && candidates[1].cost < candidates[0].cost - 1e-6)
    std::stable_sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) { return a.cost < b.cost - 1e-9; });
  std::vector<Mat3> frames;
  for (const Candidate& c : candidates)
    if (static_cast<int>(frames.size()) < std::max(1, count)) frames.push_back(c.rotation);
  return frames;
}

}  // namespace hexfeature
