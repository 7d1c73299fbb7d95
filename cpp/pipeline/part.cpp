// HexFeatureWB - LGPL-2.1-or-later
#include "pipeline/part.h"

#include <algorithm>
#include <cctype>

#include "brep/cad_model.h"
#include "surface/surface.h"

namespace hexfeature {
namespace {

class CadPart : public Part {
 public:
  explicit CadPart(std::unique_ptr<CadModel> model) : model_(std::move(model)), centre_(0.5 * (model_->bbox_min() + model_->bbox_max())) {}
  Geometry geometry() const override { return model_->geometry(); }
  int solid_count() const override { return model_->solid_count; }
  double volume() const override { return model_->volume(); }
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

/// A triangle surface keeps the coordinates it came with: its readers expect a part drawn along the axes.
class SurfacePart : public Part {
 public:
  explicit SurfacePart(TrianglePart part) : part_(std::move(part)) {
    lo_ = hi_ = part_.mesh.points.front();
    for (const Vec3& p : part_.mesh.points) {
      lo_ = lo_.cwiseMin(p);
      hi_ = hi_.cwiseMax(p);
    }
  }
  Geometry geometry() const override { return part_.geometry(); }
  int solid_count() const override { return 1; }
  double volume() const override { return enclosed_volume(part_.mesh); }
  double diagonal() const override { return (hi_ - lo_).norm(); }
  std::vector<std::string> warnings() const override { return {}; }
  std::vector<Mat3> frames() const override { return {Mat3::Identity()}; }
  void place(const Mat3&) override {}
  void place_in_world() override {}
  Vec3 to_world(const Vec3& p) const override { return p; }
  Vec3 centre() const override { return Vec3::Zero(); }
  SurfaceMesh surface(double, Context&) const override { return part_.mesh; }

 private:
  TrianglePart part_;
  Vec3 lo_, hi_;
};

}  // namespace

std::unique_ptr<Part> read_part(const std::string& path, const Options& options, Context& context) {
  const auto dot = path.find_last_of('.');
  std::string ending = dot == std::string::npos ? "" : path.substr(dot + 1);
  std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return std::tolower(c); });
  if (ending == "stl" || ending == "obj" || ending == "ply")
    return std::make_unique<SurfacePart>(read_triangles(path, options.crease_angle, context));
  return std::make_unique<CadPart>(read_cad(path, context));
}

std::unique_ptr<Part> part_of_brep_string(const std::string& brep, Context& context) {
  return std::make_unique<CadPart>(read_brep_string(brep, context));
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
