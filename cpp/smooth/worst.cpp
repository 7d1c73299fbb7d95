// HexFeatureWB - LGPL-2.1-or-later
#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "mesh/incidence.h"
#include "smooth/patch.h"

namespace hexfeature {
namespace {

/// One sweep over the powers on the patch. Leaves it in its best state seen, on the CAD; returns how far its merit rose.
template <class Merit>
double sweep(Patch& patch, const std::vector<int>& powers, Merit merit) {
  const double h = patch.setting.options.size;
  patch.boundary->find_feet(patch.x);
  patch.boundary->snap(patch.x);
  std::vector<double> best = patch.x, gradient(patch.x.size());
  Grade last = patch.grade();
  const double start = merit(last);
  double best_merit = start;
  EnergyTerms terms;
  terms.theta = patch.setting.options.theta;
  terms.shape_weight = 0.5;
  for (int power : powers) {
    terms.power = power;
    patch.energy->admit(patch.x.data());
    if (!std::isfinite(patch.energy->evaluate(patch.x.data(), terms, gradient.data()).energy)) break;
    patch.boundary->hold_at_rims(gradient);
    PatchObjective objective(patch, terms, 0);
    objective.drift_limit = 0.3 * h;
    LbfgsOptions options;
    options.step_limit = 0.1 * h;
    if (patch.setting.options.brief) options.iterations = 15;
    options.floor = patch.energy->floor(terms);
    std::vector<double> moved = patch.x;
    Lbfgs(static_cast<int>(moved.size()), patch.workers).descend(objective, moved, options);
    // Off the tangents some elements may get worse: then go less far.
    std::vector<double> next;
    Grade grade;
    for (int tries = 0; tries < 4; ++tries) {
      next = patch.retract(patch.x, moved);
      grade = patch.grade(next);
      if (grade.inverted == 0 && grade.min_sj >= 0.8 * last.min_sj) break;
      for (std::size_t i = 0; i < moved.size(); ++i) moved[i] = 0.5 * (moved[i] + patch.x[i]);
    }
    if (grade.inverted > 0 || grade.min_sj < 0.8 * last.min_sj) break;
    patch.x = next;
    last = grade;
    if (merit(grade) > best_merit) best = next, best_merit = merit(grade);
  }
  patch.x = best;
  patch.boundary->find_feet(patch.x);
  patch.boundary->snap(patch.x);
  return best_merit - start;
}

}  // namespace

void lift_worst(HexComplex& mesh, SmoothSetting& setting) {
  const bool brief = setting.options.brief;
  const int sweeps = brief ? 1 : 6;
  constexpr double kLeastGain = 0.003;
  std::vector<double> quality;
  for (int k = 0; k < sweeps; ++k) {
    setting.context.progress("smooth", 0.8 + 0.15 * k / sweeps);
    measure(mesh, setting.workers, quality);
    const double worst = *std::min_element(quality.begin(), quality.end());
    const double limit = brief ? std::clamp(worst + 0.15, 0.3, 0.95) : std::clamp(worst + 0.25, 0.5, 0.95);
    if (!(worst > 0) || worst >= limit) return;
    Patch patch(mesh, points_near(mesh, 2, [&](int h) { return quality[h] < limit; }), setting);
    const double gain = sweep(patch,
                              brief    ? std::vector<int>{2, 4, 8}
                              : k == 0 ? std::vector<int>{1, 1, 2, 2, 4, 4, 8, 8, 16}
                                       : std::vector<int>{4, 8, 16, 16},
                              [](const Grade& g) { return g.min_sj; });
    if (gain > 0) patch.write_back(mesh);
    if (gain < kLeastGain) return;
  }
}

namespace {

/// A bad element and what moves with it.
struct Place {
  int worst;
  std::unique_ptr<Patch> patch;
  double gain = 0;
};

/// Of a bad element: whether its place was tried in vain; if so, when it was the worst one, or before.
enum class InVain : char { No, Early, Yes };

/// The elements round one that is bad: those that have a point of it or of `rings` more elements.
class Neighbourhood {
 public:
  Neighbourhood(const HexComplex& mesh, const Incidence& incidence)
      : mesh_(mesh), incidence_(incidence), free_(mesh.points.size(), 0), inside_(mesh.hexes.size(), 0) {}

  /// False when it meets an element that is taken.
  bool grow(int bad, int rings, const std::vector<char>& taken) {
    for (int v : points_) free_[v] = 0;
    for (int h : elements_) inside_[h] = 0;
    points_.clear();
    elements_.assign(1, bad);
    inside_[bad] = 1;
    std::size_t next_element = 0, next_point = 0;
    for (int ring = 0; ring <= rings; ++ring) {
      for (; next_element < elements_.size(); ++next_element)
        for (int v : mesh_.hexes[elements_[next_element]])
          if (!free_[v]) free_[v] = 1, points_.push_back(v);
      for (; next_point < points_.size(); ++next_point)
        for (int h : incidence_.at(points_[next_point])) {
          if (taken[h]) return false;
          if (!inside_[h]) inside_[h] = 1, elements_.push_back(h);
        }
    }
    std::sort(elements_.begin(), elements_.end());
    return true;
  }
  const std::vector<int>& elements() const { return elements_; }  ///< in rising order
  const std::vector<char>& free() const { return free_; }         ///< per point of the mesh: it may move

 private:
  const HexComplex& mesh_;
  const Incidence& incidence_;
  std::vector<char> free_, inside_;
  std::vector<int> points_, elements_;
};

/// The worst elements below `limit` that were not tried in vain, with their neighbourhoods, as long as these share no element with each
/// other. At most kTogether, whatever the number of threads; above the rules' limit, where only the mesh's worst element counts, about as
/// bad ones.
std::vector<Place> worst_places(const HexComplex& mesh, Neighbourhood& around, const std::vector<double>& quality,
                                const std::vector<InVain>& in_vain, double limit, const PlaceRules& rules, SmoothSetting& setting,
                                Workers& alone) {
  constexpr int kTogether = 4, kTries = 100;
  constexpr double kAsBad = 0.01;
  std::vector<int> bad;
  for (int h = 0; h < mesh.hex_count(); ++h)
    if (in_vain[h] != InVain::Yes && quality[h] > 0 && quality[h] < limit) bad.push_back(h);
  const std::size_t tries = std::min<std::size_t>(kTries, bad.size());
  std::partial_sort(bad.begin(), bad.begin() + static_cast<long>(tries), bad.end(),
                    [&](int a, int b) { return quality[a] != quality[b] ? quality[a] < quality[b] : a < b; });
  std::vector<Place> places;
  std::vector<char> taken(mesh.hexes.size(), 0);
  for (std::size_t i = 0; i < tries && places.size() < kTogether; ++i) {
    const int worst = bad[i];
    if (quality[worst] > std::max(rules.limit, quality[bad[0]] + kAsBad)) break;
    if (taken[worst] || (in_vain[worst] == InVain::Early && !places.empty())) continue;
    if (!around.grow(worst, rules.rings, taken)) continue;
    for (int h : around.elements()) taken[h] = 1;
    places.push_back({worst, std::make_unique<Patch>(mesh, around.free(), around.elements(), setting, alone)});
  }
  return places;
}

}  // namespace

void lift_each_place(HexComplex& mesh, SmoothSetting& setting, const PlaceRules& rules, const std::function<double(Patch&)>& lift) {
  constexpr int kPlaces = 60;
  std::vector<double> quality;
  measure(mesh, setting.workers, quality);
  std::vector<InVain> in_vain(mesh.hexes.size(), InVain::No);
  const Incidence incidence(mesh.hexes, mesh.points.size());
  Neighbourhood around(mesh, incidence);
  Workers alone(1, setting.context);
  double limit = rules.goal;
  for (int done = 0; done < kPlaces;) {
    setting.context.progress("smooth", rules.progress + 0.02 * done / kPlaces);
    std::vector<Place> places = worst_places(mesh, around, quality, in_vain, limit, rules, setting, alone);
    if (places.empty()) return;
    setting.workers.run(static_cast<int>(places.size()), 2, [&](int begin, int end) {
      for (int i = begin; i < end; ++i) places[i].gain = lift(*places[i].patch);
    });
    for (const Place& place : places) {
      if (done == kPlaces || !(quality[place.worst] < limit)) break;
      ++done;
      if (place.gain < rules.least_gain) {
        const bool first = &place == places.data();
        in_vain[place.worst] = first ? InVain::Yes : InVain::Early;
        if (first) limit = rules.limit;  // the mesh's worst element stays what it is
        continue;
      }
      place.patch->write_back(mesh);
      std::vector<double> now;
      place.patch->measure(place.patch->x, now);
      for (std::size_t i = 0; i < now.size(); ++i) {
        quality[place.patch->elements[i]] = now[i];
        in_vain[place.patch->elements[i]] = InVain::No;  // its surroundings are others now
      }
    }
  }
}

void lift_places(HexComplex& mesh, SmoothSetting& setting) {
  PlaceRules rules;
  rules.limit = rules.goal = 0.4;
  rules.rings = 2;
  rules.least_gain = 5e-3;
  rules.progress = 0.95;
  lift_each_place(mesh, setting, rules, [](Patch& patch) {
    // A tenth more of the worst element is worth a twentieth of the neighbourhood's mean.
    const double count = static_cast<double>(patch.hexes.size());
    const auto merit = [&](const Grade& g) { return g.min_sj > 0 ? 0.5 * std::log(g.min_sj) + g.sum_sj / count : -1e9; };
    return sweep(patch, {1, 2, 4, 8, 16}, merit);
  });
}

}  // namespace hexfeature
