// HexFeatureWB - LGPL-2.1-or-later
#include "pipeline/part.h"

#include <algorithm>
#include <cctype>

#include "brep/cad_model.h"
#include "surface/placed_projector.h"
#include "surface/surface.h"

namespace hexfeature {
namespace {

class CadPart : public Part {
 public:
  explicit CadPart(std::unique_ptr<CadModel> model) : model_(std::move(model)), centre_(0.5 * (model_->bbox_min() + model_->bbox_max())) {}
  Geometry geometry() const override { return model_->geometry(); }
  int solid_count() const override { return model_->solid_count; }
  std::vector<std::string> solid_names() const override { return model_->solid_names; }
  double volume() const override { return model_->volume(); }
  double rough_volume() const override { return model_->rough_volume(); }
  double diagonal() const override { return model_->diagonal(); }
  std::vector<std::string> warnings() const override { return model_->warnings; }
  std::vector<Mat3> frames() const override { return find_frames(*model_, 2); }
  void place(const Mat3& rotation) override { model_->place(rotation, centre_); }
  void place_in_world() override { model_->place(Mat3::Identity(), Vec3::Zero()); }
  Vec3 to_world(const Vec3& p) const override { return model_->to_world(p); }
  Vec3 centre() const override { return centre_; }
  SurfaceMesh surface(double size, Context& context) const override {
    SurfaceOptions options;
    options.size = size;
    return triangulate(*model_, options, context);
  }

 private:
  std::unique_ptr<CadModel> model_;
  Vec3 centre_;
};

/// A triangle surface: the part as read, and its mesh and tables as placed.
class SurfacePart : public Part {
 public:
  explicit SurfacePart(TrianglePart part)
      : read_(std::move(part)), mesh_(read_.mesh), faces_(read_.faces), vertices_(read_.vertices), projector_(*read_.projector) {
    Vec3 lo = read_.mesh.points.front(), hi = lo;
    for (const Vec3& p : read_.mesh.points) {
      lo = lo.cwiseMin(p);
      hi = hi.cwiseMax(p);
    }
    centre_ = 0.5 * (lo + hi);
    diagonal_ = (hi - lo).norm();
  }
  Geometry geometry() const override { return {&faces_, &read_.edges, &vertices_, &projector_}; }
  int solid_count() const override { return 1; }
  double volume() const override { return enclosed_volume(mesh_); }
  double diagonal() const override { return diagonal_; }
  std::vector<std::string> warnings() const override { return {}; }
  std::vector<Mat3> frames() const override { return find_frames(read_, 2); }
  void place(const Mat3& rotation) override { place(rotation, centre_); }
  void place_in_world() override { place(Mat3::Identity(), Vec3::Zero()); }
  Vec3 to_world(const Vec3& p) const override { return projector_.to_world(p); }
  Vec3 centre() const override { return centre_; }
  SurfaceMesh surface(double, Context&) const override { return mesh_; }

 private:
  void place(const Mat3& rotation, const Vec3& centre) {
    projector_.place(rotation, centre);
    for (std::size_t i = 0; i < mesh_.points.size(); ++i) mesh_.points[i] = projector_.to_frame(read_.mesh.points[i]);
    for (std::size_t i = 0; i < mesh_.corner_normals.size(); ++i) mesh_.corner_normals[i] = projector_.turned(read_.mesh.corner_normals[i]);
    for (std::size_t i = 0; i < faces_.size(); ++i) {
      faces_[i].origin = projector_.to_frame(read_.faces[i].origin);
      faces_[i].axis = projector_.turned(read_.faces[i].axis);
    }
    for (std::size_t i = 0; i < vertices_.size(); ++i) vertices_[i].point = projector_.to_frame(read_.vertices[i].point);
  }

  TrianglePart read_;
  SurfaceMesh mesh_;
  std::vector<CadFace> faces_;
  std::vector<CadVertex> vertices_;
  PlacedProjector projector_;
  Vec3 centre_;
  double diagonal_ = 0;
};

}  // namespace

std::unique_ptr<Part> read_part(const std::string& path, const Options& options, Context& context) {
  const auto dot = path.find_last_of('.');
  std::string ending = dot == std::string::npos ? "" : path.substr(dot + 1);
  std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return std::tolower(c); });
  if (ending == "stl" || ending == "obj" || ending == "ply")
    return std::make_unique<SurfacePart>(read_triangles(path, options.crease_angle, context));
  return std::make_unique<CadPart>(read_cad(path, context, options.threads));
}

std::unique_ptr<Part> part_of_brep_string(const std::string& brep, const Options& options, Context& context) {
  return std::make_unique<CadPart>(read_brep_string(brep, context, options.threads));
}

SurfaceMesh surface_of_solid(const SurfaceMesh& surface, const Geometry& geometry, int solid) {
  SurfaceMesh result;
  std::vector<int> point(surface.points.size(), -1);
  for (int t = 0; t < surface.triangle_count(); ++t) {
    const int face = surface.triangle_face[t];
    if (face > 0 && geometry.face(face).solid != solid) continue;
    std::array<int, 3> triangle;
    for (int k = 0; k < 3; ++k) {
      int& p = point[surface.triangles[t][k]];
      if (p < 0) {
        p = result.point_count();
        result.points.push_back(surface.points[surface.triangles[t][k]]);
        result.place.push_back(surface.place[surface.triangles[t][k]]);
      }
      triangle[k] = p;
      result.corner_normals.push_back(surface.corner_normals[3 * t + k]);
      result.halfedge_edge.push_back(surface.halfedge_edge[3 * t + k]);
    }
    result.triangles.push_back(triangle);
    result.triangle_face.push_back(face);
  }
  if (result.triangles.empty())
    throw MeshingError(Failure::BadInput, "surface", "solid " + std::to_string(solid) + " has no faces", "check the part's solids");
  connect(result);
  return result;
}

}  // namespace hexfeature
