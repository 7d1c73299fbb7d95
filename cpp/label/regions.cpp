// HexFeatureWB - LGPL-2.1-or-later
#include "label/regions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "label/site_parts.h"
#include "label/strips.h"
#include "mesh/cut_mesh.h"
#include "shape/partition.h"

namespace hexfeature {
namespace {

constexpr double kDegree = EIGEN_PI / 180;

/// The direction 0..5 that the triangle's true normals are nearest to.
int nearest_direction(const SurfaceMesh& mesh, int t) {
  Vec3 squares = Vec3::Zero();
  for (int k = 0; k < 3; ++k) squares += mesh.corner_normals[3 * t + k].cwiseAbs2();
  int axis;
  squares.maxCoeff(&axis);
  return make_label(axis, mesh.mean_normal(t)[axis] < 0 ? -1 : 1);
}

/// One CAD face's triangles and what the rules ask about them.
struct FacePatch {
  std::vector<int> triangles;
  double area = 0;
  Vec3 mean = Vec3::Zero();  ///< mean normal, unit (zero when the normals cancel)
  double spread = EIGEN_PI;  ///< greatest angle between a normal and the mean
};

FacePatch measure(const SurfaceMesh& mesh, std::vector<int> triangles) {
  FacePatch patch;
  patch.triangles = std::move(triangles);
  for (int t : patch.triangles) {
    const double area = mesh.area(t);
    patch.area += area;
    patch.mean += area * mesh.mean_normal(t);
  }
  if (patch.mean.norm() < 1e-6 * patch.area) return patch;
  patch.mean.normalize();
  double least = 1;
  for (int t : patch.triangles)
    for (int k = 0; k < 3; ++k) least = std::min(least, patch.mean.dot(mesh.corner_normals[3 * t + k]));
  patch.spread = std::acos(std::clamp(least, -1.0, 1.0));
  return patch;
}

/// Is a cylinder or cone oblique, longer than h and more than about half round? Then `middle` is its mid-height on the axis.
bool needs_cross_cut(const SurfaceMesh& mesh, const FacePatch& patch, const StripFrame& frame, const RegionOptions& options,
                     double& middle) {
  if (frame.axis.cwiseAbs().maxCoeff() > std::cos(options.oblique_angle * kDegree)) return false;
  double low = std::numeric_limits<double>::max(), high = -low;
  constexpr int kBins = 12;
  std::array<char, kBins> seen{};
  for (int t : patch.triangles)
    for (int v : mesh.triangles[t]) {
      const Vec3 r = mesh.points[v] - frame.origin;
      low = std::min(low, r.dot(frame.axis));
      high = std::max(high, r.dot(frame.axis));
      const double turn = std::atan2(r.dot(frame.e2), r.dot(frame.e1)) / (2 * EIGEN_PI) + 0.5;
      seen[std::min(kBins - 1, static_cast<int>(turn * kBins))] = 1;
    }
  middle = 0.5 * (low + high);
  return high - low > options.size && std::count(seen.begin(), seen.end(), 1) > kBins / 2;
}

/// The cut functions of one face (none: it stays whole). Those of a free-form face end where a third axis is nearer.
std::vector<CutFunction> cut_functions(const SurfaceMesh& mesh, const FacePatch& patch, const CadFace& face, const Vec3& border,
                                       const RegionOptions& options) {
  std::vector<CutFunction> cuts;
  if (face.kind == SurfaceKind::Plane || patch.spread < options.flat_angle * kDegree) return cuts;
  if (is_revolved(face)) {
    const StripFrame frame(face, options.size, border);
    cuts.push_back({[frame](const Vec3& p, const Vec3&) { return frame.side(p); }, {}, 0});
    double middle = 0;
    if (face.kind == SurfaceKind::Torus)
      cuts.push_back({[frame](const Vec3&, const Vec3& n) { return n.dot(frame.axis) * n.dot(frame.axis) - 0.5; }, {}, 0});
    else if (needs_cross_cut(mesh, patch, frame, options, middle))
      cuts.push_back({[frame, middle](const Vec3& p, const Vec3&) { return (p - frame.origin).dot(frame.axis) - middle; }, {}, 0});
    return cuts;
  }
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    const double tie = options.tie;
    cuts.push_back({[i, j](const Vec3&, const Vec3& n) { return n[i] * n[i] - n[j] * n[j]; },
                    [i, j, k, tie](const Vec3&, const Vec3& n) { return std::min(n[i] * n[i], n[j] * n[j]) >= tie * n[k] * n[k]; }, 0});
  }
  return cuts;
}

}  // namespace

Regions cut_regions(const SurfaceMesh& input, const Geometry& geometry, const RegionOptions& options, Context& context) {
  Regions result;
  result.mesh = input;
  SurfaceMesh& mesh = result.mesh;
  const int faces = mesh.triangle_face.empty() ? 0 : *std::max_element(mesh.triangle_face.begin(), mesh.triangle_face.end());
  std::vector<std::vector<int>> face_triangles(faces + 1);
  for (int t = 0; t < mesh.triangle_count(); ++t) face_triangles[mesh.triangle_face[t]].push_back(t);

  // Cut face by face; a neighbour's triangles that a cut bisects join that neighbour's list.
  SurfaceCutter cutter(mesh, geometry.projector, options.snap);
  std::vector<int> piece(mesh.triangle_count(), 0);  // per triangle: which piece of its face, by the signs of the cut functions
  std::vector<double> face_area(faces + 1, 0);
  Strips strips = place_strips(geometry, options.size);
  strips.tip.resize(std::max<std::size_t>(strips.tip.size(), faces + 1), 0);
  std::vector<signed char> side;
  for (int f = 0; f <= faces; ++f) {
    if (face_triangles[f].empty()) continue;
    context.progress("label", 0.2 * f / (faces + 1));
    const FacePatch patch = measure(mesh, face_triangles[f]);
    face_area[f] = patch.area;
    if (f == 0 || !geometry.faces || f > static_cast<int>(geometry.faces->size())) continue;
    for (const CutFunction& cut : cut_functions(mesh, patch, geometry.face(f), strips.border[f], options)) {
      const int old_count = mesh.triangle_count();
      std::vector<int>& list = face_triangles[f];
      cutter.cut(list, cut, side);
      for (int t = old_count; t < mesh.triangle_count(); ++t) {
        piece.push_back(piece[cutter.parents()[t - cutter.first_new()]]);
        if (mesh.triangle_face[t] != f) face_triangles[mesh.triangle_face[t]].push_back(t);
      }
      for (std::size_t i = 0; i < list.size(); ++i)
        piece[list[i]] = cut.accept ? nearest_direction(mesh, list[i]) : 2 * piece[list[i]] + (side[i] > 0);
    }
  }

  std::vector<int> key(mesh.triangle_count());
  for (int t = 0; t < mesh.triangle_count(); ++t) key[t] = 8 * mesh.triangle_face[t] + piece[t];
  result.site = connected_components(mesh, key);
  const LeastSite least{options.least_share, options.least_area * options.size * options.size, options.strip_share,
                        options.least_width * options.size};
  merge_small_sites(mesh, face_area, geometry, strips.tip, least, result.site);
  const int sites = result.site.empty() ? 0 : 1 + *std::max_element(result.site.begin(), result.site.end());
  result.site_face.assign(sites, 0);
  for (int t = 0; t < mesh.triangle_count(); ++t) result.site_face[result.site[t]] = mesh.triangle_face[t];
  return result;
}

}  // namespace hexfeature
