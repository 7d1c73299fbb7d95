// HexFeatureWB - LGPL-2.1-or-later
#include <pybind11/stl.h>

#include <cmath>

#include "bindings/convert.h"

namespace py = pybind11;

namespace hexfeature {

py::dict report_of(const Result& r) {
  py::dict report;
  report["method"] = r.method;
  report["certified"] = r.certified;
  if (!r.stopped_after.empty()) report["stopped_after"] = r.stopped_after;

  py::list attempts;
  for (const Attempt& a : r.attempts) {
    py::dict d;
    d["method"] = a.method;
    d["solid"] = a.solid;
    d["frame"] = a.frame + 1;
    d["seconds"] = a.seconds;
    d["made_the_mesh"] = a.reason.empty();
    if (!a.reason.empty()) {
      d["step"] = a.step;
      d["reason"] = text_of(a.reason);
      d["hint"] = text_of(a.hint);
      d["cad_faces"] = a.cad_faces;
    }
    attempts.append(d);
  }
  report["attempts"] = attempts;

  py::dict times;
  double total = 0;
  for (const StepTime& t : r.times) {
    times[py::str(t.step)] = t.seconds;
    total += t.seconds;
  }
  report["step_seconds"] = times;
  report["seconds"] = total;
  report["warnings"] = text_list(r.warnings);

  py::dict part;
  part["solids"] = r.solids;
  part["solid_names"] = text_list(r.solid_names);
  part["cad_faces"] = r.cad_faces;
  part["cad_edges"] = r.cad_edges;
  part["cad_vertices"] = r.cad_vertices;
  part["volume"] = r.cad_volume;
  report["part"] = part;

  const QualityReport& q = r.quality;
  py::dict quality;
  quality["hexes"] = q.hexes;
  quality["points"] = q.points;
  quality["quads"] = q.quads;
  quality["min_scaled_jacobian"] = q.min_sj;
  quality["mean_scaled_jacobian"] = q.mean_sj;
  quality["below_0.2"] = q.below_02;
  quality["below_0.5"] = q.below_05;
  quality["histogram"] = q.histogram;
  quality["worst_hexes"] = q.worst_hexes;
  quality["volume"] = q.volume;
  quality["volume_error"] = r.cad_volume > 0 ? std::abs(q.volume - r.cad_volume) / r.cad_volume : 0.0;
  quality["min_edge"] = q.min_edge;
  quality["max_edge"] = q.max_edge;
  py::dict skin;
  skin["mean_lean_degrees"] = q.skin.mean_lean;
  skin["max_lean_degrees"] = q.skin.max_lean;
  skin["min_thickness"] = q.skin.min_thickness;
  skin["mean_thickness"] = q.skin.mean_thickness;
  skin["max_warp_degrees"] = q.skin.max_warp;
  skin["warped_quads"] = q.skin.warped;
  quality["skin"] = skin;
  report["quality"] = quality;

  py::dict cad;
  cad["largest_node_deviation"] = q.deviation;
  cad["faces_without_quads"] = r.faces_without_quads;
  cad["sharp_edges_not_followed"] = r.sharp_edges_not_followed;
  cad["straightened_mid_nodes"] = static_cast<int>(r.straightened.size());
  report["faithfulness"] = cad;

  if (!r.hexes20.empty()) {
    py::dict second;
    second["least_jacobian"] = r.least_jacobian20;
    second["largest_mid_side_deviation"] = r.mid_side_deviation;
    second["straightened_nodes"] = r.straightened;
    second["straightened_faces"] = r.straightened_faces;
    report["second_order"] = second;
  }

  py::dict limits;
  constexpr double kDegrees = 180 / 3.14159265358979323846;
  limits["bound"] = r.limits.bound;
  py::list sharp_edges, tips;
  for (const EdgeLimit& e : r.limits.edges) {
    py::dict d;
    d["cad_edge"] = e.cad_edge;
    d["angle_degrees"] = e.angle * kDegrees;
    d["bound"] = e.bound;
    d["bound_for_elements"] = e.best_count;
    d["min_scaled_jacobian"] = e.min_sj;
    d["most_elements"] = e.most_crowded;
    sharp_edges.append(d);
  }
  for (const TipLimit& t : r.limits.tips) {
    py::dict d;
    d["cad_vertex"] = t.cad_vertex;
    d["cad_face"] = t.cad_face;
    d["angle_degrees"] = t.angle * kDegrees;
    d["bound"] = t.bound;
    tips.append(d);
  }
  limits["sharp_edges"] = sharp_edges;
  limits["face_tips"] = tips;
  report["limits"] = limits;

  py::dict labels;
  labels["charts"] = r.labels.shape.chart_count();
  labels["arcs"] = r.labels.shape.arc_count();
  labels["corners"] = r.labels.shape.corner_count();
  labels["energy"] = r.labels.energy;
  labels["defects"] = r.labels.defects;
  labels["expansions"] = r.labels.expansions;
  py::list violations;
  for (const Violation& v : r.labels.validity.violations) {
    py::dict d;
    d["condition"] = v.condition;
    d["reason"] = v.reason;
    d["charts"] = v.charts;
    violations.append(d);
  }
  labels["violations"] = violations;
  report["labels"] = labels;

  py::dict sheets;
  sheets["inserted"] = r.sheets.inserted;
  sheets["refused"] = r.sheets.refused;
  sheets["taken_back"] = r.sheets.taken_back;
  report["sheets"] = sheets;

  py::dict options;
  for (const OptionSpec& spec : option_list())
    options[py::str(spec.name)] = std::visit([](const auto& v) -> py::object { return py::cast(v); }, get_option(r.options, spec));
  report["options"] = options;
  return report;
}

}  // namespace hexfeature
