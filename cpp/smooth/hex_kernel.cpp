// HexFeatureWB - LGPL-2.1-or-later
#include "smooth/hex_kernel.h"

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

#include "mesh/hex_complex.h"

#define HEXFEATURE_INLINE inline __attribute__((always_inline))
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
// Without FMA, which would round differently.
#define HEXFEATURE_CLONES __attribute__((target_clones("avx2", "default")))
#else
#define HEXFEATURE_CLONES
#endif

namespace hexfeature {

FrameTable::FrameTable() {
  for (int k = 0; k < kCorners; ++k)
    for (int i = 0; i < 3; ++i) frame[k].from[i] = kHexCorners[k][0], frame[k].to[i] = kHexCorners[k][i + 1];
  constexpr int node[2][2][2] = {{{0, 4}, {3, 7}}, {{1, 5}, {2, 6}}};  // of the cube's corner (r, s, t)
  int count = kCorners;
  for (int axis = 0; axis < 3; ++axis)
    for (int side = 0; side < 4; ++side)
      for (int end = 0; end < 2; ++end) {
        const int others[2] = {(axis + 1) % 3, (axis + 2) % 3};
        int corner[3];
        corner[others[0]] = side & 1;
        corner[others[1]] = side / 2;
        const auto put = [&](int direction) {
          int low[3] = {corner[0], corner[1], corner[2]}, high[3] = {corner[0], corner[1], corner[2]};
          low[direction] = 0;
          high[direction] = 1;
          frame[count].from[direction] = node[low[0]][low[1]][low[2]];
          frame[count].to[direction] = node[high[0]][high[1]][high[2]];
        };
        corner[axis] = 0;
        put(axis);
        corner[axis] = end;
        put(others[0]);
        corner[axis] = 1 - end;
        put(others[1]);
        ++count;
      }
}

const FrameTable& hex_frames() {
  static const FrameTable table;
  return table;
}

namespace {

/// Four numbers, one an element; operations are lane by lane.
typedef double Lanes __attribute__((vector_size(kLanes * sizeof(double))));
typedef std::uint64_t Bits __attribute__((vector_size(kLanes * sizeof(std::uint64_t))));

HEXFEATURE_INLINE Lanes load(const double* from) {
  Lanes v;
  std::memcpy(&v, from, sizeof v);
  return v;
}
HEXFEATURE_INLINE void store(double* to, const Lanes& v) { std::memcpy(to, &v, sizeof v); }
HEXFEATURE_INLINE Lanes least_of(const Lanes& a, const Lanes& b) { return b < a ? b : a; }
HEXFEATURE_INLINE Lanes positive(const Lanes& a) { return a > 0 ? a : Lanes{}; }
HEXFEATURE_INLINE Lanes square_root(const Lanes& a) {
  Lanes r;
  for (int l = 0; l < kLanes; ++l) r[l] = std::sqrt(a[l]);
  return r;
}

/// Three coordinates, each of four elements.
struct Vector {
  Lanes x, y, z;
};
HEXFEATURE_INLINE Vector operator-(const Vector& a, const Vector& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
HEXFEATURE_INLINE Lanes dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
HEXFEATURE_INLINE Vector cross(const Vector& a, const Vector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
HEXFEATURE_INLINE void add(Vector& a, const Vector& b) { a.x += b.x, a.y += b.y, a.z += b.z; }
HEXFEATURE_INLINE void subtract(Vector& a, const Vector& b) { a.x -= b.x, a.y -= b.y, a.z -= b.z; }

/// c^(-1/3) of positive numbers: a guess from the exponent bits, then Newton to the last digits; the same on every machine.
HEXFEATURE_INLINE Lanes inverse_cube_root(const Lanes& c) {
  Bits bits;
  std::memcpy(&bits, &c, sizeof bits);
  // A third of the bits, 1/4 + 1/16 + ..., by shifts.
  Bits third_of = bits >> 2;
  third_of += third_of >> 2;
  third_of += third_of >> 4;
  third_of += third_of >> 8;
  third_of += third_of >> 16;
  third_of += third_of >> 32;
  bits = 0x553EF0FF289DD796u - third_of;
  Lanes y;
  std::memcpy(&y, &bits, sizeof y);
  const Lanes third = c * (1.0 / 3.0);
  for (int i = 0; i < 4; ++i) y = y * (4.0 / 3.0 - third * (y * y * y));
  return y;
}

HEXFEATURE_INLINE Lanes to_power(Lanes q, int p) {
  for (; p > 1; p /= 2) q = q * q;
  return q;
}

constexpr int kMeanPower = 8, kBarrierPower = 16;
constexpr double kBarrier = 0.1;

HEXFEATURE_INLINE Lanes to_root(Lanes q, int p) {
  for (; p > 1; p /= 2) q = square_root(q);
  return q;
}

/// Of the mean-element energy: 1 - s, and what it changes per change of log q^8 at a corner, divided by q^8.
struct Mean {
  Lanes value, slope;
};
HEXFEATURE_INLINE Mean mean_of_corners(const Vector* p) {
  const FrameTable& frames = hex_frames();
  Lanes sum{};
  for (int i = 0; i < kCorners; ++i) {
    const Frame& frame = frames.frame[i];
    const Vector a = p[frame.to[0]] - p[frame.from[0]], b = p[frame.to[1]] - p[frame.from[1]], c = p[frame.to[2]] - p[frame.from[2]];
    sum += to_power(square_root(dot(a, a) * dot(b, b) * dot(c, c)) / dot(a, cross(b, c)), kMeanPower);
  }
  const Lanes s = 1 / to_root(sum / kCorners, kMeanPower);
  return {1 - s, s / (kMeanPower * sum)};
}

enum class Kind { Shape, Worst, Mean };

template <Kind kKind>
HEXFEATURE_INLINE GroupValue evaluate(const Group& group, const double* x, const EnergyTerms& terms, double* slots) {
  const Lanes inverse = load(group.inverse_size), wall = load(group.shortest), allowed = load(group.least);
  Vector p[8];
  for (int k = 0; k < 8; ++k) {
    for (int l = 0; l < kLanes; ++l) {
      const double* from = x + group.node[k * kLanes + l];
      p[k].x[l] = from[0];
      p[k].y[l] = from[1];
      p[k].z[l] = from[2];
    }
    p[k].x *= inverse, p[k].y *= inverse, p[k].z *= inverse;
  }
  Vector grad[8] = {};
  constexpr bool kWalls = kKind != Kind::Shape, kMean = kKind == Kind::Mean;
  const Mean mean = kMean ? mean_of_corners(p) : Mean{};
  const FrameTable& frames = hex_frames();
  const double theta = terms.theta, epsilon2 = terms.epsilon_squared, shape = kWalls ? terms.shape_weight : 1;
  Lanes energy = mean.value, least = Lanes{} + std::numeric_limits<double>::infinity(), too_short = Lanes{} + 1;
  for (int i = 0; i < group.frames; ++i) {
    const Frame& frame = frames.frame[i];
    const double share = i < kCorners ? 1 : kMixedWeight, part_shape = share * shape;
    const Vector a = p[frame.to[0]] - p[frame.from[0]], b = p[frame.to[1]] - p[frame.from[1]], c = p[frame.to[2]] - p[frame.from[2]];
    const Vector bc = cross(b, c), ca = cross(c, a), ab = cross(a, b);
    const Lanes d = dot(a, bc), aa = dot(a, a), bb = dot(b, b), cc = dot(c, c), sum = aa + bb + cc;
    least = least_of(least, d);
    // chi without cancellation for d < 0, and chi' = chi / root.
    const Lanes size = d < 0 ? -d : d, root = square_root(epsilon2 + d * d), outer = root + size;
    const Lanes chi = d >= 0 ? 0.5 * outer : (0.5 * epsilon2) / outer;
    const Lanes y = inverse_cube_root(chi), y2 = y * y, inverse_chi = y2 * y, slope = chi / root;
    const Lanes f = sum * y2, g = (1 + d * d) * inverse_chi;
    energy += part_shape * ((1 - theta) * f + theta * g);
    const Lanes alpha = (2 * (1 - theta) * part_shape) * y2;
    Lanes beta = part_shape * (2 * theta * d * inverse_chi - slope * inverse_chi * ((1 - theta) * (2.0 / 3.0) * f + theta * g));
    Lanes alpha_a = alpha, alpha_b = alpha, alpha_c = alpha;
    if (kWalls) {
      too_short = least_of(too_short, least_of(least_of(aa, bb), cc) - allowed);
      const Lanes q = square_root(aa * bb * cc) / d;
      const int exponent = kMean ? kBarrierPower : terms.power;
      const Lanes power = kMean ? kBarrier * to_power(terms.worst * q, exponent) : share * to_power(q, exponent);
      Lanes slope_q = exponent * power;
      if (kMean) slope_q += kMeanPower * mean.slope * to_power(q, kMeanPower);
      const Lanes ia = 1 / aa, ib = 1 / bb, ic = 1 / cc;
      const Lanes wa = positive(wall * ia - 1), wb = positive(wall * ib - 1), wc = positive(wall * ic - 1);
      energy += power + (4 * share) * (wa * wa + wb * wb + wc * wc);
      alpha_a += slope_q * ia - (16 * share) * wa * wall * ia * ia;
      alpha_b += slope_q * ib - (16 * share) * wb * wall * ib * ib;
      alpha_c += slope_q * ic - (16 * share) * wc * wall * ic * ic;
      beta -= slope_q / d;
    }
    if (!slots) continue;
    const Vector ga{alpha_a * a.x + beta * bc.x, alpha_a * a.y + beta * bc.y, alpha_a * a.z + beta * bc.z};
    const Vector gb{alpha_b * b.x + beta * ca.x, alpha_b * b.y + beta * ca.y, alpha_b * b.z + beta * ca.z};
    const Vector gc{alpha_c * c.x + beta * ab.x, alpha_c * c.y + beta * ab.y, alpha_c * c.z + beta * ab.z};
    add(grad[frame.to[0]], ga), subtract(grad[frame.from[0]], ga);
    add(grad[frame.to[1]], gb), subtract(grad[frame.from[1]], gb);
    add(grad[frame.to[2]], gc), subtract(grad[frame.from[2]], gc);
  }
  // Empty lanes repeat the last element: harmless in the minimum, left out of the sum.
  GroupValue value{0, least[0]};
  for (int l = 0; l < kLanes; ++l) {
    if (kWalls && !(too_short[l] >= 0)) return {std::numeric_limits<double>::infinity(), 0};
    if (least[l] < value.min_det || std::isnan(least[l])) value.min_det = least[l];
    if (group.weight[l] > 0) value.energy += energy[l];
  }
  if (slots)
    for (int k = 0; k < 8; ++k) {
      store(slots + (3 * k) * kLanes, grad[k].x * inverse);
      store(slots + (3 * k + 1) * kLanes, grad[k].y * inverse);
      store(slots + (3 * k + 2) * kLanes, grad[k].z * inverse);
    }
  return value;
}

HEXFEATURE_CLONES GroupValue evaluate_shape(const Group& group, const double* x, const EnergyTerms& terms, double* slots) {
  return evaluate<Kind::Shape>(group, x, terms, slots);
}

HEXFEATURE_CLONES GroupValue evaluate_worst(const Group& group, const double* x, const EnergyTerms& terms, double* slots) {
  return evaluate<Kind::Worst>(group, x, terms, slots);
}

HEXFEATURE_CLONES GroupValue evaluate_mean(const Group& group, const double* x, const EnergyTerms& terms, double* slots) {
  return evaluate<Kind::Mean>(group, x, terms, slots);
}

}  // namespace

GroupValue evaluate_group(const Group& group, const double* x, const EnergyTerms& terms, double* slots) {
  if (terms.mean) return evaluate_mean(group, x, terms, slots);
  return terms.power > 0 ? evaluate_worst(group, x, terms, slots) : evaluate_shape(group, x, terms, slots);
}

}  // namespace hexfeature
