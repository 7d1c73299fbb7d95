// HexFeatureWB - LGPL-2.1-or-later
#include "smooth/patch.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "mesh/hex_element.h"

namespace hexfeature {
namespace {

double quality_of(const double* x, const std::array<int, 8>& hex) {
  std::array<Vec3, 8> corners;
  for (int k = 0; k < 8; ++k) corners[k] = Eigen::Map<const Vec3>(x + 3 * hex[k]);
  return proved_scaled_jacobian(corners);
}

double shortest_edge(const std::vector<double>& x, const std::array<int, 8>& hex) {
  double least = std::numeric_limits<double>::max();
  for (const auto& e : kHexEdges)
    least = std::min(least, (Eigen::Map<const Vec3>(x.data() + 3 * hex[e[0]]) - Eigen::Map<const Vec3>(x.data() + 3 * hex[e[1]])).norm());
  return least;
}

}  // namespace

void measure(const HexComplex& mesh, Workers& workers, std::vector<double>& quality) {
  static_assert(sizeof(Vec3) == 3 * sizeof(double), "points are flat");
  quality.resize(mesh.hexes.size());
  workers.run(mesh.hex_count(), 256, [&](int begin, int end) {
    for (int h = begin; h < end; ++h) quality[h] = quality_of(mesh.points.data()->data(), mesh.hexes[h]);
  });
}

Grade grade_of(const std::vector<double>& quality) {
  Grade g;
  for (double q : quality) {
    g.inverted += !(q > 0);
    g.min_sj = std::min(g.min_sj, q);
    g.sum_sj += q;
  }
  return g;
}

Patch Patch::whole(const HexComplex& mesh, SmoothSetting& setting) {
  return Patch(mesh, std::vector<char>(mesh.points.size(), 1), setting);
}

namespace {

std::vector<int> elements_of(const HexComplex& mesh, const std::vector<char>& points) {
  std::vector<int> elements;
  for (int h = 0; h < mesh.hex_count(); ++h)
    if (std::any_of(mesh.hexes[h].begin(), mesh.hexes[h].end(), [&](int v) { return points[v] != 0; })) elements.push_back(h);
  return elements;
}

}  // namespace

Patch::Patch(const HexComplex& mesh, const std::vector<char>& free_points, SmoothSetting& setting_)
    : Patch(mesh, free_points, elements_of(mesh, free_points), setting_, setting_.workers) {}

Patch::Patch(const HexComplex& mesh, const std::vector<char>& free_points, std::vector<int> elements_, SmoothSetting& setting_,
             Workers& workers_)
    : setting(setting_), workers(workers_), elements(std::move(elements_)) {
  std::vector<int> own(mesh.points.size(), -1);
  for (int h : elements)
    for (int v : mesh.hexes[h])
      if (own[v] < 0) own[v] = 0, nodes.push_back(v);
  std::sort(nodes.begin(), nodes.end());
  for (std::size_t i = 0; i < nodes.size(); ++i) own[nodes[i]] = static_cast<int>(i);
  setting.context.check();
  std::vector<CadPlace> place;
  for (int v : nodes) {
    free.push_back(free_points[v] && !setting.held[v]);
    place.push_back(mesh.place[v]);
    for (int a = 0; a < 3; ++a) x.push_back(mesh.points[v][a]);
  }
  std::vector<double> target, shortest, least;
  std::vector<char> thorough;
  for (int element : elements) {
    std::array<int, 8> hex;
    for (int k = 0; k < 8; ++k) hex[k] = own[mesh.hexes[element][k]];
    hexes.push_back(hex);
    const double size = setting.target[element];
    target.push_back(size);
    thorough.push_back(quality_of(x.data(), hex) < 0.3);
    const double edge = shortest_edge(x, hex), h = setting.options.size;
    shortest.push_back(std::clamp(0.6 * edge, 0.08 * h, 0.15 * h));
    // An element that comes with a shorter edge (a thin wall) may keep it.
    least.push_back(std::max(edge > 0.0505 * h ? 0.05 * h : 0.9 * edge, 1e-9 * size));
  }
  setting.context.check();
  boundary = std::make_unique<Boundary>(place, free, setting.projector, setting.options.size, workers, setting.context);
  energy = std::make_unique<HexEnergy>(hexes, static_cast<int>(nodes.size()), target, shortest, least, thorough, workers);
  setting.context.check();
  std::vector<Span> spans;
  for (const Span& s : setting.spans)
    if (own[s.a] >= 0 && own[s.b] >= 0 && (free_points[s.a] || free_points[s.b]))
      spans.push_back({own[s.a], own[s.b], s.longest, s.shortest});
  energy->set_spans(std::move(spans), x.data());
}

void Patch::measure(const std::vector<double>& at, std::vector<double>& quality) const {
  quality.resize(hexes.size());
  workers.run(static_cast<int>(hexes.size()), 256, [&](int begin, int end) {
    for (int h = begin; h < end; ++h) quality[h] = quality_of(at.data(), hexes[h]);
  });
}

Grade Patch::grade(const std::vector<double>& at) const {
  std::vector<double> quality;
  measure(at, quality);
  return grade_of(quality);
}

void Patch::write_back(HexComplex& mesh) const {
  std::vector<CadPlace> place;
  for (int v : nodes) place.push_back(mesh.place[v]);
  boundary->store(place);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (!free[i]) continue;
    mesh.points[nodes[i]] = Eigen::Map<const Vec3>(x.data() + 3 * i);
    mesh.place[nodes[i]] = place[i];
  }
}

void Patch::read(const HexComplex& mesh) {
  std::vector<CadPlace> place;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    Eigen::Map<Vec3>(x.data() + 3 * i) = mesh.points[nodes[i]];
    place.push_back(mesh.place[nodes[i]]);
  }
  boundary->load(place);
}

std::vector<double> Patch::retract(const std::vector<double>& from, const std::vector<double>& moved, const std::vector<double>& floor) {
  std::vector<double> before, after, result = moved;
  measure(from, before);
  std::vector<double> fraction(nodes.size(), 1.0);
  std::vector<char> changed(nodes.size(), 1);
  constexpr int kHalvings = 6;
  after.assign(hexes.size(), 0);
  for (int round = 0; round < 3 * kHalvings; ++round) {
    setting.context.check();
    boundary->find_feet(result, changed);
    boundary->snap(result);
    workers.run(static_cast<int>(hexes.size()), 256, [&](int begin, int end) {
      for (int h = begin; h < end; ++h)
        if (std::any_of(hexes[h].begin(), hexes[h].end(), [&](int v) { return changed[v] != 0; }))
          after[h] = quality_of(result.data(), hexes[h]);
    });
    std::fill(changed.begin(), changed.end(), 0);
    bool any = false;
    for (std::size_t h = 0; h < hexes.size(); ++h) {
      if ((after[h] > 0 && (floor.empty() || after[h] >= floor[h])) || !(before[h] > 0)) continue;
      for (int v : hexes[h])
        if (fraction[v] > 0) changed[v] = 1, any = true;
    }
    if (!any) return result;
    for (std::size_t v = 0; v < nodes.size(); ++v) {
      if (!changed[v]) continue;
      fraction[v] = round < kHalvings ? 0.5 * fraction[v] : 0;
      for (int a = 0; a < 3; ++a) result[3 * v + a] = from[3 * v + a] + fraction[v] * (moved[3 * v + a] - from[3 * v + a]);
    }
  }
  boundary->find_feet(from);
  return from;
}

PatchObjective::PatchObjective(Patch& patch, const EnergyTerms& terms, double penalty) : patch_(patch), terms_(terms), penalty_(penalty) {
  std::vector<double> stiffness;
  patch.energy->stiffness(patch.x.data(), terms, stiffness);
  patch.setting.context.check();
  patch.boundary->invert_stiffness(stiffness, penalty, inverse_);
}

double PatchObjective::evaluate(const std::vector<double>& x, std::vector<double>& gradient) {
  patch_.setting.context.check();
  const EnergyValue value = patch_.energy->evaluate(x.data(), terms_, gradient.data());
  if (!(value.energy < std::numeric_limits<double>::infinity())) return value.energy;
  if (penalty_ > 0) {
    const double penalty = patch_.boundary->add_penalty(x, penalty_, gradient);
    patch_.boundary->fix_corners(gradient);
    return value.energy + penalty;
  }
  patch_.boundary->make_tangent(gradient);
  return value.energy;
}

void PatchObjective::precondition(std::vector<double>& r) const {
  patch_.workers.run(static_cast<int>(patch_.nodes.size()), 2048, [&](int begin, int end) {
    for (int v = begin; v < end; ++v) {
      const double* m = inverse_.data() + 6 * v;
      double* g = r.data() + 3 * v;
      const double x = g[0], y = g[1], z = g[2];
      g[0] = m[0] * x + m[5] * y + m[4] * z;
      g[1] = m[5] * x + m[1] * y + m[3] * z;
      g[2] = m[4] * x + m[3] * y + m[2] * z;
    }
  });
}

void PatchObjective::constrain(std::vector<double>& direction) const {
  if (penalty_ > 0)
    patch_.boundary->fix_corners(direction);
  else
    patch_.boundary->make_tangent(direction);
}

bool PatchObjective::enough(const std::vector<double>& x) const { return drift_limit > 0 && patch_.boundary->drifted(x, drift_limit); }

}  // namespace hexfeature
