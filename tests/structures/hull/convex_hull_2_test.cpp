// SPDX-License-Identifier: GPL-3.0-or-later
// ConvexHull2 on motion in general position: CGAL between all events, `sturm`, bounds, provable
// counts.
#include "structures/hull/convex_hull_2.h"

#include <gtest/gtest.h>

#include <map>
#include <string>

#include "tests/sanitized.h"
#include "tests/structures/hull/hull_support.h"

namespace kinex::test {
namespace convex_hull_2_test {

std::uint64_t count(const StructureLedger& ledger, const std::string& kind) {
  const auto it = ledger.by_kind.find(kind);
  return it == ledger.by_kind.end() ? 0 : it->second;
}

TEST(ConvexHull2, RandomMotionIsAuditedAtEveryEvent) {
  for (const char* structure : {"convex_hull_2", "convex_hull_2_naive"}) {
    for (const int degree : {1, 2, 3}) {
      for (const int n : {0, 1, 2, 3, 4, 5, 8, 13, 24}) {
        if (n > 13 && degree > 1) continue;
        HullRun run(random_plane(n, static_cast<std::uint64_t>(100 * degree + n), degree),
                    structure);
        run.trial.to_end().expect_clean();
        EXPECT_EQ(run.hull().node_rebuilds(), 0u) << "degree " << degree << ", n " << n;
      }
    }
  }
}

TEST(ConvexHull2, LargerMotionsNeedNoRebuild) {
  for (const std::uint64_t seed : {1u, 2u}) {
    HullRun run(random_plane(1500, seed), "convex_hull_2", "exact", AuditLevel::kEnd);
    run.trial.to_end().expect_clean();
    EXPECT_EQ(run.hull().node_rebuilds(), 0u);
    EXPECT_GT(run.trial.ledger().processed, 5000u);
    std::uint64_t total = 0;
    for (const std::uint64_t k : run.hull().failures_by_level()) total += k;
    EXPECT_EQ(total, run.trial.ledger().processed);
  }
}

// Each kind of certificate is a part with a line of its own; a failure of it is an event of its kind.
TEST(ConvexHull2, PartsFailAsTheirEventsSay) {
  HullRun run(random_plane(300, 7), "convex_hull_2", "exact", AuditLevel::kEnd);
  run.trial.to_end().expect_clean();
  const StructureLedger& ledger = run.trial.ledger();
  std::map<std::string, std::uint64_t> failures;
  for (const PartLedger& part : ledger.parts) failures[part.name] = part.failures;
  ASSERT_EQ(failures.size(), 6u);
  EXPECT_EQ(failures["x"], count(ledger, "x"));
  EXPECT_EQ(failures["y"], count(ledger, "yl") + count(ledger, "yr") + count(ledger, "yb") +
                               count(ledger, "yt"));
  EXPECT_EQ(failures["s"] + failures["s of tangents"],
            count(ledger, "sl") + count(ledger, "sr") + count(ledger, "st"));
  EXPECT_EQ(failures["left ends"] + failures["right ends"], count(ledger, "end"));
  for (const auto& [name, times] : failures) EXPECT_GT(times, 0u) << name;
  // Both slopes of a tangent are claimed, so a tangent has a certificate in both parts.
  EXPECT_LE(ledger.parts[3].live, ledger.parts[2].live);
  HullRun naive(random_plane(60, 7), "convex_hull_2_naive", "exact", AuditLevel::kEnd);
  naive.trial.to_end().expect_clean();
  EXPECT_EQ(naive.trial.ledger().parts.at(2).created, 0u);
}

// Every hull change, and no other external event; the report's Omega(n^2) for linear motion.
TEST(ConvexHull2, WorstCaseChanges) {
  for (const auto& [m, n] : {std::pair{3, 3}, {4, 4}, {6, 5}, {5, 9}}) {
    for (const std::string& structure : kHulls) {
      const HullStory story = tell(hull_worst(m, n), structure, "exact", AuditLevel::kEnd);
      EXPECT_EQ(story.events.size(), static_cast<std::size_t>(2 * n * m - 1)) << structure;
      EXPECT_EQ(count(story.ledger, "enter") + count(story.ledger, "leave"),
                static_cast<std::uint64_t>(2 * n * m - 1));
    }
  }
}

TEST(ConvexHull2, MethodsAgreeOnRandomMotion) {
  for (const int degree : {1, 2}) {
    for (const int n : {3, 4, 5, 7, 12}) {
      expect_one_story(random_plane(n, static_cast<std::uint64_t>(n + degree), degree));
    }
  }
  expect_one_story(random_plane(60, 5), AuditLevel::kEnd);
}

TEST(ConvexHull2, MethodsAgreeOnTheWorstCase) {
  expect_one_story(hull_worst(4, 4));
  expect_one_story(hull_worst(7, 6), AuditLevel::kEnd);
}

// One end of a long chain over one line: a point is in many certificates of the naive set only.
TEST(ConvexHull2, LocalityIsWhatTheSlopesBuy) {
  std::vector<Trajectory> motions;
  const int n = 64;
  for (int i = 0; i < n; ++i) {
    motions.push_back(path({{2 * i - n, 1}, {-(2 * i - n) * (2 * i - n)}}));
  }
  for (int i = 0; i < n; ++i) motions.push_back(path({{i % 8}, {-100000 - i, -1}}));
  motions[n] = path({{-1000}, {-100000, 1}});
  motions[n + 1] = path({{1001}, {-100000, 1}});
  const Scene scene = scene_of(motions, 0, Rational(1));
  const HullStory local = tell(scene, "convex_hull_2", "exact", AuditLevel::kEnd);
  const HullStory naive = tell(scene, "convex_hull_2_naive", "exact", AuditLevel::kEnd);
  EXPECT_GE(naive.ledger.max_per_object, 60u);
  EXPECT_LE(local.ledger.max_per_object, 56u);
}

TEST(ConvexHull2, TheHullIsACycleFromTheSmallestId) {
  // Counter-clockwise 2, 0, 3, 1.
  const Scene scene = scene_of({path({{4}, {0, 1}}), path({{0, 1}, {4}}), path({{0}, {0}}),
                                path({{4, 1}, {4, 1}}), path({{2}, {2}})},
                               0, Rational(1));
  for (const std::string& structure : kHulls) {
    EXPECT_EQ(tell(scene, structure).last, (std::vector<ObjectId>{0, 3, 1, 2})) << structure;
  }
}

TEST(ConvexHull2, TheMiddleOfThreeChangesSides) {
  // The triangle turns over: same vertices, another cycle.
  const Scene scene =
      scene_of({path({{0}, {0}}), path({{4}, {0}}), path({{2}, {-1, 1}})}, 0, Rational(2));
  for (const std::string& structure : kHulls) {
    const HullStory story = tell(scene, structure);
    ASSERT_EQ(story.events.size(), 1u) << structure;
    EXPECT_EQ(story.events[0].kind, HullEvents::kTurn);
    EXPECT_EQ(story.events[0].ids, (std::vector<ObjectId>{0, 2, 1}));
    EXPECT_EQ(story.last, (std::vector<ObjectId>{0, 1, 2}));
  }
}

TEST(ConvexHull2, InexactArithmeticsEnd) {
  for (const char* arithmetic : {"double", "gsl", "mpfr:12", "mpfr:60"}) {
    for (std::uint64_t seed = 0; seed < test::fewer(6u); ++seed) {
      for (const std::string& structure : kHulls) {
        tell(small_plane(9, seed, 1 + static_cast<int>(seed % 2), 2), structure, arithmetic,
             AuditLevel::kNone);
      }
    }
  }
}

}  // namespace convex_hull_2_test
}  // namespace kinex::test
