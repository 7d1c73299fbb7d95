// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "base/context.h"
#include "mesh/geometry.h"
#include "mesh/surface_mesh.h"
#include "shape/feature_shape.h"
#include "shape/validity.h"

namespace hexfeature {

struct LabelResult;

struct LabelOptions {
  double size = 1;                ///< element size h
  double max_work = 6e7;          ///< bound on counted search work (about 1.5e7 a second); counted, so that results do not depend on time
  double fold_tolerance = 0.75;   ///< length, in h, that a feature line may turn back along its axis without being repaired
  int max_expansions = 4000;      ///< bound on best-first expansions (deterministic stop)
  double beta = 0.5;              ///< paper's equation (1)
  int max_smoothing_rounds = 50;  ///< paper's step 3-7b, at most so often
  /// May be empty: called when labels are there that the search is going to repair; not valid, or not filled, or with defects.
  std::function<void(LabelResult)> first_look;
};

/// Tells whether a combinatorially valid feature shape also fills (quantization + lattice): supplied by the pipeline,
/// so that this room does not know the later ones. Returns the charts to blame in `charts` when it does not.
/// Not `thorough`: a quick answer, at the size asked for only, is enough.
struct FillOutcome {
  bool ok = false;
  std::string reason;
  std::vector<int> charts;
  int rounds = 1;  ///< counted work: solve-and-fill rounds
};
using FillCheck = std::function<FillOutcome(const SurfaceMesh& mesh, const FeatureShape& shape, bool thorough)>;

struct LabelResult {
  LabelledSurface surface;
  FeatureShape shape;       ///< with validity's arc signs
  ValidityReport validity;  ///< of `shape`
  bool filled = false;      ///< the fill check said yes
  double energy = 0;        ///< experiments A5: E, and the soft defects Q
  double defects = 0;
  int expansions = 0;
  std::vector<int> sites;  ///< per triangle of surface.mesh: CAD region (for pictures)
};

/// The default labeller: labels on CAD regions, energy, validity with blame, best-first repair (design 3.3, experiments A3-A7).
LabelResult label_regions(const SurfaceMesh& mesh, const Geometry& geometry, const LabelOptions& options, const FillCheck& fill,
                          Context& context);

/// The paper's labeller, steps 3-2 to 3-7b: adaptation, groups, correction rules, conditions, equations (1) and (2).
/// `adaptation` is the final degree of adaptation per triangle.
struct PaperLabelResult : LabelResult {
  std::vector<Vec3> adaptation;
  int smoothing_rounds = 0;
};
PaperLabelResult label_paper(const SurfaceMesh& mesh, const LabelOptions& options, const FillCheck& fill, Context& context);

}  // namespace hexfeature
