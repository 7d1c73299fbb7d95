// HexFeatureWB - LGPL-2.1-or-later
#include <pybind11/stl.h>

#include "base/error.h"
#include "bindings/convert.h"

namespace py = pybind11;

namespace hexfeature {
namespace {

using Pointer = std::shared_ptr<Result>;

/// A surface mesh's arrays, points in the part's own coordinates.
void add_surface(py::dict& d, const SurfaceMesh& mesh, const Pointer& r) {
  py::array_t<double> points({static_cast<py::ssize_t>(mesh.points.size()), static_cast<py::ssize_t>(3)});
  auto p = points.mutable_unchecked<2>();
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    const Vec3 x = r->rotation.transpose() * mesh.points[i] + r->centre;
    for (int k = 0; k < 3; ++k) p(i, k) = x[k];
  }
  d["points"] = points;
  d["triangles"] = view(mesh.triangles, r);
  d["cad_face"] = view(mesh.triangle_face, r);
  d["cad_edge"] = view(mesh.halfedge_edge, r);
  d["point_dim"] = field(mesh.place, &CadPlace::dim, r);
  d["point_entity"] = field(mesh.place, &CadPlace::entity, r);
}

py::dict labels(const Pointer& r) {
  py::dict d;
  add_surface(d, r->labels.surface.mesh, r);
  d["label"] = view(r->labels.surface.label, r);
  d["chart"] = view(r->labels.shape.cells.triangle_part, r);
  if (!r->labels.sites.empty()) d["site"] = view(r->labels.sites, r);
  if (!r->adaptation.empty()) d["adaptation"] = view(r->adaptation, r);
  std::vector<int> violated(r->labels.shape.charts.size(), 0);
  for (const Violation& v : r->labels.validity.violations)
    for (int c : v.charts) violated[c] = v.condition;
  py::array_t<int> violation(static_cast<py::ssize_t>(r->labels.surface.label.size()));
  auto out = violation.mutable_unchecked<1>();
  for (std::size_t t = 0; t < r->labels.surface.label.size(); ++t) out(t) = violated[r->labels.shape.cells.triangle_part[t]];
  d["violation"] = violation;
  return d;
}

/// The feature shape as a B-rep: charts with loops of darts, arcs as polylines (point numbers of the labelled surface), corners.
py::dict shape(const Pointer& r) {
  py::dict d;
  const FeatureShape& s = r->labels.shape;
  add_surface(d, r->labels.surface.mesh, r);
  py::list arcs, axis, sign, length, dihedral, left, right, start, end;
  for (int a = 0; a < s.arc_count(); ++a) {
    const Partition::Edge& e = s.cells.edges[a];
    arcs.append(e.vertices);
    axis.append(s.arcs[a].axis);
    sign.append(s.arcs[a].sign);
    length.append(s.arcs[a].length);
    dihedral.append(s.arcs[a].dihedral);
    left.append(e.left);
    right.append(e.right);
    start.append(e.start);
    end.append(e.end);
  }
  d["arcs"] = arcs;
  d["arc_axis"] = axis;
  d["arc_sign"] = sign;
  d["arc_length"] = length;
  d["arc_dihedral"] = dihedral;
  d["arc_left"] = left;
  d["arc_right"] = right;
  d["arc_start"] = start;
  d["arc_end"] = end;
  py::list corners, corner_darts, chart_label, chart_area, chart_loops, chart_faces;
  for (const auto& n : s.cells.nodes) {
    corners.append(n.vertex);
    corner_darts.append(n.darts);
  }
  for (int c = 0; c < s.chart_count(); ++c) {
    chart_label.append(static_cast<int>(s.charts[c].label));
    chart_area.append(s.charts[c].area);
    chart_loops.append(s.cells.parts[c].loops);
    chart_faces.append(s.charts[c].cad_faces);
  }
  d["corners"] = corners;
  d["corner_darts"] = corner_darts;
  d["chart_label"] = chart_label;
  d["chart_area"] = chart_area;
  d["chart_loops"] = chart_loops;
  d["chart_cad_faces"] = chart_faces;
  return d;
}

}  // namespace

py::dict stage_of(const Pointer& r, const std::string& name) {
  py::dict d;
  if (name == "surface") {
    add_surface(d, r->surface, r);
    d["corner_normals"] = view(r->surface.corner_normals, r);
  } else if (name == "labels") {
    d = labels(r);
  } else if (name == "shape") {
    d = shape(r);
  } else if (name == "polycube") {
    d = shape(r);
    d["chart_coordinate"] = view(r->polycube.coordinate, r);
    d["corner_coordinates"] = view(r->polycube.corners, r);
  } else if (name == "lattice" || name == "fit" || name == "sheets" || name == "smooth") {
    d["points"] = view(r->mesh.points, r);
    d["hexes"] = view(r->mesh.hexes, r);
    d["hex_block"] = view(r->mesh.hex_block, r);
    d["quads"] = view(r->mesh.quads, r);
    d["quad_chart"] = view(r->mesh.quad_chart, r);
    d["quad_face"] = view(r->mesh.quad_face, r);
    d["feature_edges"] = view(r->mesh.feature_edges, r);
  } else {
    throw MeshingError(Failure::Usage, "stage", "there is no intermediate result '" + name + "'",
                       "one of surface, labels, shape, polycube, lattice, fit, sheets, smooth");
  }
  d["rotation"] = std::vector<double>(r->rotation.data(), r->rotation.data() + 9);
  d["centre"] = std::vector<double>(r->centre.data(), r->centre.data() + 3);
  return d;
}

}  // namespace hexfeature
