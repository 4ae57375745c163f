// SPDX-License-Identifier: GPL-3.0-or-later
// Calipers, diameter, width and rectangles of random scenes, audited after every instant.
#include <string>
#include <vector>

#include "tests/sanitized.h"
#include "tests/structures/extent/calipers_support.h"
#include "tests/structures/special_scenes.h"

namespace kinex::test {
namespace calipers_random_test {

class EveryCaliperStructure : public ::testing::TestWithParam<std::string> {};

void run_lattices(const std::string& structure, std::uint64_t first, std::uint64_t last) {
  std::uint64_t external = 0, shared = 0;
  for (std::uint64_t seed = first; seed <= first + test::fewer(last - first); ++seed) {
    SCOPED_TRACE(seed);
    const Scene scene = caliper_lattice(seed);
    const CaliperRun run(scene, structure, kAllHulls[seed % kAllHulls.size()]);
    external += run.ledger().external;
    shared += run.ledger().simultaneous_groups;
    if (seed % 8 != 0) continue;
    const CaliperRun twin(scene, structure, kAllHulls[seed % kAllHulls.size()], "sturm");
    EXPECT_EQ(run.sink.lines, twin.sink.lines);
    EXPECT_EQ(run.values(), twin.values());
  }
  EXPECT_GT(external, test::seen_in_fewer(last - first));
  EXPECT_GT(shared, test::seen_in_fewer(last - first) / 24);
}

// The tests that find errors in what calipers note. Of changed edges: a swap, an enter or a leave that notes
// none, or one of its two edges: Lattices of what reads them, HullsAgree. Of ties: new motions that note
// none: RandomFlights; renewed certificates that note none, a failure or a leave that does not settle them:
// Lattices. Calipers, or maxima along directions, that take every certificate of their structure for their
// own (owns()): Calipers.ReferenceScenes, ExtentDirections.RandomLattices. An enter that does not settle ties
// was not found.
TEST_P(EveryCaliperStructure, Lattices) { run_lattices(GetParam(), 1, 48); }
TEST_P(EveryCaliperStructure, SlowLattices) { run_lattices(GetParam(), 49, 300); }

TEST_P(EveryCaliperStructure, LatticesOfHigherDegree) {
  std::uint64_t external = 0;
  for (const int degree : {2, 3}) {
    for (std::uint64_t seed = 1; seed <= test::fewer(24u); ++seed) {
      SCOPED_TRACE("degree " + std::to_string(degree) + ", seed " + std::to_string(seed));
      const CaliperRun run(caliper_lattice(seed, degree), GetParam(), kAllHulls[seed % kAllHulls.size()]);
      external += run.ledger().external;
    }
  }
  EXPECT_GT(external, test::seen_in_fewer(100u));
}

TEST_P(EveryCaliperStructure, RandomFlights) {
  std::uint64_t external = 0, updates = 0, insertions = 0;
  for (const int degree : {1, 2}) {
    for (std::uint64_t seed = 1; seed <= test::fewer(degree == 1 ? 48u : 8u); ++seed) {
      SCOPED_TRACE("degree " + std::to_string(degree) + ", seed " + std::to_string(seed));
      const CaliperRun run(random_flights(seed, 8, 2, degree, seed % 2 == 0), GetParam(),
                           kAllHulls[seed % kAllHulls.size()]);
      external += run.ledger().external;
      updates += run.ledger().motion_updates;
      insertions += run.ledger().insertions;
    }
  }
  EXPECT_GT(external, test::seen_in_fewer(60u));
  EXPECT_GT(updates, test::seen_in_fewer(100u));
  EXPECT_GT(insertions, test::seen_in_fewer(10u));
}

// The same changes at the same instants over every hull.
TEST_P(EveryCaliperStructure, HullsAgree) {
  for (std::uint64_t seed = 1; seed <= test::fewer(24u); ++seed) {
    SCOPED_TRACE(seed);
    const Scene scene = seed % 2 == 0 ? caliper_lattice(seed + 1000) : random_flights(seed, 7, 2, 1, true);
    const CaliperRun first(scene, GetParam(), kHulls[0]);
    for (std::size_t i = 1; i < kHulls.size(); ++i) {
      const CaliperRun other(scene, GetParam(), kHulls[i]);
      EXPECT_EQ(first.values(), other.values()) << kHulls[i];
      EXPECT_EQ(first.begins_with, other.begins_with) << kHulls[i];
    }
  }
}

// Hulls of directions, whatever maintains them: the same values for the same k.
TEST_P(EveryCaliperStructure, HullsOfDirectionsAgree) {
  std::uint64_t external = 0;
  for (std::uint64_t seed = 1; seed <= test::fewer(16u); ++seed) {
    SCOPED_TRACE(seed);
    const Scene scene = seed % 2 == 0 ? caliper_lattice(seed + 2000) : random_flights(seed, 7, 2, 1, true);
    for (const std::vector<std::string>& hulls : kHullsOfDirections) {
      const CaliperRun first(scene, GetParam(), hulls[0]);
      external += first.ledger().external;
      for (std::size_t i = 1; i < hulls.size(); ++i) {
        const CaliperRun other(scene, GetParam(), hulls[i]);
        EXPECT_EQ(first.values(), other.values()) << hulls[i];
        EXPECT_EQ(first.begins_with, other.begins_with) << hulls[i];
      }
    }
  }
  EXPECT_GT(external, test::seen_in_fewer(100u));
}

// They come one by one and leave one by one; one jumps.
TEST_P(EveryCaliperStructure, FromNothingToNothing) {
  Scene scene = from_nothing_to_nothing();
  jump(scene, 3, 5, path({{40}, {-9, 1}}));
  for (const std::string& hull : kAllHulls) {
    const CaliperRun run(scene, GetParam(), hull);
    EXPECT_EQ(run.begins_with, Ids{});
    EXPECT_EQ(run.ids(), Ids{});
    EXPECT_EQ(run.ledger().insertions, 8u);
  }
}

// All points are on one line at one instant.
TEST_P(EveryCaliperStructure, AllOnOneLineForAnInstant) {
  for (std::uint64_t seed = 1; seed <= test::fewer(40u); ++seed) {
    SCOPED_TRACE(seed);
    const CaliperRun run(on_a_line_for_an_instant(seed, 5, 20), GetParam(),
                         kAllHulls[seed % kAllHulls.size()]);
  }
}

TEST_P(EveryCaliperStructure, ExtremeNumbers) {
  for (const char* size : kExtremeUnits) {
    SCOPED_TRACE(size);
    const CaliperRun run(in_units_of(size), GetParam());
    EXPECT_GT(run.ledger().external, 0u);
  }
}

// In an arithmetic that errs: the attribute of the exact run at the end, or an error that is noticed. (Of
// rectangles of one area either may be named: inexact_agreement_test.cpp compares areas.)
TEST_P(EveryCaliperStructure, AgreesInInexactArithmeticsOrNoticesAnError) {
  int agree = 0, noticed = 0;
  for (std::uint64_t seed = 1; seed <= test::fewer(16u); ++seed) {
    const Scene scene = seed % 2 == 0 ? caliper_lattice(seed) : random_flights(seed, 8, 2, 2, true);
    const std::string& hull = kAllHulls[seed % kAllHulls.size()];
    const Ids exact = CaliperRun(scene, GetParam(), hull, "exact", AuditLevel::kEnd).ids();
    for (const char* arithmetic : {"double", "gsl", "mpfr:4", "mpfr:24", "mpfr:53"}) {
      SCOPED_TRACE(std::string(arithmetic) + " over " + hull + ", seed " + std::to_string(seed));
      const CaliperRun run(scene, GetParam(), hull, arithmetic, AuditLevel::kEnd);
      ++(run.noticed() ? noticed : agree);
      if (run.noticed() || GetParam() == "min_area_rectangle_2") continue;
      EXPECT_EQ(run.ids(), exact);
    }
  }
  EXPECT_GT(agree, test::seen_in_fewer(20));
  EXPECT_GT(noticed, 0);
}

INSTANTIATE_TEST_SUITE_P(All, EveryCaliperStructure, ::testing::ValuesIn(kAllCaliperStructures),
                         [](const auto& one) { return one.param; });

// The baseline changes at the same instants.
TEST(Diameter, AllPairsAgree) {
  std::uint64_t external = 0;
  for (std::uint64_t seed = 1; seed <= test::fewer(60u); ++seed) {
    SCOPED_TRACE(seed);
    const Scene scene = seed % 2 == 0 ? caliper_lattice(seed) : random_flights(seed, 7, 2, 2, true);
    const CaliperRun fast(scene, "diameter_2", kHulls[seed % kHulls.size()]);
    const CaliperRun slow(scene, "diameter_all_pairs", "");
    EXPECT_EQ(fast.begins_with, slow.begins_with);
    EXPECT_EQ(fast.values(), slow.values());
    external += fast.ledger().external;
  }
  EXPECT_GT(external, test::seen_in_fewer(60u));
}

// 0 and 3 recede from each other until they are as far apart as 1 and 2, and stay so: of pairs that
// are equally far identically the first one counts.
TEST(Diameter, ThePlanThatMakesPairsEqual) {
  Scene scene = scene_of(
      {path({{-5}, {0}}), path({{0}, {5}}), path({{0}, {-5}}), path({{1, 4}, {0}})}, 0, Rational(2));
  scene.objects[3].motion.pieces[0].to = Rational(1);
  scene.objects[3].motion.pieces.push_back({Rational(1), std::nullopt, path({{5}, {0}})});
  for (const std::string& hull : kHulls) {
    const CaliperRun run(scene, "diameter_2", hull);
    EXPECT_EQ(run.begins_with, (Ids{1, 2}));
    EXPECT_EQ(run.ids(), (Ids{0, 3}));
    EXPECT_EQ(run.ledger().external, 1u);
  }
}

TEST(Diameter, AllPairsInOneAndThreeAxes) {
  for (const int dimension : {1, 3}) {
    for (std::uint64_t seed = 1; seed <= test::fewer(12u); ++seed) {
      SCOPED_TRACE(std::to_string(dimension) + " axes, seed " + std::to_string(seed));
      const CaliperRun run(random_flights(seed, 7, dimension, 2, true), "diameter_all_pairs", "");
    }
  }
}

}  // namespace calipers_random_test
}  // namespace kinex::test
