// HexFeatureWB - LGPL-2.1-or-later
#include "surface/refine.h"

#include <algorithm>
#include <cmath>

namespace hexfeature {

Refiner::Refiner(const CadModel& model, double edge_length, double plane_length, int segments_per_turn)
    : mesh(model.impl().base),
      model_(model),
      cad_(model.impl().cad),
      edge_length_(edge_length),
      plane_length_(plane_length),
      turn_cosine_(std::cos(1.3 * 2 * EIGEN_PI / std::max(segments_per_turn, 4))),
      shortest_(0.03 * edge_length) {
  planar_.resize(cad_.faces.size());
  for (std::size_t f = 0; f < cad_.faces.size(); ++f) planar_[f] = model.faces[f].kind == SurfaceKind::Plane;
  corner_normals.resize(mesh.corner_uv.size());
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    const Vec2 inside = (mesh.corner_uv[3 * t] + mesh.corner_uv[3 * t + 1] + mesh.corner_uv[3 * t + 2]) / 3;
    for (int h = 3 * t; h < 3 * t + 3; ++h) corner_normals[h] = normal_at(t, mesh.corner_uv[h], inside);
  }
}

Vec3 Refiner::normal_at(int triangle, const Vec2& uv, const Vec2& inside) const {
  return mesh.triangle_side[triangle] * cad_.face(mesh.triangle_face[triangle]).normal_towards(uv, inside);
}

double Refiner::excess(int h) const {
  const int e = mesh.halfedge_edge[h], f = mesh.triangle_face[h / 3];
  const double length = (mesh.points[mesh.to(h)] - mesh.points[mesh.from(h)]).norm();
  const bool plane = e == 0 && planar_[f - 1] != 0;
  double ratio = length / (plane ? plane_length_ : edge_length_);
  if (ratio > 1 || plane || length < shortest_) return ratio;
  // Curvature: the normals at the ends (on a CAD edge, its tangents) may not turn further than one segment of a turn.
  double cosine = 1;
  if (e != 0) {
    const EdgeGeometry& g = cad_.edge(e);
    if (g.kind != EdgeGeometry::Kind::Line) cosine = g.tangent(mesh.halfedge_t[h][0]).dot(g.tangent(mesh.halfedge_t[h][1]));
  } else if (mesh.corner_free[h] < 0 && mesh.corner_free[next(h)] < 0) {
    cosine = corner_normals[h].dot(corner_normals[next(h)]);
  }
  return cosine < turn_cosine_ ? 1.01 : ratio;
}

/// Parameter of a point about midway along a CAD edge between two parameters: spline parameters may be uneven.
double Refiner::middle_of(int edge, double ta, double tb) const {
  const EdgeGeometry& g = cad_.edge(edge);
  double t = 0.5 * (ta + tb);
  if (g.kind != EdgeGeometry::Kind::Other) return t;
  const Vec3 a = g.point(ta), b = g.point(tb);
  double low = 0, high = 1, s = 0.5;
  for (int i = 0; i < 6; ++i) {
    t = ta + s * (tb - ta);
    const Vec3 p = g.point(t);
    const double da = (p - a).norm(), db = (p - b).norm();
    if (std::abs(da - db) < 0.2 * (da + db)) break;
    (da < db ? low : high) = s;
    s = 0.5 * (low + high);
  }
  return t;
}

int Refiner::add_triangle_like(int t) {
  const int n = mesh.triangle_count();
  mesh.triangles.push_back(mesh.triangles[t]);
  mesh.triangle_face.push_back(mesh.triangle_face[t]);
  mesh.triangle_solid.push_back(mesh.triangle_solid[t]);
  mesh.triangle_side.push_back(mesh.triangle_side[t]);
  for (int c = 0; c < 3; ++c) {
    mesh.corner_uv.push_back(Vec2(mesh.corner_uv[3 * t + c]));
    corner_normals.push_back(Vec3(corner_normals[3 * t + c]));
    mesh.corner_free.push_back(static_cast<signed char>(mesh.corner_free[3 * t + c]));
    mesh.halfedge_edge.push_back(mesh.halfedge_edge[3 * t + c]);
    mesh.halfedge_t.push_back(Vec2(mesh.halfedge_t[3 * t + c]));
    mesh.opposite.push_back(mesh.opposite[3 * t + c]);
  }
  return n;
}

void Refiner::split(int h) {
  const int g = mesh.opposite[h], e = mesh.halfedge_edge[h];
  const int m = static_cast<int>(mesh.points.size());
  Vec2 uv[2];
  for (int s = 0; s < 2; ++s) {
    const int a = s == 0 ? h : g, b = next(a);
    uv[s] = 0.5 * (mesh.corner_uv[a] + mesh.corner_uv[b]);
    // From a pole the edge runs along the other end's free parameter.
    if (const int k = mesh.corner_free[a]; k >= 0) uv[s][k] = mesh.corner_uv[b][k];
    if (const int k = mesh.corner_free[b]; k >= 0) uv[s][k] = mesh.corner_uv[a][k];
  }
  double t = 0;
  if (e != 0) {
    t = middle_of(e, mesh.halfedge_t[h][0], mesh.halfedge_t[h][1]);
    const Vec3 p = cad_.edge(e).point(t);
    for (int s = 0; s < 2; ++s) {
      const FaceGeometry& face = cad_.face(mesh.triangle_face[(s == 0 ? h : g) / 3]);
      Vec2 foot;
      if (face.closest(p, uv[s], foot)) uv[s] = foot;
    }
    mesh.points.push_back(p);
    mesh.place.push_back({1, e, {t, 0}});
  } else {
    const int f = mesh.triangle_face[h / 3];
    const FaceGeometry& face = cad_.face(f);
    uv[0] = uv[1] = 0.5 * (uv[0] + uv[1]);
    if (face.native == SurfaceKind::Sphere || face.native == SurfaceKind::Cone) {
      // Round a pole the middle in parameters is far from the middle in space.
      Vec2 foot;
      if (face.closest(0.5 * (mesh.points[mesh.from(h)] + mesh.points[mesh.to(h)]), uv[0], foot)) uv[0] = uv[1] = foot;
    }
    mesh.points.push_back(face.point(uv[0]));
    mesh.place.push_back({2, f, uv[0]});
  }

  int added[2];
  for (int s = 0; s < 2; ++s) {
    const int a = s == 0 ? h : g, triangle = a / 3, b = next(a), c = prev(a);
    const Vec2 inside = (mesh.corner_uv[a] + mesh.corner_uv[b] + mesh.corner_uv[c]) / 3;
    const Vec3 n = s == 1 && e == 0 ? Vec3(corner_normals[next(h)]) : normal_at(triangle, uv[s], inside);
    const int fresh = add_triangle_like(triangle);
    added[s] = fresh;
    const int a2 = 3 * fresh + a % 3, b2 = next(a2), c2 = prev(a2);
    mesh.triangles[triangle][b % 3] = m;
    mesh.corner_uv[b] = uv[s];
    corner_normals[b] = n;
    mesh.corner_free[b] = -1;
    mesh.triangles[fresh][a % 3] = m;
    mesh.corner_uv[a2] = uv[s];
    corner_normals[a2] = n;
    mesh.corner_free[a2] = -1;
    if (e != 0) {
      mesh.halfedge_t[a][1] = t;
      mesh.halfedge_t[a2][0] = t;
    }
    // The new side m - c between the two, and the outer side that went to the new triangle.
    mesh.opposite[mesh.opposite[b2]] = b2;
    mesh.halfedge_edge[b] = mesh.halfedge_edge[c2] = 0;
    mesh.opposite[b] = c2;
    mesh.opposite[c2] = b;
    for (int k = 0; k < 3; ++k) {
      mesh.settle_pole(3 * triangle + k);
      mesh.settle_pole(3 * fresh + k);
    }
  }
  const int h2 = 3 * added[0] + h % 3, g2 = 3 * added[1] + g % 3;
  mesh.opposite[h] = g2;
  mesh.opposite[g2] = h;
  mesh.opposite[h2] = g;
  mesh.opposite[g] = h2;
}

bool Refiner::flip_if_better(int h) {
  if (mesh.halfedge_edge[h] != 0) return false;
  const int g = mesh.opposite[h];
  const int ia = h, ib = next(h), ic = prev(h), id = prev(g);
  const int a = mesh.from(ia), b = mesh.from(ib), c = mesh.from(ic), d = mesh.from(id);
  if (c == d) return false;
  const Vec3 &A = mesh.points[a], &B = mesh.points[b], &C = mesh.points[c], &D = mesh.points[d];
  // Delaunay: the angles at c and d sum to at most a half turn.
  const Vec3 ca = A - C, cb = B - C, da = A - D, db = B - D;
  const double cos_c = ca.dot(cb), sin_c = ca.cross(cb).norm(), cos_d = da.dot(db), sin_d = da.cross(db).norm();
  const double sum = sin_c * cos_d + cos_c * sin_d;  // |..| sin(c + d)
  const double scale = ca.norm() * cb.norm() * da.norm() * db.norm();
  const bool flat = sin_c + sin_d <= 1e-12 * (ca.norm() * cb.norm() + da.norm() * db.norm());
  if (sum >= -1e-6 * scale && !(flat && cos_c + cos_d < 0)) return false;
  // The new triangles a d c and d b c must be turned as the old ones.
  const Vec3 old_normal = (B - A).cross(C - A) + (A - B).cross(D - B);
  const Vec3 n1 = (D - A).cross(C - A), n2 = (B - D).cross(C - D);
  const double tiny = 1e-7 * (C - D).squaredNorm();
  if (n1.dot(old_normal) <= 0.3 * n1.norm() * old_normal.norm() || n2.dot(old_normal) <= 0.3 * n2.norm() * old_normal.norm()) return false;
  if (n1.norm() < tiny || n2.norm() < tiny) return false;
  const int f = mesh.triangle_face[h / 3];
  if (planar_[f - 1] == 0) {
    const double before = corner_normals[ia].dot(corner_normals[ib]), after = corner_normals[ic].dot(corner_normals[id]);
    if (after < before - 1e-3 && after < turn_cosine_) return false;  // would cut across the curvature
    const auto turned = [&](int i, int j, int k) {
      const Vec2 u = mesh.corner_uv[j] - mesh.corner_uv[i], v = mesh.corner_uv[k] - mesh.corner_uv[i];
      return u[0] * v[1] - u[1] * v[0];
    };
    if (mesh.corner_free[ia] < 0 && mesh.corner_free[ib] < 0 && mesh.corner_free[ic] < 0 && mesh.corner_free[id] < 0) {
      const double sense = turned(ia, ib, ic);
      if (turned(ia, id, ic) * sense <= 0 || turned(id, ib, ic) * sense <= 0) return false;
    }
  }
  // c and d must not be joined already.
  for (int s = ic;;) {
    if (mesh.to(s) == d || mesh.from(prev(s)) == d) return false;
    s = mesh.opposite[prev(s)];
    if (s == ic) break;
  }
  // h: a -> d, then d -> c, c -> a; g: b -> c, then c -> d, d -> b.
  const int t = h / 3, s = g / 3;
  const Vec2 uv[4] = {mesh.corner_uv[ia], mesh.corner_uv[ib], mesh.corner_uv[ic], mesh.corner_uv[id]};
  const Vec2 uv_a = 0.5 * (uv[0] + mesh.corner_uv[next(g)]), uv_b = 0.5 * (uv[1] + mesh.corner_uv[g]);
  Vec3 normal[4] = {corner_normals[ia] + corner_normals[next(g)], corner_normals[ib] + corner_normals[g], corner_normals[ic],
                    corner_normals[id]};
  for (Vec3& n : normal)
    if (n.norm() > 1e-9) n.normalize();
  struct Outer {
    int opposite, edge;
    Vec2 t;
  };
  const auto outer = [&](int i) { return Outer{mesh.opposite[i], mesh.halfedge_edge[i], mesh.halfedge_t[i]}; };
  const Outer bc = outer(ib), ca_side = outer(ic), ad = outer(next(g)), db_side = outer(id);
  const auto set = [&](int i, const Outer& o) {
    mesh.opposite[i] = o.opposite;
    mesh.opposite[o.opposite] = i;
    mesh.halfedge_edge[i] = o.edge;
    mesh.halfedge_t[i] = o.t;
  };
  const signed char free[4] = {mesh.corner_free[ia], mesh.corner_free[ib], mesh.corner_free[ic], mesh.corner_free[id]};
  const auto corner = [&](int i, int point, const Vec2& parameters, const Vec3& n, signed char pole) {
    mesh.triangles[i / 3][i % 3] = point;
    mesh.corner_free[i] = pole;
    mesh.corner_uv[i] = parameters;
    corner_normals[i] = n;
  };
  const int t0 = 3 * t, s0 = 3 * s;
  corner(t0, a, uv_a, normal[0], free[0]);
  corner(t0 + 1, d, uv[3], normal[3], free[3]);
  corner(t0 + 2, c, uv[2], normal[2], free[2]);
  corner(s0, b, uv_b, normal[1], free[1]);
  corner(s0 + 1, c, uv[2], normal[2], free[2]);
  corner(s0 + 2, d, uv[3], normal[3], free[3]);
  // Two of the outer sides may face each other (a point of valence three): then set() of the second repairs the first.
  const auto moved = [&](int old) { return old == ib ? s0 : old == ic ? t0 + 2 : old == next(g) ? t0 : old == id ? s0 + 2 : old; };
  Outer sides[4] = {ad, ca_side, bc, db_side};
  for (Outer& o : sides) o.opposite = moved(o.opposite);
  set(t0, sides[0]);
  set(t0 + 2, sides[1]);
  set(s0, sides[2]);
  set(s0 + 2, sides[3]);
  mesh.opposite[t0 + 1] = s0 + 1;
  mesh.opposite[s0 + 1] = t0 + 1;
  mesh.halfedge_edge[t0 + 1] = mesh.halfedge_edge[s0 + 1] = 0;
  for (int k = 0; k < 3; ++k) {
    mesh.settle_pole(t0 + k);
    mesh.settle_pole(s0 + k);
  }
  return true;
}

void Refiner::flip_all(Context& context) {
  const int n = 3 * mesh.triangle_count();
  settled_ = true;
  for (int h = n - 1; h >= 0; --h)
    if (h < mesh.opposite[h]) queue(h);
  flip_queued(4 * n + 1000, context);
}

void Refiner::queue(int h) {
  h = std::min(h, mesh.opposite[h]);
  if (mesh.halfedge_edge[h] != 0) return;
  if (queued_.size() < mesh.opposite.size()) queued_.resize(mesh.opposite.size(), 0);
  if (queued_[h] != 0) return;
  queued_[h] = 1;
  stack_.push_back(h);
}

// Bounded by `limit` flips, for curved faces have no Delaunay theorem that would end it.
void Refiner::flip_queued(int limit, Context& context) {
  int flips = 0;
  for (std::size_t step = 0; !stack_.empty(); ++step) {
    if (step % 4096 == 0) context.check();
    const int h = stack_.back();
    stack_.pop_back();
    queued_[h] = 0;
    const int g = mesh.opposite[h];
    if (!flip_if_better(h)) continue;
    if (++flips > limit) {
      settled_ = false;
      break;
    }
    for (const int t : {h / 3, g / 3})
      for (int i = 3 * t; i < 3 * t + 3; ++i) queue(i);
  }
  for (const int h : stack_) queued_[h] = 0;
  stack_.clear();
}

void Refiner::run(Context& context) {
  flip_all(context);
  double worst = 0;
  for (int h = 0; h < 3 * mesh.triangle_count(); ++h) worst = std::max(worst, excess(h));
  // The longest first, by classes: bisection then makes good triangles.
  double level = worst / 1.5;
  for (int round = 0; round < 60; ++round, level /= 1.5) {
    level = std::max(level, 1.0);
    int splits = 0;
    for (int h = 0; h < 3 * mesh.triangle_count(); ++h) {
      if (h % 4096 == 0) context.check();
      if (h < mesh.opposite[h] && excess(h) > level) {
        const int g = mesh.opposite[h], n = 3 * mesh.triangle_count();
        split(h);
        ++splits;
        // Delaunay again at once: a fan of long edges then needs one point, not one on each.
        for (const int t : {h / 3, g / 3, n / 3, n / 3 + 1})
          for (int i = 3 * t; i < 3 * t + 3; ++i) queue(i);
        flip_queued(200, context);
      }
    }
    // Each split has flipped what it changed, as far as that went: all edges are looked at again only where it had to stop.
    if (splits > 0 && !settled_)
      flip_all(context);
    else if (splits == 0 && level == 1.0)
      break;
  }
}

void Refiner::settle_poles() {
  for (int h = 0; h < 3 * mesh.triangle_count(); ++h) {
    if (mesh.corner_free[h] < 0) continue;
    mesh.settle_pole(h);
    const int t = h / 3;
    corner_normals[h] =
        normal_at(t, mesh.corner_uv[h], (mesh.corner_uv[3 * t] + mesh.corner_uv[3 * t + 1] + mesh.corner_uv[3 * t + 2]) / 3);
  }
}

void Refiner::separate_double_edges(Context& context) {
  struct Pair {
    int a, b, halfedge;
  };
  std::vector<Pair> pairs;
  for (int round = 0; round < 6; ++round) {
    context.check();
    pairs.clear();
    for (int h = 0; h < 3 * mesh.triangle_count(); ++h)
      if (h < mesh.opposite[h]) pairs.push_back({std::min(mesh.from(h), mesh.to(h)), std::max(mesh.from(h), mesh.to(h)), h});
    std::sort(pairs.begin(), pairs.end(), [](const Pair& p, const Pair& q) {
      return p.a != q.a ? p.a < q.a : p.b != q.b ? p.b < q.b : p.halfedge < q.halfedge;
    });
    std::vector<int> doubles;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const auto same = [&](std::size_t j) { return j < pairs.size() && pairs[i].a == pairs[j].a && pairs[i].b == pairs[j].b; };
      if (same(i + 1) || (i > 0 && same(i - 1))) doubles.push_back(pairs[i].halfedge);
    }
    if (doubles.empty()) return;
    for (const int h : doubles) split(h);  // a split leaves the start of every halfedge where it was
  }
}

}  // namespace hexfeature
