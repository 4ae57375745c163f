// SPDX-License-Identifier: GPL-3.0-or-later
// The maximum read off a sorted list, and the sharing of that list.
#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

#include "structures/plan.h"
#include "structures/registry.h"
#include "tests/structures/test_run.h"
#include "tests/structures/test_scenes.h"

namespace kinex::test {
namespace maximum_of_list_test {

Request asked(const std::string& structure, const std::string& label = "", int axis = 0) {
  Request request{structure, label.empty() ? structure : label, {}};
  request.key.axis = axis;
  return request;
}

struct SharedRun {
  SharedRun(Scene scene, std::vector<Request> requests, const std::string& arithmetic = "exact")
      : simulator((scene.maintain = std::move(requests), scene), make_arithmetic(arithmetic, scene),
                  Trial::options(AuditLevel::kEvents)),
        sink(simulator) {
    add_structures(simulator, scene);
    simulator.set_sink(&sink);
    simulator.start();
    simulator.run_until(std::nullopt);
    EXPECT_EQ(simulator.violations(), std::vector<std::string>{});
  }
  // The report of one structure, without its label.
  std::vector<std::string> told_by(const std::string& label) const {
    std::vector<std::string> result;
    for (const std::string& line : sink.lines) {
      if (line.rfind(label + " ", 0) == 0) result.push_back(line.substr(label.size() + 1));
    }
    return result;
  }
  std::vector<std::string> labels() const {
    std::vector<std::string> result;
    for (StructureId id = 0; id < simulator.structures(); ++id) {
      result.push_back(simulator.label(id));
    }
    return result;
  }
  Simulator simulator;
  LogSink sink;
};

// The tournament's events at its root are those of the maximum.
std::vector<std::string> external_of(const std::vector<std::string>& lines) {
  std::vector<std::string> result;
  for (const std::string& line : lines) {
    if (line.back() == '!') result.push_back(line);
  }
  return result;
}

// No two pairs meet at one instant.
Scene generic_scene(unsigned seed, int n, int degree) {
  std::mt19937 random(seed);
  std::vector<Trajectory> t;
  for (int i = 0; i < n; ++i) {
    std::vector<Rational> c;
    for (int k = 0; k <= degree; ++k) {
      c.emplace_back(static_cast<int>(random() >> 8) - (1 << 23));
    }
    t.push_back(path({c}));
  }
  return scene_of(t, -2, Rational(2));
}

TEST(MaximumOfList, IsRightThroughFlightPlansAndTies) {
  // Audited after every instant.
  for (const int degree : {1, 2, 3}) {
    for (const unsigned seed : {1u, 2u, 3u}) {
      SharedRun run(random_flights(seed, 24, 1, degree, seed == 3),
                    {asked("maximum_sorted_list"), asked("minimum_sorted_list")});
      EXPECT_GT(run.simulator.ledger(1).external, 0u);
    }
  }
}

TEST(MaximumOfList, AgreesWithTheTournament) {
  for (const int degree : {1, 2, 3}) {
    for (const unsigned seed : {1u, 2u, 3u}) {
      const Scene scene = generic_scene(seed, 24, degree);
      SharedRun run(scene, {asked("maximum_sorted_list"), asked("minimum_sorted_list"),
                            asked("maximum_tournament"), asked("minimum_tournament")});
      SCOPED_TRACE("degree " + std::to_string(degree) + ", seed " + std::to_string(seed));
      for (const std::string kind : {"maximum", "minimum"}) {
        const auto list = external_of(run.told_by(kind + "_sorted_list"));
        EXPECT_EQ(list, external_of(run.told_by(kind + "_tournament")));
        EXPECT_FALSE(list.empty());
      }
      EXPECT_EQ(run.simulator.ledger(1).external,
                external_of(run.told_by("maximum_sorted_list")).size());
    }
  }
}

TEST(MaximumOfList, WorstCase) {
  // n lines, tangents of a parabola: the maximum is each of them in turn.
  std::vector<Trajectory> t;
  for (int i = 0; i < 12; ++i) t.push_back(path({{-i * i, i}}));
  SharedRun run(scene_of(t, 0, std::nullopt), {asked("maximum_sorted_list")});
  EXPECT_EQ(run.simulator.ledger(1).external, 11u);
  EXPECT_EQ(run.simulator.ledger(0).processed, 66u);
}

TEST(MaximumOfList, OfTiesTheSmallestId) {
  // 1 and 2 are identically equal and overtake 0 at 3; then they are the largest, and 1 wins.
  SharedRun run(scene_of({path({{3}}), path({{0, 1}}), path({{0, 1}})}, 0, Rational(4)),
                {asked("maximum_sorted_list"), asked("minimum_sorted_list")});
  EXPECT_EQ(run.simulator.structure(1).attribute().ids, std::vector<ObjectId>{1});
  EXPECT_EQ(run.simulator.structure(2).attribute().ids, std::vector<ObjectId>{0});
  EXPECT_EQ(run.told_by("minimum_sorted_list"), std::vector<std::string>{"replace 1 0 !"});
}

TEST(Plan, ListsAreSharedByKey) {
  const Scene scene =
      scene_of({path({{0, 1}, {0}}), path({{1}, {0, 1}}), path({{2}, {1}})}, 0, Rational(4));
  // Requested last, and read by two: one list, in front of them.
  SharedRun shared(
      scene, {asked("maximum_sorted_list"), asked("minimum_sorted_list"), asked("sorted_list")});
  EXPECT_EQ(shared.labels(), (std::vector<std::string>{"sorted_list", "maximum_sorted_list",
                                                       "minimum_sorted_list"}));
  // By another key it is another list, not requested.
  SharedRun apart(scene, {asked("sorted_list"), asked("maximum_sorted_list", "top", 1)});
  EXPECT_EQ(apart.labels(), (std::vector<std::string>{"sorted_list", "top.sorted_list", "top"}));
  // The label that it would have is taken.
  SharedRun named(scene,
                  {asked("maximum_sorted_list", "top"), asked("delaunay_2", "top.sorted_list")});
  EXPECT_EQ(named.labels(),
            (std::vector<std::string>{"top.sorted_list'", "top", "top.sorted_list"}));
}

TEST(Plan, SharingCostsNothing) {
  const Scene scene = random_flights(5, 30, 1, 1, false);
  SharedRun list(scene, {asked("sorted_list")});
  SharedRun all(scene,
                {asked("sorted_list"), asked("maximum_sorted_list"), asked("minimum_sorted_list")});
  const auto solved = [](const SharedRun& run) {
    return run.simulator.arithmetic().counters().polynomials_solved;
  };
  EXPECT_EQ(solved(list), solved(all));
}

TEST(Plan, ReadersNeedSomethingToRead) {
  const Scene scene = scene_of({path({{0}})}, 0, Rational(1));
  Simulator simulator(scene, make_arithmetic("exact", scene), SimulatorOptions{});
  const StructureId id = simulator.reserve();
  EXPECT_THROW(make_structure(asked("maximum_sorted_list"), scene, simulator.kernel(), id),
               std::invalid_argument);
}

// The few nearest names, never the list of all.
TEST(Plan, UnknownStructuresHaveNearOnes) {
  const Scene scene = scene_of({path({{0}})}, 0, Rational(1));
  Simulator simulator(scene, make_arithmetic("exact", scene), SimulatorOptions{});
  const StructureId id = simulator.reserve();
  const auto message = [&](const char* name) -> std::string {
    try {
      make_structure(asked(name), scene, simulator.kernel(), id);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(message("sorted-lost"), "\"sorted-lost\" is not a known structure; did you mean sorted_list?");
  EXPECT_EQ(message("xyzzy"), "\"xyzzy\" is not a known structure; kinex list structures names them");
}

}  // namespace maximum_of_list_test
}  // namespace kinex::test
