// HexFeatureWB - LGPL-2.1-or-later
// A part that nothing is read from, for the unit tests of the pipeline.
#pragma once
#include <string>
#include <vector>

#include "pipeline/part.h"

namespace fixtures {

struct NoPart : hexfeature::Part {
  hexfeature::Geometry geometry() const override { return {}; }
  int solid_count() const override { return 1; }
  double volume() const override { return 1; }
  double diagonal() const override { return 1; }
  std::vector<std::string> warnings() const override { return {}; }
  std::vector<hexfeature::Mat3> frames() const override { return {hexfeature::Mat3::Identity()}; }
  void place(const hexfeature::Mat3&) override {}
  void place_in_world() override {}
  hexfeature::Vec3 to_world(const hexfeature::Vec3& p) const override { return p; }
  hexfeature::Vec3 centre() const override { return hexfeature::Vec3::Zero(); }
  hexfeature::SurfaceMesh surface(double, hexfeature::Context&) const override { return {}; }
};

}  // namespace fixtures
