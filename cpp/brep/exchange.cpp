// HexFeatureWB - LGPL-2.1-or-later
#include "brep/exchange.h"

#include <IGESControl_Reader.hxx>
#include <Interface_Check.hxx>
#include <Interface_EntityIterator.hxx>
#include <Interface_Graph.hxx>
#include <Interface_InterfaceModel.hxx>
#include <STEPControl_Reader.hxx>
#include <StepBasic_Product.hxx>
#include <StepBasic_ProductDefinition.hxx>
#include <StepBasic_ProductDefinitionFormation.hxx>
#include <StepGeom_Curve.hxx>
#include <StepGeom_Pcurve.hxx>
#include <StepRepr_CharacterizedDefinition.hxx>
#include <StepRepr_DefinitionalRepresentation.hxx>
#include <StepRepr_PropertyDefinition.hxx>
#include <StepRepr_RepresentationItem.hxx>
#include <StepRepr_RepresentationRelationship.hxx>
#include <StepRepr_RepresentedDefinition.hxx>
#include <StepShape_ShapeDefinitionRepresentation.hxx>
#include <StepShape_ShapeRepresentation.hxx>
#include <TColStd_SequenceOfAsciiString.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>
#include <algorithm>
#include <cstdint>
#include <fstream>
#include <mutex>
#include <vector>

#include "brep/occt.h"

namespace hexfeature {
namespace {

[[noreturn]] void bad_input(const std::string& reason, const std::string& hint) {
  throw MeshingError(Failure::BadInput, "read", reason, hint);
}

/// The last characters of the file, where STEP and IGES say that they are complete.
std::string tail(const std::string& path, std::streamoff count) {
  std::ifstream in(path, std::ios::binary | std::ios::ate);
  const std::streamoff size = in.tellg();
  in.seekg(std::max<std::streamoff>(0, size - count));
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

std::mutex& exchange_mutex() {  // OCCT's STEP and IGES readers have global state
  static std::mutex mutex;
  return mutex;
}

/// A curve on a surface is a representation whose first item must be that curve; the schema alone does not say so.
bool lacks_its_curve(const Handle(Standard_Transient) & entity) {
  const auto pcurve = Handle(StepGeom_Pcurve)::DownCast(entity);
  if (pcurve.IsNull()) return false;
  const auto reference = pcurve->ReferenceToCurve();
  return reference.IsNull() || reference->Items().IsNull() || reference->NbItems() < 1 ||
         !reference->ItemsValue(1)->IsKind(STANDARD_TYPE(StepGeom_Curve));
}

/// A STEP entity that could not be loaded has null where its parts should be, and OCCT follows the null. Refused when a shape needs it.
void check_entities(STEPControl_Reader& reader, const std::string& path) {
  const Handle(Interface_InterfaceModel) model = reader.Model();
  std::vector<Handle(Standard_Transient)> broken, shapes;
  for (int i = 1; i <= model->NbEntities(); ++i) {
    const Handle(Standard_Transient) entity = model->Value(i);
    if (entity.IsNull()) continue;
    if (entity->IsKind(STANDARD_TYPE(StepShape_ShapeRepresentation))) shapes.push_back(entity);
    if (model->Check(i, Standard_True)->HasFailed() || lacks_its_curve(entity)) broken.push_back(entity);
  }
  if (broken.empty()) return;
  Interface_Graph graph(model, Standard_False);
  for (const auto& shape : shapes) graph.GetFromEntity(shape, Standard_True);
  for (const auto& entity : broken)
    if (entity->IsKind(STANDARD_TYPE(StepRepr_RepresentationItem)) && graph.IsPresent(graph.EntityNumber(entity)))
      bad_input("'" + path + "' is damaged: entity " + model->StringLabel(entity)->ToCString() + " (" + entity->DynamicType()->Name() +
                    ") cannot be read",
                "export or download the part again");
}
void check_entities(IGESControl_Reader&, const std::string&) {}

/// The entities of one type that refer to `entity`.
template <class Type>
std::vector<Handle(Type)> referring(const Interface_Graph& graph, const Handle(Standard_Transient) & entity) {
  std::vector<Handle(Type)> found;
  for (Interface_EntityIterator i = graph.Sharings(entity); i.More(); i.Next())
    if (const auto one = Handle(Type)::DownCast(i.Value()); !one.IsNull()) found.push_back(one);
  return found;
}

std::string text_of(const Handle(TCollection_HAsciiString) & text) { return text.IsNull() ? "" : text->ToCString(); }

/// The name that a STEP file gives to a solid: its own, else that of the product whose shape it is. Empty when there is none.
std::string name_of(const Interface_Graph& graph, const Handle(Standard_Transient) & solid) {
  const auto item = Handle(StepRepr_RepresentationItem)::DownCast(solid);
  if (item.IsNull()) return {};
  if (std::string own = text_of(item->Name()); !own.empty() && own != "NONE") return own;
  std::vector<Handle(StepShape_ShapeRepresentation)> shapes = referring<StepShape_ShapeRepresentation>(graph, solid);
  // A shape may stand for another one, which then has the product.
  for (std::size_t i = 0; i < shapes.size() && i < 8; ++i)
    for (const auto& relation : referring<StepRepr_RepresentationRelationship>(graph, shapes[i]))
      for (const auto& other : {relation->Rep1(), relation->Rep2()}) {
        const auto shape = Handle(StepShape_ShapeRepresentation)::DownCast(other);
        if (!shape.IsNull() && std::find(shapes.begin(), shapes.end(), shape) == shapes.end()) shapes.push_back(shape);
      }
  for (const auto& shape : shapes)
    for (const auto& definition : referring<StepShape_ShapeDefinitionRepresentation>(graph, shape)) {
      const auto property = definition->Definition().PropertyDefinition();
      const auto product = property.IsNull() ? Handle(StepBasic_ProductDefinition)() : property->Definition().ProductDefinition();
      if (product.IsNull() || product->Formation().IsNull() || product->Formation()->OfProduct().IsNull()) continue;
      if (std::string name = text_of(product->Formation()->OfProduct()->Name()); !name.empty()) return name;
    }
  return {};
}

void add_names(STEPControl_Reader& reader, ReadShape& read) {
  const Handle(XSControl_TransferReader) transferred = reader.WS()->TransferReader();
  Interface_Graph graph(reader.Model(), Standard_False);
  TopTools_IndexedMapOfShape solids;
  TopExp::MapShapes(read.shape, TopAbs_SOLID, solids);
  if (solids.Extent() < 2) return;  // the part's name says nothing new
  for (int i = 1; i <= solids.Extent(); ++i) {
    const Handle(Standard_Transient) entity = transferred->EntityFromShapeResult(solids(i).Located(TopLoc_Location()), 1);
    if (entity.IsNull()) continue;
    if (const std::string name = name_of(graph, entity); !name.empty()) read.names.emplace_back(solids(i), name);
  }
}
void add_names(IGESControl_Reader&, ReadShape&) {}

void add_unit(STEPControl_Reader& reader, ReadShape& read) {
  TColStd_SequenceOfAsciiString lengths, angles, solid_angles;
  reader.FileUnits(lengths, angles, solid_angles);
  if (lengths.IsEmpty()) return;
  TCollection_AsciiString unit = lengths.First();
  unit.LowerCase();
  if (!unit.IsEqual("millimetre") && !unit.IsEqual("mm") && !unit.IsEqual("millimeter"))
    read.warnings.push_back("the file's unit is " + std::string(unit.ToCString()) + "; lengths, the element size too, are in millimetres");
}
void add_unit(IGESControl_Reader&, ReadShape&) {}

template <class Reader>
ReadShape transfer(Reader& reader, const std::string& path, const std::string& kind, Context& context) {
  const std::lock_guard<std::mutex> lock(exchange_mutex());
  Handle(CancelIndicator) indicator = new CancelIndicator(context);
  if (reader.ReadFile(path.c_str()) != IFSelect_RetDone)
    bad_input("'" + path + "' is not a readable " + kind + " file", "export the part again");
  context.check();
  const int roots = reader.NbRootsForTransfer();
  check_entities(reader, path);
  Message_ProgressScope scope(indicator->Start(), "transfer", std::max(1, roots));
  for (int i = 1; i <= roots; ++i) {
    reader.TransferOneRoot(i, scope.Next());
    indicator->rethrow();
    context.check();
  }
  ReadShape read;
  read.shape = reader.OneShape();
  if (read.shape.IsNull()) return read;
  add_names(reader, read);
  add_unit(reader, read);
  return read;
}

/// OCCT may crash on a file that refers to entities which it does not have (one that lost its middle or end).
void check_references(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  const std::string text(std::istreambuf_iterator<char>(in), {});
  std::vector<std::uint64_t> defined, used;
  bool quoted = false;
  char before = ';';  // the last character that is no blank
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '\'') quoted = !quoted;
    if (!quoted && c == '/' && i + 1 < text.size() && text[i + 1] == '*') {  // a comment, which counts as a blank
      i = text.find("*/", i + 2);
      if (i == std::string::npos) break;
      ++i;
      continue;
    }
    if (!quoted && c == '#' && i + 1 < text.size() && text[i + 1] >= '0' && text[i + 1] <= '9') {
      std::uint64_t id = 0;
      while (i + 1 < text.size() && text[i + 1] >= '0' && text[i + 1] <= '9') id = id * 10 + static_cast<std::uint64_t>(text[++i] - '0');
      (before == ';' ? defined : used).push_back(id);
      before = '0';
    } else if (static_cast<unsigned char>(c) > ' ') {
      before = c;
    }
  }
  std::sort(defined.begin(), defined.end());
  for (const std::uint64_t id : used)
    if (!std::binary_search(defined.begin(), defined.end(), id))
      bad_input("'" + path + "' is incomplete: it refers to #" + std::to_string(id) + ", which it does not have",
                "export or download the part again");
}

}  // namespace

ReadShape read_step(const std::string& path, Context& context) {
  std::ifstream in(path, std::ios::binary);
  std::string head(512, '\0');
  in.read(head.data(), static_cast<std::streamsize>(head.size()));
  if (head.find("ISO-10303-21") == std::string::npos)
    bad_input("'" + path + "' is not a STEP file", "its first line must be ISO-10303-21;");
  if (tail(path, 4096).find("END-ISO-10303-21") == std::string::npos)
    bad_input("'" + path + "' is truncated", "export or download the part again");
  check_references(path);
  STEPControl_Reader reader;
  return transfer(reader, path, "STEP", context);
}

ReadShape read_iges(const std::string& path, Context& context) {
  IGESControl_Reader reader;
  return transfer(reader, path, "IGES", context);
}

}  // namespace hexfeature
