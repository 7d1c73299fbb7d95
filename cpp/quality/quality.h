// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include <array>
#include <string>
#include <vector>

#include "base/context.h"
#include "mesh/hex_complex.h"
#include "mesh/projector.h"

namespace hexfeature {

/// Verdict's scaled Jacobian of one hexahedron (least of 8 corners and the centre), in [-1, 1].
double scaled_jacobian(const std::vector<Vec3>& points, const std::array<int, 8>& hex);

/// Least of the 27 Bernstein coefficients of the trilinear map's Jacobian determinant, over the mean edge length cubed.
/// > 0 proves the element injective.
double bernstein_minimum(const std::vector<Vec3>& points, const std::array<int, 8>& hex);

struct QualityReport {
  int hexes = 0, points = 0, quads = 0;
  double min_sj = 0, mean_sj = 0, below_02 = 0, below_05 = 0;  ///< fractions
  std::array<int, 20> histogram{};                             ///< of scaled Jacobian over [-1, 1] in steps of 0.1
  double volume = 0;
  double min_edge = 0, max_edge = 0;
  double deviation = 0;  ///< largest distance of a boundary node from its CAD entity
  std::vector<int> worst_hexes;  ///< the ten worst
};
QualityReport measure_quality(const HexComplex& complex, const Projector& projector, Context& context);

/// The certificate (design 3.10). Throws MeshingError(NoMesh, "certificate") naming what failed and the CAD faces:
/// all 27 Bernstein coefficients > 0; every inner face shared by exactly two; boundary a closed manifold and exactly `quads`;
/// no coincident or unused points; every CAD face covered (`face_count` faces; missing ones are returned, not thrown,
/// as faithfulness is reported separately); boundary nodes on their CAD entity within `tolerance`.
struct Certificate {
  std::vector<int> faces_without_quads;
};
Certificate certify(const HexComplex& complex, const Projector& projector, int face_count, double tolerance, Context& context);

}  // namespace hexfeature
