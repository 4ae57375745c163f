// SPDX-License-Identifier: GPL-3.0-or-later
// The smallest circle, the farthest-point triangulation and the box on a hull: points that jump,
// come and go, all over every hull; and inexact arithmetics, which end.
#include <string>
#include <vector>

#include "tests/sanitized.h"
#include "tests/structures/extent/circle_support.h"
#include "tests/structures/special_scenes.h"

namespace kinex::test {
namespace min_circle_dynamic_test {

constexpr const char* kReaders[] = {"bounding_box_2_hull", "farthest_delaunay_2", "min_circle_2"};

// Every hull gives the same history. That of the circle is the one by brute force.
std::uint64_t expect_one_history(const Scene& scene) {
  std::uint64_t changes = 0;
  for (const char* reader : kReaders) {
    SCOPED_TRACE(reader);
    const LayeredRun first(scene, reader);
    changes += first.external();
    for (const std::string& hull : kHulls) {
      EXPECT_EQ(LayeredRun(scene, reader, hull).sink.history, first.sink.history) << hull;
    }
    if (std::string(reader) != "min_circle_2") continue;
    EXPECT_EQ(LayeredRun(scene, "min_circle_2_brute_force").sink.history, first.sink.history);
  }
  return changes;
}

// Over a hull of directions, whose vertices jump: the audits check the error.
void run_along_directions(const Scene& scene) {
  for (const char* reader : kReaders) {
    for (const std::vector<std::string>& hulls : kHullsOfDirections) {
      SCOPED_TRACE(std::string(reader) + " over " + hulls[0]);
      const LayeredRun first(scene, reader, hulls[0]);
      for (std::size_t i = 1; i < hulls.size(); ++i) {
        EXPECT_EQ(LayeredRun(scene, reader, hulls[i]).sink.history, first.sink.history) << hulls[i];
      }
    }
  }
}

// Each point of a circle and one inside it jumps far away, or to the centre, or leaves for a while.
TEST(MinCircleDynamic, EachPointJumpsOrGoes) {
  const std::vector<std::pair<int, int>> start{{5, 0}, {-3, 4}, {-3, -4}, {0, 5}, {1, 1}, {4, -2}};
  for (std::size_t moved = 0; moved < start.size(); moved += kSanitized ? 3 : 1) {
    for (const auto& [x, y] : std::vector<std::pair<int, int>>{{40, 7}, {0, 0}, {-3, 4}}) {
      std::vector<Trajectory> t;
      for (std::size_t i = 0; i < start.size(); ++i) {
        t.push_back(path({{start[i].first, i % 2 == 0 ? 1 : -1}, {start[i].second, 1}}));
      }
      Scene scene = scene_of(t, 0, Rational(6));
      auto& pieces = scene.objects[moved].motion.pieces;
      pieces[0].to = Rational(2);
      pieces.push_back({Rational(2), Rational(4), path({{x, 1}, {y, -1}})});
      pieces.push_back({Rational(4), std::nullopt, t[moved]});
      SCOPED_TRACE(std::to_string(moved) + " to " + std::to_string(x));
      expect_one_history(scene);
      if (x == 40) run_along_directions(scene);
      pieces.erase(pieces.begin() + 1);  // it is away from 2 to 4
      expect_one_history(scene);
      if (x == 0) run_along_directions(scene);
    }
  }
}

// 0 comes to stand on the circle of the others: the diagonal is then that of the smallest id.
TEST(MinCircleDynamic, ThePlanThatPutsFourOnACircle) {
  Scene scene =
      scene_of({path({{1, 4}, {0}}), path({{0}, {5}}), path({{-5}, {0}}), path({{0}, {-5}})}, 0,
               Rational(2));
  scene.objects[0].motion.pieces[0].to = Rational(1);
  scene.objects[0].motion.pieces.push_back({Rational(1), std::nullopt, path({{5}, {0}})});
  EXPECT_EQ(expect_one_history(scene), 2u);  // the box keeps its points
  using Values = std::vector<std::vector<ObjectId>>;
  EXPECT_EQ(LayeredRun(scene, "farthest_delaunay_2").values(),
            (Values{{0, 1, 0, 3, 1, 2, 1, 3, 2, 3}, {0, 1, 0, 2, 0, 3, 1, 2, 2, 3}}));
  EXPECT_EQ(LayeredRun(scene, "min_circle_2").values(), (Values{{1, 2, 3}, {0, 1, 2, 3}}));
}

TEST(MinCircleDynamic, FromNothingToNothing) {
  const Scene scene = from_nothing_to_nothing();
  EXPECT_GT(expect_one_history(scene), 1u);
  run_along_directions(scene);
  const LayeredRun run(scene, "min_circle_2");
  EXPECT_EQ(run.values().front(), std::vector<ObjectId>{});
  EXPECT_EQ(run.values().back(), std::vector<ObjectId>{});
}

// All points are on one line for an instant, and pass through it.
TEST(MinCircleDynamic, AllOnOneLineForAnInstant) {
  std::uint64_t changes = 0;
  for (std::uint64_t seed = 1; seed <= (kSanitized ? 3u : 25u); ++seed) {
    SCOPED_TRACE(seed);
    const Scene scene = on_a_line_for_an_instant(seed, 6, 9);
    changes += expect_one_history(scene);
    if (seed < 9) run_along_directions(scene);
  }
  EXPECT_GT(changes, kSanitized ? 20u : 100u);
}

// Many certificates of diagonals fail with those of the hull, which is inside out until it has been repaired:
// the flips end, and the triangulation is that of the hull as it becomes.
TEST(MinCircleDynamic, FlipsDoNotWaitForTheHull) {
  std::uint64_t flips = 0;
  for (std::uint64_t seed = 1; seed <= (kSanitized ? 1u : 6u); ++seed) {
    SCOPED_TRACE(seed);
    const Scene scene = on_a_line_for_an_instant(seed, 24, 90);
    const LayeredRun first(scene, "farthest_delaunay_2");
    for (const std::string& hull : kHulls) {
      const LayeredRun run(scene, "farthest_delaunay_2", hull);
      EXPECT_EQ(run.sink.history, first.sink.history) << hull;
      EXPECT_EQ(run.external(), first.external()) << hull;
      flips += run.events_of("flip");
    }
  }
  EXPECT_GT(flips, kSanitized ? 20u : 200u);
}

TEST(MinCircleDynamic, ExtremeNumbers) {
  for (const char* size : kExtremeUnits) {
    SCOPED_TRACE(size);
    EXPECT_GT(expect_one_history(in_units_of(size, 6)), 0u);
  }
}

// The attribute of the exact run at the end, or an error that is noticed.
TEST(MinCircleDynamic, AgreesInInexactArithmeticsOrNoticesAnError) {
  int agree = 0, noticed = 0;
  const auto compare = [&](const Scene& scene, const std::string& reader, const std::string& hull) {
    const LayeredRun exact(scene, reader, hull, "exact", AuditLevel::kEnd);
    for (const char* arithmetic : {"double", "gsl", "mpfr:4", "mpfr:53"}) {
      SCOPED_TRACE(reader + " over " + hull + " in " + arithmetic);
      const LayeredRun run(scene, reader, hull, arithmetic, AuditLevel::kEnd);
      ++(run.noticed() ? noticed : agree);
      if (run.noticed()) continue;
      EXPECT_EQ(run.values().back(), exact.values().back());
    }
  };
  for (const int degree : {1, 2}) {
    for (std::uint64_t seed = 1; seed <= (kSanitized ? 1u : 4u); ++seed) {
      const Scene scene = random_flights(seed, 9, 2, degree, seed % 2 == 0);
      for (const char* reader : kReaders) {
        for (const std::string& hull : kAllHulls) compare(scene, reader, hull);
      }
      compare(scene, "min_circle_2_brute_force", "");
    }
  }
  EXPECT_GT(agree, noticed);
  EXPECT_GT(noticed, 0);
}

}  // namespace min_circle_dynamic_test
}  // namespace kinex::test
