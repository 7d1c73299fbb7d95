// HexFeatureWB - LGPL-2.1-or-later
#include "tetsplit/remesh.h"

#include <algorithm>
#include <cmath>

namespace hexfeature {
namespace {

constexpr double kLong = 4.0 / 3, kShort = 0.8;  ///< of the wanted length: Botsch and Kobbelt's bounds
constexpr double kFacing = 0.35;                 ///< least cosine between a triangle's normal and the surface's at its corners

/// Candidates in a fixed order: by key, then by number.
struct Ranked {
  double key;
  int h;
  bool operator<(const Ranked& o) const { return key != o.key ? key < o.key : h < o.h; }
};

}  // namespace

Remesher::Remesher(const SurfaceMesh& mesh, const Geometry& geometry, double tiny)
    : geometry_(geometry),
      tiny_(tiny),
      points_(mesh.points),
      place_(mesh.place),
      pinned_(mesh.points.size(), 0),
      out_(mesh.points.size(), -1),
      triangles_(mesh.triangles),
      face_(mesh.triangle_face),
      normals_(mesh.corner_normals),
      edge_(mesh.halfedge_edge),
      opposite_(mesh.opposite) {
  for (int& e : edge_)
    if (e > 0 && (geometry.edge(e).seam || geometry.edge(e).degenerate)) e = 0;
  for (int h = 0; h < static_cast<int>(opposite_.size()); ++h) out_[from(h)] = h;
  for (int v = 0; v < static_cast<int>(points_.size()); ++v) {
    if (out_[v] < 0 || place_[v].dim >= 2) continue;
    // Points of seams and poles belong to the face, unless it has a tip there.
    circulate(out_[v]);
    bool follows = false, tip = false;
    for (int h : ring_) {
      follows |= edge_[h] > 0;
      tip |= normals_[h].dot(normals_[ring_[0]]) < 0.9;
    }
    if (follows || (tip && place_[v].dim == 0)) continue;
    place_[v] = {2, face_[out_[v] / 3], Vec2::Zero()};
    place_[v].uv = geometry.projector->project_to_face(place_[v].entity, points_[v], nullptr).uv;
  }
}

void Remesher::circulate(int h) {
  ring_.clear();
  for (int g = h;;) {
    ring_.push_back(g);
    g = opposite_[prev(g)];
    if (g == h) break;
  }
}

double Remesher::shape(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& na, const Vec3& nb, const Vec3& nc) const {
  const Vec3 n = (b - a).cross(c - a);
  const double twice_area = n.norm();
  const double squares = (b - a).squaredNorm() + (c - b).squaredNorm() + (a - c).squaredNorm();
  const double facing = std::min({n.dot(na), n.dot(nb), n.dot(nc)});
  if (!(twice_area > 0) || facing < kFacing * twice_area) return -1;
  return 2 * std::sqrt(3.0) * twice_area / squares;
}

double Remesher::shape(int t) const {
  const auto& v = triangles_[t];
  return shape(points_[v[0]], points_[v[1]], points_[v[2]], normals_[3 * t], normals_[3 * t + 1], normals_[3 * t + 2]);
}

void Remesher::split(int h, const LengthAt& length) {
  // Triangles a b c and b a d become a m c, m b c, m a d, b m d.
  const int g = opposite_[h], t = h / 3, u = g / 3;
  const int hn = next(h), hp = prev(h), gp = prev(g);
  const int b = to(h), c = from(hp), d = from(gp), m = static_cast<int>(points_.size());
  const Vec3 middle = 0.5 * (points_[from(h)] + points_[b]);
  CadPlace place;
  Vec3 point, normal_t, normal_u;
  if (edge_[h] > 0) {
    const CurvePoint foot = geometry_.projector->project_to_edge(edge_[h], middle, nullptr);
    place = {1, edge_[h], {foot.t, 0}};
    point = foot.point;
    normal_t = geometry_.projector->project_to_face(face_[t], point, nullptr).normal;
    normal_u = face_[u] == face_[t] ? normal_t : geometry_.projector->project_to_face(face_[u], point, nullptr).normal;
  } else {
    const FacePoint foot = geometry_.projector->project_to_face(face_[t], middle, nullptr);
    place = {2, face_[t], foot.uv};
    point = foot.point;
    normal_t = normal_u = foot.normal;
  }
  points_.push_back(point);
  place_.push_back(place);
  length_.push_back(length(point));
  pinned_.push_back(0);

  const int tn = static_cast<int>(triangles_.size()), un = tn + 1;
  const Vec3 normal_b_t = normals_[hn], normal_b_u = normals_[g];
  triangles_.push_back({m, b, c});
  face_.push_back(face_[t]);
  normals_.insert(normals_.end(), {normal_t, normal_b_t, normals_[hp]});
  edge_.insert(edge_.end(), {edge_[h], edge_[hn], 0});
  triangles_.push_back({b, m, d});
  face_.push_back(face_[u]);
  normals_.insert(normals_.end(), {normal_b_u, normal_u, normals_[gp]});
  edge_.insert(edge_.end(), {edge_[g], 0, edge_[gp]});
  // Old triangles: a m c and m a d.
  triangles_[t][hn % 3] = m;
  normals_[hn] = normal_t;
  triangles_[u][g % 3] = m;
  normals_[g] = normal_u;
  opposite_.resize(opposite_.size() + 6);
  const auto glue = [&](int x, int y) {
    opposite_[x] = y;
    opposite_[y] = x;
  };
  glue(3 * tn + 1, opposite_[hn]);
  glue(3 * un + 2, opposite_[gp]);
  edge_[hn] = 0;
  edge_[gp] = 0;
  glue(hn, 3 * tn + 2);
  glue(gp, 3 * un + 1);
  glue(3 * tn, 3 * un);
  glue(h, g);
  out_.push_back(3 * tn);
  out_[b] = 3 * tn + 1;
  out_[c] = hp;
  out_[d] = gp;
}

bool Remesher::may_vanish(int h) const {
  const int a = from(h), b = to(h);
  if (pinned_[a]) return false;
  if (place_[a].dim == 2) return true;
  if (edge_[h] == 0) return false;
  if (place_[a].dim == 1) return place_[b].dim <= 1;
  return place_[b].dim == 0 && geometry_.edge(edge_[h]).length < tiny_;
}

bool Remesher::collapse(int h, bool forced) {
  // a -> b; triangles a b c and b a d vanish.
  const int a = from(h), b = to(h), g = opposite_[h];
  const int hn = next(h), hp = prev(h), gn = next(g), gp = prev(g);
  const int c = from(hp), d = from(gp);
  if (c == d || (!forced && ((edge_[hn] > 0 && edge_[hp] > 0) || (edge_[gn] > 0 && edge_[gp] > 0)))) return false;
  const bool any_length = forced || place_[a].dim == 0;
  circulate(next(g));  // ring of a, beginning with a -> d
  other_ring_ = ring_;
  circulate(hn);  // ring of b
  for (int x : ring_)
    for (int y : other_ring_)
      if (to(x) == to(y) && to(x) != c && to(x) != d) return false;
  circulate(hp);
  if (ring_.size() <= 3) return false;
  circulate(gp);
  if (ring_.size() <= 3) return false;
  // The normal at b that each changed triangle will have: that of a triangle of its face at b.
  circulate(hn);
  const auto normal_at_b = [&](int face) -> Vec3 {
    for (int x : ring_)
      if (face_[x / 3] == face) return normals_[x];
    return geometry_.projector->project_to_face(face, points_[b], nullptr).normal;
  };
  double before = 1, after = 1;
  for (int x : other_ring_) {
    const int t = x / 3;
    before = std::min(before, shape(t));
    if (t == h / 3 || t == g / 3) continue;
    const int y = next(x), z = prev(x);
    after = std::min(after, shape(points_[b], points_[from(y)], points_[from(z)], normal_at_b(face_[t]), normals_[y], normals_[z]));
    if (!any_length && (points_[b] - points_[from(y)]).norm() > kLong * 0.5 * (length_[b] + length_[from(y)])) return false;
    if (after < 0) return false;
  }
  if (!forced && after < 0.3 && after < 0.9 * before) return false;

  for (int x : other_ring_) {
    const int t = x / 3;
    if (t == h / 3 || t == g / 3) continue;
    const Vec3 n = normal_at_b(face_[t]);
    normals_[x] = n;
    triangles_[t][x % 3] = b;
  }
  const auto glue = [&](int x, int y) {
    const int e = std::max(edge_[x], edge_[y]);
    edge_[x] = edge_[y] = e;
    opposite_[x] = y;
    opposite_[y] = x;
  };
  const int hn_o = opposite_[hn], hp_o = opposite_[hp], gn_o = opposite_[gn], gp_o = opposite_[gp];
  edge_[hn_o] = edge_[hp_o] = std::max(edge_[hn], edge_[hp]);
  edge_[gn_o] = edge_[gp_o] = std::max(edge_[gn], edge_[gp]);
  glue(hn_o, hp_o);
  glue(gn_o, gp_o);
  out_[a] = -1;
  out_[b] = hn_o >= 0 && from(hn_o) == c ? opposite_[hn_o] : hn_o;
  out_[c] = from(hn_o) == c ? hn_o : hp_o;
  out_[d] = from(gn_o) == d ? gn_o : gp_o;
  triangles_[h / 3] = triangles_[g / 3] = {-1, -1, -1};
  return true;
}

bool Remesher::flip(int h, bool forced) {
  // Triangles a b c and b a d become c d b and d c a.
  const int g = opposite_[h], t = h / 3, u = g / 3;
  if (edge_[h] > 0 || face_[t] != face_[u]) return false;
  const int hn = next(h), hp = prev(h), gn = next(g), gp = prev(g);
  const int a = from(h), b = to(h), c = from(hp), d = from(gp);
  if (c == d) return false;
  const double before = std::min(shape(t), shape(u));
  const Vec3 na = normals_[h], nb = normals_[hn], nc = normals_[hp], nd = normals_[gp];
  const double after =
      std::min(shape(points_[c], points_[d], points_[b], nc, nd, nb), shape(points_[d], points_[c], points_[a], nd, nc, na));
  if (after < 0 || (!forced && after < 1.05 * before)) return false;
  circulate(hp);
  for (int x : ring_)
    if (to(x) == d) return false;
  circulate(h);
  if (ring_.size() <= 3) return false;
  circulate(g);
  if (ring_.size() <= 3) return false;
  const std::array<int, 4> o{opposite_[hn], opposite_[hp], opposite_[gn], opposite_[gp]};
  const std::array<int, 4> e{edge_[hn], edge_[hp], edge_[gn], edge_[gp]};
  // t: c d b (halfedges cd, db, bc); u: d c a (dc, ca, ad).
  triangles_[t] = {c, d, b};
  triangles_[u] = {d, c, a};
  normals_[3 * t] = nc, normals_[3 * t + 1] = nd, normals_[3 * t + 2] = nb;
  normals_[3 * u] = nd, normals_[3 * u + 1] = nc, normals_[3 * u + 2] = na;
  const auto glue = [&](int x, int y, int edge) {
    opposite_[x] = y;
    opposite_[y] = x;
    edge_[x] = edge_[y] = edge;
  };
  glue(3 * t, 3 * u, 0);
  glue(3 * t + 1, o[3], e[3]);
  glue(3 * t + 2, o[0], e[0]);
  glue(3 * u + 1, o[1], e[1]);
  glue(3 * u + 2, o[2], e[2]);
  out_[a] = 3 * u + 2;
  out_[b] = 3 * t + 2;
  out_[c] = 3 * t;
  out_[d] = 3 * u;
  return true;
}

bool Remesher::slide(int v, const LengthAt& length) {
  if (place_[v].dim == 0 || pinned_[v]) return false;
  circulate(out_[v]);
  CadPlace place = place_[v];
  Vec3 point;
  if (place.dim == 1) {
    Vec3 sum = Vec3::Zero();
    int n = 0;
    for (int h : ring_)
      if (edge_[h] == place.entity) sum += points_[to(h)], ++n;
    if (n != 2) return false;
    const CurvePoint foot = geometry_.projector->project_to_edge(place.entity, 0.5 * sum, nullptr);
    point = foot.point;
    place.uv[0] = foot.t;
  } else {
    Vec3 sum = Vec3::Zero();
    double weights = 0;
    for (int h : ring_) {
      // Towards even areas and, where the wanted length changes, towards the finer side.
      const double w = 1 / (length_[to(h)] * length_[to(h)]);
      sum += w * points_[to(h)];
      weights += w;
    }
    const FacePoint foot = geometry_.projector->project_to_face(place.entity, sum / weights, &place.uv);
    point = foot.point;
    place.uv = foot.uv;
  }
  if (!point.allFinite()) return false;
  std::vector<Vec3>& normal = slide_normals_;
  normal.clear();
  double before = 1, after = 1;
  int known_face = 0;
  Vec3 known = Vec3::Zero();
  for (int h : ring_) {
    const int t = h / 3, y = next(h), z = prev(h);
    if (face_[t] != known_face) {
      known_face = face_[t];
      const Vec2* guess = place.dim == 2 ? &place.uv : nullptr;
      known = geometry_.projector->project_to_face(known_face, point, guess).normal;
    }
    normal.push_back(known);
    before = std::min(before, shape(t));
    after = std::min(after, shape(point, points_[from(y)], points_[from(z)], known, normals_[y], normals_[z]));
  }
  if (after < 0 || (after < before && after < 0.6)) return false;
  points_[v] = point;
  place_[v] = place;
  length_[v] = length(point);
  for (std::size_t i = 0; i < ring_.size(); ++i) normals_[ring_[i]] = normal[i];
  return true;
}

void Remesher::split_long(double factor, const LengthAt& length, Context& context) {
  std::vector<Ranked> queue;
  for (int round = 0; round < 20; ++round) {
    context.check();
    queue.clear();
    for (int h = 0; h < static_cast<int>(opposite_.size()); ++h)
      if (alive(h / 3) && h < opposite_[h] && edge_length(h) > factor * wanted(h)) queue.push_back({edge_length(h) / wanted(h), h});
    if (queue.empty()) return;
    std::sort(queue.begin(), queue.end(), [](const Ranked& x, const Ranked& y) { return y < x; });
    for (std::size_t i = 0; i < queue.size(); ++i) {
      if (i % 32 == 0) context.check();  // a projection onto a spline takes its time
      if (edge_length(queue[i].h) > factor * wanted(queue[i].h)) split(queue[i].h, length);
    }
  }
}

void Remesher::collapse_short(Context& context) {
  context.check();
  std::vector<Ranked> queue;
  for (int h = 0; h < static_cast<int>(opposite_.size()); ++h) {
    if (!alive(h / 3) || !may_vanish(h)) continue;
    const double ratio = edge_length(h) / wanted(h);
    if (ratio < kShort || place_[from(h)].dim == 0) queue.push_back({ratio, h});
  }
  context.check();
  std::sort(queue.begin(), queue.end());
  for (std::size_t i = 0; i < queue.size(); ++i) {
    if (i % 32 == 0) context.check();
    const int h = queue[i].h;
    if (alive(h / 3) && may_vanish(h) && (edge_length(h) < kShort * wanted(h) || place_[from(h)].dim == 0)) collapse(h);
  }
}

void Remesher::flip_all(Context& context) {
  for (int round = 0, flips = 1; round < 10 && flips > 0; ++round) {
    flips = 0;
    for (int h = 0; h < static_cast<int>(opposite_.size()); ++h) {
      if (h % 4096 == 0) context.check();
      if (alive(h / 3) && h < opposite_[h] && flip(h)) ++flips;
    }
  }
}

void Remesher::want(const LengthAt& length, const Context& context) {
  length_.resize(points_.size());
  for (std::size_t v = 0; v < points_.size(); ++v) {
    if (v % 1024 == 0) context.check();
    length_[v] = length(points_[v]);
  }
}

void Remesher::refine(const LengthAt& length, Context& context) {
  want(length, context);
  for (int round = 0; round < 3; ++round) {
    split_long(kLong, length, context);
    flip_all(context);
  }
}

void Remesher::remesh(const LengthAt& length, int rounds, Context& context) {
  want(length, context);
  for (int round = 0; round < rounds; ++round) {
    split_long(kLong, length, context);
    collapse_short(context);
    flip_all(context);
    for (int sweep = 0; sweep < 2; ++sweep)
      for (int v = 0; v < static_cast<int>(points_.size()); ++v) {
        if (v % 32 == 0) context.check();
        if (out_[v] >= 0) slide(v, length);
      }
    flip_all(context);
  }
}

void Remesher::cut_ears(Context& context) {
  constexpr double kStraight = -0.17;  // cosine of 100 degrees
  const LengthAt as_before = [](const Vec3&) { return 1.0; };
  std::vector<int> cut;
  for (int h = 0; h < static_cast<int>(opposite_.size()); ++h) {
    if (!alive(h / 3) || edge_[h] == 0 || edge_[next(h)] == 0) continue;
    const Vec3 p = points_[from(h)] - points_[to(h)], q = points_[to(next(h))] - points_[to(h)];
    if (p.dot(q) < kStraight * p.norm() * q.norm()) cut.push_back(prev(h));
  }
  for (std::size_t i = 0; i < cut.size(); ++i) {
    if (i % 32 == 0) context.check();
    split(cut[i], as_before);
  }
  for (int v = 0; v < static_cast<int>(points_.size()); ++v) {
    if (v % 32 == 0) context.check();
    if (out_[v] >= 0 && place_[v].dim == 2) slide(v, as_before);
  }
}

int Remesher::find(int a, int b) {
  circulate(out_[a]);
  for (int h : ring_)
    if (to(h) == b) return h;
  return -1;
}

bool Remesher::cut_tip(int h, int g, double width, double longest) {
  // Outgoing along the two CAD edges; the tip's face is to the left of h and to the right of g.
  const LengthAt as_before = [](const Vec3&) { return 1.0; };
  const int tip = from(h), face = face_[h / 3];
  const std::array<int, 2> cad{edge_[h], edge_[g]};
  const double most = std::min(longest, std::min(geometry_.edge(cad[0]).length, geometry_.edge(cad[1]).length) / 12);
  // How far the tip is narrower than `width`: steps along the first edge.
  const Vec3 apex = points_[tip];
  const auto gap_at = [&](double s, Vec3& first, Vec3& second) {
    // The chord direction is good enough to start the projection from.
    const CurvePoint a = geometry_.projector->project_to_edge(cad[0], apex + s * (points_[to(h)] - apex).normalized(), nullptr);
    const CurvePoint b = geometry_.projector->project_to_edge(cad[1], a.point, nullptr);
    first = a.point;
    second = b.point;
    return (a.point - b.point).norm();
  };
  double length = 0;
  Vec3 first, second;
  for (double s = 0.02 * most; s <= most && gap_at(s, first, second) < width; s += 0.02 * most) length = s;
  if (length < 5 * width) return false;

  // Short mesh edges along both, as far as the tip goes and one farther.
  const auto follow = [&](int x, int side) {  // the next halfedge along the CAD edge, -1 at its end
    if (place_[to(x)].dim != 1) return -1;
    circulate(out_[to(x)]);
    for (int y : ring_)
      if (edge_[y] == cad[side] && to(y) != from(x)) return y;
    return -1;
  };
  for (int side = 0; side < 2; ++side) {
    int start = tip, target = side == 0 ? to(h) : to(g);
    while (start >= 0 && (points_[start] - apex).norm() < length) {
      int x = find(start, target);
      for (int guard = 0; guard < 20 && edge_length(x) > 0.12 * length; ++guard) {
        split(x, as_before);
        x = find(start, static_cast<int>(points_.size()) - 1);
      }
      const int y = follow(x, side);
      start = y < 0 ? -1 : to(x);
      if (y >= 0) target = to(y);
    }
  }
  // Zip the two together, pair by pair, from the tip on.
  int at = tip, zipped = 0, skipped = 0;
  std::array<int, 2> end{-1, -1};
  for (;;) {
    circulate(out_[at]);
    for (int side = 0; side < 2; ++side) {
      end[side] = -1;
      for (int y : ring_)
        if (edge_[y] == cad[side] && (place_[to(y)].dim == 1) && (points_[to(y)] - apex).norm() > (points_[at] - apex).norm())
          end[side] = to(y);
      if (end[side] < 0) return zipped > 0;
    }
    const double gap = (geometry_.projector->project_to_edge(cad[1], points_[end[0]], nullptr).point - points_[end[0]]).norm();
    if ((points_[end[0]] - apex).norm() > length || gap > width) break;
    // A point that the other edge has no partner for is not needed.
    const double reach[2] = {(points_[end[0]] - apex).norm(), (points_[end[1]] - apex).norm()};
    const int nearer = reach[0] < reach[1] ? 0 : 1;
    if (reach[1 - nearer] - reach[nearer] > 0.05 * length && collapse(find(end[nearer], at), true)) continue;
    // One triangle between the two: flip away what is in between, whichever edge lets itself.
    const auto flip_one_between = [&] {
      circulate(out_[at]);
      std::rotate(ring_.begin(), std::find_if(ring_.begin(), ring_.end(), [&](int y) { return to(y) == end[0]; }), ring_.end());
      std::vector<int> fan;
      for (std::size_t i = 1; i < ring_.size() && to(ring_[i]) != end[1]; ++i) fan.push_back(to(ring_[i]));
      return std::any_of(fan.begin(), fan.end(), [&](int v) { return flip(find(at, v), true); });
    };
    bool one = to(next(find(at, end[0]))) == end[1];
    for (int guard = 0; !one && guard < 50 && flip_one_between(); ++guard) one = to(next(find(at, end[0]))) == end[1];
    const int across = next(find(at, end[0]));
    if (!one || face_[across / 3] != face || !collapse(opposite_[across], true)) {
      // This pair will not meet; the next may.
      if (++skipped < 8 && collapse(find(end[1], at), true)) continue;
      return zipped > 0;
    }
    const int seam = find(at, end[0]);
    edge_[seam] = edge_[opposite_[seam]] = cad[0];
    pinned_[end[0]] = 1;
    if (at != tip) pinned_[at] = 0;
    at = end[0];
    ++zipped;
  }
  return zipped > 0;
}

int Remesher::cut_tips(double width, double longest, Context& context) {
  length_.resize(points_.size(), 1);
  constexpr double kNarrow = 0.94;  // cosine of 20 degrees, between the first mesh edges
  int count = 0;
  for (int v = 0; v < static_cast<int>(points_.size()); ++v) {
    if (out_[v] < 0 || place_[v].dim != 0) continue;
    context.check();
    circulate(out_[v]);
    std::vector<int> along;
    for (int h : ring_)
      if (edge_[h] > 0) along.push_back(h);
    for (std::size_t i = 0; i < along.size() && along.size() > 1; ++i) {
      // The ring runs clockwise or not, whichever: the tip's face is left of one of the two and right of the other.
      int h = along[i], g = along[(i + 1) % along.size()];
      if (face_[h / 3] != face_[opposite_[g] / 3]) std::swap(h, g);
      if (face_[h / 3] != face_[opposite_[g] / 3] || edge_[h] == edge_[g]) continue;
      const Vec3 p = points_[to(h)] - points_[v], q = points_[to(g)] - points_[v];
      if (p.dot(q) < kNarrow * p.norm() * q.norm()) continue;
      if (!cut_tip(h, g, width, longest)) continue;
      ++count;
      break;  // the ring is another now
    }
  }
  return count;
}

SurfaceMesh Remesher::result(const Context& context, std::vector<int>* pinned) const {
  SurfaceMesh mesh;
  std::vector<int> point(points_.size(), -1);
  for (std::size_t t = 0; t < triangles_.size(); ++t) {
    if (triangles_[t][0] < 0) continue;
    std::array<int, 3> triangle;
    for (int k = 0; k < 3; ++k) {
      const int v = triangles_[t][k];
      if (point[v] < 0) {
        point[v] = mesh.point_count();
        mesh.points.push_back(points_[v]);
        mesh.place.push_back(place_[v]);
        if (pinned != nullptr && pinned_[v]) pinned->push_back(point[v]);
      }
      triangle[k] = point[v];
      mesh.corner_normals.push_back(normals_[3 * t + k]);
      mesh.halfedge_edge.push_back(edge_[3 * t + k]);
    }
    mesh.triangles.push_back(triangle);
    mesh.triangle_face.push_back(face_[t]);
  }
  connect(mesh, context);
  return mesh;
}

}  // namespace hexfeature
