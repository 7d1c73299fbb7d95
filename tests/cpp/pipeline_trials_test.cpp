// HexFeatureWB - LGPL-2.1-or-later
// The choice of sheets, with meshes made up for it.
#include <doctest/doctest.h>

#include <algorithm>
#include <chrono>

#include "pipeline/sheet_trials.h"

using namespace hexfeature;

namespace {

/// Three sheets A, B, C, inserted in this order and all at the worst element. `outcome` says what a mesh without some of them is worth.
struct Outcome {
  double min_sj = 0;
  int inverted = 0;
  double lost = 0;
  bool edges_lost = false;
  double mean_sj = 0;
  bool again = false;
};

struct Workshop {
  std::function<Outcome(const std::string& without)> outcome;
  std::string worst_at = "ABC";
  std::vector<std::string> asked{};  ///< without which sheets, trial by trial

  SheetTrial mesh(const SheetNames& without) {
    std::string letters;
    for (const auto& name : without) letters += static_cast<char>('A' + name[0]);
    asked.push_back(letters);
    SheetTrial trial;
    const Outcome o = outcome(letters);
    trial.smoothing.min_sj = trial.worth.min_sj = o.min_sj;
    trial.smoothing.mean_sj = o.mean_sj;
    trial.smoothing.inverted = o.inverted;
    trial.again = o.again;
    trial.worth.lost = o.lost;
    trial.worth.faithful = o.lost == 0 && o.inverted == 0;
    trial.worth.edges_lost = o.edges_lost;
    trial.sheets.taken_back = static_cast<int>(without.size());
    for (int sheet = 0; sheet < 3; ++sheet)
      if (letters.find(static_cast<char>('A' + sheet)) == std::string::npos) trial.sheets.names.push_back({sheet});
    trial.sheets.inserted = static_cast<int>(trial.sheets.names.size());
    for (char c : worst_at)
      if (letters.find(c) == std::string::npos) trial.suspects.push_back({c - 'A'});
    return trial;
  }
  SheetTrial run(const SheetRules& rules = {}) {
    Context context;
    return try_sheets([this](const SheetNames& without, bool) { return mesh(without); }, rules, context);
  }
};

using Asked = std::vector<std::string>;

}  // namespace

TEST_CASE("a good mesh keeps all its sheets, and so does one that is bad elsewhere") {
  Workshop good{[](const std::string&) { return Outcome{0.6}; }};
  CHECK(good.run().smoothing.min_sj == 0.6);
  CHECK(good.asked == Asked{""});
  Workshop elsewhere{[](const std::string&) { return Outcome{0.3}; }, ""};
  elsewhere.run();
  CHECK(elsewhere.asked == Asked{""});
}

TEST_CASE("a mesh with a bad element far from all sheets is made once without any") {
  Workshop without_any{[](const std::string& without) { return Outcome{without.empty() ? 0.1 : 0.15}; }, ""};
  CHECK(without_any.run().smoothing.min_sj == 0.15);
  CHECK(without_any.asked == Asked{"", "ABC"});
  Workshop one{[](const std::string& without) { return Outcome{without.empty() ? 0.15 : 0.1}; }, "ABC"};
  CHECK(one.run().smoothing.min_sj == 0.15);
  CHECK(one.asked == Asked{"", "C", "B", "A", "ABC"});  // the last is that very mesh
  Workshop in_vain{[](const std::string& without) { return Outcome{without.empty() ? 0.15 : 0.1}; }, "C"};
  CHECK(in_vain.run().smoothing.min_sj == 0.15);
  CHECK(in_vain.asked == Asked{"", "C", "ABC"});
}

TEST_CASE("sheets at the worst element are left out one by one, the last first, then all; the best stays") {
  Workshop none_helps{[](const std::string& without) { return Outcome{without.empty() ? 0.3 : 0.2}; }};
  CHECK(none_helps.run().sheets.taken_back == 0);
  CHECK(none_helps.asked == Asked{"", "C", "B", "A", "ABC"});
  Workshop b_helps{[](const std::string& without) { return Outcome{without == "B" ? 0.6 : 0.3}; }};
  CHECK(b_helps.run().smoothing.min_sj == 0.6);
  CHECK(b_helps.asked == Asked{"", "C", "B"});
  Workshop all_help{[](const std::string& without) { return Outcome{without.size() == 3 ? 0.6 : 0.3}; }};
  CHECK(all_help.run().sheets.taken_back == 3);
}

TEST_CASE("what was left out stays out while others are tried; six trials are enough") {
  Workshop each{[](const std::string& without) { return Outcome{0.1 + 0.1 * static_cast<double>(without.size())}; }};
  CHECK(each.run().sheets.taken_back == 3);
  CHECK(each.asked == Asked{"", "C", "CB", "CBA"});
  Workshop many{[](const std::string& without) { return Outcome{without.empty() ? 0.2 : 0.1}; }, "ABCDEFGHIJ"};
  many.run();
  CHECK(many.asked == Asked{"", "J", "I", "H", "G", "F"});
}

TEST_CASE("a gain that nobody sees keeps the sheets; a mesh that keeps more of the part is better, whatever its worst element") {
  Workshop little{[](const std::string& without) { return Outcome{without.empty() ? 0.3 : 0.304}; }};
  CHECK(little.run().sheets.taken_back == 0);
  Workshop faithful{[](const std::string& without) { return Outcome{without == "C" ? 0.25 : 0.4, 0, without == "C" ? 0 : 0.05}; }};
  CHECK(faithful.run().sheets.taken_back == 1);
  CHECK(faithful.run().worth.faithful);
}

TEST_CASE("of meshes whose worst elements are alike the one of the better mean is kept") {
  const auto outcome = [](double least, double mean) {
    return [least, mean](const std::string& without) {
      return without == "C" ? Outcome{least, 0, 0, false, mean} : Outcome{0.3, 0, 0, false, 0.9};
    };
  };
  CHECK(Workshop{outcome(0.299, 0.92)}.run().sheets.taken_back == 1);
  CHECK(Workshop{outcome(0.29, 0.92)}.run().sheets.taken_back == 0);
  CHECK(Workshop{outcome(0.299, 0.9002)}.run().sheets.taken_back == 0);
}

TEST_CASE("the very mesh of an earlier choice is no better, whatever is not known of it") {
  Workshop inverted{[](const std::string& without) { return without.empty() ? Outcome{0, 4} : Outcome{0, 0, 0, false, 0, true}; }};
  CHECK(inverted.run().smoothing.inverted == 4);
  Workshop sound{[](const std::string& without) { return without.empty() ? Outcome{0.3} : Outcome{0.9, 0, 0, false, 0.9, true}; }};
  CHECK(sound.run().smoothing.min_sj == 0.3);
}

TEST_CASE("with inverted elements: once without all the sheets there, or not at all") {
  const auto outcome = [](const std::string& without) { return Outcome{0.2, without.empty() ? 5 : 3}; };
  Workshop inverted{outcome};
  CHECK(inverted.run().smoothing.inverted == 3);
  CHECK(inverted.asked == Asked{"", "ABC"});
  Workshop once{outcome};
  CHECK(once.run({true, false}).smoothing.inverted == 5);
  CHECK(once.asked == Asked{""});
}

TEST_CASE("sharp edges lost by the labels are left to the next method, where there is one") {
  const auto outcome = [](const std::string&) { return Outcome{0.3, 0, 0.3, true}; };
  Workshop next{outcome}, last{outcome};
  next.run({false, true});
  CHECK(next.asked == Asked{""});
  last.run({false, false});
  CHECK(last.asked.size() == 5);
}

TEST_CASE("when the time for more trials is used up, the mesh that is there stays") {
  Context context;
  context.deadline = Context::Clock::now() + std::chrono::hours(1);
  int asked = 0;
  const SheetTrial kept = try_sheets(
      [&](const SheetNames&, bool) {
        if (++asked > 1) {
          context.deadline = Context::Clock::now() - std::chrono::milliseconds(1);  // time flies
          context.check();
        }
        SheetTrial trial;
        trial.worth.faithful = true;
        trial.smoothing.min_sj = 0.3;
        trial.suspects = {{0}, {1}};
        return trial;
      },
      {}, context);
  CHECK(asked == 2);
  CHECK(kept.smoothing.min_sj == 0.3);
  CHECK(context.deadline > Context::Clock::now() + std::chrono::minutes(59));
}

TEST_CASE("sheets that run through the part are tried shorter where one is refused or the mesh is bad at them, before any is left out") {
  struct Made {
    std::size_t without;
    bool run_through;
  };
  std::vector<Made> made;
  const auto run = [&](double through, double shorter, int refused, int could_be_shorter) {
    made.clear();
    Context context;
    return try_sheets(
        [&](const SheetNames& without, bool run_through) {
          made.push_back({without.size(), run_through});
          SheetTrial trial;
          trial.worth.faithful = true;
          trial.smoothing.min_sj = trial.worth.min_sj = run_through ? through : shorter;
          trial.sheets.names = {{0}};
          trial.sheets.inserted = 1;
          trial.sheets.refused = run_through ? refused : 0;
          trial.sheets.run_through = run_through ? could_be_shorter : 0;
          trial.suspects = {{0}};
          return trial;
        },
        {}, context);
  };
  CHECK(run(0.6, 0.7, 0, 1).smoothing.min_sj == 0.6);
  CHECK(made.size() == 1);
  CHECK(run(0.6, 0.7, 1, 1).smoothing.min_sj == 0.7);
  CHECK(made.size() == 2);
  CHECK(run(0.6, 0.7, 1, 0).smoothing.min_sj == 0.6);
  CHECK(made.size() == 1);
  CHECK(run(0.3, 0.6, 0, 1).smoothing.min_sj == 0.6);
  CHECK(made.size() == 2);
  // Worse: those that run through stay, and what is left out is left out of them.
  CHECK(run(0.3, 0.2, 0, 1).smoothing.min_sj == 0.3);
  REQUIRE(made.size() == 3);
  CHECK(made[1].without == 0);
  CHECK_FALSE(made[1].run_through);
  CHECK(made[2].without == 1);
  CHECK(made[2].run_through);
  // Better, but still bad: the shorter ones are left out.
  CHECK(run(0.3, 0.4, 0, 1).smoothing.min_sj == 0.4);
  REQUIRE(made.size() == 3);
  CHECK_FALSE(made[2].run_through);
}
