// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include <cstdint>

#include "base/types.h"

namespace hexfeature {

/// Greatest valence of a corner of a polycube.
constexpr int kMaxCornerValence = 6;

/// Which arc signs a corner may have, given the labels round it.
///
/// Found by enumeration (experiments A6): of the 256 ways to fill the octants round a lattice vertex, those whose boundary
/// is a disk (its link is one cycle) are the corners a polycube can have. Flat neighbours merged, 48 label sequences
/// of valence 3, 48 of valence 4 and 24 of valence 6 remain (rotations counted), each with its legal outgoing directions.
struct CornerSigns {
  const std::uint8_t* begin = nullptr;  ///< legal sign masks: bit i set = dart i runs along + of its axis
  const std::uint8_t* end = nullptr;
  bool empty() const { return begin == end; }
  bool allows(std::uint8_t mask) const {
    for (const std::uint8_t* m = begin; m != end; ++m)
      if (*m == mask) return true;
    return false;
  }
};

/// `labels[i]` is the label left of the corner's i-th outgoing dart, darts counter-clockwise seen from outside; dart i's axis is
/// the one that is neither labels[i-1]'s nor labels[i]'s. Empty when no polycube has such a corner.
CornerSigns corner_signs(const Label* labels, int valence);

}  // namespace hexfeature
