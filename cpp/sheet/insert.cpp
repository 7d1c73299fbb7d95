// HexFeatureWB - LGPL-2.1-or-later
// Fill the gap that a shrink set leaves (experiments B3).
#include <algorithm>
#include <map>

#include "sheet/edge_angle.h"
#include "sheet/shrink_set.h"

namespace hexfeature {
namespace {

// Cosine of 155 degrees: the largest corner, as inserted, of a quad that the sheet may leave on an arc.
constexpr double kBend = -0.906;
constexpr double kFold = 0.5;  // ... and the least, 60 degrees

// Local corner of hexahedron `nodes` at node v.
int corner_of(const std::array<int, 8>& nodes, int v) { return static_cast<int>(std::find(nodes.begin(), nodes.end(), v) - nodes.begin()); }

// The other face of a hexahedron at the edge (a, b) of its face f.
int across(const std::array<int, 8>& nodes, int f, int a, int b) {
  for (int g = 0; g < 6; ++g) {
    if (g == f) continue;
    int hits = 0;
    for (int c : kHexFaces[g]) hits += nodes[c] == a || nodes[c] == b;
    if (hits == 2) return g;
  }
  return -1;
}

class Inserter {
 public:
  Inserter(const HexComplex& complex, const HexTopology& topology, const FeatureShape& shape, const Geometry& geometry,
           const ShrinkSet& set, double thickness, const Context& context)
      : old_(complex),
        topology_(topology),
        shape_(shape),
        geometry_(geometry),
        set_(set),
        thickness_(thickness),
        context_(context),
        result_(complex) {}

  LayerRefusal run(HexComplex& complex) {
    collect_sheet();
    if (sheet_.empty()) return {"the sheet would be empty", {}};
    context_.check();
    collect_copies();
    context_.check();
    for (const Copy& c : copies_) add_node(c);
    if (refusal_.refused()) return refusal_;
    context_.check();
    add_layer();
    move_quads();
    move_feature_edges();
    check_curves();
    if (refusal_.refused()) return refusal_;
    const std::string wrong = check_complex(result_, context_);
    if (!wrong.empty()) return {wrong, {}};
    complex = std::move(result_);
    return {};
  }

 private:
  // The hexahedra of the shrink set round one node of the sheet that hang together by faces: they share one copy of it.
  struct Copy {
    int node;
    std::vector<int> hexes;
    std::vector<int> free_quads;
    std::vector<const HexTopology::Edge*> free_edges;  // boundary edges at the node between two of free_quads
  };

  bool on_sheet(int side) const {
    if (!set_.inside[side / 6]) return false;
    const int other = topology_.neighbour[side];
    return other >= 0 ? !set_.inside[other / 6] : is_covered(-1 - other);
  }
  bool is_covered(int quad) const {
    const int c = old_.quad_chart[quad];
    return c >= 0 && set_.covered[c];
  }

  void collect_sheet() {
    for (int s = 0; s < static_cast<int>(topology_.neighbour.size()); ++s)
      if (on_sheet(s)) sheet_.push_back(s);
  }

  void collect_copies() {
    std::vector<char> at_sheet(old_.points.size(), 0);
    for (int s : sheet_)
      for (int c : kHexFaces[s % 6]) at_sheet[old_.hexes[s / 6][c]] = 1;
    struct Use {
      int node, hex;
    };
    std::vector<Use> uses;
    for (int h = 0; h < old_.hex_count(); ++h)
      if (set_.inside[h])
        for (int v : old_.hexes[h])
          if (at_sheet[v]) uses.push_back({v, h});
    std::sort(uses.begin(), uses.end(), [](const Use& a, const Use& b) { return a.node != b.node ? a.node < b.node : a.hex < b.hex; });
    copy_at_.assign(8 * old_.hexes.size(), -1);
    for (std::size_t i = 0; i < uses.size();) {
      std::size_t j = i;
      std::vector<int> round;
      for (; j < uses.size() && uses[j].node == uses[i].node; ++j) round.push_back(uses[j].hex);
      split_round(uses[i].node, round);
      i = j;
    }
  }

  // One copy for each face-connected set of the shrinking hexahedra `round` a node (sorted) that the sheet touches.
  void split_round(int node, const std::vector<int>& round) {
    std::vector<char> seen(round.size(), 0);
    for (std::size_t seed = 0; seed < round.size(); ++seed) {
      if (seen[seed]) continue;
      Copy copy{node, {}, {}, {}};
      bool touched = false;
      std::vector<std::size_t> stack{seed};
      seen[seed] = 1;
      while (!stack.empty()) {
        const int h = round[stack.back()];
        stack.pop_back();
        copy.hexes.push_back(h);
        const int corner = corner_of(old_.hexes[h], node);
        for (int f = 0; f < 6; ++f) {
          if (std::find(kHexFaces[f].begin(), kHexFaces[f].end(), corner) == kHexFaces[f].end()) continue;
          const int side = 6 * h + f, other = topology_.neighbour[side];
          if (on_sheet(side)) {
            touched = true;
          } else if (other < 0) {
            copy.free_quads.push_back(-1 - other);
          } else {
            const std::size_t k = std::lower_bound(round.begin(), round.end(), other / 6) - round.begin();
            if (!seen[k]) {
              seen[k] = 1;
              stack.push_back(k);
            }
          }
        }
      }
      if (!touched) continue;
      std::sort(copy.hexes.begin(), copy.hexes.end());
      std::sort(copy.free_quads.begin(), copy.free_quads.end());
      collect_free_edges(copy);
      const int id = old_.point_count() + static_cast<int>(copies_.size());
      for (int h : copy.hexes) copy_at_[8 * h + corner_of(old_.hexes[h], node)] = id;
      copies_.push_back(std::move(copy));
    }
  }

  void collect_free_edges(Copy& copy) const {
    for (int q : copy.free_quads) {
      const auto& n = old_.quads[q];
      const int i = static_cast<int>(std::find(n.begin(), n.end(), copy.node) - n.begin());
      // Each edge at the node once: as the one that leaves it in the counter-clockwise quad.
      const HexTopology::Edge* e = topology_.find_edge(copy.node, n[(i + 1) % 4]);
      const int other = e->quads[0] == q ? e->quads[1] : e->quads[0];
      if (std::binary_search(copy.free_quads.begin(), copy.free_quads.end(), other) && joined_inside(*e)) copy.free_edges.push_back(e);
    }
  }

  int far_end(const HexTopology::Edge& e, int v) const { return e.nodes[0] == v ? e.nodes[1] : e.nodes[0]; }

  void add_node(const Copy& copy) {
    const HexTopology::Edge *curve = nullptr, *arc = nullptr;  // the copy slides along these
    int curves = 0, arcs = 0;
    for (const auto* e : copy.free_edges) {
      if (feature_of(old_, e->nodes[0], e->nodes[1])) curve = e, ++curves;
      if (old_.quad_chart[e->quads[0]] != old_.quad_chart[e->quads[1]]) arc = e, ++arcs;
    }
    if (curves > 1 || arcs > 1) {
      refusal_.reason = "the sheet would cut a corner off the part";
      return;
    }
    CadPlace place;
    ShapePlace shape_place;
    Vec3 point;
    if (copy.free_quads.empty()) {
      point = old_.points[copy.node] + thickness_ * inner_offset(copy);
    } else {
      const HexTopology::Edge* track = curve ? curve : arc;
      point = old_.points[copy.node] +
              thickness_ * (track ? old_.points[far_end(*track, copy.node)] - old_.points[copy.node] : surface_offset(copy));
      shape_place = arc ? ShapePlace{1, arc_between(*arc)} : ShapePlace{2, old_.quad_chart[copy.free_quads.front()]};
      place = curve ? CadPlace{1, feature_of(old_, curve->nodes[0], curve->nodes[1]), Vec2::Zero()}
                    : CadPlace{2, common_face(copy), Vec2::Zero()};
      settle(old_.place[copy.node], place, point);
    }
    result_.points.push_back(point);
    result_.place.push_back(place);
    if (!old_.shape_place.empty()) result_.shape_place.push_back(shape_place);
  }

  // Away from the sheet: per hexahedron along its edge (one face on the sheet), face diagonal (two) or diagonal (three), mean.
  // Diagonals, because at a smooth border the two edges themselves point apart.
  Vec3 inner_offset(const Copy& copy) const {
    Vec3 sum = Vec3::Zero();
    int count = 0;
    for (int h : copy.hexes) {
      const auto& n = old_.hexes[h];
      const int corner = corner_of(n, copy.node);
      std::array<char, 8> on{};  // corners on sheet faces at this node, counted
      int faces = 0;
      for (int f = 0; f < 6; ++f)
        if (std::find(kHexFaces[f].begin(), kHexFaces[f].end(), corner) != kHexFaces[f].end() && on_sheet(6 * h + f)) {
          ++faces;
          for (int c : kHexFaces[f]) ++on[c];
        }
      if (faces == 0) continue;
      int target = -1;
      if (faces == 1) {
        for (int k = 1; k < 4; ++k)
          if (!on[kHexCorners[corner][k]]) target = kHexCorners[corner][k];
      } else if (faces == 2) {  // opposite the node in the face that is not on the sheet
        for (int f = 0; f < 6; ++f) {
          const auto at = std::find(kHexFaces[f].begin(), kHexFaces[f].end(), corner);
          if (at != kHexFaces[f].end() && !on_sheet(6 * h + f)) target = kHexFaces[f][(at - kHexFaces[f].begin() + 2) % 4];
        }
      } else {
        for (int c = 0; c < 8; ++c)
          if (!on[c]) target = c;
      }
      sum += old_.points[n[target]] - old_.points[copy.node];
      ++count;
    }
    return count ? Vec3(sum / count) : sum;
  }

  // The same in the free quads round a node where the sheet leaves.
  Vec3 surface_offset(const Copy& copy) const {
    Vec3 sum = Vec3::Zero();
    int count = 0;
    for (int q : copy.free_quads) {
      const auto& n = old_.quads[q];
      const int i = static_cast<int>(std::find(n.begin(), n.end(), copy.node) - n.begin());
      const bool next_free = is_free_edge(copy, n[(i + 1) % 4]), back_free = is_free_edge(copy, n[(i + 3) % 4]);
      if (next_free && back_free) continue;
      const int target = next_free ? n[(i + 1) % 4] : back_free ? n[(i + 3) % 4] : n[(i + 2) % 4];
      sum += old_.points[target] - old_.points[copy.node];
      ++count;
    }
    return count ? Vec3(sum / count) : sum;
  }
  bool is_free_edge(const Copy& copy, int far) const {
    return std::any_of(copy.free_edges.begin(), copy.free_edges.end(), [&](const auto* e) { return far_end(*e, copy.node) == far; });
  }

  int arc_between(const HexTopology::Edge& e) const {
    if (old_.shape_place.empty()) return -1;
    for (int v : e.nodes)
      if (old_.shape_place[v].dim == 1) return old_.shape_place[v].item;
    const int a = old_.quad_chart[e.quads[0]], b = old_.quad_chart[e.quads[1]];
    const int m = old_.shape_place[e.nodes[0]].item, n = old_.shape_place[e.nodes[1]].item;
    int found = -1;
    for (int i = 0; i < shape_.arc_count(); ++i) {
      const auto& arc = shape_.cells.edges[i];
      if ((arc.left == a && arc.right == b) || (arc.left == b && arc.right == a)) {
        if ((arc.start == m && arc.end == n) || (arc.start == n && arc.end == m)) return i;
        if (found < 0) found = i;
      }
    }
    return found;
  }

  // The CAD face of most of the free quads (smaller number first).
  int common_face(const Copy& copy) const {
    std::map<int, int> count;
    for (int q : copy.free_quads) ++count[old_.quad_face[q]];
    int best = 0, most = 0;
    for (const auto& [face, n] : count)
      if (n > most) best = face, most = n;
    return best;
  }

  // Onto the CAD entity, starting from the original node's parameters where it lies on the same one.
  void settle(const CadPlace& from, CadPlace& place, Vec3& point) const {
    if (!geometry_.projector || place.entity <= 0) return;
    const bool same = from.dim == place.dim && from.entity == place.entity;
    if (place.dim == 1) {
      const CurvePoint p = geometry_.projector->project_to_edge(place.entity, point, same ? &from.uv[0] : nullptr);
      point = p.point;
      place.uv = Vec2(p.t, 0);
    } else {
      const FacePoint p = geometry_.projector->project_to_face(place.entity, point, same ? &from.uv : nullptr);
      point = p.point;
      place.uv = p.uv;
    }
  }

  // Node of hexahedron h at local corner c, after the shrinking.
  int shrunk(int h, int c) const {
    const int copy = copy_at_[8 * h + c];
    return copy >= 0 ? copy : old_.hexes[h][c];
  }

  void add_layer() {
    for (int h = 0; h < old_.hex_count(); ++h)
      for (int c = 0; c < 8; ++c) result_.hexes[h][c] = shrunk(h, c);
    // Sheet hexahedra of one block and one side of it make a block: (block, block beyond or -1 - chart).
    std::map<std::array<int, 2>, int> blocks;
    int next_block = 0;
    for (int b : old_.hex_block) next_block = std::max(next_block, b + 1);
    for (int s : sheet_) {
      const int h = s / 6, other = topology_.neighbour[s];
      std::array<int, 8> hex;
      for (int i = 0; i < 4; ++i) {
        const int c = kHexFaces[s % 6][i];
        hex[i] = shrunk(h, c);
        hex[4 + i] = old_.hexes[h][c];
      }
      const std::array<int, 2> key{old_.hex_block[h], other >= 0 ? old_.hex_block[other / 6] : -1 - old_.quad_chart[-1 - other]};
      const auto [it, fresh] = blocks.try_emplace(key, next_block);
      if (fresh) ++next_block;
      result_.hexes.push_back(hex);
      result_.hex_solid.push_back(old_.hex_solid[h]);
      result_.hex_block.push_back(it->second);
      for (int i = 0; i < 4; ++i) {
        const int quad = exit_quad(s, hex[4 + i], hex[4 + (i + 1) % 4]);
        if (quad < 0) continue;
        result_.quads.push_back({hex[i], hex[(i + 1) % 4], hex[4 + (i + 1) % 4], hex[4 + i]});
        result_.quad_chart.push_back(old_.quad_chart[quad]);
        result_.quad_face.push_back(old_.quad_face[quad]);
      }
    }
  }

  // Turning inside the shrink set round edge (a, b) of sheet face `side`: the free quad at the end, or -1 (another sheet face).
  int exit_quad(int side, int a, int b) const {
    int h = side / 6, f = side % 6;
    for (int guard = 0; guard < 1000; ++guard) {
      const int g = across(old_.hexes[h], f, a, b), next = 6 * h + g;
      if (on_sheet(next)) return -1;
      const int other = topology_.neighbour[next];
      if (other < 0) return -1 - other;
      h = other / 6, f = other % 6;
    }
    return -1;
  }

  void move_quads() {
    for (std::size_t q = 0; q < old_.quads.size(); ++q) {
      const int side = topology_.quad_side[q], h = side / 6;
      if (!set_.inside[h] || is_covered(static_cast<int>(q))) continue;
      for (int& v : result_.quads[q]) v = shrunk(h, corner_of(old_.hexes[h], v));
    }
  }

  // A feature edge between two free quads of the shrink set moves with them, and reaches back to where it was by the
  // edges between the old and the new nodes. All others stay.
  void move_feature_edges() {
    struct Item {
      std::array<int, 2> nodes;
      int cad;
    };
    std::vector<Item> items;
    const auto add = [&](int a, int b, int cad) { items.push_back({{std::min(a, b), std::max(a, b)}, cad}); };
    for (std::size_t i = 0; i < old_.feature_edges.size(); ++i) {
      const auto [a, b] = old_.feature_edges[i];
      const int cad = old_.feature_edge_cad[i];
      const auto* e = topology_.find_edge(a, b);
      bool free = e != nullptr;
      for (int k = 0; free && k < 2; ++k) free = set_.inside[topology_.hex_of_quad(e->quads[k])] && !is_covered(e->quads[k]);
      if (!free || !joined_inside(*e)) {
        add(a, b, cad);
        continue;
      }
      const int h = topology_.hex_of_quad(e->quads[0]);
      const int a2 = shrunk(h, corner_of(old_.hexes[h], a)), b2 = shrunk(h, corner_of(old_.hexes[h], b));
      add(a2, b2, cad);
      if (a2 != a) add(a, a2, cad);
      if (b2 != b) add(b, b2, cad);
    }
    std::sort(items.begin(), items.end(),
              [](const Item& x, const Item& y) { return x.nodes != y.nodes ? x.nodes < y.nodes : x.cad < y.cad; });
    result_.feature_edges.clear();
    result_.feature_edge_cad.clear();
    for (const Item& i : items) {
      if (!result_.feature_edges.empty() && result_.feature_edges.back() == i.nodes) continue;
      result_.feature_edges.push_back(i.nodes);
      result_.feature_edge_cad.push_back(i.cad);
    }
  }

  // A new quad with two neighbouring edges on one CAD edge would have a corner of 180 degrees, unless that edge is a tight arc. Sets the
  // refusal.
  void check_curves() {
    for (std::size_t q = old_.quads.size(); q < result_.quads.size(); ++q)
      for (int i = 0; i < 4; ++i) {
        const auto& n = result_.quads[q];
        const int cad = feature_of(result_, n[i], n[(i + 1) % 4]), node = n[(i + 1) % 4];
        if (cad == 0 || cad != feature_of(result_, node, n[(i + 2) % 4])) continue;
        const Vec3 back = result_.points[n[i]] - result_.points[node], on = result_.points[n[(i + 2) % 4]] - result_.points[node];
        const double cosine = back.dot(on) / (back.norm() * on.norm());  // not a number where an edge has no length
        if (cosine > kBend && cosine < kFold) continue;                  // the edge bends enough by itself
        refusal_.reason = "the sheet would leave along CAD edge " + std::to_string(cad) + " and turn off it within one quad";
        const int old_node = node < old_.point_count() ? node : copies_[node - old_.point_count()].node;
        for (std::size_t e = 0; e < old_.feature_edges.size(); ++e) {
          const auto& nodes = old_.feature_edges[e];
          const auto* edge = topology_.find_edge(nodes[0], nodes[1]);
          if (!edge || old_.feature_edge_cad[e] != cad || (nodes[0] != old_node && nodes[1] != old_node)) continue;
          const auto begin = topology_.edge_hexes.begin() + edge->first;
          refusal_.together.emplace_back(begin, begin + edge->count);
        }
      }
    std::sort(refusal_.together.begin(), refusal_.together.end());
    refusal_.together.erase(std::unique(refusal_.together.begin(), refusal_.together.end()), refusal_.together.end());
  }

  // All hexahedra round a boundary edge shrink: no sheet face there.
  bool joined_inside(const HexTopology::Edge& e) const {
    for (int i = 0; i < e.count; ++i)
      if (!set_.inside[topology_.edge_hexes[e.first + i]]) return false;
    return true;
  }

  const HexComplex& old_;
  const HexTopology& topology_;
  const FeatureShape& shape_;
  const Geometry& geometry_;
  const ShrinkSet& set_;
  double thickness_;
  const Context& context_;
  HexComplex result_;
  std::vector<int> sheet_;  // sides of shrinking hexahedra that the sheet lies on
  std::vector<Copy> copies_;
  std::vector<int> copy_at_;  // per hexahedron corner: its new node, or -1
  LayerRefusal refusal_;
};

}  // namespace

LayerRefusal insert_layer(HexComplex& complex, const HexTopology& topology, const FeatureShape& shape, const Geometry& geometry,
                          const ShrinkSet& set, const SheetOptions& options, const Context& context) {
  return Inserter(complex, topology, shape, geometry, set, options.thickness, context).run(complex);
}

}  // namespace hexfeature
