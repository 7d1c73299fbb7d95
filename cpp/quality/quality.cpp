// HexFeatureWB - LGPL-2.1-or-later
#include "quality/quality.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "base/error.h"
#include "quality/topology.h"

namespace hexfeature {
namespace {

constexpr const char* kStep = "certificate";

/// Distance of a boundary node from the CAD entity that it claims to lie on; 0 inside.
double distance_to_cad(const Projector& projector, const CadPlace& place, const Vec3& p) {
  switch (place.dim) {
    case 0:
      return (projector.vertex_point(place.entity) - p).norm();
    case 1:
      return (projector.project_to_edge(place.entity, p, &place.uv[0]).point - p).norm();
    case 2:
      return (projector.project_to_face(place.entity, p, &place.uv).point - p).norm();
    default:
      return 0;
  }
}

/// CAD faces of the quads that have the most of the given points; the nearest quad's when none has any.
std::vector<int> faces_at(const HexComplex& complex, const std::vector<int>& points) {
  std::vector<char> marked(complex.points.size(), 0);
  for (int v : points)
    if (v >= 0 && v < complex.point_count()) marked[v] = 1;
  const auto known = [&](std::size_t q) { return q < complex.quad_face.size() && complex.quad_face[q] > 0; };
  std::vector<int> faces;
  int most = 1;
  for (std::size_t q = 0; q < complex.quads.size(); ++q) {
    int count = 0;
    for (int v : complex.quads[q]) count += v >= 0 && v < complex.point_count() && marked[v];
    if (count < most || !known(q)) continue;
    if (count > most) faces.clear();
    most = count;
    faces.push_back(complex.quad_face[q]);
  }
  if (faces.empty() && !points.empty()) {
    const int first = points[0];
    double nearest = std::numeric_limits<double>::max();
    for (std::size_t q = 0; q < complex.quads.size(); ++q) {
      if (!known(q)) continue;
      for (int v : complex.quads[q]) {
        const double d = (complex.points[v] - complex.points[first]).squaredNorm();
        if (d < nearest) nearest = d, faces = {complex.quad_face[q]};
      }
    }
  }
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  return faces;
}

void raise(const HexComplex& complex, const MeshFault& fault, const char* hint) {
  if (fault.count == 0) return;
  throw MeshingError(Failure::NoMesh, kStep, std::to_string(fault.count) + " " + fault.reason, hint, faces_at(complex, fault.points));
}

void check_finite(const HexComplex& complex) {
  MeshFault fault{"points with coordinates that are not numbers", 0, {}};
  for (int v = 0; v < complex.point_count(); ++v)
    if (!complex.points[v].allFinite()) fault.add(&v, 1);
  raise(complex, fault, "the part's geometry is defective near the named faces; try repairing it");
}

void check_elements(const HexComplex& complex, Context& context) {
  MeshFault fault{"elements not proved positive (inverted or folded)", 0, {}};
  for (int h = 0; h < complex.hex_count(); ++h) {
    if (h % 8192 == 0) context.check();
    if (!proves_positive(complex.points, complex.hexes[h])) fault.add(complex.hexes[h].data(), 8);
  }
  raise(complex, fault, "try a smaller element size, or simplify the named faces");
}

void check_distances(const HexComplex& complex, const Projector& projector, double tolerance, Context& context) {
  MeshFault fault{"boundary points off their CAD face, edge or vertex", 0, {}};
  if (complex.place.size() != complex.points.size())
    throw MeshingError(Failure::NoMesh, kStep, "the mesh does not know which CAD entity its points lie on");
  std::vector<char> outside(complex.points.size(), 0);
  for (const auto& q : complex.quads)
    for (int v : q) outside[v] = 1;
  for (int v = 0; v < complex.point_count(); ++v) {
    if (v % 256 == 0) context.check();
    const CadPlace& place = complex.place[v];
    const bool wrong_kind = outside[v] ? place.dim < 0 || place.dim > 2 : place.dim != 3;
    if (wrong_kind || !(distance_to_cad(projector, place, complex.points[v]) <= tolerance)) fault.add(&v, 1);
  }
  raise(complex, fault, "");
}

}  // namespace

QualityReport measure_quality(const HexComplex& complex, const Projector& projector, Context& context) {
  QualityReport report;
  report.hexes = complex.hex_count();
  report.points = complex.point_count();
  report.quads = static_cast<int>(complex.quads.size());
  for (const auto& hex : complex.hexes)
    for (int v : hex)
      if (v < 0 || v >= report.points) throw MeshingError(Failure::NoMesh, "quality", "an element refers to a point that does not exist");
  if (report.hexes == 0) return report;

  std::vector<double> value(report.hexes);
  double sum = 0, min_edge = std::numeric_limits<double>::max(), max_edge = 0;
  int below_02 = 0, below_05 = 0;
  for (int h = 0; h < report.hexes; ++h) {
    if (h % 8192 == 0) context.check();
    const auto& hex = complex.hexes[h];
    value[h] = scaled_jacobian(complex.points, hex);
    if (std::isnan(value[h])) value[h] = -1;
    sum += value[h];
    below_02 += value[h] < 0.2;
    below_05 += value[h] < 0.5;
    ++report.histogram[std::clamp(static_cast<int>(std::floor((value[h] + 1) * 10)), 0, 19)];
    report.volume += hex_volume(complex.points, hex);
    for (const auto& e : kHexEdges) {
      const double length = (complex.points[hex[e[0]]] - complex.points[hex[e[1]]]).squaredNorm();
      min_edge = std::min(min_edge, length);
      max_edge = std::max(max_edge, length);
    }
  }
  report.min_sj = *std::min_element(value.begin(), value.end());
  report.mean_sj = sum / report.hexes;
  report.below_02 = static_cast<double>(below_02) / report.hexes;
  report.below_05 = static_cast<double>(below_05) / report.hexes;
  report.min_edge = std::sqrt(min_edge);
  report.max_edge = std::sqrt(max_edge);

  std::vector<int> order(report.hexes);
  for (int h = 0; h < report.hexes; ++h) order[h] = h;
  const int count = std::min(10, report.hexes);
  std::partial_sort(order.begin(), order.begin() + count, order.end(),
                    [&](int a, int b) { return value[a] != value[b] ? value[a] < value[b] : a < b; });
  report.worst_hexes.assign(order.begin(), order.begin() + count);

  context.check();
  report.skin = measure_skin(complex, context);

  if (complex.place.size() == complex.points.size())
    for (int v = 0; v < report.points; ++v) {
      if (v % 256 == 0) context.check();
      report.deviation = std::max(report.deviation, distance_to_cad(projector, complex.place[v], complex.points[v]));
    }
  return report;
}

Certificate certify(const HexComplex& complex, const Projector& projector, int face_count, double tolerance, Context& context) {
  if (complex.hexes.empty()) throw MeshingError(Failure::NoMesh, kStep, "the mesh has no elements");
  check_finite(complex);
  raise(complex, check_topology(complex, context), "this is a fault of the program: please report the part");
  Vec3 low = complex.points[0], high = low;
  for (const Vec3& p : complex.points) low = low.cwiseMin(p), high = high.cwiseMax(p);
  raise(complex, find_coincident_points(complex.points, 1e-9 * (high - low).maxCoeff(), context), "try a smaller element size");
  check_elements(complex, context);
  check_distances(complex, projector, tolerance, context);

  Certificate certificate;
  std::vector<char> covered(static_cast<std::size_t>(std::max(face_count, 0)) + 1, 0);
  for (int f : complex.quad_face)
    if (f >= 1 && f <= face_count) covered[f] = 1;
  for (int f = 1; f <= face_count; ++f)
    if (!covered[f]) certificate.faces_without_quads.push_back(f);
  return certificate;
}

}  // namespace hexfeature
