// HexFeatureWB - LGPL-2.1-or-later
#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_MakeSolid.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <BRepLib.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <GProp_GProps.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <ShapeFix_FixSmallFace.hxx>
#include <ShapeFix_Shape.hxx>
#include <ShapeFix_Solid.hxx>
#include <ShapeFix_Wireframe.hxx>
#include <Standard_Version.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <mutex>
#include <sstream>

#include "brep/exchange.h"
#include "brep/model_impl.h"
#include "brep/occt.h"
#include "brep/sound.h"

namespace hexfeature {
namespace {

[[noreturn]] void bad_input(const std::string& reason, const std::string& hint) {
  throw MeshingError(Failure::BadInput, "read", reason, hint);
}

std::string lower_extension(const std::string& path) {
  std::string ending = std::filesystem::path(path).extension().string();
  for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return ending;
}

void check_file(const std::string& path) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) bad_input("there is no file '" + path + "'", "check the path");
  if (std::filesystem::is_directory(status)) bad_input("'" + path + "' is a directory", "give the part's file");
  if (std::filesystem::is_regular_file(status) && std::filesystem::file_size(path, error) == 0)
    bad_input("'" + path + "' is empty", "export the part again");
  if (!std::ifstream(path, std::ios::binary)) bad_input("'" + path + "' cannot be opened", "check its permissions");
}

void silence_occt() {
  static std::once_flag once;
  std::call_once(once, [] { Message::DefaultMessenger()->ChangePrinters().Clear(); });
}

/// OCCT's reader trusts the counts in the text and would go on past its end for ever: the stream throws there instead.
TopoDS_Shape parse_brep(const std::string& text) {
  std::istringstream in(text + "\n\n");
  in.exceptions(std::ios::eofbit | std::ios::failbit | std::ios::badbit);
  TopoDS_Shape shape;
  BRep_Builder builder;
  try {
    BRepTools::Read(shape, in, builder);
  } catch (const std::ios_base::failure&) {
    bad_input("the B-rep is truncated or no B-rep at all", "export the part again");
  }
  if (shape.IsNull()) bad_input("the B-rep holds no shape", "export the part again; from FreeCAD: shape.exportBrepToString()");
  return shape;
}

std::vector<TopoDS_Shape> solids_of(const TopoDS_Shape& shape) {
  TopTools_IndexedMapOfShape map;
  TopExp::MapShapes(shape, TopAbs_SOLID, map);
  std::vector<TopoDS_Shape> solids;
  for (int i = 1; i <= map.Extent(); ++i) solids.push_back(map(i));
  return solids;
}

/// A closed shell without a solid, or loose faces that can be sewn: make the solid. Null when they do not close.
TopoDS_Shape make_solid(const TopoDS_Shape& shape, std::vector<std::string>& warnings) {
  const auto closed_shells = [](const TopoDS_Shape& s) {
    std::vector<TopoDS_Shell> shells;
    for (TopExp_Explorer e(s, TopAbs_SHELL); e.More(); e.Next()) {
      const TopoDS_Shell shell = TopoDS::Shell(e.Current());
      if (BRep_Tool::IsClosed(shell)) shells.push_back(shell);
    }
    return shells;
  };
  std::vector<TopoDS_Shell> shells = closed_shells(shape);
  if (shells.empty()) {
    Bnd_Box box;
    BRepBndLib::Add(shape, box);
    const double size = box.IsVoid() ? 1 : std::sqrt(box.SquareExtent());
    BRepBuilderAPI_Sewing sewing(1e-5 * size);
    sewing.Add(shape);
    sewing.Perform();
    const TopoDS_Shape sewn = sewing.SewedShape();
    if (!sewn.IsNull()) shells = closed_shells(sewn);
    if (!shells.empty()) warnings.push_back("loose faces were sewn into a solid: face numbers are those of the sewn solid");
  } else {
    warnings.push_back("a closed shell was taken as a solid");
  }
  if (shells.empty()) return {};
  TopoDS_Compound compound;
  BRep_Builder builder;
  builder.MakeCompound(compound);
  for (const TopoDS_Shell& shell : shells) {
    TopoDS_Solid solid = BRepBuilderAPI_MakeSolid(shell).Solid();
    BRepLib::OrientClosedSolid(solid);
    builder.Add(compound, solid);
  }
  return shells.size() == 1 ? solids_of(compound).front() : TopoDS_Shape(compound);
}

/// The part in the shape that was read: its solid, or the compound of its solids.
TopoDS_Shape part_of(const TopoDS_Shape& shape, std::vector<std::string>& warnings) {
  if (shape.IsNull()) bad_input("the file holds no shape", "export a solid");
  TopTools_IndexedMapOfShape all_faces;
  TopExp::MapShapes(shape, TopAbs_FACE, all_faces);
  if (all_faces.IsEmpty()) bad_input("the file holds no face", "export a solid, not a sketch or wire");
  std::vector<TopoDS_Shape> solids = solids_of(shape);
  TopoDS_Shape part;
  if (solids.empty()) {
    part = make_solid(shape, warnings);
    if (part.IsNull())
      bad_input("the part is not closed: no solid in the file, and its faces do not form one", "close the open shell or export a solid");
    return part;
  }
  part = solids.size() == 1 ? solids.front() : shape;
  TopTools_IndexedMapOfShape used;
  for (const TopoDS_Shape& s : solids) TopExp::MapShapes(s, TopAbs_FACE, used);
  if (used.Extent() < all_faces.Extent())
    warnings.push_back(std::to_string(all_faces.Extent() - used.Extent()) + " stray face(s) beside the solid are left out");
  return part;
}

TopoDS_Shape heal(const TopoDS_Shape& part, Context& context) {
  Handle(CancelIndicator) indicator = new CancelIndicator(context);
  ShapeFix_Shape fix(part);
  fix.Perform(indicator->Start());
  indicator->rethrow();
  context.check();
  return fix.Shape();
}

double size_of(const TopoDS_Shape& shape) {
  Bnd_Box box;
  BRepBndLib::Add(shape, box, Standard_False);
  return box.IsVoid() ? 0 : std::sqrt(box.SquareExtent());
}

/// Stronger than `heal`: edges and faces far below any element's size are removed and gaps of that size closed. Null when the outcome is
/// no solid any more, or not the same one.
TopoDS_Shape mend(const TopoDS_Shape& part, Context& context) {
  const double tolerance = 1e-7 * size_of(part);
  Handle(CancelIndicator) indicator = new CancelIndicator(context);
  Handle(ShapeFix_Wireframe) wires = new ShapeFix_Wireframe(part);
  wires->SetPrecision(tolerance);
  wires->SetMaxTolerance(10 * tolerance);
  wires->ModeDropSmallEdges() = Standard_True;
  wires->FixSmallEdges();
  wires->FixWireGaps();
  context.check();
  ShapeFix_FixSmallFace faces;
  faces.Init(wires->Shape());
  faces.SetPrecision(tolerance);
  faces.SetMaxTolerance(10 * tolerance);
  faces.Perform();
  context.check();
  BRepBuilderAPI_Sewing sewing(10 * tolerance);
  sewing.Add(faces.FixShape());
  sewing.Perform(indicator->Start());
  indicator->rethrow();
  context.check();
  std::vector<std::string> ignored;
  const TopoDS_Shape mended = heal(make_solid(sewing.SewedShape(), ignored), context);
  if (mended.IsNull() || solids_of(mended).size() != solids_of(part).size()) return {};
  GProp_GProps before, after;
  BRepGProp::VolumeProperties(part, before);
  BRepGProp::VolumeProperties(mended, after);
  if (!(std::abs(std::abs(after.Mass()) - std::abs(before.Mass())) < 1e-3 * std::abs(before.Mass()))) return {};
  return solids_of(mended).size() == 1 ? solids_of(mended).front() : mended;
}

std::unique_ptr<CadModel> tabulate(const TopoDS_Shape& part, Context& context, int threads) {
  CadTables tables(part);
  if (!(tables.diagonal > 0) || !std::isfinite(tables.diagonal)) bad_input("the part has no extent", "check its geometry");
  BaseMesh base = make_base_mesh(tables, context, threads);
  return std::make_unique<CadModel>(std::make_unique<CadModel::Impl>(std::move(tables), std::move(base)));
}

/// The model of a part; of the mended part when its surface does not close as it is.
std::unique_ptr<CadModel> tabulate_or_mend(const TopoDS_Shape& part, std::vector<std::string>& warnings, Context& context, int threads) {
  try {
    return tabulate(part, context, threads);
  } catch (const MeshingError& error) {
    if (error.kind != Failure::BadInput) throw;
    try {
      const TopoDS_Shape mended = guarded("read", "the part cannot be mended", [&] { return mend(part, context); });
      if (mended.IsNull()) throw error;
      std::unique_ptr<CadModel> model = tabulate(mended, context, threads);
      warnings.push_back("tiny edges and faces were removed: face numbers are those of the mended solid");
      return model;
    } catch (const MeshingError& second) {
      if (second.kind != Failure::BadInput) throw;
    }
    throw error;  // of the part as it is
  }
}

std::unique_ptr<CadModel> make_model(const ReadShape& read, Context& context, int threads) {
  return guarded("read", "the part cannot be read", [&] {
    std::vector<std::string> warnings = read.warnings;
    TopoDS_Shape part = part_of(read.shape, warnings);
    require_sound(part, context);
    context.progress("read", 0.5);
    if (!BRepCheck_Analyzer(part, Standard_True, threads > 1).IsValid()) {
      const TopoDS_Shape healed = heal(part, context);
      if (!healed.IsNull() && !solids_of(healed).empty()) {
        part = solids_of(healed).size() == 1 ? solids_of(healed).front() : healed;
        warnings.push_back("the solid had faults and was healed");
      }
    }
    context.progress("read", 0.6);
    std::unique_ptr<CadModel> model = tabulate_or_mend(part, warnings, context, threads);
    context.progress("read", 0.8);
    model->warnings = std::move(warnings);
    model->impl().trims = make_trim_regions(model->impl().cad, model->impl().base);
    analyse(*model, context, threads);
    model->solid_names.assign(model->solid_count, "");
    for (const auto& [solid, name] : read.names)
      for (int s = 0; s < model->solid_count; ++s)
        if (solid.IsSame(model->impl().cad.solids[s])) model->solid_names[s] = name;
    context.progress("read", 1);
    return model;
  });
}

}  // namespace

CadTables::CadTables(const TopoDS_Shape& part) : shape(part), solids(solids_of(part)) {
  TopExp::MapShapes(shape, TopAbs_FACE, face_map);
  TopExp::MapShapes(shape, TopAbs_EDGE, edge_map);
  TopExp::MapShapes(shape, TopAbs_VERTEX, vertex_map);
  for (int i = 1; i <= face_map.Extent(); ++i) faces.emplace_back(TopoDS::Face(face_map(i)));
  for (int i = 1; i <= edge_map.Extent(); ++i) edges.emplace_back(TopoDS::Edge(edge_map(i)));
  for (int i = 1; i <= vertex_map.Extent(); ++i) vertices.push_back(to_eigen(BRep_Tool::Pnt(TopoDS::Vertex(vertex_map(i)))));
  diagonal = size_of(shape);
}

std::unique_ptr<CadModel> read_cad(const std::string& path, Context& context, int threads) {
  silence_occt();
  context.progress("read", 0);
  check_file(path);
  const std::string ending = lower_extension(path);
  return guarded("read", "'" + path + "' cannot be read", [&] {
    if (ending == ".step" || ending == ".stp") return make_model(read_step(path, context), context, threads);
    if (ending == ".iges" || ending == ".igs") return make_model(read_iges(path, context), context, threads);
    if (ending == ".brep" || ending == ".brp") {
      std::ifstream in(path, std::ios::binary);
      return make_model({parse_brep(std::string(std::istreambuf_iterator<char>(in), {})), {}, {}}, context, threads);
    }
    bad_input("'" + ending + "' is no CAD file that can be read", "use .step, .iges or .brep");
  });
}

std::unique_ptr<CadModel> read_brep_string(const std::string& text, Context& context, int threads) {
  silence_occt();
  context.progress("read", 0);
  return guarded("read", "the B-rep text cannot be read", [&] { return make_model({parse_brep(text), {}, {}}, context, threads); });
}

}  // namespace hexfeature
