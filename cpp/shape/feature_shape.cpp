// HexFeatureWB - LGPL-2.1-or-later
#include "shape/feature_shape.h"

#include <algorithm>

namespace hexfeature {

FeatureShape make_feature_shape(const LabelledSurface& surface) {
  const SurfaceMesh& mesh = surface.mesh;
  FeatureShape shape;
  const std::vector<int> labels(surface.label.begin(), surface.label.end());
  shape.cells = make_partition(mesh, connected_components(mesh, labels));

  for (const auto& part : shape.cells.parts) {
    FeatureShape::Chart chart;
    chart.label = surface.label[part.triangles.front()];
    for (int t : part.triangles) {
      const double area = mesh.area(t);
      chart.area += area;
      chart.centroid += area * mesh.centroid(t);
      chart.normal += area * mesh.mean_normal(t);
      chart.cad_faces.push_back(mesh.triangle_face[t]);
    }
    chart.centroid /= chart.area;
    chart.normal /= chart.area;
    std::sort(chart.cad_faces.begin(), chart.cad_faces.end());
    chart.cad_faces.erase(std::unique(chart.cad_faces.begin(), chart.cad_faces.end()), chart.cad_faces.end());
    shape.charts.push_back(std::move(chart));
  }
  for (const auto& edge : shape.cells.edges) {
    FeatureShape::Arc arc;
    double dihedral = 0;
    for (int h : edge.halfedges) {
      const double length = (mesh.points[mesh.to(h)] - mesh.points[mesh.from(h)]).norm();
      arc.length += length;
      arc.centroid += 0.5 * length * (mesh.points[mesh.to(h)] + mesh.points[mesh.from(h)]);
      dihedral += length * mesh.dihedral(h);
    }
    if (arc.length > 0) {
      arc.dihedral = dihedral / arc.length;
      arc.centroid /= arc.length;
    }
    arc.displacement = mesh.points[edge.vertices.back()] - mesh.points[edge.vertices.front()];
    const int a = axis_of(shape.charts[edge.left].label), b = axis_of(shape.charts[edge.right].label);
    if (a != b) {
      arc.axis = third_axis(a, b);
      arc.sign = arc.displacement[arc.axis] < 0 ? -1 : 1;
    }
    shape.arcs.push_back(arc);
  }
  return shape;
}

}  // namespace hexfeature
