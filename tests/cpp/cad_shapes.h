// HexFeatureWB - LGPL-2.1-or-later
#pragma once
// Tiny CAD shapes made with OCCT, handed over as B-rep text, the way FreeCAD does.
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRepTools.hxx>
#include <TopoDS_Shape.hxx>
#include <gp_Ax1.hxx>
#include <gp_Ax2.hxx>
#include <gp_Trsf.hxx>
#include <memory>
#include <sstream>
#include <string>

#include "brep/cad_model.h"

namespace cad_shapes {

inline std::string text_of(const TopoDS_Shape& shape) {
  std::ostringstream out;
  BRepTools::Write(shape, out);
  return out.str();
}
inline std::unique_ptr<hexfeature::CadModel> model_of(const TopoDS_Shape& shape) {
  hexfeature::Context context;
  return hexfeature::read_brep_string(text_of(shape), context);
}
inline TopoDS_Shape box(double x, double y, double z) { return BRepPrimAPI_MakeBox(x, y, z).Shape(); }
inline TopoDS_Shape cylinder(double r, double h) { return BRepPrimAPI_MakeCylinder(r, h).Shape(); }
inline TopoDS_Shape sphere(double r) { return BRepPrimAPI_MakeSphere(r).Shape(); }
inline TopoDS_Shape torus(double r, double s) { return BRepPrimAPI_MakeTorus(r, s).Shape(); }
inline TopoDS_Shape cone(double r, double h) { return BRepPrimAPI_MakeCone(r, 0, h).Shape(); }
inline TopoDS_Shape moved(const TopoDS_Shape& shape, double x, double y, double z) {
  gp_Trsf t;
  t.SetTranslation(gp_Vec(x, y, z));
  return BRepBuilderAPI_Transform(shape, t, true).Shape();
}
inline TopoDS_Shape turned(const TopoDS_Shape& shape, double ax, double ay, double az) {
  gp_Trsf x, y, z;
  x.SetRotation(gp::OX(), ax * M_PI / 180);
  y.SetRotation(gp::OY(), ay * M_PI / 180);
  z.SetRotation(gp::OZ(), az * M_PI / 180);
  return BRepBuilderAPI_Transform(shape, z * y * x, true).Shape();
}
inline TopoDS_Shape cut(const TopoDS_Shape& a, const TopoDS_Shape& b) { return BRepAlgoAPI_Cut(a, b).Shape(); }
inline TopoDS_Shape fuse(const TopoDS_Shape& a, const TopoDS_Shape& b) { return BRepAlgoAPI_Fuse(a, b).Shape(); }
inline TopoDS_Shape as_splines(const TopoDS_Shape& shape) { return BRepBuilderAPI_NurbsConvert(shape).Shape(); }
/// A plate 40 x 30 x 8 with a hole of radius 6.
inline TopoDS_Shape plate_with_hole() { return cut(box(40, 30, 8), moved(cylinder(6, 20), 15, 15, -5)); }

}  // namespace cad_shapes
