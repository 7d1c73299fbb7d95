// HexFeatureWB - LGPL-2.1-or-later
#include "brep/sound.h"

#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom2d_TrimmedCurve.hxx>
#include <Geom_Curve.hxx>
#include <Geom_Surface.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>
#include <cmath>
#include <string>

#include "brep/occt.h"

namespace hexfeature {
namespace {

constexpr double kFarthest = 1e15;  ///< no coordinate or parameter of a part is larger
constexpr double kMostTurns = 100;  ///< periods that a parameter may be away from the first one

using Trimmed3d = Handle(Geom_TrimmedCurve);
using Trimmed2d = Handle(Geom2d_TrimmedCurve);

bool sane(double x) { return std::abs(x) < kFarthest; }  // false for NaN, too
bool sane(const gp_XYZ& p) { return sane(p.X()) && sane(p.Y()) && sane(p.Z()); }

/// What is wrong with a curve over a range; empty when nothing is.
template <class Trimmed, class Curve>
std::string fault_of(Curve curve, double first, double last) {
  for (auto trimmed = Trimmed::DownCast(curve); !trimmed.IsNull(); trimmed = Trimmed::DownCast(curve)) curve = trimmed->BasisCurve();
  if (!sane(first) || !sane(last)) return "an edge's parameters are not finite";
  if (!(first < last)) return "an edge has no length in its parameter";
  if (curve->IsPeriodic()) {
    const double period = curve->Period();
    if (!(period > 0)) return "an edge's curve has no period";
    if (std::abs(first) > kMostTurns * period || std::abs(last) > kMostTurns * period)
      return "an edge's parameters are far out of their period";
  } else if (first < curve->FirstParameter() - 0.5 * (last - first) || last > curve->LastParameter() + 0.5 * (last - first)) {
    return "an edge lies beyond the end of its curve";
  }
  return {};
}

std::string fault_of(const TopoDS_Edge& edge) {
  double first = 0, last = 0;
  const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, first, last);
  if (!sane(BRep_Tool::Tolerance(edge))) return "an edge's tolerance is not finite";
  if (curve.IsNull()) return {};
  if (std::string fault = fault_of<Trimmed3d>(curve, first, last); !fault.empty()) return fault;
  for (const double t : {first, 0.5 * (first + last), last})
    if (!sane(curve->Value(t).XYZ())) return "an edge's curve is not finite";
  return {};
}

std::string fault_of(const TopoDS_Edge& edge, const TopoDS_Face& face, const Handle(Geom_Surface) & surface) {
  double first = 0, last = 0;
  const Handle(Geom2d_Curve) curve = BRep_Tool::CurveOnSurface(edge, face, first, last);
  if (curve.IsNull()) {
    double a = 0, b = 0;
    return BRep_Tool::Curve(edge, a, b).IsNull() ? "an edge has no curve" : "";
  }
  if (std::string fault = fault_of<Trimmed2d>(curve, first, last); !fault.empty()) return fault;
  for (const double t : {first, 0.5 * (first + last), last}) {
    const gp_Pnt2d uv = curve->Value(t);
    if (!sane(uv.X()) || !sane(uv.Y())) return "an edge's curve on the face is not finite";
    if ((surface->IsUPeriodic() && std::abs(uv.X()) > kMostTurns * surface->UPeriod()) ||
        (surface->IsVPeriodic() && std::abs(uv.Y()) > kMostTurns * surface->VPeriod()))
      return "an edge's curve on the face is far out of the surface's period";
    if (!sane(surface->Value(uv.X(), uv.Y()).XYZ())) return "a face's surface is not finite";
  }
  return {};
}

std::string fault_of(const TopoDS_Face& face) {
  TopLoc_Location location;
  const Handle(Geom_Surface) surface = BRep_Tool::Surface(face, location);
  if (surface.IsNull()) return "a face has no surface";
  if (!sane(BRep_Tool::Tolerance(face))) return "a face's tolerance is not finite";
  bool edges = false;
  for (TopExp_Explorer e(face, TopAbs_EDGE); e.More(); e.Next(), edges = true) {
    const TopoDS_Edge edge = TopoDS::Edge(e.Current());
    if (std::string fault = fault_of(edge); !fault.empty()) return fault;
    if (std::string fault = fault_of(edge, face, surface); !fault.empty()) return fault;
  }
  return edges ? "" : "a face has no edges";
}

}  // namespace

void require_sound(const TopoDS_Shape& shape, Context& context) {
  TopTools_IndexedMapOfShape faces, vertices;
  TopExp::MapShapes(shape, TopAbs_FACE, faces);
  TopExp::MapShapes(shape, TopAbs_VERTEX, vertices);
  const auto refuse = [](const std::string& fault, int face) {
    throw MeshingError(Failure::BadInput, "read", "the part is damaged: " + fault, "export the part again, or repair it",
                       face > 0 ? std::vector<int>{face} : std::vector<int>{});
  };
  for (int i = 1; i <= vertices.Extent(); ++i)
    if (!sane(BRep_Tool::Pnt(TopoDS::Vertex(vertices(i))).XYZ()) || !sane(BRep_Tool::Tolerance(TopoDS::Vertex(vertices(i)))))
      refuse("a vertex is not finite", 0);
  for (int i = 1; i <= faces.Extent(); ++i) {
    context.check();
    if (const std::string fault = fault_of(TopoDS::Face(faces(i))); !fault.empty()) refuse(fault, i);
  }
}

}  // namespace hexfeature
