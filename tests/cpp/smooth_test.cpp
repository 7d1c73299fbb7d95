// HexFeatureWB - LGPL-2.1-or-later
#include "smooth/smooth.h"

#include <doctest/doctest.h>

#include <atomic>
#include <chrono>
#include <cstring>

#include "hex_fixtures.h"
#include "mesh/hex_element.h"
#include "smooth/energy.h"
#include "smooth/patch.h"

using namespace hexfeature;
using namespace fixtures;

namespace {

Context context;

SmoothReport timed(const char* name, HexComplex& c, const Projector& projector, SmoothOptions options) {
  const auto start = std::chrono::steady_clock::now();
  const SmoothReport r = smooth(c, projector, options, context);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  MESSAGE(name << ": " << c.hex_count() << " hexes, " << r.inverted_before << " inverted, min " << r.min_sj_before << " -> " << r.inverted
               << ", " << r.min_sj << " mean " << r.mean_sj << " rounds " << r.rounds << " deviation " << r.deviation << " "
               << 1000 * seconds << " ms");
  return r;
}

SmoothOptions sized(double h) {
  SmoothOptions o;
  o.size = h;
  return o;
}

double volume_of(const HexComplex& c) {
  double v = 0;
  for (const auto& h : c.hexes) v += hex_volume(c.points, h);
  return v;
}

std::vector<double> x_of(const HexComplex& c) {
  std::vector<double> x;
  for (const Vec3& p : c.points) x.insert(x.end(), p.data(), p.data() + 3);
  return x;
}

/// The mesh edges round a cylinder's two rims follow its CAD edges.
void follow_rims(HexComplex& c) {
  c.feature_edges.clear();
  c.feature_edge_cad.clear();
  for (const auto& q : c.quads)
    for (int k = 0; k < 4; ++k) {
      const int a = q[k], b = q[(k + 1) % 4];
      if (a < b && c.place[a].dim == 1 && c.place[b].dim == 1 && c.place[a].entity == c.place[b].entity) {
        c.feature_edges.push_back({a, b});
        c.feature_edge_cad.push_back(c.place[a].entity);
      }
    }
}

/// Shortest and longest of them.
std::array<double, 2> rim_lengths(const HexComplex& c) {
  std::array<double, 2> r{1e9, 0};
  for (const auto& e : c.feature_edges) {
    const double length = (c.points[e[1]] - c.points[e[0]]).norm();
    r = {std::min(r[0], length), std::max(r[1], length)};
  }
  return r;
}

bool same_bits(const HexComplex& a, const HexComplex& b) {
  return a.points.size() == b.points.size() && std::memcmp(a.points.data(), b.points.data(), a.points.size() * sizeof(Vec3)) == 0;
}

}  // namespace

TEST_CASE("the gradient is the energy's derivative") {
  HexComplex c = box_mesh({3, 2, 2}, Vec3(3, 2, 2));
  constexpr int kMean = -1;
  for (int power : {0, 1, 4, kMean}) {
    for (double amount : {0.15, 0.9}) {
      if (power != 0 && amount > 0.5) continue;
      HexComplex shaken = c;
      for (auto& p : shaken.place) p.dim = 3;
      shake_inside(shaken, amount);
      Workers workers(1, context);
      const std::size_t n = shaken.hexes.size();
      HexEnergy energy(shaken.hexes, shaken.point_count(), std::vector<double>(n, 0.8), std::vector<double>(n, 0.9),
                       std::vector<double>(n, 1e-6), std::vector<char>(n, power == 1 || amount > 0.5), workers);
      // One edge too long, one too short.
      const std::array<int, 8>& hex = shaken.hexes[0];
      energy.set_spans({{hex[0], hex[1], 0.7, 0.1}, {hex[1], hex[2], 9, 1.3}}, x_of(shaken).data());
      EnergyTerms terms;
      terms.power = std::max(power, 0);
      terms.mean = power == kMean;
      terms.worst = 0.6;
      terms.epsilon_squared = 0.01;
      std::vector<double> x, g, ignored;
      for (const Vec3& p : shaken.points) x.insert(x.end(), {p[0], p[1], p[2]});
      g.resize(x.size());
      const EnergyValue value = energy.evaluate(x.data(), terms, g.data());
      REQUIRE(std::isfinite(value.energy));
      if (amount > 0.5) CHECK(value.min_det < 0);
      double largest = 0;
      for (double k : g) largest = std::max(largest, std::abs(k));
      for (std::size_t i = 0; i < x.size(); i += 2) {
        const double keep = x[i], step = 1e-6;
        x[i] = keep + step;
        const double high = energy.evaluate(x.data(), terms, nullptr).energy;
        x[i] = keep - step;
        const double low = energy.evaluate(x.data(), terms, nullptr).energy;
        x[i] = keep;
        CHECK(std::abs((high - low) / (2 * step) - g[i]) < 1e-5 * largest);
      }
    }
  }
}

TEST_CASE("a perfect box is left as it is") {
  HexComplex c = box_mesh({6, 5, 4}, Vec3(6, 5, 4));
  const HexComplex before = c;
  const SmoothReport r = smooth(c, BoxProjector(Vec3(6, 5, 4)), sized(1), context);
  CHECK(r.min_sj == 1.0);
  CHECK(same_bits(c, before));
}

TEST_CASE("a box with a tangled inside becomes a box again") {
  for (double amount : {0.4, 1.5}) {
    HexComplex c = box_mesh({8, 8, 8}, Vec3(8, 8, 8));
    shake_inside(c, amount);
    const SmoothReport r = timed("shaken box", c, BoxProjector(Vec3(8, 8, 8)), sized(1));
    CHECK(r.min_sj > 0.98);
    CHECK(r.deviation < 1e-9);
    CHECK(volume_of(c) == doctest::Approx(512));
  }
}

TEST_CASE("a collapsed inside becomes a box again") {
  HexComplex c = box_mesh({8, 8, 8}, Vec3(8, 8, 8));
  for (int v = 0; v < c.point_count(); ++v)
    if (c.place[v].dim == 3) c.points[v] = Vec3(4, 4, 4) + 0.01 * (c.points[v] - Vec3(4, 4, 4));
  const SmoothReport r = timed("collapsed box", c, BoxProjector(Vec3(8, 8, 8)), sized(1));
  CHECK(r.inverted == 0);
  CHECK(r.min_sj > 0.5);
}

TEST_CASE("what cannot be untangled is given up early") {
  // Two fixed corners of a box have changed places.
  HexComplex c = box_mesh({4, 4, 4}, Vec3(4, 4, 4));
  std::vector<int> corners;
  for (int v = 0; v < c.point_count(); ++v)
    if (c.place[v].dim == 0) corners.push_back(v);
  REQUIRE(corners.size() == 8);
  std::swap(c.points[corners[0]], c.points[corners[1]]);
  std::swap(c.place[corners[0]], c.place[corners[1]]);
  const SmoothReport r = timed("swapped corners", c, BoxProjector(Vec3(4, 4, 4)), sized(1));
  CHECK(r.inverted > 0);
  CHECK(r.rounds < 20);
}

TEST_CASE("nodes on faces and edges slide back") {
  HexComplex c = box_mesh({6, 6, 6}, Vec3(6, 6, 6));
  const BoxProjector box(Vec3(6, 6, 6));
  std::mt19937 random(5);
  for (int v = 0; v < c.point_count(); ++v) {
    Vec3 d;
    for (int a = 0; a < 3; ++a) d[a] = 0.6 * (2.0 * random() / 4294967295.0 - 1);
    if (c.place[v].dim == 1) c.points[v] = box.project_to_edge(c.place[v].entity, c.points[v] + d, nullptr).point;
    if (c.place[v].dim == 2) c.points[v] = box.project_to_face(c.place[v].entity, c.points[v] + d, nullptr).point;
    if (c.place[v].dim == 3) c.points[v] += d;
  }
  const SmoothReport r = timed("shaken surface", c, box, sized(1));
  CHECK(r.min_sj > 0.95);
  CHECK(r.deviation < 1e-9);
}

TEST_CASE("a cylinder from one block stays valid, its O-grid is good") {
  const CylinderProjector cylinder(5, 8);
  HexComplex lattice = lattice_cylinder(8, 8, 5, 8);
  const SmoothReport a = timed("lattice cylinder", lattice, cylinder, sized(1));
  CHECK(a.min_sj > 0.15);
  CHECK(a.deviation < 1e-9 * 5);
  HexComplex grid = o_grid_cylinder(4, 3, 8, 5, 8);
  const SmoothReport b = timed("O-grid cylinder", grid, cylinder, sized(1.2));
  CHECK(b.min_sj >= 0.8);
  CHECK(b.deviation < 1e-9 * 5);
  CHECK(volume_of(grid) == doctest::Approx(kPi * 25 * 8).epsilon(0.04));
  shake_inside(grid, 1.0);
  const SmoothReport d = timed("O-grid cylinder, tangled", grid, cylinder, sized(1.2));
  CHECK(d.min_sj >= 0.8);
  CHECK(grid.place[0].dim == 2);
}

TEST_CASE("a ball from one cube, without a sheet, is valid") {
  HexComplex c = sphere_mesh(10, 5);
  const SmoothReport r = timed("ball", c, SphereProjector(5), sized(1));
  CHECK(r.min_sj > 0.15);
  CHECK(r.deviation < 1e-9 * 5);
  for (int v = 0; v < c.point_count(); ++v)
    if (c.place[v].dim == 2) CHECK(c.points[v].norm() == doctest::Approx(5).epsilon(1e-12));
}

TEST_CASE("a cube's lattice with its surface thrown onto a sphere untangles") {
  HexComplex c = lattice({10, 10, 10}, [](const Vec3& p) { return Vec3(p - Vec3(5, 5, 5)); });
  for (const auto& q : c.quads)
    for (int v : q) c.place[v] = {2, 1, Vec2::Zero()};
  for (int v = 0; v < c.point_count(); ++v)
    if (c.place[v].dim == 2) c.points[v] = 5 * c.points[v].normalized();
  const SmoothReport r = timed("cube thrown onto a ball", c, SphereProjector(5), sized(1));
  CHECK(r.inverted_before > 0);
  CHECK(r.min_sj > 0.15);
}

TEST_CASE("thorough elements see folds along edges that their corners do not show") {
  std::mt19937 random(11);
  int folds = 0;
  for (int trial = 0; trial < 20000 && folds < 10; ++trial) {
    HexComplex c = box_mesh({1, 1, 1}, Vec3(1, 1, 1));
    for (auto& p : c.place) p.dim = 3;
    shake_inside(c, 0.45, random());
    if (!(scaled_jacobian(c.points, c.hexes[0]) > 0) || proves_positive(c.points, c.hexes[0])) continue;
    ++folds;
    Workers workers(1, context);
    std::vector<double> x;
    for (const Vec3& p : c.points) x.insert(x.end(), {p[0], p[1], p[2]});
    for (char thorough : {0, 1}) {
      HexEnergy energy(c.hexes, 8, {1.0}, {0.1}, {0.01}, {thorough}, workers);
      const double d = energy.evaluate(x.data(), EnergyTerms{}, nullptr).min_det;
      CHECK((thorough ? d < 0 : d > 0));
    }
  }
  CHECK(folds == 10);
}

TEST_CASE("a place that could be better is lifted, though another holds the worst element down") {
  HexComplex c = box_mesh({8, 4, 4}, Vec3(8, 4, 4));
  const auto node = [&](int i, int j, int k) { return (k * 5 + j) * 9 + i; };
  for (int i : {2, 6}) c.points[node(i, 2, 2)] += Vec3(0.27, 0.27, 0.27);
  const SmoothOptions options = sized(1);
  const BoxProjector projector(Vec3(8, 4, 4));
  Workers workers(1, context);
  SmoothSetting setting{
      projector, options, context, workers, std::vector<double>(c.hexes.size(), 1.0), {}, std::vector<char>(c.points.size(), 0)};
  std::vector<double> before, after;
  measure(c, workers, before);
  const auto worst_of = [&](const std::vector<double>& quality, bool right) {
    double worst = 1;
    for (int h = 0; h < c.hex_count(); ++h)
      if ((h % 8 >= 4) == right) worst = std::min(worst, quality[h]);
    return worst;
  };
  REQUIRE(worst_of(before, true) > 0);
  REQUIRE(worst_of(before, true) < 0.4);
  // No node may move where the left one is.
  for (int v = 0; v < c.point_count(); ++v) setting.held[v] = v % 9 <= 3;

  HexComplex all = c;
  lift_worst(all, setting);
  measure(all, workers, after);
  CHECK(worst_of(after, true) == worst_of(before, true));  // nothing would raise the minimum
  HexComplex placewise = c;
  lift_places(placewise, setting);
  measure(placewise, workers, after);
  CHECK(worst_of(after, true) > 0.8);
  CHECK(worst_of(after, false) == worst_of(before, false));
  for (int v = 0; v < c.point_count(); ++v)
    if (setting.held[v]) CHECK(placewise.points[v] == c.points[v]);
}

TEST_CASE("a long loop stops between two slices, in every thread") {
  for (int threads : {1, 2}) {
    Context stopped;
    std::atomic<int> looks{0};
    stopped.is_cancelled = [&] { return ++looks > 2; };
    Workers workers(threads, stopped);
    std::atomic<int> done{0};
    CHECK_THROWS_AS(workers.run(1 << 20, 1, [&](int begin, int end) { done += end - begin; }), MeshingError);
    CHECK(done > 0);
    CHECK(done < 1 << 16);
  }
}

TEST_CASE("an inner edge is not collapsed for the sake of the worst element") {
  HexComplex c = sphere_mesh(10, 5);
  smooth(c, SphereProjector(5), sized(1), context);
  double shortest = 1e9;
  for (const auto& h : c.hexes)
    for (const auto& e : kHexEdges) shortest = std::min(shortest, (c.points[h[e[0]]] - c.points[h[e[1]]]).norm());
  CHECK(shortest > 0.045);
}

TEST_CASE("points along a followed curve keep apart, and no chord cuts off more than a fifth of an element") {
  const double radius = 2, h = 1;
  HexComplex c = lattice_cylinder(3, 4, radius, 4);
  follow_rims(c);
  REQUIRE(c.feature_edges.size() == 24);
  HexComplex loose = c;
  loose.feature_edges.clear();
  loose.feature_edge_cad.clear();
  smooth(loose, CylinderProjector(radius, 4), sized(h), context);
  smooth(c, CylinderProjector(radius, 4), sized(h), context);
  loose.feature_edges = c.feature_edges;
  const auto before = rim_lengths(loose), after = rim_lengths(c);
  MESSAGE("rim edges " << before[0] << " to " << before[1] << " without, " << after[0] << " to " << after[1] << " with their spans");
  const double sag = radius - std::sqrt(radius * radius - 0.25 * after[1] * after[1]);
  CHECK(sag < 0.22 * h);
  CHECK(after[0] > 3 * before[0]);
  CHECK(after[1] - after[0] <= before[1] - before[0] + 1e-9);
}

TEST_CASE("one thread and two give the same bits") {
  HexComplex one = sphere_mesh(8, 4);
  shake_inside(one, 1.0);
  HexComplex two = one;
  SmoothOptions o = sized(1);
  o.threads = 1;
  smooth(one, SphereProjector(4), o, context);
  o.threads = 2;
  smooth(two, SphereProjector(4), o, context);
  CHECK(same_bits(one, two));
}

TEST_CASE("coordinates that are no numbers end in a report, not a hang") {
  HexComplex c = box_mesh({3, 3, 3}, Vec3(3, 3, 3));
  c.points[21][0] = std::nan("");
  const SmoothReport r = smooth(c, BoxProjector(Vec3(3, 3, 3)), sized(1), context);
  CHECK(r.inverted > 0);
}

TEST_CASE("cancelling ends it") {
  HexComplex c = sphere_mesh(10, 5);
  Context stopping;
  int asked = 0;
  stopping.is_cancelled = [&] { return ++asked > 20; };
  CHECK_THROWS_AS(smooth(c, SphereProjector(5), sized(1), stopping), MeshingError);
}

TEST_CASE("the last bad elements are polished point by point, within bounds") {
  HexComplex c = box_mesh({2, 2, 2}, Vec3(2, 2, 2));
  const BoxProjector box(Vec3(2, 2, 2));
  const auto centre = std::find_if(c.points.begin(), c.points.end(), [](const Vec3& p) { return (p - Vec3(1, 1, 1)).norm() < 1e-9; });
  REQUIRE(centre != c.points.end());
  *centre += Vec3(0.31, 0.3, 0.3);
  const std::vector<Vec3> before = c.points;
  const auto worst = [&] {
    const std::vector<double> q = proved_scaled_jacobians(c.points, c.hexes);
    return *std::min_element(q.begin(), q.end());
  };
  const double bad = worst();
  REQUIRE(bad > 0);
  REQUIRE(bad < 0.25);
  SmoothOptions options = sized(1);
  Workers workers(1, context);
  const int middle = static_cast<int>(centre - c.points.begin());
  SmoothSetting setting{box, options, context, workers, {}, {}, std::vector<char>(c.points.size(), 0)};
  setting.held.assign(c.points.size(), 1);
  polish_worst(c, setting);
  CHECK(c.points == before);
  setting.held.assign(c.points.size(), 0);
  // Tied to a corner by a line that is too long already, the middle may come nearer to it only.
  const int corner = static_cast<int>(std::find(before.begin(), before.end(), Vec3(2, 2, 2)) - before.begin());
  HexComplex tied = c;
  setting.spans.push_back({middle, corner, 0.5 * (before[middle] - Vec3(2, 2, 2)).norm(), 0});
  polish_worst(tied, setting);
  CHECK((tied.points[middle] - Vec3(2, 2, 2)).norm() <= (before[middle] - Vec3(2, 2, 2)).norm() + 1e-12);
  setting.spans.clear();
  polish_worst(c, setting);
  CHECK(worst() > bad + 0.02);
  for (int v = 0; v < c.point_count(); ++v) {
    CHECK((c.points[v] - before[v]).norm() <= 0.25 + 1e-12);
    if (c.place[v].dim == 2) CHECK((box.project_to_face(c.place[v].entity, c.points[v], nullptr).point - c.points[v]).norm() < 1e-12);
  }
  const HexComplex once = c;
  for (int v = 0; v < c.point_count(); ++v) c.points[v] = before[v];
  c.place = once.place;
  polish_worst(c, setting);
  CHECK(c.points == once.points);
}

TEST_CASE("the least scaled Jacobian is raised where points must move together") {
  HexComplex start = box_mesh({3, 3, 3}, Vec3(3, 3, 3));
  const BoxProjector box(Vec3(3, 3, 3));
  for (Vec3& p : start.points)  // the eight points inside turned about the middle, and pushed aside
    if ((p - Vec3(1.5, 1.5, 1.5)).cwiseAbs().maxCoeff() < 1) {
      const Vec3 d = p - Vec3(1.5, 1.5, 1.5);
      p += 0.65 * Vec3(-d.y(), d.x(), 0) + Vec3(0.22, 0.18, 0.1);
    }
  const auto worst = [](const HexComplex& c) {
    const std::vector<double> q = proved_scaled_jacobians(c.points, c.hexes);
    return *std::min_element(q.begin(), q.end());
  };
  const double bad = worst(start);
  REQUIRE(bad > 0);
  REQUIRE(bad < 0.2);
  const SmoothOptions options = sized(1);
  const auto raised = [&](int threads, char held, std::vector<Span> spans) {
    Workers workers(threads, context);
    SmoothSetting setting{box,
                          options,
                          context,
                          workers,
                          std::vector<double>(start.hexes.size(), 1),
                          std::move(spans),
                          std::vector<char>(start.points.size(), held)};
    HexComplex c = start;
    raise_minimum(c, setting);
    return c;
  };
  CHECK(raised(1, 1, {}).points == start.points);
  const HexComplex c = raised(1, 0, {});
  HexComplex polished = start;
  {
    Workers workers(1, context);
    SmoothSetting setting{box, options, context, workers, {}, {}, std::vector<char>(start.points.size(), 0)};
    polish_worst(polished, setting);
  }
  CHECK(worst(c) > 0.99);
  CHECK(worst(polished) < 0.4);
  for (int v = 0; v < c.point_count(); ++v)
    if (c.place[v].dim == 2) CHECK((box.project_to_face(c.place[v].entity, c.points[v], nullptr).point - c.points[v]).norm() < 1e-12);
  CHECK(raised(2, 0, {}).points == c.points);
  // A mesh edge along a CAD curve that is as long as it should be does not grow by more than its barrier allows.
  const auto& e = start.hexes[13];
  const double length = (start.points[e[0]] - start.points[e[1]]).norm();
  const HexComplex tied = raised(1, 0, {{e[0], e[1], length, 0}});
  CHECK((tied.points[e[0]] - tied.points[e[1]]).norm() < std::sqrt(1.2) * length);
}

TEST_CASE("bad places that share nothing are lifted on any number of threads, also when the worst is in vain") {
  HexComplex start = box_mesh({24, 3, 3}, Vec3(24, 3, 3));
  const BoxProjector box(Vec3(24, 3, 3));
  std::vector<char> held(start.points.size(), 0);
  for (int v = 0; v < start.point_count(); ++v) {
    Vec3& p = start.points[v];
    if (start.place[v].dim != 3 || std::lround(p.x()) % 4 != 0) continue;  // five bad places in a row
    held[v] = p.x() > 18;                                                  // and the worst of them cannot be lifted
    p += (held[v] ? 1.02 : 1.0) * Vec3(0.38, 0.27, -0.27);
  }
  const SmoothOptions options = sized(1);
  const auto lifted = [&](int threads) {
    Workers workers(threads, context);
    SmoothSetting setting{box, options, context, workers, std::vector<double>(start.hexes.size(), 1), {}, held};
    HexComplex c = start;
    lift_places(c, setting);
    return c;
  };
  const std::vector<double> before = proved_scaled_jacobians(start.points, start.hexes);
  REQUIRE(*std::min_element(before.begin(), before.end()) > 0);
  const HexComplex c = lifted(1);
  const std::vector<double> after = proved_scaled_jacobians(c.points, c.hexes);
  double bad = 1, least = 1;
  for (int h = 0; h < c.hex_count(); ++h) {
    Vec3 centre = Vec3::Zero();
    for (int v : start.hexes[h]) centre += start.points[v] / 8;
    if (centre.x() > 17) continue;
    bad = std::min(bad, before[h]);
    least = std::min(least, after[h]);
  }
  CHECK(bad < 0.3);
  CHECK(least > 0.4);
  CHECK(lifted(2).points == c.points);
  CHECK(lifted(5).points == c.points);
}

TEST_CASE("the mean is lifted as far as the worst element allows") {
  HexComplex c = box_mesh({6, 6, 6}, Vec3(6, 6, 6));
  const BoxProjector box(Vec3(6, 6, 6));
  std::vector<char> held(c.points.size(), 0);
  unsigned seed = 1;
  const auto noise = [&] { return ((seed = seed * 1103515245u + 12345u) >> 16 & 1023) / 1023.0 - 0.5; };
  for (int v = 0; v < c.point_count(); ++v) {
    Vec3& p = c.points[v];
    held[v] = p.maxCoeff() < 2.5;  // the worst element is here, and it stays
    if (c.place[v].dim == 3)
      p += p.maxCoeff() < 1.5 ? Vec3(0.35, 0.3, 0.3) : held[v] ? Vec3(0, 0, 0) : Vec3(0.4 * Vec3(noise(), noise(), noise()));
  }
  const SmoothOptions options = sized(1);
  Workers workers(2, context);
  SmoothSetting setting{box, options, context, workers, std::vector<double>(c.hexes.size(), 1), {}, held};
  std::vector<double> quality;
  measure(c, workers, quality);
  const Grade before = grade_of(quality);
  REQUIRE(before.inverted == 0);
  REQUIRE(before.min_sj < 0.5);
  const std::vector<double> was = quality;
  lift_mean(c, setting);
  measure(c, workers, quality);
  for (std::size_t h = 0; h < was.size(); ++h)
    if (was[h] < 0.5) CHECK(quality[h] >= 0.97 * was[h]);
  const Grade after = grade_of(quality);
  CHECK(after.min_sj >= before.min_sj - 1e-9);
  CHECK(after.min_sj < 0.6);
  CHECK(after.sum_sj > before.sum_sj + 0.02 * c.hex_count());
}

TEST_CASE("a smoothed mesh's mean is lifted, its worst element is not worse for it, and held points stay") {
  HexComplex c = sphere_mesh(10, 5);
  const SmoothReport smoothed = smooth(c, SphereProjector(5), sized(1), context);
  SmoothOptions held = sized(1);
  for (int v = 0; v < c.point_count(); ++v)
    if (c.place[v].dim <= 2) held.held.push_back(v);
  const HexComplex before = c;
  HexComplex inside = c;
  for (auto* mesh : {&c, &inside}) {
    const SmoothReport lifted = smooth_mean(*mesh, SphereProjector(5), mesh == &c ? sized(1) : held, context);
    CHECK(lifted.mean_sj > smoothed.mean_sj + (mesh == &c ? 0.01 : 0.001));
    CHECK(lifted.min_sj >= smoothed.min_sj - 1e-9);
    CHECK(lifted.deviation < 1e-9 * 5);
  }
  for (int v : held.held) CHECK((inside.points[v] - before.points[v]).norm() < 1e-12);
}

TEST_CASE("what is stuck at the rim of a neighbourhood moves nothing beyond it") {
  const Vec3 size(30, 3, 3);
  HexComplex c = box_mesh({30, 3, 3}, size);
  const auto at = [&](const Vec3& p) {
    return static_cast<int>(std::find_if(c.points.begin(), c.points.end(), [&](const Vec3& q) { return (p - q).norm() < 1e-9; }) -
                            c.points.begin());
  };
  // Two points that may not move have changed places where the neighbourhood of others ends.
  SmoothOptions options = sized(1);
  options.around = {at(Vec3(9, 1, 1)), at(Vec3(15, 1, 1)), at(Vec3(21, 1, 1))};
  options.held = {at(Vec3(5, 1, 1)), at(Vec3(6, 1, 1))};
  std::swap(c.points[options.held[0]], c.points[options.held[1]]);
  c.points[at(Vec3(3, 2, 2))] += Vec3(0.1, 0.2, 0.1);  // which would relax
  const HexComplex before = c;
  const SmoothReport report = smooth(c, BoxProjector(size), options, context);
  CHECK(report.inverted > 0);
  CHECK(report.rounds > 4);
  int moved = 0;
  for (int v = 0; v < c.point_count(); ++v) {
    const bool same = std::memcmp(&c.points[v], &before.points[v], sizeof(Vec3)) == 0;
    moved += !same;
    if (before.points[v].x() < 4.9 || before.points[v].x() > 25.1) CHECK(same);
  }
  CHECK(moved > 0);
}

TEST_CASE("around new points only their neighbourhood moves") {
  const Vec3 size(12, 3, 3);
  const BoxProjector projector(size);
  HexComplex c = box_mesh({12, 3, 3}, size);
  const HexComplex before = c;
  // One point of the top is pushed towards another.
  int pushed = -1;
  for (int v = 0; v < c.point_count(); ++v)
    if (c.points[v] == Vec3(2, 1, 3)) pushed = v;
  REQUIRE(pushed >= 0);
  c.points[pushed] = Vec3(2.7, 1.7, 3);
  SmoothOptions options = sized(1);
  options.around = {pushed};
  const SmoothReport report = smooth(c, projector, options, context);
  CHECK(report.inverted == 0);
  CHECK(report.min_sj > 0.99);
  CHECK((c.points[pushed] - before.points[pushed]).norm() < 0.05);
  for (int v = 0; v < c.point_count(); ++v)
    if (before.points[v].x() > 8) CHECK(std::memcmp(&c.points[v], &before.points[v], sizeof(Vec3)) == 0);
  // Held, it stays where it is, and the others make room.
  HexComplex held = before;
  held.points[pushed] = Vec3(2.3, 1.2, 3);
  options.held = {pushed};
  const SmoothReport with = smooth(held, projector, options, context);
  CHECK(with.inverted == 0);
  CHECK(held.points[pushed] == Vec3(2.3, 1.2, 3));
}
