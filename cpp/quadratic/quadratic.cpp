// HexFeatureWB - LGPL-2.1-or-later
#include "quadratic/quadratic.h"

#include <algorithm>
#include <cmath>

namespace hexfeature {
namespace {

/// Reference coordinates in [-1, 1]^3 of the 20 nodes.
constexpr std::array<std::array<int, 3>, 20> kNodes{
    {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1}, {-1, -1, 1}, {1, -1, 1}, {1, 1, 1},   {-1, 1, 1}, {0, -1, -1}, {1, 0, -1},
     {0, 1, -1},   {-1, 0, -1}, {0, -1, 1}, {1, 0, 1},   {0, 1, 1},   {-1, 0, 1}, {-1, -1, 0}, {1, -1, 0}, {1, 1, 0},   {-1, 1, 0}}};

using Gradients = std::array<Vec3, 20>;

/// Gradients of the serendipity shape functions at a reference point.
Gradients shape_gradients(const Vec3& x) {
  Gradients g;
  for (int n = 0; n < 20; ++n) {
    const Vec3 c(kNodes[n][0], kNodes[n][1], kNodes[n][2]);
    // Factors (1 + c x), or (1 - x^2) along a mid-side node's own direction.
    Vec3 factor, slope;
    int zero = -1;
    for (int a = 0; a < 3; ++a)
      if (c[a] == 0) {
        zero = a;
        factor[a] = 1 - x[a] * x[a];
        slope[a] = -2 * x[a];
      } else {
        factor[a] = 1 + c[a] * x[a];
        slope[a] = c[a];
      }
    for (int a = 0; a < 3; ++a) {
      const int b = (a + 1) % 3, d = (a + 2) % 3;
      if (zero >= 0)
        g[n][a] = 0.25 * slope[a] * factor[b] * factor[d];
      else  // corner: 1/8 product of factors times (c.x - 2)
        g[n][a] = 0.125 * factor[b] * factor[d] * (slope[a] * (c.dot(x) - 2) + factor[a] * c[a]);
    }
  }
  return g;
}

/// Shape gradients where the determinant must be positive: the integration points of C3D20 and C3D20R, and the nodes.
std::vector<Gradients> check_points() {
  std::vector<Gradients> points;
  const auto grid = [&](std::initializer_list<double> values) {
    for (double r : values)
      for (double s : values)
        for (double t : values) points.push_back(shape_gradients(Vec3(r, s, t)));
  };
  grid({-std::sqrt(0.6), 0.0, std::sqrt(0.6)});
  grid({-std::sqrt(1.0 / 3), std::sqrt(1.0 / 3)});
  for (const auto& n : kNodes) points.push_back(shape_gradients(Vec3(n[0], n[1], n[2])));
  return points;
}

/// Number every edge of the complex; edge ids of each hexahedron in kHexEdges order.
struct Edges {
  std::vector<std::array<int, 2>> nodes;  // smaller first, sorted
  std::vector<std::array<int, 12>> of_hex;
  int find(int a, int b) const {
    const std::array<int, 2> key{std::min(a, b), std::max(a, b)};
    return static_cast<int>(std::lower_bound(nodes.begin(), nodes.end(), key) - nodes.begin());
  }
};

Edges number_edges(const HexComplex& complex) {
  Edges edges;
  edges.nodes.reserve(12 * complex.hexes.size());
  for (const auto& h : complex.hexes)
    for (const auto& e : kHexEdges) edges.nodes.push_back({std::min(h[e[0]], h[e[1]]), std::max(h[e[0]], h[e[1]])});
  std::sort(edges.nodes.begin(), edges.nodes.end());
  edges.nodes.erase(std::unique(edges.nodes.begin(), edges.nodes.end()), edges.nodes.end());
  edges.of_hex.resize(complex.hexes.size());
  for (std::size_t h = 0; h < complex.hexes.size(); ++h)
    for (int e = 0; e < 12; ++e) edges.of_hex[h][e] = edges.find(complex.hexes[h][kHexEdges[e][0]], complex.hexes[h][kHexEdges[e][1]]);
  return edges;
}

/// The two edges of a hexahedron that run beside edge e in its faces (kHexEdges order: two rings of four, then the uprights).
std::array<int, 2> beside(int e) {
  if (e < 8) return {e / 4 * 4 + (e + 2) % 4, (e + 4) % 8};
  return {8 + (e + 1) % 4, 8 + (e + 3) % 4};
}

/// Edges bend along with their neighbours: each soft edge's bow becomes the mean of those of the edges beside it.
void spread_bows(const Edges& edges, const std::vector<char>& soft, std::vector<Vec3>& bow) {
  constexpr int kSweeps = 16;
  std::vector<Vec3> sum(bow.size());
  std::vector<int> count(bow.size());
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    std::fill(sum.begin(), sum.end(), Vec3::Zero());
    std::fill(count.begin(), count.end(), 0);
    for (const auto& of_hex : edges.of_hex)
      for (int e = 0; e < 12; ++e) {
        if (!soft[of_hex[e]]) continue;
        for (int other : beside(e)) sum[of_hex[e]] += bow[of_hex[other]];
        count[of_hex[e]] += 2;
      }
    for (std::size_t e = 0; e < bow.size(); ++e)
      if (soft[e]) bow[e] = sum[e] / count[e];
  }
}

}  // namespace

QuadraticMesh make_quadratic(const HexComplex& complex, const Projector& projector, Context& context) {
  QuadraticMesh result;
  const Edges edges = number_edges(complex);
  const int edge_count = static_cast<int>(edges.nodes.size()), first_mid = complex.point_count();

  std::vector<Vec3> chord(edge_count), bow(edge_count, Vec3::Zero());  // bow: from the chord's middle to the mid-side node
  result.mid_place.assign(edge_count, CadPlace{});
  for (int e = 0; e < edge_count; ++e) chord[e] = 0.5 * (complex.points[edges.nodes[e][0]] + complex.points[edges.nodes[e][1]]);

  // Boundary edges: a feature edge's middle lies on its curve, another's on the face of a quad beside it.
  std::vector<int> cad_edge(edge_count, 0), cad_face(edge_count, 0);
  for (std::size_t i = 0; i < complex.feature_edges.size(); ++i)
    cad_edge[edges.find(complex.feature_edges[i][0], complex.feature_edges[i][1])] = complex.feature_edge_cad[i];
  for (std::size_t q = 0; q < complex.quads.size(); ++q)
    for (int k = 0; k < 4; ++k) {
      int& face = cad_face[edges.find(complex.quads[q][k], complex.quads[q][(k + 1) % 4])];
      if (face == 0) face = complex.quad_face[q];
    }
  const auto put_on_face = [&](int e) {
    const FacePoint p = projector.project_to_face(cad_face[e], chord[e] + bow[e], nullptr);
    bow[e] = p.point - chord[e];
    result.mid_place[e] = {2, cad_face[e], p.uv};
  };
  for (int e = 0; e < edge_count; ++e) {
    if (e % 256 == 0) context.check();
    if (cad_edge[e] > 0) {
      const CurvePoint p = projector.project_to_edge(cad_edge[e], chord[e], nullptr);
      bow[e] = p.point - chord[e];
      result.mid_place[e] = {1, cad_edge[e], Vec2(p.t, 0)};
    } else if (cad_face[e] > 0) {
      put_on_face(e);
    }
  }

  const std::vector<Gradients> checks = check_points();
  std::vector<std::array<int, 20>>& hexes = result.hexes;
  hexes.resize(complex.hexes.size());
  for (std::size_t h = 0; h < hexes.size(); ++h) {
    std::copy(complex.hexes[h].begin(), complex.hexes[h].end(), hexes[h].begin());
    for (int e = 0; e < 12; ++e) hexes[h][8 + e] = first_mid + edges.of_hex[h][e];
  }
  const auto good = [&](std::size_t h) {
    std::array<Vec3, 20> x;
    for (int n = 0; n < 8; ++n) x[n] = complex.points[hexes[h][n]];
    for (int e = 0; e < 12; ++e) {
      const int id = edges.of_hex[h][e];
      x[8 + e] = chord[id] + bow[id];
    }
    for (const Gradients& g : checks) {
      Mat3 j = Mat3::Zero();
      for (int n = 0; n < 20; ++n) j += x[n] * g[n].transpose();
      if (!(j.determinant() > 0)) return false;
    }
    return true;
  };
  const auto bad_hexes = [&] {
    std::vector<int> bad;
    for (std::size_t h = 0; h < hexes.size(); ++h) {
      if (h % 1024 == 0) context.check();
      const auto& of_hex = edges.of_hex[h];
      if (std::any_of(of_hex.begin(), of_hex.end(), [&](int e) { return !bow[e].isZero(0); }) && !good(h))
        bad.push_back(static_cast<int>(h));
    }
    return bad;
  };

  // A strongly curved edge folds its element unless the edges beside it bend too: inside the part, and within its faces.
  std::vector<int> bad = bad_hexes();
  std::vector<char> soft(edge_count, 0);
  for (int round = 0; round < 4 && !bad.empty(); ++round) {
    std::vector<int> bending = bad;  // and a ring more round them each time
    for (std::size_t h = 0; h < hexes.size(); ++h)
      if (std::any_of(edges.of_hex[h].begin(), edges.of_hex[h].end(), [&](int e) { return soft[e] != 0; }))
        bending.push_back(static_cast<int>(h));
    for (int h : bending)
      for (int e : edges.of_hex[h]) soft[e] = cad_edge[e] == 0;
    spread_bows(edges, soft, bow);
    for (int e = 0; e < edge_count; ++e)
      if (soft[e] && cad_face[e] > 0) put_on_face(e);
    bad = bad_hexes();
  }
  // Where that is not enough, back off from curve to chord: half way, and at last all of it.
  std::vector<char> backed_off(edge_count, 0);
  for (int round = 0; round < 8 && !bad.empty(); ++round) {
    for (int h : bad)
      for (int e : edges.of_hex[h]) {
        if (!bow[e].isZero(0)) backed_off[e] = 1;
        bow[e] *= round < 4 ? 0.5 : 0.0;
      }
    bad = bad_hexes();
  }
  result.mid_points.resize(edge_count);
  for (int e = 0; e < edge_count; ++e) {
    result.mid_points[e] = chord[e] + bow[e];
    if (backed_off[e] && result.mid_place[e].dim < 3) {
      ++result.straightened;
      result.mid_place[e] = CadPlace{};
    }
  }
  for (const auto& q : complex.quads) {
    std::array<int, 8> quad;
    for (int k = 0; k < 4; ++k) {
      quad[k] = q[k];
      quad[4 + k] = first_mid + edges.find(q[k], q[(k + 1) % 4]);
    }
    result.quads.push_back(quad);
  }
  return result;
}

}  // namespace hexfeature
