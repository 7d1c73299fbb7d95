// HexFeatureWB - LGPL-2.1-or-later
// Random polycubes, stretched unevenly, at element sizes that do not divide them: each must fill.
#include <doctest/doctest.h>

#include <random>

#include "fixtures.h"
#include "lattice/lattice.h"

using namespace hexfeature;
using namespace fixtures;

namespace {

/// No two cells that touch only along an edge or at a point, filled or empty; one piece.
bool is_manifold(const Voxels& v) {
  std::set<std::array<int, 3>> nodes;
  for (const auto& c : v)
    for (int k = 0; k < 8; ++k) nodes.insert({c[0] + (k & 1), c[1] + (k >> 1 & 1), c[2] + (k >> 2)});
  for (const auto& n : nodes) {
    int bits = 0;
    for (int k = 0; k < 8; ++k)
      if (v.count({n[0] - 1 + (k & 1), n[1] - 1 + (k >> 1 & 1), n[2] - 1 + (k >> 2)})) bits |= 1 << k;
    for (const int cells : {bits, ~bits & 255}) {
      int reached = cells & -cells;
      for (int step = 0; step < 8; ++step)
        for (int i = 0; i < 8; ++i)
          if (reached >> i & 1)
            for (int b = 1; b < 8; b *= 2) reached |= (1 << (i ^ b)) & cells;
      if (reached != cells) return false;
    }
  }
  return true;
}

class Dice {
 public:
  explicit Dice(unsigned seed) : engine_(seed) {}
  int below(int n) { return static_cast<int>(engine_() % n); }
  double unit() { return engine_() / 4294967296.0; }

 private:
  std::mt19937 engine_;
};

Voxels random_polycube(Dice& dice, int pieces) {
  Voxels v = box({0, 0, 0}, {2 + dice.below(5), 2 + dice.below(5), 2 + dice.below(4)});
  for (int i = 0; i < pieces;) {
    const std::array<int, 3> lo{dice.below(7) - 1, dice.below(7) - 1, dice.below(6) - 1};
    const auto piece = box(lo, {lo[0] + 1 + dice.below(3), lo[1] + 1 + dice.below(3), lo[2] + 1 + dice.below(3)});
    const auto w = dice.below(2) ? unite(v, piece) : subtract(v, piece);
    ++i;
    if (!w.empty() && is_manifold(w)) v = w;
  }
  return v;
}

}  // namespace

TEST_CASE("random stretched polycubes fill at any element size") {
  int filled = 0, tried = 0, rounds = 0, coarse = 0;
  for (unsigned seed = 0; seed < 60; ++seed) {
    Dice dice(seed);
    auto surface = voxel_surface(random_polycube(dice, 3 + dice.below(8)), 2);
    // Uneven monotone stretching, then a gentle bend.
    std::array<std::vector<double>, 3> at;
    for (auto& line : at) {
      line.push_back(0);
      for (int i = 0; i < 16; ++i) line.push_back(line.back() + (dice.below(2) ? 0.15 + 0.3 * dice.unit() : 0.6 + 2 * dice.unit()));
    }
    const double bend = 0.02 * dice.unit();
    deform(surface.mesh, [&](const Vec3& p) {
      Vec3 q;
      for (int k = 0; k < 3; ++k) {
        const double s = p[k] + 2;
        const int i = static_cast<int>(s);
        q[k] = at[k][i] + (s - i) * (at[k][i + 1] - at[k][i]);
      }
      return Vec3(q[0] + bend * q[1] * q[1], q[1] - bend * q[2] * q[2], q[2] + bend * q[0] * q[0]);
    });
    const auto shape = make_feature_shape(surface);
    QuantizeOptions options;
    options.size = 0.5 + 1.5 * dice.unit();
    Context context;
    const auto lattice = build_lattice(surface.mesh, shape, options, context);
    ++tried;
    filled += lattice.report.ok;
    rounds += lattice.report.rounds;
    coarse += lattice.report.ok && lattice.report.size == options.size;
    if (!lattice.report.ok) MESSAGE("seed " << seed << ": " << lattice.report.reason);
  }
  MESSAGE(filled << " of " << tried << " filled, " << coarse << " at h, rounds " << rounds);
  CHECK(filled == tried);
}
