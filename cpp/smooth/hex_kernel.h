// HexFeatureWB - LGPL-2.1-or-later
#pragma once

namespace hexfeature {

/// Which energy of the corner tetrahedra is meant, and its numbers.
///
/// At each corner of a hexahedron A = (e1 e2 e3) / L, with the three edges from there and the element's target size L;
/// d = det A. The shape energy is
///   chi = (d + sqrt(eps^2 + d^2)) / 2,  f = |A|^2 / chi^(2/3),  g = (1 + d^2) / chi,  E = (1 - theta) f + theta g.
/// It is finite on inverted elements as well, and a barrier against inversion as eps goes to 0.
/// Source: Garanzha, Kaporin, Kudryavtseva, Protais, Ray, Sokolov, "Foldover-free maps in 50 lines of code",
/// ACM Trans. Graph. 40(4), 2021, equations (3) to (6).
///
/// The corners alone do not see an element that is folded along an edge. A `thorough` element has 24 more tetrahedra, at a
/// third of the weight: an edge of direction r with one edge of direction s from its one end and one of direction t from its
/// other end. The determinant's Bernstein coefficient of that edge is the mean of two of their determinants.
///
/// The worst-element energy, for power p > 0, is Sum (|e1| |e2| |e3| / det)^p + shape_weight E + a wall against edges shorter
/// than the element's shortest wanted one m: 4 (m^2 / |e|^2 - 1)^2 where |e| < m. It is defined on valid elements alone, and only
/// while no edge is shorter than the element's least allowed one.
///
/// The mean-element energy, on the same conditions, is Sum over elements of 1 - s + shape_weight E + the wall, where s is the power mean
/// (Sum_corners s^-8 / 8)^(-1/8) of the scaled Jacobians at its corners: nearly the least of them, and its sum is what the mean counts.
/// Poor corners would be given up for many others' little gains but for a barrier, 0.1 (worst / s)^16 each. Thorough elements have no more
/// tetrahedra than others here.
struct EnergyTerms {
  double theta = 0.1;
  double epsilon_squared = 1e-6;
  int power = 0;  ///< 0: shape energy alone; else 1, 2, 4, 8 or 16
  double shape_weight = 1;
  bool mean = false;  ///< the mean-element energy; `power` is not used
  double worst = 0;   ///< mean-element energy: about where its barrier rises
  bool shape_alone() const { return power == 0 && !mean; }
};

constexpr int kLanes = 4;  ///< hexahedra that are evaluated at once, a *group*
constexpr int kCorners = 8, kAllFrames = 32;
constexpr double kMixedWeight = 1.0 / 3.0;

/// Three edges of the hexahedron that span a tetrahedron: from and to node of each.
struct Frame {
  int from[3], to[3];
};
/// The 8 corners, then the 24 mixed frames of thorough elements.
struct FrameTable {
  Frame frame[kAllFrames];
  FrameTable();
};
const FrameTable& hex_frames();

/// Four hexahedra as the kernel sees them.
struct Group {
  const int* node;             ///< 8 nodes x 4 lanes, as offsets into x
  const double* inverse_size;  ///< per lane: 1 / L
  const double* weight;        ///< per lane: 1, or 0 when it is empty
  const double* shortest;      ///< per lane: (m / L)^2
  const double* least;         ///< per lane: (least allowed edge / L)^2
  int frames;                  ///< kCorners or kAllFrames
};
struct GroupValue {
  double energy, min_det;
};

/// Energy of a group; its gradient goes to `slots` (8 nodes x 3 coordinates x 4 lanes) unless that is null. Compiled twice, for
/// processors with 256-bit registers and for all others, with the same operations on each lane: results are the same bit for bit.
GroupValue evaluate_group(const Group& group, const double* x, const EnergyTerms& terms, double* slots);

}  // namespace hexfeature
