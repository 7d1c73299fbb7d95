// HexFeatureWB - LGPL-2.1-or-later
#include "brep/model_impl.h"
#include "mesh/frame_search.h"

namespace hexfeature {

std::vector<Mat3> find_frames(const CadModel& model, int count) {
  const CadModel::Impl& impl = model.impl();
  const BaseMesh& base = impl.base;
  // Normals with areas: one per plane, one per triangle elsewhere. Everything in the file's frame.
  std::vector<WeightedDirection> normals, directions;
  std::vector<char> sampled(model.faces.size(), 0);
  for (std::size_t i = 0; i < model.faces.size(); ++i) {
    const CadFace& f = model.faces[i];
    if (f.solid == 0) continue;
    const Vec3 axis = impl.rotation.transpose() * f.axis;
    if (f.kind == SurfaceKind::Plane) {
      normals.push_back({axis, f.area});
      directions.push_back({axis, f.area});
    } else {
      sampled[i] = 1;
      if (f.kind == SurfaceKind::Cylinder || f.kind == SurfaceKind::Cone || f.kind == SurfaceKind::Torus)
        directions.push_back({axis, 0.5 * f.area});
    }
  }
  for (int t = 0; t < base.triangle_count(); ++t) {
    if (!sampled[base.triangle_face[t] - 1]) continue;
    const auto& v = base.triangles[t];
    const Vec3 n = 0.5 * (base.points[v[1]] - base.points[v[0]]).cross(base.points[v[2]] - base.points[v[0]]);
    if (n.norm() > 0) normals.push_back({n.normalized(), n.norm()});
  }
  return best_frames(normals, directions, count);
}

}  // namespace hexfeature
