// HexFeatureWB - LGPL-2.1-or-later
// The driver of the methods, with methods made up for it.
#include <doctest/doctest.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <memory>
#include <thread>

#include "pipeline/solid.h"
#include "pipeline_fixtures.h"
#include "tetsplit/tets_ahead.h"

using namespace hexfeature;
using namespace fixtures;

namespace {

/// A method whose mesh is worth that, and has so many points as its name is long.
Method yields(const std::string& name, bool faithful, double min_sj, double mean_sj) {
  return {name, [=](const SolidTask& task) {
            Candidate candidate;
            candidate.method = name;
            candidate.mesh.points.resize(name.size());
            candidate.worth.faithful = faithful;
            candidate.worth.lost = faithful ? 0 : 0.05;
            candidate.worth.min_sj = min_sj;
            candidate.worth.mean_sj = mean_sj;
            Attempt attempt;
            attempt.method = name;
            task.record(attempt, Context::Clock::now());
            return candidate;
          }};
}

Method fails(const std::string& name, Failure kind) {
  return {name, [=](const SolidTask& task) -> Candidate {
            Attempt attempt;
            attempt.method = name;
            attempt.step = "somewhere";
            attempt.reason = name + " cannot";
            task.record(attempt, Context::Clock::now());
            throw MeshingError(kind, "somewhere", name + " cannot", "another size", {7});
          }};
}

struct Outcome {
  HexComplex mesh;
  Result result;
};

Outcome run(const std::vector<Method>& methods, const std::string& chosen = "auto", double seconds = 0) {
  Outcome outcome;
  NoPart part;
  Options options;
  options.method = chosen;
  Context context;
  if (seconds > 0)
    context.deadline = Context::Clock::now() + std::chrono::duration_cast<Context::Clock::duration>(std::chrono::duration<double>(seconds));
  Run all(options, context, outcome.result);
  outcome.mesh = mesh_solid(part, 1, {Mat3::Identity()}, all, methods);
  return outcome;
}

}  // namespace

TEST_CASE("the first method that suffices ends the search") {
  const Outcome outcome = run({yields("one", true, 0.15, 0.9), yields("three", true, 0.9, 0.95)});
  CHECK(outcome.result.method == "one");
  CHECK(outcome.mesh.points.size() == 3);
  CHECK(outcome.result.attempts.size() == 1);
}

TEST_CASE("when a method gives up, the next goes on, and the report says why") {
  const Outcome outcome = run({fails("first", Failure::NoMesh), yields("second", true, 0.3, 0.6)});
  CHECK(outcome.result.method == "second");
  REQUIRE(outcome.result.attempts.size() == 2);
  CHECK(outcome.result.attempts[0].reason == "first cannot");
  CHECK(outcome.result.attempts[1].reason.empty());
}

TEST_CASE("the best mesh is kept, not the first nor the last: faithful, then sound, then quality") {
  CHECK(run({yields("lossy", false, 0.7, 0.9), yields("faithful", true, 0.05, 0.5)}).result.method == "faithful");
  CHECK(run({yields("faithful", true, 0.05, 0.5), yields("lossy", false, 0.7, 0.9)}).result.method == "faithful");
  CHECK(run({yields("poor", true, 0.09, 0.95), yields("sound", true, 0.25, 0.6)}).result.method == "sound");
  const Outcome kept = run({yields("good", true, 0.08, 0.9), yields("bad", true, 0.07, 0.6)});
  CHECK(kept.result.method == "good");
  REQUIRE(kept.result.attempts.size() == 2);
  CHECK(kept.result.attempts[0].reason.empty());
  CHECK(kept.result.attempts[1].reason == "the mesh of another method is better");
}

TEST_CASE("when all give up, the first one's reason is told") {
  try {
    run({fails("first", Failure::NoMesh), fails("second", Failure::NoMesh)});
    FAIL("no error");
  } catch (const MeshingError& error) {
    CHECK(error.reason == "first cannot");
    CHECK(error.cad_faces == std::vector<int>{7});
  }
}

TEST_CASE("a method chosen by name is the only one") {
  CHECK(run({yields("one", true, 0.9, 0.9), yields("two", true, 0.5, 0.9)}, "two").result.method == "two");
  CHECK_THROWS_AS(run({fails("one", Failure::NoMesh), yields("two", true, 0.5, 0.9)}, "one"), MeshingError);
}

TEST_CASE("what is not for want of a mesh ends the run") {
  CHECK_THROWS_AS(run({fails("one", Failure::BadInput), yields("two", true, 0.5, 0.9)}), MeshingError);
  CHECK_THROWS_AS(run({fails("one", Failure::Cancelled), yields("two", true, 0.5, 0.9)}), MeshingError);
}

namespace {

const Method kSlow{"slow", [](const SolidTask& task) -> Candidate {
                     Context& context = task.run.context;
                     CHECK(context.deadline < Context::Clock::now() + std::chrono::seconds(1801));  // half of the hour
                     context.deadline = Context::Clock::now() - std::chrono::milliseconds(1);       // time flies
                     context.check();
                     FAIL("not stopped");
                     return {};
                   }};

const Method kLarge{"large", [](const SolidTask&) -> Candidate { throw MemoryLimit(); }};

}  // namespace

TEST_CASE("a method that uses up its share of the time makes room for the next") {
  const Outcome outcome = run({kSlow, yields("quick", true, 0.4, 0.6)}, "auto", 3600);
  CHECK(outcome.result.method == "quick");
  REQUIRE(outcome.result.attempts.size() == 2);
  CHECK(outcome.result.attempts[0].method == "slow");
  CHECK(outcome.result.attempts[0].reason == "its share of the time limit is used up");
}

TEST_CASE("a mesh that is there is kept when the next method has no time or memory left") {
  const Method poor = yields("poor", true, 0.05, 0.5);
  const Outcome late = run({poor, kSlow}, "auto", 3600);
  CHECK(late.result.method == "poor");
  REQUIRE(late.result.attempts.size() == 2);
  CHECK(late.result.attempts[0].reason.empty());
  CHECK(late.result.attempts[1].reason == "its share of the time limit is used up");
  const Outcome large = run({poor, kLarge});
  CHECK(large.result.method == "poor");
  REQUIRE(large.result.attempts.size() == 2);
  CHECK(large.result.attempts[1].reason == "memory limit reached");
}

TEST_CASE("a method that needs too much memory makes room for the next") {
  CHECK(run({kLarge, yields("small", true, 0.4, 0.6)}).result.method == "small");
  try {
    run({kLarge}, "large");
    FAIL("no error");
  } catch (const MeshingError& error) {
    CHECK(error.kind == Failure::NoMesh);
    CHECK(error.reason == "memory limit reached");
  }
}

TEST_CASE("why no mesh could be made is told rather than that time ran out") {
  try {
    run({kSlow, fails("second", Failure::NoMesh)}, "auto", 3600);
    FAIL("no error");
  } catch (const MeshingError& error) {
    CHECK(error.kind == Failure::NoMesh);
    CHECK(error.reason == "second cannot");
  }
}

TEST_CASE("a cancel ends the run, also with a mesh there and its share of the time used up") {
  for (const bool late : {false, true}) {
    const Method cancelled{"cancelled", [late](const SolidTask& task) -> Candidate {
                             Context& context = task.run.context;
                             if (late) context.deadline = Context::Clock::now() - std::chrono::milliseconds(1);
                             context.is_cancelled = [asked = 0]() mutable { return asked++ == 0; };  // says so once
                             context.check();
                             return {};
                           }};
    CHECK_THROWS_AS(run({yields("poor", true, 0.05, 0.5), cancelled}, "auto", 3600), MeshingError);
  }
}

TEST_CASE("what may better one solid leaves time for those to come") {
  struct Two : NoPart {
    int solid_count() const override { return 2; }
  } part;
  Options options;
  Context context;
  context.deadline = Context::Clock::now() + std::chrono::hours(1);
  Result result;
  Run all(options, context, result);
  std::vector<double> minutes;
  const Method clock{"clock", [&](const SolidTask& task) -> Candidate {
                       minutes.push_back(std::chrono::duration<double>(task.run.context.deadline - Context::Clock::now()).count() / 60);
                       return yields("poor", true, 0.05, 0.5).mesh(task);
                     }};
  for (int solid : {1, 2}) mesh_solid(part, solid, {Mat3::Identity()}, all, {clock, clock});
  REQUIRE(minutes.size() == 4);
  CHECK(minutes[0] == doctest::Approx(15).epsilon(0.01));
  CHECK(minutes[1] == doctest::Approx(15).epsilon(0.01));
  CHECK(minutes[2] == doctest::Approx(30).epsilon(0.01));
}

namespace {

/// A box of 4 x 3 x 2, read from an STL file.
std::unique_ptr<Part> box_part(Context& context) {
  const std::filesystem::path path = std::filesystem::temp_directory_path() / "hexfeature_driver_box.stl";
  {
    std::ofstream file(path);
    file << "solid box\n";
    constexpr int kSides[6][4] = {{0, 2, 6, 4}, {1, 5, 7, 3}, {0, 4, 5, 1}, {2, 3, 7, 6}, {0, 1, 3, 2}, {4, 6, 7, 5}};
    for (const auto& side : kSides)
      for (int k : {1, 2}) {
        file << "facet normal 0 0 0\nouter loop\n";
        for (int corner : {side[0], side[k], side[k + 1]})
          file << "vertex " << 4 * (corner & 1) << ' ' << 3 * (corner >> 1 & 1) << ' ' << 2 * (corner >> 2) << '\n';
        file << "endloop\nendfacet\n";
      }
    file << "endsolid box\n";
  }
  std::unique_ptr<Part> part = read_part(path.string(), {}, context);
  std::filesystem::remove(path);
  return part;
}

}  // namespace

TEST_CASE("tetrahedra made ahead give tet-split's own mesh, in whatever frames the method before it was") {
  Context context;
  const std::unique_ptr<Part> part = box_part(context);
  Mat3 turned;
  turned << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  const std::vector<Mat3> frames{Mat3::Identity(), turned};
  int seen = 0, taken = 0;  // begun when the first method gave up; used by tet-split
  context.on_log = [&](const std::string& line) { taken += line.find("made ahead") != std::string::npos; };
  const auto mesh_with = [&](const std::string& chosen, int last_frame) {
    const Method slow{"feature-line", [&](const SolidTask& task) -> Candidate {
                        task.place(0);
                        begin_tets_ahead(task);
                        seen += task.run.tets_ahead != nullptr;
                        std::this_thread::sleep_for(std::chrono::milliseconds(800));
                        task.place(last_frame);
                        throw MeshingError(Failure::NoMesh, "labels", "in vain");
                      }};
    Options options;
    options.method = chosen;
    options.size = 1;
    Result result;
    Run run(options, context, result);
    return mesh_solid(*part, 1, frames, run, {slow, {"tet-split", mesh_by_tet_split}});
  };
  const HexComplex alone = mesh_with("tet-split", 0);
  CHECK(seen == 0);
  CHECK(taken == 0);
  REQUIRE(alone.hex_count() > 0);
  for (int frame : {0, 1}) {
    const HexComplex mesh = mesh_with("auto", frame);
    CHECK(seen == frame + 1);
    CHECK(taken == seen);  // made when the frame changed, if not long before
    CHECK(mesh.points == alone.points);
    CHECK(mesh.hexes == alone.hexes);
  }
}
