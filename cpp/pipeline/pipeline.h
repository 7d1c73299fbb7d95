// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "base/context.h"
#include "base/options.h"
#include "brep/cad_model.h"
#include "label/labels.h"
#include "lattice/lattice.h"
#include "mesh/hex_complex.h"
#include "quality/quality.h"
#include "sheet/sheet.h"
#include "smooth/smooth.h"
#include "surface/surface.h"

namespace hexfeature {

/// One method that was tried, and why it gave up (empty reason: it made the mesh).
struct Attempt {
  std::string method;
  std::string step, reason, hint;
  std::vector<int> cad_faces;
  double seconds = 0;
};

struct StepTime {
  std::string step;
  double seconds = 0;
};

/// Everything a run leaves. `mesh` is certified unless the run was stopped early by Options::stop_after, in which case the
/// intermediate results up to that step are filled and `mesh` holds the complex of that step, if it has one.
/// `mesh` is in the world frame (the part's own coordinates); the intermediate results are in the working frame
/// x -> rotation * (x - centre).
struct Result {
  Options options;  ///< as used (size filled in)
  std::string method;
  std::vector<Attempt> attempts;
  std::vector<StepTime> times;
  std::vector<std::string> warnings;

  Mat3 rotation = Mat3::Identity();
  Vec3 centre = Vec3::Zero();
  SurfaceMesh surface;     ///< step 3-1
  LabelResult labels;      ///< steps 3-2 to 3-6: labelled surface, feature shape, validity
  std::vector<Vec3> adaptation;  ///< per triangle of labels.surface.mesh, with --labels paper
  Polycube polycube;
  HexComplex mesh;
  std::vector<std::array<int, 20>> hexes20;  ///< order 2: VTK node order, else empty
  std::vector<std::array<int, 8>> quads8;

  QualityReport quality;
  SheetReport sheets;
  SmoothReport smoothing;
  std::vector<int> faces_without_quads;
  int cad_faces = 0, cad_edges = 0, cad_vertices = 0, solids = 1;
  double cad_volume = 0;
  bool certified = false;
};

/// Read a part file and mesh it: the whole way. Throws MeshingError.
Result mesh_file(const std::string& path, const Options& options, Context& context);
/// Mesh a B-rep given as text (FreeCAD's shape.exportBrepToString()).
Result mesh_brep_string(const std::string& brep, const Options& options, Context& context);

}  // namespace hexfeature
