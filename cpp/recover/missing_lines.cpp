// HexFeatureWB - LGPL-2.1-or-later
#include "recover/missing_lines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>

#include "mesh/triangle_tree.h"

namespace hexfeature {

namespace {

/// A row of a chart's quads: those between k and k + 1 of an axis.
struct Row {
  int chart, axis, k;
  bool operator<(const Row& o) const { return std::tie(chart, axis, k) < std::tie(o.chart, o.axis, o.k); }
};

/// The row of a quad that its side runs across (0 or 2: one row, 1 or 3: the other).
Row row_across(int q, int side, const HexComplex& lattice, const HexComplex& fitted) {
  const auto& v = fitted.quads[q];
  int axis = 0;
  (lattice.points[v[(side + 1) % 4]] - lattice.points[v[side]]).cwiseAbs().maxCoeff(&axis);
  double least = lattice.points[v[0]][axis];
  for (int n : v) least = std::min(least, lattice.points[n][axis]);
  return {fitted.quad_chart[q], axis, static_cast<int>(std::lround(least))};
}

/// Mean of a quad's two sides in one direction.
Vec3 mean_side(int q, int side, const HexComplex& fitted) {
  const auto& v = fitted.quads[q];
  const auto& p = fitted.points;
  return 0.5 * (p[v[(side + 1) % 4]] - p[v[side]] + p[v[(side + 2) % 4]] - p[v[(side + 3) % 4]]);
}

/// The row that a curve of this direction runs along in a quad.
std::optional<Row> row_along(int q, const Vec3& direction, const HexComplex& lattice, const HexComplex& fitted) {
  const Vec3 du = mean_side(q, 0, fitted), dv = mean_side(q, 1, fitted);
  Eigen::Matrix2d gram;
  gram << du.dot(du), du.dot(dv), du.dot(dv), dv.dot(dv);
  if (!(gram.determinant() > 1e-12 * gram(0, 0) * gram(1, 1))) return std::nullopt;
  const Vec2 steps = gram.inverse() * Vec2(du.dot(direction), dv.dot(direction));
  return row_across(q, std::abs(steps[0]) >= std::abs(steps[1]) ? 1 : 0, lattice, fitted);
}

}  // namespace

std::vector<Separation> missing_lines(const std::vector<int>& halfedges, const Lattice& lattice, const HexComplex& fitted,
                                      const SurfaceMesh& mesh, const FeatureShape& shape, double size, const Context& context) {
  constexpr double kShortest = 0.7;  // of h: what runs less along a row only crosses it
  constexpr double kTallest = 3;     // of h: a row may be so tall
  const auto& chart_of = shape.cells.triangle_part;
  const TriangleTree tree(triangles_of_quads(fitted), context);
  std::map<Row, double> length;
  for (int h : halfedges) {
    context.check();
    const int chart = chart_of[h / 3];
    if (chart != chart_of[mesh.opposite[h] / 3]) continue;
    const Vec3 &a = mesh.points[mesh.from(h)], &b = mesh.points[mesh.to(h)];
    const ClosestPoint c = tree.closest_if(0.5 * (a + b), [&](int t) { return fitted.quad_chart[t / 2] == chart; });
    if (c.triangle < 0) continue;
    if (const auto row = row_along(c.triangle / 2, b - a, lattice.complex, fitted)) length[*row] += (b - a).norm();
  }
  struct Sides {
    double length = 0;
    int count = 0;
  };
  std::map<Row, Sides> sides;
  for (int q = 0; q < static_cast<int>(fitted.quads.size()); ++q)
    for (int side : {0, 1}) {
      Sides& of_row = sides[row_across(q, side, lattice.complex, fitted)];
      of_row.length += mean_side(q, side, fitted).norm();
      ++of_row.count;
    }
  // The nearest charts that bound a chart on either side of a row.
  const auto& u = lattice.polycube.coordinate;
  const auto bounds = [&](const Row& row) {
    Separation s;
    for (const auto& edge : shape.cells.edges) {
      if (edge.left != row.chart && edge.right != row.chart) continue;
      const int other = edge.left == row.chart ? edge.right : edge.left;
      if (axis_of(shape.charts[other].label) != row.axis) continue;
      if (u[other] <= row.k && (s.low < 0 || u[other] > u[s.low])) s.low = other;
      if (u[other] > row.k && (s.high < 0 || u[other] < u[s.high])) s.high = other;
    }
    return s;
  };
  // Lines wanted in the layers of the lattice that the rows are of, by their bounds: several charts may have a row in one layer.
  std::map<std::pair<int, int>, std::map<int, int>> more;
  const auto want = [&](const Row& row, int lines) {
    const Separation s = bounds(row);
    if (s.low < 0 || s.high < 0) return;
    int& wanted = more[{s.low, s.high}][row.k];
    wanted = std::max(wanted, lines);
  };
  for (const auto& [row, along] : length)
    if (along >= kShortest * size) want(row, 1);
  for (const auto& [row, of_row] : sides)
    if (const int lines = static_cast<int>(std::ceil(of_row.length / of_row.count / (kTallest * size))) - 1; lines > 0) want(row, lines);
  std::vector<Separation> separations;
  for (const auto& [charts, layers] : more) {
    int gap = u[charts.second] - u[charts.first];
    for (const auto& [k, lines] : layers) gap += lines;
    separations.push_back({charts.first, charts.second, gap});
  }
  return separations;
}

}  // namespace hexfeature
