// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include "mesh/projector.h"

namespace hexfeature {

/// Another projector in a working frame x -> rotation * (x - centre): points go through the frame on their way in and out.
class PlacedProjector : public Projector {
 public:
  explicit PlacedProjector(const Projector& still) : still_(still) {}

  void place(const Mat3& rotation, const Vec3& centre) {
    rotation_ = rotation;
    centre_ = centre;
  }
  Vec3 to_world(const Vec3& p) const { return rotation_.transpose() * p + centre_; }
  Vec3 to_frame(const Vec3& p) const { return rotation_ * (p - centre_); }
  Vec3 turned(const Vec3& direction) const { return rotation_ * direction; }

  FacePoint project_to_face(int face, const Vec3& p, const Vec2* guess) const override {
    const FacePoint foot = still_.project_to_face(face, to_world(p), guess);
    return {to_frame(foot.point), turned(foot.normal), foot.uv};
  }
  CurvePoint project_to_edge(int edge, const Vec3& p, const double* guess) const override {
    return placed(still_.project_to_edge(edge, to_world(p), guess));
  }
  Vec3 vertex_point(int vertex) const override { return to_frame(still_.vertex_point(vertex)); }
  CurvePoint edge_point(int edge, double t) const override { return placed(still_.edge_point(edge, t)); }

 private:
  CurvePoint placed(const CurvePoint& p) const { return {to_frame(p.point), turned(p.tangent), p.t}; }

  const Projector& still_;
  Mat3 rotation_ = Mat3::Identity();
  Vec3 centre_ = Vec3::Zero();
};

}  // namespace hexfeature
