// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include <vector>

#include "base/context.h"
#include "fit/chain.h"
#include "fit/fit.h"
#include "fit/quad_net.h"
#include "fit/region_map.h"

namespace hexfeature {

/// A piece of a chart, cut by the CAD edges routed so far: its triangles on the part and its quads on the lattice have the
/// same outline, chain by chain.
struct Region {
  int chart = -1;
  std::vector<int> triangles, quads;
  RegionMap map;
  bool dirty = true;  ///< `map` is out of date
};

/// The state of boundary fitting (room-internal). The steps run in the order of the functions below.
struct BoundaryFit {
  BoundaryFit(HexComplex& complex, const SurfaceMesh& mesh, const FeatureShape& shape, const Geometry& geometry, const FitOptions& options,
              Context& context);

  /// Corners, arcs, and one region per chart.
  void start();
  /// Route the CAD edges that run inside charts (cad_edges.cpp), each cutting its region in two.
  void route_cad_edges();
  /// Bring every region's map up to date, then give every boundary node its place and position, every quad its CAD face.
  void finish();

  // Chains and regions.
  Vec2 flatten(int chart, const Vec3& lattice_point) const;
  void space(int chain);   ///< space_nodes, then the polyline's lattice positions; the regions on both sides become dirty
  void attach(int chain);  ///< enter the chain into border_of, border_index, quad_cut
  void detach(int chain);
  void update(int region);  ///< remap when dirty
  /// Cut `region` along the (attached) chain. False, and nothing changed, when part and lattice fall apart differently.
  bool split(int region, int chain);

  // Results.
  void place_nodes();
  void assign_faces();
  void collect_feature_edges();
  bool lies_on(int node, int edge) const;  ///< on the CAD edge or one of its ends
  /// Whether the node lies on another CAD edge that goes on from this one at a soft vertex.
  bool lies_beyond_soft_end(int node, int edge) const;
  /// A face narrower than an element may own no quad: those that cover most of it take its number, unless they lie along a sharp
  /// edge of their own face.
  void cover_narrow_faces();
  /// Throws MeshingError(NoMesh, "fit") when two nodes hold one CAD vertex: neither may move, so no smoothing can part them.
  void require_own_vertices() const;

  HexComplex& complex;
  const SurfaceMesh& mesh;
  const FeatureShape& shape;
  const Geometry& geometry;
  const FitOptions& options;
  Context& context;

  std::vector<Vec3> lattice;  ///< node positions as they came
  QuadNet net;
  std::vector<Chain> chains;
  std::vector<std::vector<Vec3>> chain_lattice;  ///< per chain: lattice position of each polyline vertex
  std::vector<int> corner_target;                ///< per corner: mesh vertex that it snaps to, or -1

  std::vector<int> border_of;     ///< per mesh halfedge: the chain it lies on, -1 = none
  std::vector<int> border_index;  ///< ... and the index of its start in that chain's vertices
  std::vector<char> quad_cut;     ///< per quad halfedge: it lies on a chain
  std::vector<int> node_taken;    ///< per node: number of chains through it
  int freely_turned = 0;          ///< routed curves that turn where the CAD edge does not

  std::vector<Region> regions;
  std::vector<int> region_of_triangle, region_of_quad;
  std::vector<Vec2> corner_flat;  ///< 3 per triangle: image in its region's plane
};

}  // namespace hexfeature
