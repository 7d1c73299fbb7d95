// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include <array>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "base/context.h"
#include "base/options.h"
#include "label/labels.h"
#include "lattice/lattice.h"
#include "mesh/hex_complex.h"
#include "quality/limits.h"
#include "quality/quality.h"
#include "sheet/sheet.h"
#include "smooth/smooth.h"

namespace hexfeature {

/// One method that was tried on one solid, and why it gave up (empty reason: it made the mesh).
struct Attempt {
  std::string method;
  int solid = 1;
  int frame = 0;  ///< number of the working frame, best first
  std::string step, reason, hint;
  std::vector<int> cad_faces;
  double seconds = 0;

  void blame(const MeshingError& error) {
    step = error.step;
    reason = error.reason;
    hint = error.hint;
    cad_faces = error.cad_faces;
  }
};

struct StepTime {
  std::string step;
  double seconds = 0;
};

/// Everything a run leaves. `mesh` is certified unless the run was stopped early by Options::stop_after: then the
/// intermediate results up to that step are filled and `mesh` holds the complex of that step, if it has one.
/// `mesh` is in the part's own coordinates (world); the other intermediate results are of the last solid, in the
/// working frame x -> rotation * (x - centre).
struct Result {
  Options options;     ///< as used, with the size filled in
  std::string method;  ///< that made the mesh
  std::string stopped_after;
  std::vector<Attempt> attempts;
  std::vector<StepTime> times;  ///< summed per step, in pipeline order
  std::vector<std::string> warnings;

  Mat3 rotation = Mat3::Identity();
  Vec3 centre = Vec3::Zero();
  SurfaceMesh surface;           ///< step 3-1
  LabelResult labels;            ///< steps 3-2 to 3-6: labelled surface, feature shape, validity
  std::vector<Vec3> adaptation;  ///< per triangle of labels.surface.mesh, with the paper's labeller
  Polycube polycube;             ///< recognition model
  HexComplex mesh;
  std::vector<std::array<int, 20>> hexes20;  ///< order 2: VTK node order, points appended to mesh.points; else empty
  std::vector<std::array<int, 8>> quads8;
  std::vector<int> straightened;        ///< boundary mid-side nodes that had to leave the CAD for their element's sake
  std::vector<int> straightened_faces;  ///< CAD faces with such a node
  double least_jacobian20 = 0;          ///< least determinant at C3D20's and C3D20R's integration points and the nodes, over the mean
  double mid_side_deviation = 0;        ///< largest distance of a boundary mid-side node from its CAD, the straightened ones' too

  QualityReport quality;
  SheetReport sheets;
  SmoothReport smoothing;
  Limits limits;                              ///< what the part's own angles allow, beside what the mesh has
  std::vector<int> faces_without_quads;       ///< CAD faces that no quad covers
  std::vector<int> sharp_edges_not_followed;  ///< sharp CAD edges that mesh edges do not follow in full
  int cad_faces = 0, cad_edges = 0, cad_vertices = 0, solids = 1;
  std::vector<std::string> solid_names;  ///< one a solid, empty where the file gives none
  double cad_volume = 0;
  bool certified = false;
};

/// For a preview: called with a result that shows labels and feature shape of one solid (1-based), first as soon as there are some, before
/// they are tried and repaired, then when they are final. A run that Options::stop_after ends goes on to the next solid. May be empty.
using Look = std::function<void(std::shared_ptr<Result>, int solid, bool final)>;

/// Read a part file (.step .stp .iges .igs .brep .brp .stl .obj .ply) and mesh it: the whole way. Throws MeshingError.
Result mesh_file(const std::string& path, const Options& options, Context& context);
/// Mesh a B-rep given as text (FreeCAD's shape.exportBrepToString()).
Result mesh_brep_string(const std::string& brep, const Options& options, Context& context, const Look& look = {});

}  // namespace hexfeature
