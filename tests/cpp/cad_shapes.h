// HexFeatureWB - LGPL-2.1-or-later
#pragma once
// Tiny CAD shapes made with OCCT, handed over as B-rep text, the way FreeCAD does.
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeSolid.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRepTools.hxx>
#include <GC_MakeArcOfCircle.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Shape.hxx>
#include <cmath>
#include <gp_Ax1.hxx>
#include <gp_Ax2.hxx>
#include <gp_Trsf.hxx>
#include <memory>
#include <sstream>
#include <string>
#include <utility>

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
/// A square bar of that side and height, one of its upright edges rounded.
inline TopoDS_Shape rounded_block(double side, double r, double height) {
  const double c = side - r, m = c + r * std::sqrt(0.5);
  const gp_Pnt p[] = {{0, 0, 0}, {side, 0, 0}, {side, c, 0}, {c, side, 0}, {0, side, 0}};
  BRepBuilderAPI_MakeWire wire;
  for (const auto& [a, b] : {std::pair{0, 1}, {1, 2}}) wire.Add(BRepBuilderAPI_MakeEdge(p[a], p[b]));
  wire.Add(BRepBuilderAPI_MakeEdge(GC_MakeArcOfCircle(p[2], gp_Pnt(m, m, 0), p[3]).Value()));
  for (const auto& [a, b] : {std::pair{3, 4}, {4, 0}}) wire.Add(BRepBuilderAPI_MakeEdge(p[a], p[b]));
  return BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(wire.Wire()), gp_Vec(0, 0, height)).Shape();
}
/// A drill of that radius that stands on the origin, its wall in two halves, parted in the direction of `degrees`; with `tip` > 0 one so
/// long at its lower end.
inline TopoDS_Shape parted_drill(double r, double h, double degrees, double tip) {
  TopoDS_Shape halves[2];
  for (int i = 0; i < 2; ++i) {
    halves[i] = BRepPrimAPI_MakeCylinder(r, h, M_PI).Shape();
    if (tip > 0) halves[i] = fuse(halves[i], moved(BRepPrimAPI_MakeCone(0, r, tip, M_PI).Shape(), 0, 0, -tip));
    halves[i] = turned(halves[i], 0, 0, degrees + 180 * i);
  }
  return fuse(halves[0], halves[1]);
}
/// A hexagonal prism that stands on the origin, two of its sides square to x, its upper edges chamfered.
inline TopoDS_Shape chamfered_hexagon(double corner, double height, double chamfer) {
  const auto point = [](double radius, double z, int i) {
    return gp_Pnt(radius * std::cos(M_PI / 6 + i * M_PI / 3), radius * std::sin(M_PI / 6 + i * M_PI / 3), z);
  };
  const std::pair<double, double> rings[] = {{corner, 0}, {corner, height - chamfer}, {corner - chamfer / std::cos(M_PI / 6), height}};
  BRepBuilderAPI_Sewing sewing;
  for (int k = 0; k < 2; ++k)
    for (int i = 0; i < 6; ++i) {
      const auto [r, z] = rings[k];
      const auto [s, w] = rings[k + 1];
      sewing.Add(BRepBuilderAPI_MakeFace(
          BRepBuilderAPI_MakePolygon(point(r, z, i), point(r, z, i + 1), point(s, w, i + 1), point(s, w, i), true)));
    }
  for (const auto& [r, z] : {rings[0], rings[2]}) {
    BRepBuilderAPI_MakePolygon outline;
    for (int i = 0; i < 6; ++i) outline.Add(point(r, z, r == corner ? -i : i));
    outline.Close();
    sewing.Add(BRepBuilderAPI_MakeFace(outline.Wire()));
  }
  sewing.Perform();
  return BRepBuilderAPI_MakeSolid(TopoDS::Shell(sewing.SewedShape()));
}
/// A plate 40 x 30 x 8 with a hole of radius 6.
inline TopoDS_Shape plate_with_hole() { return cut(box(40, 30, 8), moved(cylinder(6, 20), 15, 15, -5)); }

}  // namespace cad_shapes
