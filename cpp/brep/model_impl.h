// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Shape.hxx>
#include <vector>

#include "brep/base_mesh.h"
#include "brep/cad_model.h"
#include "brep/edge_geometry.h"
#include "brep/face_geometry.h"
#include "brep/trim.h"

namespace hexfeature {

/// The B-rep as OCCT has it, numbered as FreeCAD numbers it, with the geometry of each face and edge.
struct CadTables {
  TopoDS_Shape shape;                ///< one solid, or a compound of several
  std::vector<TopoDS_Shape> solids;  ///< solid i + 1
  TopTools_IndexedMapOfShape face_map, edge_map, vertex_map;
  std::vector<FaceGeometry> faces;  ///< as in face_map
  std::vector<EdgeGeometry> edges;
  std::vector<Vec3> vertices;
  double diagonal = 0;

  explicit CadTables(const TopoDS_Shape& part);
  const FaceGeometry& face(int id) const { return faces[id - 1]; }
  const EdgeGeometry& edge(int id) const { return edges[id - 1]; }
};

/// Everything in the file's frame; the working frame is applied on the way in and out.
struct CadModel::Impl {
  CadTables cad;
  BaseMesh base;
  std::vector<TrimRegion> trims;  ///< per face
  Mat3 rotation = Mat3::Identity();
  Vec3 centre = Vec3::Zero();
  std::vector<CadFace> faces_as_read;  ///< filled by the first CadModel::place
  double volume = -1;                  ///< below 0: nobody has asked for it yet

  Impl(CadTables tables, BaseMesh mesh) : cad(std::move(tables)), base(std::move(mesh)) {}
};

/// Fill the model's faces, edges and vertices (file's frame) from tables and base mesh.
void analyse(CadModel& model, Context& context, int threads);

/// Recognise plane, cylinder, cone, sphere and torus in a face whose surface is something else (spline, revolution,
/// extrusion), from points and normals of the true surface. Sets kind, origin, axis and radii; leaves Other when none fits.
void recognise(const std::vector<Vec3>& points, const std::vector<Vec3>& normals, double tolerance, CadFace& face);

}  // namespace hexfeature
