// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include <array>
#include <string>
#include <vector>

#include "base/context.h"
#include "mesh/hex_complex.h"
#include "mesh/hex_element.h"
#include "mesh/projector.h"
#include "quality/skin.h"

namespace hexfeature {

struct QualityReport {
  int hexes = 0, points = 0, quads = 0;
  double min_sj = 0, mean_sj = 0, below_02 = 0, below_05 = 0;  ///< fractions
  std::array<int, 20> histogram{};                             ///< of scaled Jacobian over [-1, 1] in steps of 0.1
  double volume = 0;
  double min_edge = 0, max_edge = 0;
  double deviation = 0;          ///< largest distance of a boundary node from its CAD entity
  std::vector<int> worst_hexes;  ///< the ten worst
  SkinReport skin;
};
/// Throws MeshingError(NoMesh, "quality") when the complex refers to points that it does not have.
QualityReport measure_quality(const HexComplex& complex, const Projector& projector, Context& context);

/// The certificate (design 3.10). Throws MeshingError(NoMesh, "certificate") naming what failed, how often, and the CAD faces:
/// every number finite; the Jacobian determinant of every element proved positive by its Bernstein coefficients
/// (`proves_positive`); every inner face shared by exactly two elements, on opposite sides; boundary a closed manifold
/// (vertices too) and exactly `quads`, outward; no coincident or unused points; every CAD face covered (`face_count` faces;
/// missing ones are returned, not thrown, as faithfulness is reported separately); boundary nodes on their CAD entity within
/// `tolerance` (a length).
struct Certificate {
  std::vector<int> faces_without_quads;
};
Certificate certify(const HexComplex& complex, const Projector& projector, int face_count, double tolerance, Context& context);

}  // namespace hexfeature
