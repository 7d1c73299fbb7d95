// HexFeatureWB - LGPL-2.1-or-later
#include <algorithm>
#include <array>
#include <string>

#include "lattice/lattice.h"
#include "lattice/raster.h"
#include "lattice/separate.h"

namespace hexfeature {
namespace {

constexpr double kMostGridCells = 4e7;

/// What the checks find, gathered until the report is written.
struct Findings {
  std::string reason;
  std::vector<Clash> clashes;
  std::vector<int> charts;
  void add(const char* why, int p, int q, const std::array<int, 3>& at) {
    if (reason.empty()) reason = why;
    charts.push_back(p);
    charts.push_back(q);
    if (p != q && clashes.size() < 20000) clashes.push_back({p, q, at});
  }
};

/// For each of the 256 ways to fill the eight cells round a node (bit x + 2y + 4z): is the boundary there one disk?
/// It is when the filled and the empty cells are both connected through faces.
std::array<char, 256> disk_table() {
  std::array<char, 256> table{};
  const auto connected = [](int cells) {
    int reached = cells & -cells;
    for (int step = 0; step < 8; ++step)
      for (int i = 0; i < 8; ++i)
        if (reached >> i & 1)
          for (int bit = 1; bit < 8; bit *= 2) reached |= (1 << (i ^ bit)) & cells;
    return reached == cells;
  };
  for (int i = 1; i < 255; ++i) table[i] = connected(i) && connected(~i & 255);
  return table;
}

class Filler {
 public:
  Filler(const FeatureShape& shape, const Polycube& polycube, int solid, Context& context)
      : shape_(shape), polycube_(polycube), solid_number_(solid), context_(context) {}

  Lattice run(const std::vector<Separation>& tried) {
    Lattice lattice;
    lattice.polycube = polycube_;
    if (shape_.corner_count() == 0) {
      lattice.report.reason = "the feature shape has no corners";
      return lattice;
    }
    grid_ = bounding_grid(polycube_);
    if (static_cast<double>(grid_.n[0]) * grid_.n[1] * grid_.n[2] > kMostGridCells) {
      lattice.report.reason = "the lattice would have more than 40 million cells: raise the element size";
      return lattice;
    }
    raster_ = rasterise(shape_, polycube_, context_);
    for (const auto& o : raster_.overlaps) findings_.add("a chart's outline crosses itself", o.first, o.second, o.at);
    for (int c : raster_.bad_charts) findings_.charts.push_back(c);
    if (findings_.reason.empty() && !raster_.bad_charts.empty()) findings_.reason = "a chart's outline is not simple";
    fill();
    if (findings_.reason.empty()) check_nodes();
    if (findings_.reason.empty()) make_complex(lattice.complex);
    if (findings_.reason.empty()) {
      lattice.report.ok = true;
      return lattice;
    }
    lattice.complex = HexComplex();
    lattice.report.reason = findings_.reason;
    lattice.report.charts = findings_.charts;
    auto& charts = lattice.report.charts;
    std::sort(charts.begin(), charts.end());
    charts.erase(std::unique(charts.begin(), charts.end()), charts.end());
    lattice.report.separations = separations_for(shape_, polycube_, raster_, findings_.clashes, tried);
    return lattice;
  }

 private:
  bool filled(int x, int y, int z) const {
    return x >= 0 && y >= 0 && z >= 0 && x < grid_.n[0] && y < grid_.n[1] && z < grid_.n[2] && fill_[grid_.cell(x, y, z)] == 7;
  }

  /// Fill between the charts of each axis on its own; the boundary is exactly the charts' cells, on their right sides, when in
  /// every column they alternate (in, out, in, out, each at a place of its own) and the three fillings agree.
  void fill() {
    fill_.assign(grid_.cell_count(), 0);
    const std::array<std::size_t, 3> stride{1, static_cast<std::size_t>(grid_.n[0]), static_cast<std::size_t>(grid_.n[0]) * grid_.n[1]};
    for (int axis = 0; axis < 3; ++axis) {
      context_.check();
      const auto& cells = raster_.cells[axis];
      const auto sign = [&](std::size_t i) { return sign_of(shape_.charts[cells[i].chart].label); };
      const int levels = grid_.n[axis] + 1;
      for (std::size_t i = 0; i < cells.size();) {
        std::size_t j = i;
        while (j < cells.size() && cells[j].key / levels == cells[i].key / levels) ++j;
        for (std::size_t k = i; k < j; ++k) {
          const auto at = grid_.face_position(axis, cells[k].key);
          if (k + 1 < j && cells[k + 1].key == cells[k].key)
            findings_.add("two charts lie on the same cells", cells[k].chart, cells[k + 1].chart, at);
          else if (k + 1 < j && sign(k) == sign(k + 1))
            findings_.add("two charts that face the same way follow each other", cells[k].chart, cells[k + 1].chart, at);
          if ((k == i && sign(k) > 0) || (k + 1 == j && sign(k) < 0))
            findings_.add("a chart faces the wrong way", cells[k].chart, cells[k == i ? j - 1 : i].chart, at);
          if (sign(k) > 0 || k + 1 == j || sign(k + 1) < 0) continue;
          const int end = grid_.face_position(axis, cells[k + 1].key)[axis];
          std::size_t cell = grid_.cell(at[0], at[1], at[2]);
          for (int p = at[axis]; p < end; ++p, cell += stride[axis]) fill_[cell] |= static_cast<char>(1 << axis);
        }
        i = j;
      }
    }
    for (int z = 0; z < grid_.n[2]; ++z) {
      context_.check();
      for (int y = 0; y < grid_.n[1]; ++y)
        for (int x = 0; x < grid_.n[0]; ++x) {
          const int bits = fill_[grid_.cell(x, y, z)];
          if (bits != 0 && bits != 7) blame_cell({x, y, z}, bits);
        }
    }
  }

  /// The charts' cells next to a cell on both sides along an axis; -1: none.
  std::array<int, 2> neighbours(int axis, const std::array<int, 3>& cell) const {
    const auto& cells = raster_.cells[axis];
    const std::uint64_t key = grid_.face_key(axis, cell), levels = grid_.n[axis] + 1;
    const auto above = std::upper_bound(cells.begin(), cells.end(), key, [](std::uint64_t k, const ChartCell& c) { return k < c.key; });
    std::array<int, 2> result{-1, -1};
    if (above != cells.begin() && (above - 1)->key / levels == key / levels) result[0] = (above - 1)->chart;
    if (above != cells.end() && above->key / levels == key / levels) result[1] = above->chart;
    return result;
  }

  /// The axes disagree on whether this cell is inside: somewhere near, charts of an axis that says one thing clash with those
  /// of one that says the other.
  void blame_cell(const std::array<int, 3>& cell, int bits) {
    if (findings_.clashes.size() > 10000) return;
    for (int in = 0; in < 3; ++in)
      for (int out = 0; out < 3; ++out) {
        if (!(bits >> in & 1) || (bits >> out & 1)) continue;
        for (int p : neighbours(in, cell))
          for (int q : neighbours(out, cell))
            if (p >= 0 && q >= 0) findings_.add("the inside leaks: the axes disagree", p, q, cell);
        if (findings_.reason.empty()) findings_.reason = "the inside leaks: the axes disagree";
        for (int p : neighbours(in, cell))
          if (p >= 0) findings_.charts.push_back(p);
      }
  }

  int chart_of_face(int axis, const std::array<int, 3>& at) const {
    const auto& cells = raster_.cells[axis];
    const std::uint64_t key = grid_.face_key(axis, at);
    const auto it = std::lower_bound(cells.begin(), cells.end(), key, [](const ChartCell& c, std::uint64_t k) { return c.key < k; });
    return it != cells.end() && it->key == key ? it->chart : -1;
  }

  /// Every node of the boundary must have one disk of boundary around it.
  void check_nodes() {
    static const std::array<char, 256> disk = disk_table();
    for (int z = 0; z <= grid_.n[2]; ++z) {
      context_.check();
      for (int y = 0; y <= grid_.n[1]; ++y)
        for (int x = 0, left = 0; x <= grid_.n[0]; ++x) {
          int right = 0;  // the four cells on the +x side of this node; the -x side is the last node's
          for (int k = 0; k < 4; ++k)
            if (filled(x, y - 1 + (k & 1), z - 1 + (k >> 1))) right |= 2 << (2 * k);
          const int bits = left | right;
          left = right >> 1;
          if (bits != 0 && bits != 255 && !disk[bits]) blame_node({x, y, z});
        }
    }
  }

  /// Charts that only touch at this node, not sharing a boundary edge there, clash.
  void blame_node(const std::array<int, 3>& node) {
    std::vector<int> charts;
    for (int axis = 0; axis < 3; ++axis) {
      const int a = (axis + 1) % 3, b = (axis + 2) % 3;
      for (int k = 0; k < 4; ++k) {
        auto at = node;
        at[a] -= k & 1;
        at[b] -= k >> 1;
        if (at[a] < 0 || at[b] < 0 || at[a] >= grid_.n[a] || at[b] >= grid_.n[b]) continue;
        const int chart = chart_of_face(axis, at);
        if (chart >= 0) charts.push_back(chart);
      }
    }
    std::sort(charts.begin(), charts.end());
    charts.erase(std::unique(charts.begin(), charts.end()), charts.end());
    const auto adjacent = [&](int p, int q) {
      for (const auto& side : raster_.sides[p])
        if (side.chart == q) return true;
      return false;
    };
    for (std::size_t i = 0; i < charts.size(); ++i)
      for (std::size_t j = i + 1; j < charts.size(); ++j)
        if (!adjacent(charts[i], charts[j])) findings_.add("the part touches itself", charts[i], charts[j], node);
    if (findings_.reason.empty()) findings_.reason = "the part touches itself";
    findings_.charts.insert(findings_.charts.end(), charts.begin(), charts.end());
  }

  void make_complex(HexComplex& complex) {
    const auto slab = slabs();
    std::vector<int> point(grid_.node_count(), -1);
    const std::array<std::array<int, 3>, 8> corner{
        {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}};
    // Number the points in grid order, then the hexahedra.
    for (int z = 0; z < grid_.n[2]; ++z)
      for (int y = 0; y < grid_.n[1]; ++y)
        for (int x = 0; x < grid_.n[0]; ++x)
          if (fill_[grid_.cell(x, y, z)])
            for (const auto& d : corner) point[grid_.node(x + d[0], y + d[1], z + d[2])] = 0;
    for (int z = 0; z <= grid_.n[2]; ++z)
      for (int y = 0; y <= grid_.n[1]; ++y)
        for (int x = 0; x <= grid_.n[0]; ++x) {
          int& p = point[grid_.node(x, y, z)];
          if (p < 0) continue;
          p = complex.point_count();
          complex.points.emplace_back(x, y, z);
        }
    const int blocks_x = slab[0].empty() ? 1 : slab[0].back() + 1, blocks_y = slab[1].empty() ? 1 : slab[1].back() + 1;
    for (int z = 0; z < grid_.n[2]; ++z) {
      context_.check();
      for (int y = 0; y < grid_.n[1]; ++y)
        for (int x = 0; x < grid_.n[0]; ++x) {
          if (!fill_[grid_.cell(x, y, z)]) continue;
          std::array<int, 8> hex;
          for (int k = 0; k < 8; ++k) hex[k] = point[grid_.node(x + corner[k][0], y + corner[k][1], z + corner[k][2])];
          complex.hexes.push_back(hex);
          complex.hex_block.push_back((slab[2][z] * blocks_y + slab[1][y]) * blocks_x + slab[0][x]);
        }
    }
    renumber(complex.hex_block);
    complex.hex_solid.assign(complex.hexes.size(), solid_number_);
    make_quads(complex, point);
    place_nodes(complex, point);
    check_euler(complex);
  }

  /// Per axis and cell layer: between which consecutive chart coordinates it lies.
  std::array<std::vector<int>, 3> slabs() const {
    std::array<std::vector<int>, 3> slab;
    for (int axis = 0; axis < 3; ++axis) {
      std::vector<int> cut(grid_.n[axis] + 1, 0);
      for (int c = 0; c < shape_.chart_count(); ++c)
        if (axis_of(shape_.charts[c].label) == axis) cut[polycube_.coordinate[c]] = 1;
      for (int p = 0, s = 0; p < grid_.n[axis]; ++p) {
        if (p > 0) s += cut[p];
        slab[axis].push_back(s);
      }
    }
    return slab;
  }

  /// Numbers in order of first appearance, without gaps.
  static void renumber(std::vector<int>& values) {
    if (values.empty()) return;
    std::vector<int> number(*std::max_element(values.begin(), values.end()) + 1, -1);
    int count = 0;
    for (int& v : values) {
      if (number[v] < 0) number[v] = count++;
      v = number[v];
    }
  }

  void make_quads(HexComplex& complex, const std::vector<int>& point) const {
    struct Face {
      int chart, axis;
      std::uint64_t key;
    };
    std::vector<Face> faces;
    for (int axis = 0; axis < 3; ++axis)
      for (const auto& c : raster_.cells[axis]) faces.push_back({c.chart, axis, c.key});
    std::sort(faces.begin(), faces.end(),
              [](const Face& p, const Face& q) { return p.chart != q.chart ? p.chart < q.chart : p.key < q.key; });
    for (const auto& f : faces) {
      auto p = grid_.face_position(f.axis, f.key);
      const int a = (f.axis + 1) % 3, b = (f.axis + 2) % 3;
      std::array<int, 4> quad;
      quad[0] = point[grid_.node(p)];
      ++p[a];
      quad[1] = point[grid_.node(p)];
      ++p[b];
      quad[2] = point[grid_.node(p)];
      --p[a];
      quad[3] = point[grid_.node(p)];
      if (sign_of(shape_.charts[f.chart].label) < 0) std::swap(quad[1], quad[3]);
      complex.quads.push_back(quad);
      complex.quad_chart.push_back(f.chart);
    }
    complex.quad_face.assign(complex.quads.size(), 0);
  }

  /// Corners and arcs from their own lattice lines, what is left of the boundary from its chart. Two items on one node would
  /// be a polycube that touches itself.
  void place_nodes(HexComplex& complex, const std::vector<int>& point) {
    complex.place.assign(complex.points.size(), CadPlace());
    complex.shape_place.assign(complex.points.size(), ShapePlace());
    const auto charts_of = [&](int dim, int item) {
      std::vector<int> charts;
      if (dim == 1) charts = {shape_.cells.edges[item].left, shape_.cells.edges[item].right};
      if (dim == 0)
        for (int dart : shape_.cells.nodes[item].darts) charts.push_back(shape_.cells.left_of(dart));
      return charts;
    };
    const auto set = [&](const std::array<int, 3>& at, int dim, int item) {
      const int p = point[grid_.node(at)];
      if (p < 0) {  // not even on the solid: the polygon checks have missed something
        findings_.add("a feature line leaves the solid", charts_of(dim, item)[0], charts_of(dim, item)[1], at);
        return;
      }
      ShapePlace& place = complex.shape_place[p];
      if (place.dim == 3) {
        place = {dim, item};
        return;
      }
      for (int first : charts_of(dim, item))
        for (int second : charts_of(place.dim, place.item))
          findings_.add("two feature lines meet where they should not", first, second, at);
    };
    for (int n = 0; n < shape_.corner_count(); ++n) set(polycube_.corners[n], 0, n);
    for (int i = 0; i < shape_.arc_count(); ++i) {
      const auto& edge = shape_.cells.edges[i];
      const int axis = shape_.arcs[i].axis;
      auto at = polycube_.corners[edge.start];
      const int end = polycube_.corners[edge.end][axis], step = end > at[axis] ? 1 : -1;
      for (at[axis] += step; at[axis] != end; at[axis] += step) set(at, 1, i);
    }
    for (std::size_t q = 0; q < complex.quads.size(); ++q)
      for (int p : complex.quads[q]) {
        auto& place = complex.shape_place[p];
        if (place.dim == 3) place = {2, complex.quad_chart[q]};
      }
  }

  void check_euler(const HexComplex& complex) {
    int expected = shape_.corner_count() - shape_.arc_count();
    for (const auto& part : shape_.cells.parts) expected += 2 - static_cast<int>(part.loops.size());
    int boundary = 0;
    for (const auto& place : complex.shape_place) boundary += place.dim < 3;
    // Four edges a quad, each shared by two: V - E + F = V - F.
    if (findings_.reason.empty() && boundary - static_cast<int>(complex.quads.size()) != expected)
      findings_.reason = "the filled solid's Euler number is not the part's";
  }

  const FeatureShape& shape_;
  const Polycube& polycube_;
  const int solid_number_;
  Context& context_;
  Raster raster_;
  LatticeGrid grid_;
  std::vector<char> fill_;  // per cell: bit `axis` when the charts of that axis say inside
  Findings findings_;
};

}  // namespace

Lattice fill_lattice(const FeatureShape& shape, const Polycube& polycube, int solid, Context& context,
                     const std::vector<Separation>& tried) {
  return Filler(shape, polycube, solid, context).run(tried);
}

}  // namespace hexfeature
