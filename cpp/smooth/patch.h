// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include <algorithm>
#include <array>
#include <functional>
#include <memory>
#include <vector>

#include "base/context.h"
#include "mesh/hex_complex.h"
#include "mesh/projector.h"
#include "smooth/boundary.h"
#include "smooth/energy.h"
#include "smooth/lbfgs.h"
#include "smooth/smooth.h"
#include "smooth/workers.h"

namespace hexfeature {

/// What all stages share.
struct SmoothSetting {
  const Projector& projector;
  const SmoothOptions& options;
  Context& context;
  Workers& workers;
  std::vector<double> target;  ///< target size of each element of the mesh
  std::vector<Span> spans;     ///< the mesh's edges along CAD curves
  std::vector<char> held;      ///< per point of the mesh: it never moves
};

/// How good a set of elements is.
struct Grade {
  int inverted = 0;  ///< not proved positive
  double min_sj = 1, sum_sj = 0;
};

/// Scaled Jacobian of each element; 0 where it is positive but the element is not proved so everywhere.
void measure(const HexComplex& mesh, Workers& workers, std::vector<double>& quality);
Grade grade_of(const std::vector<double>& quality);

/// Points of the elements that `chosen` accepts, and `rings` elements farther.
template <class Chosen>
std::vector<char> points_near(const HexComplex& mesh, int rings, Chosen chosen) {
  std::vector<char> marked(mesh.points.size(), 0);
  for (int h = 0; h < mesh.hex_count(); ++h)
    if (chosen(h))
      for (int v : mesh.hexes[h]) marked[v] = 1;
  for (int ring = 0; ring < rings; ++ring) {
    std::vector<char> next = marked;
    for (const auto& hex : mesh.hexes)
      if (std::any_of(hex.begin(), hex.end(), [&](int v) { return marked[v] != 0; }))
        for (int v : hex) next[v] = 1;
    marked.swap(next);
  }
  return marked;
}

/// A part of the mesh (or all of it) that one stage works on: some elements, with the points that may move. The points of
/// the rim, which belong to other elements too, do not.
class Patch {
 public:
  /// `free` per point of the mesh; the elements are those that have a free point.
  Patch(const HexComplex& mesh, const std::vector<char>& free, SmoothSetting& setting);
  /// The same where those elements are known, in rising order; the stage's loops are shared by `workers`.
  Patch(const HexComplex& mesh, const std::vector<char>& free, std::vector<int> elements, SmoothSetting& setting, Workers& workers);
  static Patch whole(const HexComplex& mesh, SmoothSetting& setting);

  Grade grade() const { return grade(x); }
  Grade grade(const std::vector<double>& at) const;
  /// Scaled Jacobian of each element; 0 where it is positive but the element is not proved so everywhere.
  void measure(const std::vector<double>& at, std::vector<double>& quality) const;
  /// Put points and parameters back into the mesh.
  void write_back(HexComplex& mesh) const;
  /// Take points and parameters from the mesh.
  void read(const HexComplex& mesh);
  /// From a state on the CAD to `moved`, which has left it along tangents: every point on its CAD entity, as far along as no
  /// element turns inverted that was not, or falls below its scaled Jacobian in `floor` (none when empty), which it had. Returns the new
  /// state; the boundary's feet are those of the result.
  std::vector<double> retract(const std::vector<double>& from, const std::vector<double>& moved, const std::vector<double>& floor = {});

  SmoothSetting& setting;
  Workers& workers;
  std::vector<int> nodes;                 ///< point of the mesh
  std::vector<int> elements;              ///< element of the mesh
  std::vector<std::array<int, 8>> hexes;  ///< in own numbers
  std::vector<char> free;                 ///< per own point
  std::vector<double> x;                  ///< 3 per own point
  std::unique_ptr<Boundary> boundary;
  std::unique_ptr<HexEnergy> energy;
};

/// The energy of a patch with its boundary: penalised (soft rounds) or restricted to the tangent spaces.
class PatchObjective : public Objective {
 public:
  /// `penalty` > 0: boundary points are free, weight of their penalty; 0: they stay on their tangent planes and lines.
  PatchObjective(Patch& patch, const EnergyTerms& terms, double penalty);
  double evaluate(const std::vector<double>& x, std::vector<double>& gradient) override;
  void precondition(std::vector<double>& r) const override;
  void constrain(std::vector<double>& direction) const override;
  bool enough(const std::vector<double>& x) const override;
  double drift_limit = 0;  ///< end when a boundary point has moved so far; 0: no limit

 private:
  Patch& patch_;
  EnergyTerms terms_;
  double penalty_;
  std::vector<double> inverse_;  ///< of the stiffness, per point
};

/// Which bad places `lift_each_place` looks at.
struct PlaceRules {
  double limit = 0;       ///< elements of a scaled Jacobian below this ...
  double goal = 0;        ///< ... or below this, as long as none has been in vain: the mesh's worst element then rises
  int rings = 1;          ///< of elements round the bad one that move, too
  double least_gain = 0;  ///< of a place, or it is left as it was
  double progress = 0;    ///< of the whole of smoothing, at the first place
};

/// The worst element with its neighbourhood alone, then the next one, at most sixty; bad ones that share nothing at
/// once. `lift` changes a patch and returns what is gained; it is called from several threads.
void lift_each_place(HexComplex& mesh, SmoothSetting& setting, const PlaceRules& rules, const std::function<double(Patch&)>& lift);

/// (2) of experiments B5: penalised untangling rounds, first of the whole patch, then of what is still inverted where its boundary
/// points are put onto the CAD, with the elements around. Returns the number of rounds.
int untangle_softly(HexComplex& mesh, Patch& patch);
/// (3): exact sliding. The patch ends on the CAD.
void slide(Patch& patch);
/// (4): lift the worst elements. Requires a patch on the CAD and no inverted element.
void lift_worst(HexComplex& mesh, SmoothSetting& setting);
/// (5): what (4) could not lift for some other place's sake: one bad place after the other, each with its neighbourhood alone.
void lift_places(HexComplex& mesh, SmoothSetting& setting);
/// (6): the least scaled Jacobian itself, at one bad place after the other; or at the mesh's worst alone, as long as that gains.
void raise_minimum(HexComplex& mesh, SmoothSetting& setting, bool worst_alone = false);
/// (7): the last bad elements, point by point, by their scaled Jacobian itself.
void polish_worst(HexComplex& mesh, SmoothSetting& setting);
/// (8): mesh edges a little shorter than they should be at least.
void part_close_points(HexComplex& mesh, SmoothSetting& setting);
/// The mean, which (4) may have spent on the worst element. That one stays as good as it is, and poor ones lose next to nothing.
void lift_mean(HexComplex& mesh, SmoothSetting& setting);

}  // namespace hexfeature
