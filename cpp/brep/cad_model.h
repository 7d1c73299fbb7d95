// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "base/context.h"
#include "base/types.h"
#include "mesh/geometry.h"
#include "mesh/projector.h"

namespace hexfeature {

/// A solid part: a B-rep with its analysis, in the working frame. The B-rep may be placed in a rotated
/// and centred working frame; all queries are then in that frame, and `to_world` brings points back.
/// Implements Projector on the true surfaces and curves (cached parameters + own Newton).
class CadModel : public Projector {
 public:
  ~CadModel() override;

  std::vector<CadFace> faces;  ///< faces[i] is CAD face i + 1
  std::vector<CadEdge> edges;
  std::vector<CadVertex> vertices;
  int solid_count = 1;
  std::vector<std::string> solid_names;  ///< as in the file; empty where it gives none
  std::vector<std::string> warnings;     ///< what healing changed, stray faces left out, ...

  const CadFace& face(int id) const { return faces[id - 1]; }
  const CadEdge& edge(int id) const { return edges[id - 1]; }
  const CadVertex& vertex(int id) const { return vertices[id - 1]; }

  Geometry geometry() const { return {&faces, &edges, &vertices, this}; }
  double volume() const;        ///< measured when first asked for, which takes a while on splines
  double rough_volume() const;  ///< of the first triangulation
  Vec3 bbox_min() const;        ///< of the placed part
  Vec3 bbox_max() const;
  double diagonal() const { return (bbox_max() - bbox_min()).norm(); }

  /// Put the part into a working frame: x -> rotation * (x - centre). Updates faces, vertices and queries.
  void place(const Mat3& rotation, const Vec3& centre);
  Vec3 to_world(const Vec3& p) const;
  Vec3 to_frame(const Vec3& p) const;

  FacePoint project_to_face(int face, const Vec3& p, const Vec2* guess) const override;
  CurvePoint project_to_edge(int edge, const Vec3& p, const double* guess) const override;
  Vec3 vertex_point(int vertex) const override;
  CurvePoint edge_point(int edge, double t) const override;

  struct Impl;  ///< OCCT lives here, seen by the brep and surface rooms' sources alone
  const Impl& impl() const { return *impl_; }
  Impl& impl() { return *impl_; }
  explicit CadModel(std::unique_ptr<Impl> impl);

 private:
  std::unique_ptr<Impl> impl_;
};

/// Read a part by its ending: .step .stp .iges .igs .brep .brp. STEP and IGES come in millimetres, whatever unit the file has, as in
/// FreeCAD. Heals (ShapeFix) when the solid is bad, and removes tiny edges and faces when its surface cannot be triangulated as it is.
/// Face numbers are those of the file's shape as FreeCAD numbers it: for one solid, that solid's faces in
/// MapShapes order; for several, the compound's. Throws MeshingError(BadInput, "read") with a hint: missing file,
/// a directory, empty, truncated, no solid, open shell.
std::unique_ptr<CadModel> read_cad(const std::string& path, Context& context, int threads = 1);

/// Read a B-rep from its text (FreeCAD: shape.exportBrepToString()).
std::unique_ptr<CadModel> read_brep_string(const std::string& text, Context& context, int threads = 1);

/// Candidate working frames, best first: rotations that bring the part's own directions onto the axes
/// (least sum of area * |R n|_1), for use with `place`; all from the file's frame, however the part is placed now. At most
/// `count`, no two of which differ by a permutation of the axes alone. The identity is preferred when it ties.
std::vector<Mat3> find_frames(const CadModel& model, int count = 2);

}  // namespace hexfeature
