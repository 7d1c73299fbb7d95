// HexFeatureWB - LGPL-2.1-or-later
#include "quadratic/quadratic.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>

#include "quadratic/bows.h"
#include "quadratic/mesh_edges.h"
#include "quadratic/unfold.h"

namespace hexfeature {
namespace {

constexpr int kHalvings = 4;                                               // then all the way to the chord
constexpr double kOnCad = 1e-11;                                           // of the edge's length
constexpr double kRounding = 16 * std::numeric_limits<double>::epsilon();  // of the largest coordinate: a projection's, far away

class BackOff {
 public:
  BackOff(const HexComplex& complex, const MeshEdges& edges, Bows& bows, Context& context)
      : complex_(complex), edges_(edges), bows_(bows), context_(context) {}

  bool straight(int h) const {
    return std::all_of(edges_.of_hex[h].begin(), edges_.of_hex[h].end(), [&](int e) { return bows_.bow[e].isZero(0); });
  }
  /// Elements that cannot be proved good.
  std::vector<int> bad() const {
    return bad_where([](int) { return true; });
  }
  /// The same, only those with an edge in `changed` (flags per edge).
  std::vector<int> bad_around(const std::vector<char>& changed) const {
    return bad_where(
        [&](int h) { return std::any_of(edges_.of_hex[h].begin(), edges_.of_hex[h].end(), [&](int e) { return changed[e] != 0; }); });
  }
  /// Halve the bows of the bad elements' edges, on the CAD too or only inside; at last all of them. Returns what is still bad.
  std::vector<int> straighten(std::vector<int> bad, bool on_cad) {
    for (int round = 0; !bad.empty(); ++round) {
      std::vector<int> halved;
      for (int h : bad)
        for (int e : edges_.of_hex[h])
          if ((on_cad || bows_.place[e].dim == 3) && !bows_.bow[e].isZero(0)) halved.push_back(e);
      std::sort(halved.begin(), halved.end());
      halved.erase(std::unique(halved.begin(), halved.end()), halved.end());
      if (halved.empty()) break;
      for (int e : halved) bows_.bow[e] *= round < kHalvings ? 0.5 : 0.0;
      bad = this->bad();
    }
    return bad;
  }

 private:
  template <class Where>
  std::vector<int> bad_where(const Where& where) const {
    std::vector<int> result;
    for (int h = 0; h < complex_.hex_count(); ++h) {
      if (h % 256 == 0) context_.check();
      if (where(h) && !straight(h) && !proves_positive(bent_element(complex_, edges_, bows_, h))) result.push_back(h);
    }
    return result;
  }

  const HexComplex& complex_;
  const MeshEdges& edges_;
  Bows& bows_;
  Context& context_;
};

/// Let one mid-side node of each bad element leave the CAD, before others one on a face, before others the one most bent.
/// Returns flags per edge: those that did. All elements round these are changed, not only the bad ones.
std::vector<char> release_from_cad(const MeshEdges& edges, const std::vector<int>& bad, Bows& bows) {
  std::vector<char> released(edges.count(), 0);
  for (int h : bad) {
    int chosen = -1;
    const auto key = [&](int e) { return std::make_pair(bows.place[e].dim, bows.bow[e].norm() / bows.length[e]); };
    for (int e : edges.of_hex[h])
      if (bows.place[e].dim < 3 && (chosen < 0 || key(e) > key(chosen))) chosen = e;
    if (chosen < 0) continue;
    bows.place[chosen] = CadPlace{};
    bows.bow[chosen] *= 0.5;
    released[chosen] = 1;
  }
  return released;
}

/// Unfold; then let nodes of what is bad still leave the CAD, and unfold again, until none is bad or none is left there.
void unfold_off_cad(const HexComplex& complex, const MeshEdges& edges, const Projector& projector, const BackOff& back_off,
                    std::vector<int> bad, Bows& bows, Context& context) {
  bad = unfold(complex, edges, projector, bad, bows, context);
  while (!bad.empty()) {
    const std::vector<char> released = release_from_cad(edges, bad, bows);
    if (std::none_of(released.begin(), released.end(), [](char r) { return r != 0; })) return;
    const std::vector<int> around = back_off.bad_around(released);
    std::vector<int> all;
    std::set_union(bad.begin(), bad.end(), around.begin(), around.end(), std::back_inserter(all));
    bad = unfold(complex, edges, projector, all, bows, context);
  }
}

/// Distance of the mid-side node of an edge from the curve or face `place`, whose parameters become those of the foot point;
/// they are where to look first if `near`. 0 inside.
double find_foot(const Bows& bows, int e, const Projector& projector, bool near, CadPlace& place) {
  const Vec3 p = bows.chord[e] + bows.bow[e];
  if (place.dim == 1) {
    const CurvePoint foot = projector.project_to_edge(place.entity, p, near ? &place.uv[0] : nullptr);
    place.uv = Vec2(foot.t, 0);
    return (foot.point - p).norm();
  }
  if (place.dim == 2) {
    const FacePoint foot = projector.project_to_face(place.entity, p, near ? &place.uv : nullptr);
    place.uv = foot.uv;
    return (foot.point - p).norm();
  }
  return 0;
}

/// A mid-side node is on the CAD within this distance: what is left of a projection.
double on_cad_tolerance(const Bows& bows, int e) {
  return std::max(kOnCad * bows.length[e], kRounding * (bows.chord[e] + bows.bow[e]).lpNorm<Eigen::Infinity>());
}

}  // namespace

QuadraticMesh make_quadratic(const HexComplex& complex, const Projector& projector, Context& context) {
  QuadraticMesh result;
  const MeshEdges edges = number_edges(complex, context);
  Bows bows = place_mid_sides(complex, edges, projector, context);

  BackOff back_off(complex, edges, bows, context);
  const std::vector<CadPlace> claimed = bows.place;
  const std::vector<int> bad = back_off.straighten(back_off.bad(), false);
  if (!bad.empty()) {
    unfold_off_cad(complex, edges, projector, back_off, bad, bows, context);
    back_off.straighten(back_off.bad(), true);  // the last proof is one of all elements
  }

  const int first_mid = complex.point_count();
  std::vector<char> off_cad(edges.count(), 0);
  for (int e = 0; e < edges.count(); ++e) {
    if (e % 1024 == 0) context.check();
    // One that slid has its new parameters. One that was let off, or went back to the chord, may be on a straight curve or a plane
    // still, but far from its old ones.
    const bool let_off = bows.place[e].dim == 3;
    if (let_off) bows.place[e] = claimed[e];
    double distance = find_foot(bows, e, projector, !let_off, bows.place[e]);
    const double tolerance = on_cad_tolerance(bows, e);
    if (!let_off && distance > tolerance) distance = find_foot(bows, e, projector, false, bows.place[e]);
    result.deviation = std::max(result.deviation, distance);
    if (distance > tolerance) {
      off_cad[e] = 1;
      result.straightened.push_back(first_mid + e);
      bows.place[e] = CadPlace{};
    }
  }
  for (std::size_t q = 0; q < complex.quads.size(); ++q)
    if (std::any_of(edges.of_quad[q].begin(), edges.of_quad[q].end(), [&](int e) { return off_cad[e] != 0; }))
      result.straightened_faces.push_back(complex.quad_face[q]);
  std::sort(result.straightened_faces.begin(), result.straightened_faces.end());
  result.straightened_faces.erase(std::unique(result.straightened_faces.begin(), result.straightened_faces.end()),
                                  result.straightened_faces.end());

  result.least_jacobian = std::numeric_limits<double>::max();
  result.hexes.resize(complex.hexes.size());
  for (int h = 0; h < complex.hex_count(); ++h) {
    if (h % 256 == 0) context.check();
    result.least_jacobian = std::min(result.least_jacobian, least_jacobian(bent_element(complex, edges, bows, h)));
    std::copy(complex.hexes[h].begin(), complex.hexes[h].end(), result.hexes[h].begin());
    for (int e = 0; e < 12; ++e) result.hexes[h][8 + e] = first_mid + edges.of_hex[h][e];
  }
  result.quads.resize(complex.quads.size());
  for (std::size_t q = 0; q < complex.quads.size(); ++q)
    for (int k = 0; k < 4; ++k) {
      result.quads[q][k] = complex.quads[q][k];
      result.quads[q][4 + k] = first_mid + edges.of_quad[q][k];
    }
  result.mid_points.resize(edges.count());
  for (int e = 0; e < edges.count(); ++e) result.mid_points[e] = bows.chord[e] + bows.bow[e];
  result.mid_place = std::move(bows.place);
  return result;
}

}  // namespace hexfeature
