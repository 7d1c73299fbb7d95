// HexFeatureWB - LGPL-2.1-or-later
#include "label/cut_tree.h"

#include <algorithm>

namespace hexfeature {
namespace {

constexpr int kKept = 24;            // cuttings whose triangles are kept
constexpr double kLeastPart = 0.02;  // h^2: splits into smaller parts are refused

std::vector<int> chain(const Regions& regions, const Partition& partition, int dart) {
  const auto& edge = partition.edges[dart / 2];
  if (dart % 2 == 0) return edge.halfedges;
  std::vector<int> result(edge.halfedges.rbegin(), edge.halfedges.rend());
  for (int& h : result) h = regions.mesh.opposite[h];
  return result;
}

}  // namespace

CutTree::CutTree(Regions regions, const Geometry& geometry, double size) : geometry_(geometry), size_(size) {
  Node root;
  root.partition = std::make_unique<Partition>(make_partition(regions.mesh, regions.site));
  root.graph = std::make_unique<MacroGraph>(make_macro_graph(regions, *root.partition, size));
  root.regions = std::make_unique<Regions>(std::move(regions));
  nodes_.push_back(std::move(root));
}

bool CutTree::apply(Regions& regions, const Partition& partition, const SiteCut& cut, std::vector<Label>& rim_labels) const {
  const double least = kLeastPart * size_ * size_;
  switch (cut.kind) {
    case SiteCut::Strip:
      return split_strip(regions, geometry_, cut.site, chain(regions, partition, cut.dart), cut.width, least);
    case SiteCut::Across:
      return split_across(regions, geometry_, cut.site, cut.axis, cut.coordinate, least);
    case SiteCut::Creases:
      return split_creases(regions, cut.site, cut.degrees, least);
    case SiteCut::Rim: {
      std::vector<int> halfedges;
      for (int d = 0; d < 2 * static_cast<int>(partition.edges.size()); ++d) {
        if (partition.left_of(d) != cut.site || !std::binary_search(cut.beyond.begin(), cut.beyond.end(), partition.right_of(d))) continue;
        const std::vector<int> more = chain(regions, partition, d);
        halfedges.insert(halfedges.end(), more.begin(), more.end());
      }
      return split_rim(regions, geometry_, cut.site, halfedges, cut.axis, cut.width, least, rim_labels);
    }
  }
  return false;
}

void CutTree::load(int cutting) {
  nodes_[cutting].used = ++clock_;
  if (nodes_[cutting].regions) return;
  const int parent = nodes_[cutting].parent;
  load(parent);
  auto regions = std::make_unique<Regions>(*nodes_[parent].regions);
  std::vector<Label> rim_labels;
  apply(*regions, *nodes_[parent].partition, nodes_[cutting].cut, rim_labels);
  Node& node = nodes_[cutting];
  node.partition = std::make_unique<Partition>(make_partition(regions->mesh, regions->site));
  node.regions = std::move(regions);
  drop_old(cutting);
}

void CutTree::drop_old(int keep) {
  int loaded = 0, oldest = -1;
  for (int i = 1; i < size(); ++i) {
    if (!nodes_[i].regions) continue;
    ++loaded;
    if (i != keep && (oldest < 0 || nodes_[i].used < nodes_[oldest].used)) oldest = i;
  }
  if (loaded <= kKept || oldest < 0) return;
  nodes_[oldest].regions.reset();
  nodes_[oldest].partition.reset();
}

int CutTree::child(int parent, const SiteCut& cut) {
  for (const auto& [known, id] : nodes_[parent].children)
    if (known == cut) return id;
  load(parent);
  Node node;
  node.parent = parent;
  node.depth = nodes_[parent].depth + 1;
  node.cut = cut;
  node.regions = std::make_unique<Regions>(*nodes_[parent].regions);
  if (!apply(*node.regions, *nodes_[parent].partition, cut, node.rim_labels)) {
    nodes_[parent].children.emplace_back(cut, -1);
    return -1;
  }
  node.partition = std::make_unique<Partition>(make_partition(node.regions->mesh, node.regions->site));
  node.graph = std::make_unique<MacroGraph>(make_macro_graph(*node.regions, *node.partition, size_, nodes_[parent].graph.get(), cut.site));
  node.used = ++clock_;
  const int id = size();
  nodes_[parent].children.emplace_back(cut, id);
  nodes_.push_back(std::move(node));
  drop_old(id);
  return id;
}

bool CutTree::redundant(int cutting, const std::vector<Label>& labels) const {
  for (int c = cutting; nodes_[c].parent >= 0; c = nodes_[c].parent) {
    const int site = nodes_[c].cut.site, first = nodes_[nodes_[c].parent].graph->site_count(), last = nodes_[c].graph->site_count();
    bool same = true;
    for (int s = first; s < last && same; ++s) same = labels[s] == labels[site];
    // Parts that were split again may differ further down.
    for (int d = cutting; d != c && same; d = nodes_[d].parent) {
      const int again = nodes_[d].cut.site;
      same = again != site && (again < first || again >= last);
    }
    if (same) return true;
  }
  return false;
}

const Regions& CutTree::regions(int cutting) {
  load(cutting);
  return *nodes_[cutting].regions;
}

std::vector<int> CutTree::halfedges(int cutting, int dart) {
  load(cutting);
  return chain(*nodes_[cutting].regions, *nodes_[cutting].partition, dart);
}

double CutTree::extent(int cutting, int dart) {
  Node& node = nodes_[cutting];
  if (node.extent.empty()) node.extent.assign(2 * node.graph->edges.size(), -1);
  if (node.extent[dart] < 0) {
    load(cutting);
    node.extent[dart] = strip_extent(*node.regions, node.graph->left_of(dart), chain(*node.regions, *node.partition, dart));
  }
  return node.extent[dart];
}

}  // namespace hexfeature
