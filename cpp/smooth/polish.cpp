// HexFeatureWB - LGPL-2.1-or-later
#include <algorithm>
#include <vector>

#include "mesh/hex_element.h"
#include "mesh/incidence.h"
#include "smooth/patch.h"

namespace hexfeature {
namespace {

constexpr double kLimit = 0.3;       ///< scaled Jacobian below which an element is polished, and up to which
constexpr double kLeastGain = 1e-4;  ///< of one move
constexpr double kLeastEdge = 0.06;  ///< of h: no mesh edge at a moved point gets shorter, unless it was
constexpr double kFar = 0.25;        ///< of h: no point ends farther from where it was
constexpr double kStretch = 1.15;    ///< lengths that the mesh edges along CAD curves should keep are exceeded by so much
constexpr int kRounds = 20;
constexpr int kMost = 400, kMostBriefly = 100;  ///< elements of a round

/// Moves one point after the other to where the worst element round it is best: a pattern search, for the least of several scaled
/// Jacobians is not smooth, and no power mean of a shape energy has its maximum in the same place.
class Polish {
 public:
  Polish(HexComplex& mesh, SmoothSetting& setting, std::vector<double>& quality)
      : mesh_(mesh), setting_(setting), quality_(quality), hexes_(mesh.hexes, mesh.points.size()) {
    start_ = mesh.points;
    settled_.assign(mesh.points.size(), 0);
    spans_.resize(mesh.points.size());
    for (const Span& span : setting.spans) {
      spans_[span.a].push_back(&span);
      spans_[span.b].push_back(&span);
    }
  }

  void run() {
    for (int round = 0; round < kRounds; ++round) {
      setting_.context.check();
      std::vector<int> bad;
      for (int h = 0; h < mesh_.hex_count(); ++h)
        if (quality_[h] < kLimit) bad.push_back(h);
      std::sort(bad.begin(), bad.end(), [&](int a, int b) { return quality_[a] != quality_[b] ? quality_[a] < quality_[b] : a < b; });
      const std::size_t most = setting_.options.brief ? kMostBriefly : kMost;
      if (bad.size() > most) bad.resize(most);
      bool moved = false;
      for (int h : bad) {
        setting_.context.check();
        for (int v : mesh_.hexes[h]) moved |= improve(v);
      }
      if (!moved) return;
    }
  }

  /// Mesh edges a little shorter than they should be at least: one of their ends a little farther off, where no element pays for that much.
  void part_close_points() {
    constexpr double kLeast = 0.05, kSpare = 0.0005;     // of h
    constexpr double kLoss = 0.005, kWorstLoss = 0.001;  // of the worst element there, and of the mesh
    const double h = setting_.options.size, worst = *std::min_element(quality_.begin(), quality_.end());
    std::vector<std::array<int, 2>> close;
    for (int i = 0; i < mesh_.hex_count(); ++i) {
      if (i % 4096 == 0) setting_.context.check();
      for (const auto& e : kHexEdges) {
        const int a = mesh_.hexes[i][e[0]], b = mesh_.hexes[i][e[1]];
        if ((mesh_.points[b] - mesh_.points[a]).squaredNorm() < kLeast * kLeast * h * h) close.push_back({std::min(a, b), std::max(a, b)});
      }
    }
    std::sort(close.begin(), close.end());
    close.erase(std::unique(close.begin(), close.end()), close.end());
    for (const auto& [a, b] : close) {
      setting_.context.check();
      const auto move = [&](int v, int other) {
        const Vec3 old = mesh_.points[v], way = old - mesh_.points[other];
        const double length = way.norm();
        if (length >= kLeast * h || setting_.held[v] != 0 || mesh_.place[v].dim == 0 || !(length > 0)) return;
        double before = 1;
        for (int e : hexes_.at(v)) before = std::min(before, quality_[e]);
        const double shortest = std::min(shortest_edge(v), kLeast * h), bearable = std::max({before - kLoss, worst - kWorstLoss, 1e-6});
        const double most_excess = excess(v);
        Vec2 uv = mesh_.place[v].uv;
        mesh_.points[v] = on_part(v, old + ((kLeast + kSpare) * h / length - 1) * way, uv);
        const double now = (mesh_.points[v] - mesh_.points[other]).norm();
        if (now >= kLeast * h && shortest_edge(v) >= shortest && excess(v) <= most_excess &&
            measured_round(v, *hexes_.at(v).begin(), -1) >= bearable) {
          mesh_.place[v].uv = uv;
          for (int e : hexes_.at(v)) quality_[e] = measured(e);
        } else {
          mesh_.points[v] = old;
        }
      };
      move(a, b);
      move(b, a);
    }
  }

 private:
  double measured(int h) const {
    std::array<Vec3, 8> corners;
    for (int k = 0; k < 8; ++k) corners[k] = mesh_.points[mesh_.hexes[h][k]];
    return proved_scaled_jacobian(corners);
  }

  /// Least quality round v with the point where it is now, the element `first` looked at first; stops counting at `enough` or below.
  double measured_round(int v, int first, double enough) const {
    double worst = measured(first);
    for (int e : hexes_.at(v))
      if (e != first && worst > enough) worst = std::min(worst, measured(e));
    return worst;
  }

  double shortest_edge(int v) const {
    double shortest = 1e300;
    for (int e : hexes_.at(v)) {
      const auto& hex = mesh_.hexes[e];
      const auto corner = std::find(hex.begin(), hex.end(), v) - hex.begin();
      for (int k = 1; k < 4; ++k) shortest = std::min(shortest, (mesh_.points[hex[kHexCorners[corner][k]]] - mesh_.points[v]).norm());
    }
    return shortest;
  }

  /// Where the point may go: the axes of its freedom.
  std::vector<Vec3> axes(int v) const {
    const CadPlace& place = mesh_.place[v];
    const Vec3& p = mesh_.points[v];
    if (place.dim == 0) return {};
    if (place.dim == 1) return {setting_.projector.project_to_edge(place.entity, p, &place.uv[0]).tangent};
    if (place.dim != 2) return {Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()};
    const Vec3 normal = setting_.projector.project_to_face(place.entity, p, &place.uv).normal;
    int k;
    normal.cwiseAbs().minCoeff(&k);
    const Vec3 a = normal.cross(Vec3::Unit(k)).normalized();
    return {a, normal.cross(a)};
  }

  Vec3 on_part(int v, const Vec3& p, Vec2& uv) const {
    const CadPlace& place = mesh_.place[v];
    if (place.dim == 1) {
      const CurvePoint c = setting_.projector.project_to_edge(place.entity, p, &place.uv[0]);
      uv[0] = c.t;
      return c.point;
    }
    if (place.dim == 2) {
      const FacePoint f = setting_.projector.project_to_face(place.entity, p, &place.uv);
      uv = f.uv;
      return f.point;
    }
    return p;
  }

  /// How far the mesh edges along CAD curves at v exceed the lengths that they should keep.
  double excess(int v) const {
    double most = 0;
    for (const Span* span : spans_[v])
      most = std::max(most, (mesh_.points[span->a] - mesh_.points[span->b]).norm() - kStretch * span->longest);
    return most;
  }

  bool improve(int v) {
    if (setting_.held[v] != 0 || settled_[v] != 0) return false;
    settled_[v] = 1;
    const Incidence::Range round = hexes_.at(v);
    const int worst = *std::min_element(round.begin(), round.end(), [&](int a, int b) { return quality_[a] < quality_[b]; });
    double best = quality_[worst];
    if (best >= kLimit) return false;
    const std::vector<Vec3> free = axes(v);
    const double h = setting_.options.size;
    bool moved = false;
    for (double step = 0.1 * h; step > 0.001 * h && best < kLimit;) {
      bool better = false;
      for (const Vec3& axis : free)
        for (double sign : {1.0, -1.0}) {
          const Vec3 old = mesh_.points[v];
          Vec2 uv = mesh_.place[v].uv;
          const Vec3 p = on_part(v, old + sign * step * axis, uv);
          // Not at the end of a curve or beyond the rim of a face: the way is short there.
          if (!p.allFinite() || (p - old).norm() < 0.5 * step || (p - start_[v]).norm() > kFar * h) continue;
          const double least_edge = std::min(kLeastEdge * h, shortest_edge(v)), most_excess = excess(v);
          mesh_.points[v] = p;
          const bool allowed = shortest_edge(v) >= least_edge && excess(v) <= most_excess;
          const double now = allowed ? measured_round(v, worst, best + kLeastGain) : -1;
          if (now <= best + kLeastGain) {
            mesh_.points[v] = old;
            continue;
          }
          mesh_.place[v].uv = uv;
          best = now;
          better = true;
        }
      if (!better) step *= 0.5;
      moved |= better;
    }
    if (!moved) return false;
    for (int e : round) {
      quality_[e] = measured(e);
      for (int w : mesh_.hexes[e]) settled_[w] = 0;
    }
    return true;
  }

  HexComplex& mesh_;
  SmoothSetting& setting_;
  std::vector<double>& quality_;
  Incidence hexes_;
  std::vector<char> settled_;  ///< points that could not be moved since their elements changed last
  std::vector<Vec3> start_;
  std::vector<std::vector<const Span*>> spans_;  ///< at each point
};

}  // namespace

void polish_worst(HexComplex& mesh, SmoothSetting& setting) {
  std::vector<double> quality;
  measure(mesh, setting.workers, quality);
  const double worst = quality.empty() ? 1 : *std::min_element(quality.begin(), quality.end());
  if (worst > 0 && worst < kLimit) Polish(mesh, setting, quality).run();
}

void part_close_points(HexComplex& mesh, SmoothSetting& setting) {
  std::vector<double> quality;
  measure(mesh, setting.workers, quality);
  if (!quality.empty() && *std::min_element(quality.begin(), quality.end()) > 0) Polish(mesh, setting, quality).part_close_points();
}

}  // namespace hexfeature
