// HexFeatureWB - LGPL-2.1-or-later
#include <algorithm>
#include <cmath>

#include "fit/cad_edges.h"

namespace hexfeature {

bool is_insisted(const BoundaryFit& fit, int e) { return std::binary_search(fit.options.insisted.begin(), fit.options.insisted.end(), e); }

std::vector<InnerCurve> collect_inner_curves(const BoundaryFit& fit) {
  const SurfaceMesh& mesh = fit.mesh;
  const auto wanted_edge = [&](int h) {
    if (fit.border_of[h] >= 0) return 0;
    const int e = followed_edge(mesh, fit.geometry, h);
    if (std::binary_search(fit.options.released.begin(), fit.options.released.end(), e)) return 0;
    if (e <= 0) return 0;
    return fit.geometry.edge(e).sharp || fit.options.smooth_edges || is_insisted(fit, e) ? e : 0;
  };
  std::vector<char> on_chain(mesh.point_count(), 0);
  for (const Chain& chain : fit.chains)
    for (int v : chain.vertices) on_chain[v] = 1;
  // Outgoing wanted halfedges per vertex, flat.
  std::vector<int> begin(mesh.point_count() + 1, 0), out;
  for (int h = 0; h < 3 * mesh.triangle_count(); ++h)
    if (wanted_edge(h)) ++begin[mesh.from(h) + 1];
  for (int v = 0; v < mesh.point_count(); ++v) begin[v + 1] += begin[v];
  out.resize(begin.back());
  std::vector<int> fill(begin.begin(), begin.end() - 1);
  for (int h = 0; h < 3 * mesh.triangle_count(); ++h)
    if (wanted_edge(h)) out[fill[mesh.from(h)]++] = h;

  const auto is_end = [&](int v) {
    const CadPlace& p = mesh.place[v];
    return on_chain[v] || begin[v + 1] - begin[v] != 2 || (p.dim == 0 && fit.geometry.vertex(p.entity).hard);
  };
  std::vector<char> used(3 * mesh.triangle_count(), 0);
  std::vector<InnerCurve> curves;
  const auto trace = [&](int first) {
    InnerCurve curve;
    curve.vertices.push_back(mesh.from(first));
    int h = first;
    for (;;) {
      used[h] = used[mesh.opposite[h]] = 1;
      curve.halfedges.push_back(h);
      const int v = mesh.to(h);
      curve.vertices.push_back(v);
      curve.length += (mesh.points[v] - mesh.points[mesh.from(h)]).norm();
      curve.sharp = curve.sharp || fit.geometry.edge(wanted_edge(h)).sharp;
      if (is_end(v)) break;
      const int a = out[begin[v]], b = out[begin[v] + 1];
      h = a == mesh.opposite[h] ? b : a;
      if (h == first) break;
    }
    curves.push_back(std::move(curve));
  };
  for (int pass = 0; pass < 2; ++pass)  // open curves, then closed ones without an end
    for (int h = 0; h < 3 * mesh.triangle_count(); ++h)
      if (!used[h] && wanted_edge(h) && (pass == 1 || is_end(mesh.from(h)))) trace(h);
  std::stable_sort(curves.begin(), curves.end(),
                   [](const InnerCurve& a, const InnerCurve& b) { return a.sharp != b.sharp ? a.sharp : a.length < b.length; });
  return curves;
}

FlatCurve::FlatCurve(const BoundaryFit& fit, const InnerCurve& curve) : fit_(fit), curve_(curve) {
  for (int h : curve.halfedges) flat_.push_back(fit.corner_flat[h]);
  flat_.push_back(fit.corner_flat[SurfaceMesh::next(curve.halfedges.back())]);
  s_.push_back(0);
  for (std::size_t i = 0; i + 1 < curve.vertices.size(); ++i)
    s_.push_back(s_.back() + (fit.mesh.points[curve.vertices[i + 1]] - fit.mesh.points[curve.vertices[i]]).norm());
}

double FlatCurve::distance2(const Vec2& q, double& s) const {
  double best = 1e300;
  for (std::size_t i = 0; i + 1 < flat_.size(); ++i) {
    const Vec2 d = flat_[i + 1] - flat_[i];
    const double f = d.squaredNorm() > 0 ? std::clamp(d.dot(q - flat_[i]) / d.squaredNorm(), 0.0, 1.0) : 0.0;
    const double d2 = (flat_[i] + f * d - q).squaredNorm();
    if (d2 < best) {
      best = d2;
      s = s_[i] + f * (s_[i + 1] - s_[i]);
    }
  }
  return best;
}

double FlatCurve::distance2_on_part(const Vec3& p, double& s) const {
  double best = 1e300;
  for (std::size_t i = 0; i + 1 < s_.size(); ++i) {
    const Vec3& a = fit_.mesh.points[curve_.vertices[i]];
    const Vec3 d = fit_.mesh.points[curve_.vertices[i + 1]] - a;
    const double f = d.squaredNorm() > 0 ? std::clamp(d.dot(p - a) / d.squaredNorm(), 0.0, 1.0) : 0.0;
    const double d2 = (a + f * d - p).squaredNorm();
    if (d2 < best) {
      best = d2;
      s = s_[i] + f * (s_[i + 1] - s_[i]);
    }
  }
  return best;
}

Vec3 FlatCurve::at(double s) const {
  if (curve_.closed()) s -= std::floor(s / s_.back()) * s_.back();
  s = std::clamp(s, 0.0, s_.back());
  const auto it = std::upper_bound(s_.begin() + 1, s_.end() - 1, s);
  const std::size_t i = static_cast<std::size_t>(it - s_.begin()) - 1;
  const double d = s_[i + 1] - s_[i], f = d > 0 ? (s - s_[i]) / d : 0;
  return (1 - f) * fit_.mesh.points[curve_.vertices[i]] + f * fit_.mesh.points[curve_.vertices[i + 1]];
}

double FlatCurve::turn_at(double s) const {
  const double w = fit_.options.size;
  const Vec3 p = at(s), a = p - at(s - w), b = at(s + w) - p;
  if (a.norm() < 0.1 * w || b.norm() < 0.1 * w) return 0;
  const auto it = std::upper_bound(s_.begin() + 1, s_.end() - 1, s);
  const int h = curve_.halfedges[static_cast<std::size_t>(it - s_.begin()) - 1];
  const Vec3 normal = (fit_.mesh.mean_normal(h / 3) + fit_.mesh.mean_normal(fit_.mesh.opposite[h] / 3)).normalized();
  return std::atan2(a.cross(b).dot(normal), a.dot(b));
}

Vec3 FlatCurve::direction_from(bool start) const {
  const double w = 0.5 * std::min(fit_.options.size, s_.back());
  return start ? (at(w) - fit_.mesh.points[curve_.vertices.front()]).normalized()
               : (at(s_.back() - w) - fit_.mesh.points[curve_.vertices.back()]).normalized();
}

}  // namespace hexfeature
