// HexFeatureWB - LGPL-2.1-or-later
// What sheets buy: quality after smoothing, with and without them, on fitted analytic parts.
#include <doctest/doctest.h>

#include <string>

#include "quality/quality.h"
#include "round_parts.h"
#include "sheet/sheet.h"
#include "smooth/smooth.h"

using namespace hexfeature;
using namespace fixtures;

namespace {

struct Gain {
  double without = 0, with = 0;
};

Gain measure(const HexPart& part, double size) {
  Context context;
  SmoothOptions smoothing;
  smoothing.size = size;
  SheetOptions sheets;
  sheets.size = size;
  Gain gain;
  HexComplex plain = part.complex;
  gain.without = smooth(plain, part.projector, smoothing, context).min_sj;
  HexComplex padded = part.complex;
  insert_sheets(padded, part.shape, part.geometry(), sheets, context);
  gain.with = smooth(padded, part.projector, smoothing, context).min_sj;
  for (const auto& h : padded.hexes) CHECK(bernstein_minimum(padded.points, h) > 0);
  return gain;
}

}  // namespace

// The thresholds leave room for changes of the smoothing. 0.866 = sin 120 degrees (an edge that three hexahedra share) and 0.770 (three
// such edges meeting) are the topological optima.
TEST_CASE("sheets bring round parts near the topological optimum") {
  const auto check = [](const std::string& name, const HexPart& part, double size, double at_least) {
    CAPTURE(name);
    const Gain gain = measure(part, size);
    CHECK(gain.with > gain.without);
    CHECK(gain.with > at_least);
  };
  check("cylinder", cylinder_part(4), 0.25, 0.8);
  check("sphere", sphere_part(4), 0.25, 0.7);
  check("boss", boss_part(), 0.5, 0.75);
  check("flange", flange_part(), 0.5, 0.75);
  check("shaft", shaft_part(), 0.5, 0.7);
  check("stepped shaft", stepped_shaft_part(), 0.5, 0.8);
  check("pocket", pocket_part(), 0.5, 0.75);
  check("tee", tee_part(), 0.5, 0.7);
  check("cam", cam_part(1, 4), 0.25, 0.75);  // round its acute edge the sheet would bring 0.58 at most: sin 35.8 degrees
}
