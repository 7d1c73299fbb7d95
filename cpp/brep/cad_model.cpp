// HexFeatureWB - LGPL-2.1-or-later
#include "brep/cad_model.h"

#include <BRepGProp.hxx>
#include <GProp_GProps.hxx>
#include <algorithm>
#include <cmath>

#include "brep/model_impl.h"
#include "brep/occt.h"

namespace hexfeature {

CadModel::CadModel(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
CadModel::~CadModel() = default;

double CadModel::volume() const {
  if (impl_->volume < 0)
    impl_->volume = guarded("read", "the part's volume cannot be measured", [&] {
      GProp_GProps properties;
      BRepGProp::VolumeProperties(impl_->cad.shape, properties);
      return std::abs(properties.Mass());
    });
  return impl_->volume;
}

double CadModel::rough_volume() const {
  double six = 0;
  const Vec3& o = impl_->base.points.front();
  for (const auto& t : impl_->base.triangles)
    six += (impl_->base.points[t[0]] - o).dot((impl_->base.points[t[1]] - o).cross(impl_->base.points[t[2]] - o));
  return std::abs(six) / 6;
}

namespace {
template <class Pick>
Vec3 extreme(const CadModel::Impl& impl, Pick pick) {
  Vec3 result = impl.rotation * (impl.base.points.front() - impl.centre);
  for (const Vec3& p : impl.base.points) {
    const Vec3 q = impl.rotation * (p - impl.centre);
    for (int k = 0; k < 3; ++k) result[k] = pick(result[k], q[k]);
  }
  return result;
}
}  // namespace

Vec3 CadModel::bbox_min() const {
  return extreme(*impl_, [](double a, double b) { return std::min(a, b); });
}
Vec3 CadModel::bbox_max() const {
  return extreme(*impl_, [](double a, double b) { return std::max(a, b); });
}

Vec3 CadModel::to_world(const Vec3& p) const { return impl_->rotation.transpose() * p + impl_->centre; }
Vec3 CadModel::to_frame(const Vec3& p) const { return impl_->rotation * (p - impl_->centre); }

void CadModel::place(const Mat3& rotation, const Vec3& centre) {
  // The B-rep stays where the file has it: points go through the frame on their way in and out of each query.
  // Always from the faces as read: turning turned ones would gather rounding, and a part that is used again must give the same mesh.
  if (impl_->faces_as_read.empty()) impl_->faces_as_read = faces;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    faces[i].origin = rotation * (impl_->faces_as_read[i].origin - centre);
    faces[i].axis = rotation * impl_->faces_as_read[i].axis;
  }
  for (std::size_t i = 0; i < vertices.size(); ++i) vertices[i].point = rotation * (impl_->cad.vertices[i] - centre);
  impl_->rotation = rotation;
  impl_->centre = centre;
}

FacePoint CadModel::project_to_face(int face_id, const Vec3& p, const Vec2* guess) const {
  const FaceFoot foot = closest_on_face(impl_->cad, impl_->trims[face_id - 1], face_id, to_world(p), guess);
  return {to_frame(foot.point), impl_->rotation * foot.normal, foot.uv};
}

CurvePoint CadModel::project_to_edge(int edge_id, const Vec3& p, const double* guess) const {
  return edge_point(edge_id, impl_->cad.edge(edge_id).closest(to_world(p), guess));
}

Vec3 CadModel::vertex_point(int vertex_id) const { return vertex(vertex_id).point; }

CurvePoint CadModel::edge_point(int edge_id, double t) const {
  const EdgeGeometry& e = impl_->cad.edge(edge_id);
  if (e.kind == EdgeGeometry::Kind::None) {
    const int v = std::max(edge(edge_id).vertices[0], edge(edge_id).vertices[1]);
    return {v > 0 ? vertex(v).point : Vec3::Zero(), Vec3::Zero(), t};
  }
  return {to_frame(e.point(t)), impl_->rotation * e.tangent(t), t};
}

}  // namespace hexfeature
