// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include <memory>
#include <string>

#include "base/context.h"
#include "brep/cad_model.h"
#include "mesh/surface_mesh.h"

namespace hexfeature {

struct SurfaceOptions {
  double size = 1;             ///< element size h
  double edge_factor = 0.6;    ///< triangle edges are at most edge_factor * h on curved faces and on CAD edges
  double plane_factor = 1.5;   ///< ... and plane_factor * h inside planar faces
  int segments_per_turn = 24;  ///< at least so many edges round a full turn
};

/// Step 3-1 of the paper: triangulate the placed part (BRepMesh, then split and flip within CAD faces) into a closed
/// oriented SurfaceMesh in the working frame. Every point on the true CAD. Throws MeshingError(BadInput, "surface").
SurfaceMesh triangulate(const CadModel& model, const SurfaceOptions& options, Context& context);

/// A triangle surface read from .stl .obj .ply: welded, oriented, checked closed, cut into pseudo CAD faces,
/// edges and vertices by the dihedral angle (> 30 degrees by default), with its analysis and projector.
struct TrianglePart {
  Geometry geometry() const { return {&faces, &edges, &vertices, projector.get()}; }
  SurfaceMesh mesh;            ///< as read, welded; `place` and `halfedge_edge` from the pseudo CAD
  std::vector<CadFace> faces;  ///< pseudo faces (planes recognised, else Other)
  std::vector<CadEdge> edges;  ///< chains of sharp mesh edges between pseudo vertices
  std::vector<CadVertex> vertices;
  std::unique_ptr<Projector> projector;  ///< onto the triangles of one pseudo face, the polyline of one pseudo edge
};
TrianglePart read_triangles(const std::string& path, double crease_degrees, Context& context);

/// Candidate working frames of a triangle part, best first, as `find_frames` gives them for a CAD model: from the normals of its
/// planes, and on curved faces from the directions that most area looks to and the principal directions of the normals.
std::vector<Mat3> find_frames(const TrianglePart& part, int count = 2);

}  // namespace hexfeature
