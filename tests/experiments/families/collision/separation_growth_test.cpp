// SPDX-License-Identifier: GPL-3.0-or-later
// The claims of the paper of 1999. Counts that the polygon bounds are fitted by no power; bounds on all
// motions, or on all polygons, are not confirmed; counts that shall not grow are equal.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "experiments/families/collision/separation_paper.h"

namespace kinex {
namespace separation_growth_test {

using ::testing::Contains;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::Not;

lab::SeriesResult result_of(const lab::SeriesPoint& point, double events) {
  lab::SeriesResult result;
  result.point = point;
  lab::RunRecord record;
  record.key = point.key.text();
  record.processed = static_cast<std::uint64_t>(events);
  result.runs.push_back(record);
  return result;
}

// Runs once round with mu^power events, and as many as the polygon has edges at most.
std::vector<lab::SeriesResult> rounds(double power) {
  std::vector<lab::SeriesResult> results;
  for (const lab::SeriesPoint& point : families::separation_translation_points(false)) {
    if (point.key.workload != "polygon-orbit") continue;
    const double events = 6 * std::pow(families::mu_of(result_of(point, 0)), power);
    results.push_back(result_of(point, std::min(events, 1.0 * point.key.parameters.n)));
  }
  return results;
}

// Turns before a fan: `events` of n and the separation.
std::vector<lab::SeriesResult> turns(double (*events)(int n, bool very_far)) {
  std::vector<lab::SeriesResult> results;
  for (const lab::SeriesPoint& point : families::separation_features_points(true)) {
    const bool very_far = point.key.parameters.separation == Rational(29);
    results.push_back(result_of(point, events(point.key.parameters.n, very_far)));
  }
  return results;
}

std::vector<lab::SeriesResult> hysteresis_runs(const std::string& trouble) {
  std::vector<lab::SeriesResult> results;
  for (const lab::SeriesPoint& point : families::separation_hysteresis_points(true)) {
    results.push_back(result_of(point, point.key.workload == "polygon-jitter" ? 0 : 5));
    results.back().runs.front().trouble = trouble;
  }
  return results;
}

lab::PaperClaim find_claim(const lab::PartReport& report, const std::string& id) {
  for (const lab::PaperClaim& claim : report.claims) {
    if (claim.id == id) return claim;
  }
  ADD_FAILURE() << "no claim " << id;
  return {};
}

lab::PaperClaim claim_on(const char* method, double power) {
  return find_claim(families::separation_translation_report(rounds(power), "command"),
                    std::string("translation.algebraic.") + method);
}

lab::PaperClaim far_claim(const std::vector<lab::SeriesResult>& results) {
  return find_claim(families::separation_features_report(results, "command"),
                    "features.separation-sensitive");
}

lab::PaperClaim hysteresis_claim(const std::vector<lab::SeriesResult>& results, const char* id) {
  return find_claim(families::separation_hysteresis_report(results, "command"), id);
}

constexpr const char* kNotAllMotions = "runs cannot confirm a bound on all motions";

TEST(SeparationGrowth, SaturatedCountsAreNotFitted) {
  const lab::PaperClaim claim = claim_on("separation_hysteresis", 1);
  EXPECT_EQ(claim.verdict, lab::Verdict::kOpen) << claim.observed;
  EXPECT_THAT(claim.observed, EndsWith("; consistent with the bound"));
  EXPECT_THAT(claim.observed, HasSubstr("mu from 4 to 128"));
  EXPECT_THAT(claim.observed, testing::ContainsRegex("\\(mu\\)\\^(1\\.00|0\\.99)"))
      << claim.observed;
}

// Steeper counts reach the bound sooner, and are not taken for flat ones.
TEST(SeparationGrowth, SteepCountsAreRefutedBelowTheBound) {
  const lab::PaperClaim claim = claim_on("separation_hysteresis", 1.5);
  EXPECT_EQ(claim.verdict, lab::Verdict::kRefuted) << claim.observed;
  EXPECT_THAT(claim.observed, Not(HasSubstr("consistent with the bound")));
  EXPECT_THAT(claim.assumptions, Contains(kNotAllMotions));
}

// A lower bound in the worst case takes one scene, a bound on all motions takes all.
TEST(SeparationGrowth, ScenesConfirmLowerBoundsOnly) {
  const lab::PartReport report = families::separation_translation_report(rounds(1), "command");
  EXPECT_EQ(find_claim(report, "translation.optimal").verdict, lab::Verdict::kConfirmed);
  for (const lab::PaperClaim& claim : report.claims) {
    if (claim.kind != "growth") continue;
    EXPECT_NE(claim.verdict, lab::Verdict::kConfirmed) << claim.id;
    EXPECT_THAT(claim.assumptions, Contains(kNotAllMotions)) << claim.id;
  }
}

TEST(SeparationGrowth, NoRunConfirmsNothing) {
  for (const lab::PartReport& report : {families::separation_translation_report({}, "command"),
                                        families::separation_rigid_report({}, "command"),
                                        families::separation_features_report({}, "command"),
                                        families::separation_hysteresis_report({}, "command")}) {
    EXPECT_FALSE(report.claims.empty());
    for (const lab::PaperClaim& claim : report.claims) {
      EXPECT_EQ(claim.verdict, lab::Verdict::kOpen) << claim.id;
      EXPECT_THAT(claim.observed, Not(HasSubstr("consistent with the bound"))) << claim.id;
    }
  }
}

// One certificate is what all motions shall need.
TEST(SeparationBounds, CompactnessIsOpenOrRefuted) {
  for (const std::uint64_t certificates : {6, 7}) {
    std::vector<lab::SeriesResult> results;
    for (const lab::SeriesPoint& point : families::separation_rigid_points(true)) {
      results.push_back(result_of(point, 10));
      results.back().runs.front().max_live = certificates;
    }
    const lab::PaperClaim claim =
        find_claim(families::separation_rigid_report(results, "command"), "rigid.compact");
    EXPECT_EQ(claim.verdict, certificates == 6 ? lab::Verdict::kOpen : lab::Verdict::kRefuted);
    EXPECT_THAT(claim.assumptions, Contains(kNotAllMotions));
  }
}

// Wedges that last in all runs are not all wedges; one that does not refutes.
TEST(SeparationBounds, LastingIsOpenOrRefuted) {
  const lab::PaperClaim lasting = hysteresis_claim(hysteresis_runs(""), "hysteresis.lasting");
  EXPECT_EQ(lasting.kind, "bound");
  EXPECT_EQ(lasting.verdict, lab::Verdict::kOpen);
  EXPECT_THAT(lasting.observed, EndsWith("; consistent with the bound"));
  EXPECT_THAT(lasting.assumptions, Contains(kNotAllMotions));
  const lab::PaperClaim broken =
      hysteresis_claim(hysteresis_runs("displacement: too small"), "hysteresis.lasting");
  EXPECT_EQ(broken.verdict, lab::Verdict::kRefuted);
  // Of the very scenes it is known what they cost.
  EXPECT_EQ(hysteresis_claim(hysteresis_runs(""), "hysteresis.trembling").verdict,
            lab::Verdict::kConfirmed);
}

TEST(SeparationBounds, PolygonsAreNotAllPolygons) {
  lab::StudyResult study;
  for (const lab::Verdict verdict : {lab::Verdict::kConfirmed, lab::Verdict::kRefuted}) {
    study.checks = {{"outer_hierarchy.median.depth", "bound", "", "<= 5", "5",
                     "every cut halves the chain", verdict, std::nullopt}};
    const lab::PaperClaim claim =
        families::separation_hierarchies_report(study, "command").claims.front();
    const bool holds = verdict == lab::Verdict::kConfirmed;
    EXPECT_EQ(claim.verdict, holds ? lab::Verdict::kOpen : lab::Verdict::kRefuted);
    EXPECT_EQ(claim.observed, holds ? "5; consistent with the bound" : "5");
    EXPECT_THAT(claim.assumptions, Contains("polygons cannot confirm a bound on all polygons"));
  }
}

TEST(SeparationFar, AsManyEventsForEveryN) {
  const lab::PaperClaim claim =
      far_claim(turns([](int, bool very_far) { return very_far ? 2.0 : 4.0; }));
  EXPECT_EQ(claim.verdict, lab::Verdict::kConfirmed);
  EXPECT_EQ(claim.observed, "4 to 4 at separation 2, 2 to 2 at separation 29");
}

// Few events are not enough.
TEST(SeparationFar, ACountThatGrowsIsRefuted) {
  const lab::PaperClaim claim =
      far_claim(turns([](int n, bool very_far) { return very_far ? n / 8 : 4.0; }));
  EXPECT_EQ(claim.verdict, lab::Verdict::kRefuted);
  EXPECT_EQ(claim.observed, "4 to 4 at separation 2, 1 to 4 at separation 29");
}

TEST(SeparationFar, OneSizeIsOpen) {
  std::vector<lab::SeriesResult> results = turns([](int, bool) { return 4.0; });
  std::erase_if(results,
                [](const lab::SeriesResult& result) { return result.point.key.parameters.n != 8; });
  EXPECT_EQ(far_claim(results).verdict, lab::Verdict::kOpen);
}

}  // namespace separation_growth_test
}  // namespace kinex
