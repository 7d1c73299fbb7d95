// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include <array>
#include <vector>

#include "base/types.h"
#include "smooth/hex_kernel.h"
#include "smooth/workers.h"

namespace hexfeature {

/// A mesh edge that follows a CAD curve, and the lengths it should keep: beyond `longest` its chord would cut too much off the
/// curve, below `shortest` its ends would run together. Only lengths outside the two cost anything:
///   6 (|e|^2 / longest^2 - 1)^2   and   6 (shortest^2 / |e|^2 - 1)^2;
/// in the worst-element energy the first is a barrier, 6 ((r - 1) / (r1 - r))^2 with r = |e|^2 / longest^2 and r1 where it is infinite.
struct Span {
  int a = 0, b = 0;  ///< points
  double longest = 0, shortest = 0;
};

struct EnergyValue {
  double energy = 0;   ///< infinite when the energy is not defined there
  double min_det = 0;  ///< least d of all corners (and the thorough elements' other tetrahedra)
};

/// The energy of a set of hexahedra as a function of all point coordinates x (x0 y0 z0 x1 ...). Elements are evaluated four
/// at a time, then each point gathers its gradient from its elements in a fixed order: bit-identical for any thread count.
class HexEnergy {
 public:
  /// `target` is L, `shortest` is m, `least` is the least allowed edge of each hexahedron (lengths > 0).
  HexEnergy(const std::vector<std::array<int, 8>>& hexes, int points, const std::vector<double>& target,
            const std::vector<double>& shortest, const std::vector<double>& least, const std::vector<char>& thorough, Workers& workers);

  /// The edges along CAD curves, with barriers that x is within.
  void set_spans(std::vector<Span> spans, const double* x);
  /// Widen the barriers so that x is within them.
  void admit(const double* x);

  /// A lower bound of the energy: that of perfect elements.
  double floor(const EnergyTerms& terms) const;

  /// `gradient` (3 per point, may be null) is overwritten.
  EnergyValue evaluate(const double* x, const EnergyTerms& terms, double* gradient);

  /// The positive part of the Hessian's diagonal blocks: `blocks` gets a symmetric positive semidefinite matrix per point, as
  /// xx yy zz yz xz xy. Where elements are nearly flat these are many orders of magnitude larger than elsewhere, which is
  /// what makes an unscaled descent crawl. Elements for which the energy is not defined count as perfect ones.
  void stiffness(const double* x, const EnergyTerms& terms, std::vector<double>& blocks) const;

  /// `share` of the energy of the spans alone; adds its gradient to `gradient` (may be null). `barrier`: as in the worst-element energy.
  double add_spans(const double* x, bool barrier, double share, double* gradient) const;

 private:
  int frame_count(int group, const EnergyTerms& terms) const;

  int hexes_, points_;
  std::vector<int> nodes_;             ///< per group of four elements: 8 nodes x 4 lanes, as offsets into x
  std::vector<double> inverse_size_;   ///< per group and lane
  std::vector<double> shortest_;       ///< (m / L)^2
  std::vector<double> least_;          ///< (least / L)^2
  std::vector<double> weight_;         ///< 1, or 0 in the empty lanes of the last group
  std::vector<char> thorough_;         ///< per group
  std::vector<int> start_, incident_;  ///< per point: where its gradient parts are in slots_
  std::vector<double> slots_;          ///< per group: 8 nodes x 3 coordinates x 4 lanes
  std::vector<GroupValue> parts_;      ///< per group
  std::vector<Span> spans_;
  std::vector<double> limit_;  ///< per span: r1
  Workers& workers_;
};

}  // namespace hexfeature
