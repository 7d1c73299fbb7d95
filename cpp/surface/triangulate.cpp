// HexFeatureWB - LGPL-2.1-or-later
#include <cmath>

#include "brep/occt.h"
#include "surface/refine.h"
#include "surface/surface.h"

namespace hexfeature {
namespace {
constexpr double kMostTriangles = 2e7;
}

SurfaceMesh triangulate(const CadModel& model, const SurfaceOptions& options, Context& context) {
  if (!(options.size > 0) || !std::isfinite(options.size))
    throw MeshingError(Failure::Usage, "surface", "the element size must be positive");
  context.progress("surface", 0);
  // Before anything grows: a size far below the part's would fill the memory.
  double triangles = 0;
  for (const CadFace& f : model.faces) {
    const double edge = 0.7 * options.size * (f.kind == SurfaceKind::Plane ? options.plane_factor : options.edge_factor);
    if (f.solid > 0) triangles += f.area / (0.43 * edge * edge);
  }
  if (triangles > kMostTriangles)
    throw MeshingError(Failure::Usage, "surface",
                       "the element size is too small for this part: its surface alone would need more than 20 million triangles",
                       "choose a larger element size");
  return guarded("surface", "the surface cannot be triangulated", [&] {
    Refiner refiner(model, options.edge_factor * options.size, options.plane_factor * options.size, options.segments_per_turn);
    refiner.run(context);
    refiner.separate_double_edges(context);
    refiner.settle_poles();
    context.progress("surface", 0.8);

    const BaseMesh& from = refiner.mesh;
    SurfaceMesh mesh;
    mesh.points.reserve(from.points.size());
    for (const Vec3& p : from.points) mesh.points.push_back(model.to_frame(p));
    mesh.place = from.place;
    mesh.triangles = from.triangles;
    mesh.triangle_face = from.triangle_face;
    mesh.halfedge_edge = from.halfedge_edge;
    mesh.corner_normals.reserve(refiner.corner_normals.size());
    const Mat3& rotation = model.impl().rotation;
    for (int h = 0; h < 3 * mesh.triangle_count(); ++h) {
      const Vec3 n = rotation * refiner.corner_normals[h];
      const double length = n.norm();
      mesh.corner_normals.push_back(length > 0.5 ? Vec3(n / length) : Vec3(mesh.area_normal(h / 3).normalized()));
    }
    connect(mesh);
    context.progress("surface", 1);
    return mesh;
  });
}

}  // namespace hexfeature
