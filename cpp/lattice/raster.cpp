// HexFeatureWB - LGPL-2.1-or-later
#include "lattice/raster.h"

#include <algorithm>
#include <limits>

namespace hexfeature {
namespace {

std::vector<PolygonSide> polygon_sides(const FeatureShape& shape, const Polycube& polycube, int chart) {
  std::vector<PolygonSide> sides;
  for (const auto& loop : shape.cells.parts[chart].loops)
    for (int dart : loop) {
      const auto& p = polycube.corners[shape.cells.start_of(dart)];
      const auto& q = polycube.corners[shape.cells.end_of(dart)];
      PolygonSide side;
      side.along = shape.arcs[dart / 2].axis;
      side.at = p[third_axis(side.along, axis_of(shape.charts[chart].label))];
      side.direction = q[side.along] > p[side.along] ? 1 : -1;
      side.lo = std::min(p[side.along], q[side.along]);
      side.hi = std::max(p[side.along], q[side.along]);
      side.chart = shape.cells.right_of(dart);
      side.arc = dart / 2;
      sides.push_back(side);
    }
  return sides;
}

/// One chart's polygon on its own bounding rectangle.
class ChartRaster {
 public:
  ChartRaster(const FeatureShape& shape, const Polycube& polycube, int chart, Raster& raster)
      : raster_(raster), sides_(raster.sides[chart]), chart_(chart) {
    const Label label = shape.charts[chart].label;
    axis_ = axis_of(label);
    a_ = (axis_ + 1) % 3;
    b_ = (axis_ + 2) % 3;
    sign_ = sign_of(label);
    at_[axis_] = polycube.coordinate[chart];
    lo_a_ = lo_b_ = std::numeric_limits<int>::max();
    int hi_a = std::numeric_limits<int>::min(), hi_b = hi_a;
    for (const auto& s : sides_) {
      if (s.along == b_) {
        lo_a_ = std::min(lo_a_, s.at);
        hi_a = std::max(hi_a, s.at);
      } else {
        lo_b_ = std::min(lo_b_, s.at);
        hi_b = std::max(hi_b, s.at);
      }
    }
    if (hi_a < lo_a_ || hi_b < lo_b_) {
      raster.bad_charts.push_back(chart);
      return;
    }
    width_ = hi_a - lo_a_;
    height_ = hi_b - lo_b_;
    winding_.assign(static_cast<std::size_t>(width_) * height_, 0);
    wind();
    check();
    emit();
  }

 private:
  int winding(int a, int b) const {
    a -= lo_a_;
    b -= lo_b_;
    return a < 0 || b < 0 || a >= width_ || b >= height_ ? 0 : winding_[static_cast<std::size_t>(b) * width_ + a];
  }

  // A side that goes up has the chart on its left, at smaller a, when the chart is seen from +axis; so the winding number of
  // a cell is the sum of the directions of the sides to its right.
  void wind() {
    for (const auto& s : sides_) {
      if (s.along != b_ || s.at == lo_a_) continue;
      for (int b = s.lo; b < s.hi; ++b) winding_[static_cast<std::size_t>(b - lo_b_) * width_ + (s.at - 1 - lo_a_)] += s.direction * sign_;
    }
    for (int b = 0; b < height_; ++b)
      for (int a = width_ - 2; a >= 0; --a)
        winding_[static_cast<std::size_t>(b) * width_ + a] += winding_[static_cast<std::size_t>(b) * width_ + a + 1];
  }

  void clash(int first, int second, int a, int b) {
    if (first < 0 || second < 0 || first == second) return;
    at_[a_] = a;
    at_[b_] = b;
    raster_.overlaps.push_back({first, second, at_});
  }

  /// The two sides nearest to cell (a, b) along `axis` bound an interval that should not be there: their charts are in each other's way.
  void clash_beside(int axis, int a, int b) {
    const int position = axis == a_ ? a : b, row = axis == a_ ? b : a;
    const PolygonSide *below = nullptr, *above = nullptr;
    for (const auto& s : sides_) {
      if (s.along == axis || row < s.lo || row >= s.hi) continue;
      if (s.at <= position && (!below || s.at > below->at)) below = &s;
      if (s.at > position && (!above || s.at < above->at)) above = &s;
    }
    if (below && above) clash(below->chart, above->chart, a, b);
  }

  void check() {
    bool bad = false;
    for (int b = 0; b < height_; ++b)
      for (int a = 0; a < width_; ++a) {
        const int w = winding_[static_cast<std::size_t>(b) * width_ + a];
        if (w == 0 || w == 1) continue;
        bad = true;
        clash_beside(a_, a + lo_a_, b + lo_b_);
        clash_beside(b_, a + lo_a_, b + lo_b_);
      }
    // Sides with the chart on both or on neither of their sides lie on top of each other.
    for (const auto& s : sides_)
      for (int i = s.lo; i < s.hi; ++i) {
        const bool up = s.along == b_;
        const int inside = (up ? -1 : 1) * s.direction * sign_;  // towards + or - of the other axis
        const int before = up ? winding(s.at - 1, i) : winding(i, s.at - 1), after = up ? winding(s.at, i) : winding(i, s.at);
        if ((inside > 0 ? after : before) == 1 && (inside > 0 ? before : after) == 0) continue;
        bad = true;
        for (const auto& t : sides_)
          if (t.along == s.along && t.at == s.at && i >= t.lo && i < t.hi) clash(s.chart, t.chart, up ? s.at : i, up ? i : s.at);
      }
    if (bad) raster_.bad_charts.push_back(chart_);
  }

  void emit() {
    auto& cells = raster_.cells[axis_];
    for (int b = 0; b < height_; ++b)
      for (int a = 0; a < width_; ++a)
        for (int w = std::abs(winding_[static_cast<std::size_t>(b) * width_ + a]); w > 0; --w) {
          at_[a_] = a + lo_a_;
          at_[b_] = b + lo_b_;
          cells.push_back({raster_.grid.face_key(axis_, at_), chart_});
        }
  }

  Raster& raster_;
  const std::vector<PolygonSide>& sides_;
  int chart_, axis_ = 0, a_ = 0, b_ = 0, sign_ = 1, lo_a_ = 0, lo_b_ = 0, width_ = 0, height_ = 0;
  std::array<int, 3> at_{0, 0, 0};
  std::vector<int> winding_;
};

}  // namespace

LatticeGrid bounding_grid(const Polycube& polycube) {
  LatticeGrid grid;
  for (const auto& p : polycube.corners)
    for (int k = 0; k < 3; ++k) grid.n[k] = std::max(grid.n[k], p[k]);
  return grid;
}

Raster rasterise(const FeatureShape& shape, const Polycube& polycube, Context& context) {
  Raster raster;
  raster.grid = bounding_grid(polycube);
  raster.sides.resize(shape.chart_count());
  for (int c = 0; c < shape.chart_count(); ++c) {
    context.check();
    raster.sides[c] = polygon_sides(shape, polycube, c);
    ChartRaster(shape, polycube, c, raster);
  }
  for (auto& cells : raster.cells)
    std::sort(cells.begin(), cells.end(),
              [](const ChartCell& x, const ChartCell& y) { return x.key != y.key ? x.key < y.key : x.chart < y.chart; });
  return raster;
}

Bound bound_beside(const FeatureShape& shape, const Raster& raster, int chart, const std::array<int, 3>& at, int axis, int direction) {
  const int own = axis_of(shape.charts[chart].label);
  if (axis == own) return {chart, shape.charts[chart].centroid[axis]};
  const int row = at[third_axis(axis, own)], position = at[axis];
  const PolygonSide* best = nullptr;
  for (const auto& s : raster.sides[chart]) {
    if (s.along == axis || row < s.lo || row >= s.hi) continue;
    if (direction > 0 ? s.at <= position : s.at > position) continue;
    if (!best || (direction > 0 ? s.at < best->at : s.at > best->at)) best = &s;
  }
  if (!best) return {};
  return {best->chart, shape.arcs[best->arc].centroid[axis]};
}

}  // namespace hexfeature
