// HexFeatureWB - LGPL-2.1-or-later
#include "label/strips.h"

#include <algorithm>
#include <cmath>

namespace hexfeature {
namespace {

constexpr double kPi = EIGEN_PI, kDegree = kPi / 180;
constexpr double kMostTurn = 30 * kDegree;  ///< beyond, the elements beside a hole get too oblique
constexpr double kSame = 1 * kDegree;       ///< directions that count as one
constexpr double kTwoIntervals = 1.2;       ///< a quarter of a circle of more than this many h gets two, for its sag

/// Two surfaces of revolution about one line.
bool are_coaxial(const CadFace& a, const CadFace& b, double size) {
  if (!is_revolved(a) || !is_revolved(b)) return false;
  constexpr double kParallel = 1e-4, kApart = 1e-3;
  const Vec3 axis = a.axis.normalized(), between = b.origin - a.origin;
  return axis.cross(b.axis.normalized()).norm() < kParallel && (between - axis.dot(between) * axis).norm() < kApart * size;
}

/// A line that parts a face from another one round the same axis.
struct Parting {
  Vec3 direction = Vec3::Zero();  ///< from the axis to the line; zero when it is not straight along the axis
  double radius = 0;              ///< the largest
  bool to_axis = false;
};

Parting parting_of(const CadEdge& edge, int id, const StripFrame& frame, const Projector& projector) {
  constexpr int kSamples = 5;
  Parting parting;
  for (int i = 0; i < kSamples; ++i) {
    const Vec3 p = projector.edge_point(id, edge.t0 + (edge.t1 - edge.t0) * i / (kSamples - 1)).point;
    const double radius = frame.radius(p);
    parting.to_axis = parting.to_axis || radius < frame.on_axis;
    if (radius < frame.on_axis) continue;
    const Vec3 direction = frame.radial(p);
    if (!parting.direction.isZero() && direction.dot(parting.direction) < std::cos(kSame)) return {};
    if (radius > parting.radius) parting.direction = direction, parting.radius = radius;
  }
  return parting;
}

/// The partings of one face.
struct PartedFace {
  std::vector<int> touching;      ///< faces round the same axis
  Vec3 direction = Vec3::Zero();  ///< to a parting line
  bool several = false;           ///< no turn brings all of them onto borders
  bool to_axis = false;           ///< a tip
  double turn = 0;                ///< that brings them onto borders
  double intervals = 0;           ///< that a strip may have at the widest place
};

/// The turn of the frame of `face` that brings a strip's border to a direction.
double turn_to(const CadFace& face, const Vec3& direction, double size) {
  const StripFrame frame(face, size);
  return frame.off_border(frame.origin + direction);
}

bool same_turn(double a, double b) { return std::abs(std::remainder(a - b, kPi / 2)) < kSame; }

/// Per CAD face (index = its number).
std::vector<PartedFace> parted_faces(const Geometry& geometry, double size) {
  std::vector<PartedFace> parted(geometry.faces->size() + 1);
  for (int e = 1; e <= static_cast<int>(geometry.edges->size()); ++e) {
    const CadEdge& edge = geometry.edge(e);
    const auto [f, g] = edge.faces;
    if (f == g || f <= 0 || g <= 0 || edge.degenerate || !are_coaxial(geometry.face(f), geometry.face(g), size)) continue;
    parted[f].touching.push_back(g);
    parted[g].touching.push_back(f);
    if (edge.sharp) continue;
    for (int id : {f, g}) {
      PartedFace& face = parted[id];
      const Parting parting = parting_of(edge, e, StripFrame(geometry.face(id), size), *geometry.projector);
      if (parting.direction.isZero()) continue;
      const double turn = turn_to(geometry.face(id), parting.direction, size), quarter = parting.radius * kPi / 2 / size;
      if (face.direction.isZero())
        face.direction = parting.direction, face.turn = turn;
      else if (!same_turn(turn, face.turn))
        face.several = true;
      face.to_axis = face.to_axis || parting.to_axis;
      face.intervals = std::max({face.intervals, std::round(quarter), quarter > kTwoIntervals ? 2.0 : 1.0});
    }
  }
  return parted;
}

}  // namespace

bool is_revolved(const CadFace& face) {
  return (face.kind == SurfaceKind::Cylinder || face.kind == SurfaceKind::Cone || face.kind == SurfaceKind::Torus) &&
         face.axis.norm() > 0.5;
}

StripFrame::StripFrame(const CadFace& face, double size, const Vec3& border)
    : origin(face.origin), axis(face.axis.normalized()), on_axis(1e-4 * size) {
  int k = 0;
  for (int i = 1; i < 3; ++i)
    if (std::abs(axis[i]) < std::abs(axis[k]) - 1e-9) k = i;
  e1 = (Vec3::Unit(k) - axis[k] * axis).normalized();
  e2 = axis.cross(e1);
  if (border.isZero()) return;
  const double turn = off_border(origin + border);
  e1 = std::cos(turn) * e1 + std::sin(turn) * e2;
  e2 = axis.cross(e1);
}

double StripFrame::side(const Vec3& p) const {
  const double x = (p - origin).dot(e1), y = (p - origin).dot(e2), rr = x * x + y * y;
  return rr > on_axis * on_axis ? (x * x - y * y) / rr : 0;
}

double StripFrame::off_border(const Vec3& p) const {
  return std::remainder(std::atan2((p - origin).dot(e2), (p - origin).dot(e1)) - kPi / 4, kPi / 2);
}

double StripFrame::radius(const Vec3& p) const { return std::hypot((p - origin).dot(e1), (p - origin).dot(e2)); }

Vec3 StripFrame::radial(const Vec3& p) const { return ((p - origin).dot(e1) * e1 + (p - origin).dot(e2) * e2).normalized(); }

Strips place_strips(const Geometry& geometry, double size) {
  const int faces = geometry.faces ? static_cast<int>(geometry.faces->size()) : 0;
  Strips strips{std::vector<Vec3>(faces + 1, Vec3::Zero()), std::vector<char>(faces + 1, 0)};
  if (!geometry.edges || !geometry.projector) return strips;
  const std::vector<PartedFace> parted = parted_faces(geometry, size);
  std::vector<char> seen(faces + 1, 0);
  for (int first = 1; first <= faces; ++first) {
    if (seen[first] || parted[first].direction.isZero() || parted[first].several) continue;
    const Vec3 direction = parted[first].direction;
    // All that touch it round the same axis, unless they are parted elsewhere.
    std::vector<int> group{first};
    seen[first] = 1;
    for (std::size_t i = 0; i < group.size(); ++i)
      for (int g : parted[group[i]].touching) {
        const PartedFace& face = parted[g];
        if (seen[g] || face.several || (!face.direction.isZero() && !same_turn(face.turn, turn_to(geometry.face(g), direction, size))))
          continue;
        seen[g] = 1;
        group.push_back(g);
      }
    bool turned = false, tip = false;
    for (int f : group) {
      if (parted[f].direction.isZero()) continue;
      turned = turned || std::abs(parted[f].turn) < std::min(kMostTurn, kPi / 4 / parted[f].intervals);
      tip = tip || (parted[f].to_axis && parted[f].intervals <= 2);
    }
    for (int f : group) {
      if (turned && !tip) strips.border[f] = direction;
      strips.tip[f] = tip;
    }
  }
  return strips;
}

}  // namespace hexfeature
