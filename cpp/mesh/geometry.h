// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include <array>
#include <vector>

#include "base/types.h"
#include "mesh/projector.h"

namespace hexfeature {

enum class SurfaceKind { Plane, Cylinder, Cone, Sphere, Torus, Other };

/// One CAD face, analysed. Numbers are 1-based (TopExp::MapShapes order, FreeCAD's FaceN).
struct CadFace {
  SurfaceKind kind = SurfaceKind::Other;  ///< recognised also when it arrives as a spline or a revolution
  Vec3 origin = Vec3::Zero();             ///< a point of the axis / plane, or the centre
  Vec3 axis = Vec3::UnitZ();              ///< unit axis, or the plane's outward normal
  double radius = 0, radius2 = 0;         ///< cylinder, sphere, cone (at origin); torus: major, minor
  double half_angle = 0;                  ///< cone
  double area = 0;
  bool outward_convex = false;  ///< cylinder-like: material on the axis' side (a shaft), not a hole
  int solid = 1;                ///< 1-based
  std::vector<int> edges;       ///< 1-based, each once (seams too)
};

/// One CAD edge, analysed.
struct CadEdge {
  std::array<int, 2> faces{0, 0};     ///< the two faces; equal on a seam; second 0 when free
  std::array<int, 2> vertices{0, 0};  ///< start, end; equal when closed; 0 when it has none
  double length = 0;
  double t0 = 0, t1 = 0;    ///< parameter range
  double dihedral = 0;      ///< median signed angle between the faces' normals, radians; >0 convex
  bool sharp = false;       ///< |dihedral| > 20 degrees: a feature that mesh edges must follow
  bool seam = false;        ///< same face on both sides
  bool degenerate = false;  ///< a pole: no length
};

struct CadVertex {
  Vec3 point = Vec3::Zero();
  std::vector<int> edges;  ///< 1-based, non-degenerate ones that end here
  bool hard = false;  ///< a corner that must be a mesh node: its number of sharp edges is neither 0 nor 2, or they kink over 30 degrees
};

/// The part's geometry as every step after reading sees it: analysis tables + projector (CAD or triangles).
struct Geometry {
  const std::vector<CadFace>* faces = nullptr;
  const std::vector<CadEdge>* edges = nullptr;
  const std::vector<CadVertex>* vertices = nullptr;
  const Projector* projector = nullptr;

  const CadFace& face(int id) const { return (*faces)[id - 1]; }
  const CadEdge& edge(int id) const { return (*edges)[id - 1]; }
  const CadVertex& vertex(int id) const { return (*vertices)[id - 1]; }
};

}  // namespace hexfeature
