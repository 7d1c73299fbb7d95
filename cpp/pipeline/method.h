// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "pipeline/part.h"
#include "pipeline/run.h"

namespace hexfeature {

/// What a mesh is worth. Better: one that keeps the part's faces and sharp edges, then one without a bad element, then the higher
/// quality.
struct Worth {
  bool edges_lost = false;  ///< of the sharp CAD edges more is lost than a mesh may lose: no choice of sheets brings them back
  bool faithful = false;    ///< every CAD face is covered by its quads, every sharp CAD edge followed, every corner a node
  /// Of that: share of the sharp edges' length, 0.025 for each face lost and up to that for one not covered, 0.01 for each corner.
  double lost = 0;
  double lost_at_first = 0;  ///< the same before second looks: how well the labels suit the part
  double largest_gap = 0;    ///< longest distance from a point of a CAD face to the face's own quads, in h
  double min_sj = 0, mean_sj = 0;
  std::vector<int> lost_edges, lost_faces;  ///< sharp CAD edges not followed; CAD faces without quads or not covered by them, sorted

  bool sound() const { return min_sj >= 0.2; }
  /// Nothing that another proposal could be expected to do better.
  bool good() const { return faithful && sound(); }
  /// Not worth the time of another method: those that follow make meshes of much lower quality on the whole.
  bool sufficient() const { return faithful && min_sj >= 0.1; }
  bool better_than(const Worth& other) const;
};

/// A certified mesh of one solid, in world coordinates, and the intermediate results that belong to it.
struct Candidate {
  std::string method;
  HexComplex mesh;
  Worth worth;
  SmoothReport smoothing;
  Mat3 rotation = Mat3::Identity();
  // The feature-line method's:
  LabelResult labels;
  std::vector<Vec3> adaptation;
  Polycube polycube;
  SheetReport sheets;
};

/// One solid of a part, as every method gets it.
struct SolidTask {
  Part& part;
  int solid = 1;                    ///< 1-based
  const std::vector<Mat3>& frames;  ///< candidate working frames, best first
  Run& run;

  /// Put the part into a working frame and triangulate this solid's surface into run.result.surface (step "surface").
  void place(int frame) const;
  /// An attempt of `method` in `frame` that has just begun; `run.result` gets it at its end.
  void record(Attempt attempt, Context::Clock::time_point start) const;
};

/// `mesh` in the working frame that the task's surface was triangulated in.
Worth worth_of(const HexComplex& mesh, const SmoothReport& smoothing, const SolidTask& task);

/// A way to mesh a solid: a task in, its best certified mesh out. Records every attempt in run.result.attempts.
/// Throws MeshingError(NoMesh) with the step, reason and CAD faces when it has none; lets all other errors and Stopped through.
struct Method {
  std::string name;
  std::function<Candidate(const SolidTask&)> mesh;
};

/// All methods, in the order in which `auto` tries them.
const std::vector<Method>& all_methods();

Candidate mesh_by_feature_line(const SolidTask& task);
Candidate mesh_by_tet_split(const SolidTask& task);
/// For the method before it, when the task has been placed in the first frame: what tet-split begins with is made on another thread, if
/// that method takes long.
void begin_tets_ahead(const SolidTask& task);

}  // namespace hexfeature
