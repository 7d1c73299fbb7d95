// HexFeatureWB - LGPL-2.1-or-later
#include <doctest/doctest.h>

#include <vector>

#include "pipeline/faithfulness.h"

using namespace hexfeature;

TEST_CASE("sharp edges without mesh edges: only the solid's own, and no seams, points or smooth borders") {
  std::vector<CadFace> faces(3);
  faces[0].solid = faces[1].solid = 1;
  faces[2].solid = 2;
  std::vector<CadEdge> edges(7);
  for (CadEdge& e : edges) {
    e.sharp = true;
    e.faces = {1, 2};
    e.length = 1;
  }
  edges[0].length = 6;
  edges[1].length = 2;
  edges[2].seam = true;
  edges[3].degenerate = true;
  edges[4].sharp = false;
  edges[5].faces = {3, 3};
  edges[6].length = 2;
  const std::vector<CadVertex> vertices;
  const Geometry geometry{&faces, &edges, &vertices, nullptr};
  HexComplex mesh;
  mesh.feature_edge_cad = {1, 1, 7, 0};
  const EdgesLeftOut one = sharp_edges_left_out(mesh, geometry, 1);
  CHECK(one.edges == std::vector<int>{2});
  CHECK(one.share == doctest::Approx(0.2));
  CHECK(sharp_edges_left_out(mesh, geometry, 0).edges == std::vector<int>{2, 6});
  CHECK(sharp_edges_left_out(mesh, geometry, 2).share == 1);
  mesh.feature_edge_cad = {1, 2, 7};
  CHECK(sharp_edges_left_out(mesh, geometry, 1).edges.empty());
  CHECK(sharp_edges_left_out(mesh, geometry, 1).share == 0);
}
