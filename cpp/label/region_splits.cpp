// HexFeatureWB - LGPL-2.1-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

#include "label/regions.h"
#include "mesh/cut_mesh.h"

namespace hexfeature {
namespace {

constexpr double kSnap = 0.12;

std::vector<int> triangles_of(const Regions& regions, int site) {
  std::vector<int> list;
  for (int t = 0; t < regions.mesh.triangle_count(); ++t)
    if (regions.site[t] == site) list.push_back(t);
  return list;
}

/// Area of the part of a patch where the function (taken as linear in each triangle) is negative, and of the rest.
std::array<double, 2> areas_by_sign(const SurfaceMesh& mesh, const std::vector<int>& patch, const CutFunction& f) {
  std::array<double, 2> sum{0, 0};
  for (int t : patch) {
    double value[3];
    int low = 0;
    for (int k = 0; k < 3; ++k) {
      value[k] = f.value(mesh.points[mesh.triangles[t][k]], mesh.corner_normals[3 * t + k]);
      low += value[k] < 0;
    }
    double share = low == 3 ? 1 : 0;
    if (low == 1 || low == 2) {
      int odd = 0;  // the corner that is alone on its side
      while ((value[odd] < 0) != (low == 1)) ++odd;
      const double a = value[odd], b = value[(odd + 1) % 3], c = value[(odd + 2) % 3];
      const double tip = a / (a - b) * (a / (a - c));
      share = low == 1 ? tip : 1 - tip;
    }
    const double area = mesh.area(t);
    sum[0] += share * area;
    sum[1] += (1 - share) * area;
  }
  return sum;
}

/// Give the connected pieces of a site their numbers. `cut_off` tells, per triangle of `patch`, which are the part to be
/// cut off (not 0; parts of different values are apart); a piece never crosses a halfedge of `barrier` (may be empty). Pieces under
/// `least_area` join the neighbour piece with the longest common border. The largest piece that is not cut off keeps the site's number;
/// then come the pieces cut off, then the rest, each larger ones first. False when there is one piece only.
bool number_pieces(Regions& regions, int site, const std::vector<int>& patch, const std::vector<char>& cut_off,
                   const std::vector<char>& barrier, double least_area) {
  const SurfaceMesh& mesh = regions.mesh;
  std::vector<int> local(mesh.triangle_count(), -1);
  for (std::size_t i = 0; i < patch.size(); ++i) local[patch[i]] = static_cast<int>(i);
  std::vector<int> piece(patch.size(), -1), stack;
  std::vector<double> area;
  std::vector<char> off;
  for (std::size_t seed = 0; seed < patch.size(); ++seed) {
    if (piece[seed] >= 0) continue;
    const int number = static_cast<int>(area.size());
    area.push_back(0);
    off.push_back(cut_off[seed]);
    piece[seed] = number;
    stack.push_back(static_cast<int>(seed));
    while (!stack.empty()) {
      const int i = stack.back();
      stack.pop_back();
      area[number] += mesh.area(patch[i]);
      for (int h = 3 * patch[i]; h < 3 * patch[i] + 3; ++h) {
        const int j = local[mesh.opposite[h] / 3];
        if (j < 0 || piece[j] >= 0 || cut_off[j] != cut_off[i] || (!barrier.empty() && barrier[h])) continue;
        piece[j] = number;
        stack.push_back(j);
      }
    }
  }

  const int pieces = static_cast<int>(area.size());
  std::vector<std::map<int, double>> border(pieces);
  for (std::size_t i = 0; i < patch.size(); ++i)
    for (int h = 3 * patch[i]; h < 3 * patch[i] + 3; ++h) {
      const int j = local[mesh.opposite[h] / 3];
      if (j >= 0 && piece[j] != piece[i]) border[piece[i]][piece[j]] += (mesh.points[mesh.to(h)] - mesh.points[mesh.from(h)]).norm();
    }
  std::vector<int> joined(pieces), order(pieces);
  std::iota(joined.begin(), joined.end(), 0);
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return area[a] < area[b]; });
  for (int p : order) {
    if (area[p] >= least_area || border[p].empty()) continue;
    const int to =
        std::max_element(border[p].begin(), border[p].end(), [](const auto& x, const auto& y) { return x.second < y.second; })->first;
    joined[p] = to;
    area[to] += area[p];
    for (const auto& [other, length] : border[p]) {
      border[other].erase(p);
      if (other == to) continue;
      border[to][other] += length;
      border[other][to] += length;
    }
    border[p].clear();
  }

  std::vector<int> kept;
  for (int p = 0; p < pieces; ++p)
    if (joined[p] == p) kept.push_back(p);
  if (kept.size() < 2) return false;
  std::stable_sort(kept.begin(), kept.end(), [&](int a, int b) { return area[a] > area[b]; });
  const auto rest = std::find_if(kept.begin(), kept.end(), [&](int p) { return !off[p]; });
  if (rest != kept.end()) std::rotate(kept.begin(), rest, rest + 1);
  std::stable_partition(kept.begin() + 1, kept.end(), [&](int p) { return off[p] != 0; });

  std::vector<int> number(pieces, -1);
  number[kept[0]] = site;
  for (std::size_t i = 1; i < kept.size(); ++i) {
    number[kept[i]] = regions.site_count();
    regions.site_face.push_back(regions.site_face[site]);
  }
  for (std::size_t i = 0; i < patch.size(); ++i) {
    int p = piece[i];
    while (joined[p] != p) p = joined[p];
    regions.site[patch[i]] = number[p];
  }
  return true;
}

void pin_border(const Regions& regions, int site, const std::vector<int>& patch, SurfaceCutter& cutter) {
  const SurfaceMesh& mesh = regions.mesh;
  for (int t : patch)
    for (int h = 3 * t; h < 3 * t + 3; ++h)
      if (regions.site[mesh.opposite[h] / 3] != site) {
        cutter.pin(mesh.from(h));
        cutter.pin(mesh.to(h));
      }
}

/// Cut `site` where all of `functions` are negative from the rest, one after the other.
bool split_by(Regions& regions, const Geometry& geometry, int site, const std::vector<CutFunction>& functions, double least_area) {
  std::vector<int> patch = triangles_of(regions, site);
  const auto estimate = areas_by_sign(regions.mesh, patch, functions.front());
  if (std::min(estimate[0], estimate[1]) < least_area || std::min(estimate[0], estimate[1]) <= 0) return false;

  SurfaceMesh& mesh = regions.mesh;
  SurfaceCutter cutter(mesh, geometry.projector, kSnap);
  pin_border(regions, site, patch, cutter);
  std::vector<int> inside = patch, next;
  std::vector<signed char> side;
  std::vector<char> cut_off(mesh.triangle_count(), 1);  // per triangle: all functions so far are negative
  for (const CutFunction& f : functions) {
    cutter.cut(inside, f, side);
    for (int t = static_cast<int>(cut_off.size()); t < mesh.triangle_count(); ++t) {
      const int parent = cutter.parents()[t - cutter.first_new()];
      regions.site.push_back(regions.site[parent]);
      cut_off.push_back(cut_off[parent]);
    }
    next.clear();
    for (std::size_t i = 0; i < inside.size(); ++i) {
      cut_off[inside[i]] = side[i] < 0;
      if (side[i] < 0) next.push_back(inside[i]);
    }
    inside.swap(next);
  }
  patch = triangles_of(regions, site);
  std::vector<char> off(patch.size());
  for (std::size_t i = 0; i < patch.size(); ++i) off[i] = cut_off[patch[i]];
  return number_pieces(regions, site, patch, off, {}, least_area);
}

double squared_distance(const Vec3& a, const Vec3& b, const Vec3& p) {
  const Vec3 e = b - a;
  const double length = e.squaredNorm();
  const double s = length > 0 ? std::clamp((p - a).dot(e) / length, 0.0, 1.0) : 0;
  return (p - a - s * e).squaredNorm();
}

double distance_to(const std::vector<Vec3>& chain, const Vec3& p) {
  double least = std::numeric_limits<double>::max();
  for (std::size_t i = 0; i + 1 < chain.size(); ++i) least = std::min(least, squared_distance(chain[i], chain[i + 1], p));
  return std::sqrt(least);
}

std::vector<Vec3> points_of(const SurfaceMesh& mesh, const std::vector<int>& halfedges) {
  std::vector<Vec3> chain{mesh.points[mesh.from(halfedges.front())]};
  for (int h : halfedges) chain.push_back(mesh.points[mesh.to(h)]);
  return chain;
}

double corner_angle(const SurfaceMesh& mesh, int h) {
  const Vec3 &p = mesh.points[mesh.from(h)], a = mesh.points[mesh.to(h)] - p, b = mesh.points[mesh.from(SurfaceMesh::prev(h))] - p;
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// Angle of the site at the end (or start) of a border halfedge of it.
double angle_at_end(const Regions& r, int h) {
  double angle = 0;
  for (int g = SurfaceMesh::next(h);; g = SurfaceMesh::next(r.mesh.opposite[g])) {
    angle += corner_angle(r.mesh, g);
    if (r.site[r.mesh.opposite[g] / 3] != r.site[h / 3]) return angle;
  }
}
double angle_at_start(const Regions& r, int h) {
  double angle = 0;
  for (int g = h;; g = r.mesh.opposite[SurfaceMesh::prev(g)]) {
    angle += corner_angle(r.mesh, g);
    if (r.site[r.mesh.opposite[SurfaceMesh::prev(g)] / 3] != r.site[h / 3]) return angle;
  }
}

/// A piece of a rim's border, and the direction that the rim beside it faces.
struct RimSegment {
  Vec3 from, to;
  Label label;
};

/// The directions that a rim along border halfedges of a site faces: across a convex edge, away from a concave one, along the
/// nearest axis that is not `axis`. Runs shorter than `least` take the direction of the longer run beside them.
std::vector<RimSegment> rim_segments(const SurfaceMesh& mesh, const std::vector<int>& halfedges, int axis, double least) {
  std::vector<RimSegment> segments;
  for (int h : halfedges) {
    const Vec3 &a = mesh.points[mesh.from(h)], &b = mesh.points[mesh.to(h)];
    const Vec3 across = (b - a).cross(mesh.mean_normal(h / 3)) * (mesh.dihedral(h) < 0 ? -1 : 1);
    Label best = kNoLabel;
    for (Label l = 0; l < 6; ++l)
      if (axis_of(l) != axis && (best == kNoLabel || sign_of(l) * across[axis_of(l)] > sign_of(best) * across[axis_of(best)])) best = l;
    segments.push_back({a, b, best});
  }
  struct Run {
    std::size_t first, last;
    double length;
    bool joined;  // it begins where the one before ends
  };
  std::vector<Run> runs;
  for (;;) {
    runs.clear();
    for (std::size_t i = 0; i < segments.size(); ++i) {
      const bool joined = i > 0 && segments[i].from == segments[i - 1].to;
      if (!joined || segments[i].label != segments[i - 1].label) runs.push_back({i, i, 0, joined});
      runs.back().last = i + 1;
      runs.back().length += (segments[i].to - segments[i].from).norm();
    }
    const auto joined_after = [&](std::size_t r) { return r + 1 < runs.size() && runs[r + 1].joined; };
    std::size_t shortest = runs.size();
    for (std::size_t r = 0; r < runs.size(); ++r)
      if (runs[r].length < least && (runs[r].joined || joined_after(r)) &&
          (shortest == runs.size() || runs[r].length < runs[shortest].length))
        shortest = r;
    if (shortest == runs.size()) return segments;
    const Run& run = runs[shortest];
    const bool before = run.joined && (!joined_after(shortest) || runs[shortest - 1].length >= runs[shortest + 1].length);
    const Label label = segments[before ? run.first - 1 : run.last].label;
    for (std::size_t i = run.first; i < run.last; ++i) segments[i].label = label;
  }
}

}  // namespace

bool split_strip(Regions& regions, const Geometry& geometry, int site, const std::vector<int>& halfedges, double width, double least_area) {
  if (halfedges.empty() || width <= 0) return false;
  const SurfaceMesh& mesh = regions.mesh;
  const std::vector<Vec3> chain = points_of(mesh, halfedges);
  std::vector<CutFunction> functions{
      {[chain, width](const Vec3& p, const Vec3&) { return distance_to(chain, p) - width; }, {}, 0.5 * width}};

  // Where the site goes on straight beyond the chain's end, the strip ends squarely there instead of turning round it.
  if (mesh.from(halfedges.front()) != mesh.to(halfedges.back())) {
    constexpr double kStraight = 150 * EIGEN_PI / 180;
    const auto end_plane = [&](const Vec3& end, const Vec3& before) {
      const Vec3 outward = (end - before).normalized();
      functions.push_back({[end, outward](const Vec3& p, const Vec3&) { return (p - end).dot(outward); }, {}, 0});
    };
    if (angle_at_start(regions, halfedges.front()) > kStraight) end_plane(chain[0], chain[1]);
    if (angle_at_end(regions, halfedges.back()) > kStraight) end_plane(chain[chain.size() - 1], chain[chain.size() - 2]);
  }
  return split_by(regions, geometry, site, functions, least_area);
}

bool split_across(Regions& regions, const Geometry& geometry, int site, int axis, double coordinate, double least_area) {
  return split_by(regions, geometry, site, {{[axis, coordinate](const Vec3& p, const Vec3&) { return p[axis] - coordinate; }, {}, 0}},
                  least_area);
}

bool split_creases(Regions& regions, int site, double degrees, double least_area) {
  const std::vector<int> patch = triangles_of(regions, site);
  std::vector<char> barrier(3 * regions.mesh.triangle_count(), 0);
  bool any = false;
  for (int t : patch)
    for (int h = 3 * t; h < 3 * t + 3; ++h) {
      if (regions.site[regions.mesh.opposite[h] / 3] != site) continue;
      barrier[h] = std::abs(regions.mesh.dihedral(h)) > degrees * EIGEN_PI / 180;
      any |= barrier[h] != 0;
    }
  return any && number_pieces(regions, site, patch, std::vector<char>(patch.size(), 0), barrier, least_area);
}

bool split_rim(Regions& regions, const Geometry& geometry, int site, const std::vector<int>& halfedges, int axis, double width,
               double least_area, std::vector<Label>& rim_label) {
  rim_label.assign(regions.site_count(), kNoLabel);
  if (halfedges.empty() || width <= 0) return false;
  SurfaceMesh& mesh = regions.mesh;
  constexpr double kLeastRun = 0.3;  // of the width
  std::vector<RimSegment> segments = rim_segments(mesh, halfedges, axis, kLeastRun * width);
  // Drawn in a little at both ends: beyond a corner of the border the nearer one of two pieces is told by the bisecting plane.
  for (RimSegment& s : segments) {
    const Vec3 inset = 1e-3 * std::min(1.0, width / (s.to - s.from).norm()) * (s.to - s.from);
    s.from += inset;
    s.to -= inset;
  }
  const auto distance = [&](const Vec3& p, const auto& counts) {
    double least = std::numeric_limits<double>::max();
    for (const RimSegment& s : segments)
      if (counts(s.label)) least = std::min(least, squared_distance(s.from, s.to, p));
    return std::sqrt(least);
  };
  std::vector<Label> labels;
  for (const RimSegment& s : segments)
    if (std::find(labels.begin(), labels.end(), s.label) == labels.end()) labels.push_back(s.label);

  std::vector<int> patch = triangles_of(regions, site);
  const auto all = [](Label) { return true; };
  const CutFunction rim{[&](const Vec3& p, const Vec3&) { return distance(p, all) - width; }, {}, 0.5 * width};
  if (areas_by_sign(mesh, patch, rim)[0] < least_area) return false;
  SurfaceCutter cutter(mesh, geometry.projector, kSnap);
  pin_border(regions, site, patch, cutter);
  std::vector<int> rest = patch, next;
  std::vector<signed char> side;
  std::vector<char> part(mesh.triangle_count(), 0);  // 0: not of the rim; else 1 + label
  const auto cut = [&](const CutFunction& f) {
    cutter.cut(rest, f, side);
    for (int t = static_cast<int>(part.size()); t < mesh.triangle_count(); ++t) {
      const int parent = cutter.parents()[t - cutter.first_new()];
      regions.site.push_back(regions.site[parent]);
      part.push_back(part[parent]);
    }
  };
  cut(rim);
  next.clear();
  for (std::size_t i = 0; i < rest.size(); ++i)
    if (side[i] < 0) next.push_back(rest[i]);
  rest = next;
  for (std::size_t k = 0; k < labels.size(); ++k) {
    const Label label = labels[k];
    const bool last = k + 1 == labels.size();
    const auto own = [&](Label l) { return l == label; };
    const auto others = [&](Label l) { return l != label; };
    if (!last) cut({[&](const Vec3& p, const Vec3&) { return distance(p, own) - distance(p, others); }, {}, 0});
    next.clear();
    for (std::size_t i = 0; i < rest.size(); ++i)
      if (last || side[i] < 0)
        part[rest[i]] = static_cast<char>(1 + label);
      else
        next.push_back(rest[i]);
    rest = next;
  }
  patch = triangles_of(regions, site);
  std::vector<char> off(patch.size());
  for (std::size_t i = 0; i < patch.size(); ++i) off[i] = part[patch[i]];
  const bool done = number_pieces(regions, site, patch, off, {}, least_area);
  if (!done) return false;
  // What most of a piece was cut off for.
  rim_label.assign(regions.site_count(), kNoLabel);
  std::map<int, std::array<double, 7>> area;
  for (int t : patch) area[regions.site[t]][part[t]] += mesh.area(t);
  for (const auto& [s, by_part] : area)
    rim_label[s] = static_cast<Label>(std::max_element(by_part.begin(), by_part.end()) - by_part.begin() - 1);
  return true;
}

double strip_extent(const Regions& regions, int site, const std::vector<int>& halfedges) {
  if (halfedges.empty()) return 0;
  const std::vector<Vec3> chain = points_of(regions.mesh, halfedges);
  double most = 0;
  std::vector<char> seen(regions.mesh.point_count(), 0);
  for (int t = 0; t < regions.mesh.triangle_count(); ++t) {
    if (regions.site[t] != site) continue;
    for (int v : regions.mesh.triangles[t]) {
      if (seen[v]) continue;
      seen[v] = 1;
      most = std::max(most, distance_to(chain, regions.mesh.points[v]));
    }
  }
  return most;
}

}  // namespace hexfeature
