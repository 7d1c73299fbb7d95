// HexFeatureWB - LGPL-2.1-or-later
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "fixtures.h"
#include "label/cut_tree.h"
#include "label/label_score.h"
#include "label/labels.h"

using namespace hexfeature;
using namespace fixtures;

namespace {

/// The voxel surface with its charts as planar CAD faces.
struct PlanarPart {
  explicit PlanarPart(const Voxels& voxels) : surface(voxel_surface(voxels)) {
    const int count = *std::max_element(surface.mesh.triangle_face.begin(), surface.mesh.triangle_face.end());
    faces.resize(count);
    for (int t = 0; t < surface.mesh.triangle_count(); ++t) {
      CadFace& f = faces[surface.mesh.triangle_face[t] - 1];
      f.kind = SurfaceKind::Plane;
      f.area += surface.mesh.area(t);
      f.axis = surface.mesh.area_normal(t).normalized();
      f.origin = surface.mesh.centroid(t);
    }
  }
  Geometry geometry() const { return {&faces, &edges, &vertices, nullptr}; }
  LabelledSurface surface;
  std::vector<CadFace> faces;
  std::vector<CadEdge> edges;
  std::vector<CadVertex> vertices;
};

Regions regions_of(const PlanarPart& part) {
  Regions r;
  r.mesh = part.surface.mesh;
  for (int f : part.surface.mesh.triangle_face) r.site.push_back(f - 1);
  for (std::size_t f = 1; f <= part.faces.size(); ++f) r.site_face.push_back(static_cast<int>(f));
  return r;
}

}  // namespace

TEST_CASE("the macro graph scores labels as the surface itself would") {
  for (const auto& voxels : {unit_box(), ell(), plate_with_hole(), plate_with_boss(), blind_pocket(), staircase(), hollow_box()}) {
    const PlanarPart part(voxels);
    const Regions regions = regions_of(part);
    const Partition partition = make_partition(regions.mesh, regions.site);
    const MacroGraph graph = make_macro_graph(regions, partition, 1);
    LabelScorer scorer(1, 0.75);
    unsigned random = 7;
    for (int round = 0; round < 40; ++round) {
      std::vector<Label> labels(graph.site_count());
      LabelledSurface surface = part.surface;
      for (int s = 0; s < graph.site_count(); ++s) {
        labels[s] = part.surface.label[partition.parts[s].triangles.front()];
        random = random * 1664525u + 1013904223u;
        if (round > 0 && (random >> 16) % 5 == 0) labels[s] = static_cast<Label>((random >> 20) % 6);
      }
      for (int t = 0; t < surface.mesh.triangle_count(); ++t) surface.label[t] = labels[regions.site[t]];
      const LabelScore score = scorer.score(graph, labels);
      FeatureShape shape = make_feature_shape(surface);
      const ValidityReport report = check_validity(shape, 1);
      CHECK(scorer.charts.chart_count() == shape.chart_count());
      CHECK(scorer.charts.arc_count() == shape.arc_count());
      CHECK(scorer.charts.corner_count() == shape.corner_count());
      CHECK(score.valid() == report.valid());
      for (int condition = 1; condition <= 4; ++condition) {
        int direct = 0, macro = 0;
        for (const auto& v : report.violations) direct += v.condition == condition;
        for (const auto& i : scorer.checker.issues)
          macro += condition == (i.kind <= ChartIssue::NoBorder      ? 1
                                 : i.kind <= ChartIssue::CornerSigns ? 2
                                 : i.kind == ChartIssue::Turning     ? 3
                                                                     : 4);
        if (condition == 1) CHECK(direct == macro);
      }
      if (round == 0) {
        CHECK(score.valid());
        CHECK(score.defects == 0);
        CHECK(score.energy == doctest::Approx(scorer.score(graph, labels).energy));
      }
    }
  }
}

TEST_CASE("aligned parts keep their own labels") {
  for (const auto& voxels : {unit_box(), ell(), plate_with_hole(), plate_with_boss(), blind_pocket(), staircase(), hollow_box()}) {
    const PlanarPart part(voxels);
    LabelOptions options;
    options.size = 0.5;
    Context context;
    int fills = 0;
    const FillCheck fill = [&](const SurfaceMesh&, const FeatureShape&, bool) {
      ++fills;
      return FillOutcome{true, {}, {}};
    };
    const LabelResult result = label_regions(part.surface.mesh, part.geometry(), options, fill, context);
    CHECK(result.validity.valid());
    CHECK(result.filled);
    CHECK(result.defects == 0);
    CHECK(fills == 1);
    CHECK(result.surface.label == part.surface.label);
  }
}

TEST_CASE("a labelling that does not fill is given up for another, or returned as not filled") {
  const PlanarPart part(plate_with_boss());
  LabelOptions options;
  options.size = 0.5;
  options.max_expansions = 5;
  Context context;
  const FillCheck never = [](const SurfaceMesh&, const FeatureShape& shape, bool) {
    FillOutcome outcome;
    for (int c = 0; c < shape.chart_count(); ++c) outcome.charts.push_back(c);
    return outcome;
  };
  const LabelResult result = label_regions(part.surface.mesh, part.geometry(), options, never, context);
  CHECK(!result.filled);
}

TEST_CASE("cancel stops the search") {
  const PlanarPart part(staircase());
  Context context;
  context.is_cancelled = [] { return true; };
  CHECK_THROWS_AS(label_regions(part.surface.mesh, part.geometry(), LabelOptions(), nullptr, context), MeshingError);
}
