// SPDX-License-Identifier: GPL-3.0-or-later
// The claims on translations of the paper of 1999: counts that the polygon bounds are fitted by no power.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "experiments/families/collision/separation_paper.h"

namespace kinex {
namespace separation_growth_test {

using ::testing::HasSubstr;

// Runs once round with mu^power events, and as many as the polygon has edges at most.
std::vector<lab::SeriesResult> rounds(double power) {
  std::vector<lab::SeriesResult> results;
  for (const lab::SeriesPoint& point : families::separation_translation_points(false)) {
    const lab::RunKey& key = point.key;
    if (key.workload != "polygon-orbit") continue;
    lab::SeriesResult result;
    result.point = point;
    lab::RunRecord record;
    record.key = key.text();
    const double events = 6 * std::pow(families::mu_of(result), power);
    record.processed = static_cast<std::uint64_t>(std::min(events, 1.0 * key.parameters.n));
    result.runs.push_back(record);
    results.push_back(std::move(result));
  }
  return results;
}

lab::PaperClaim claim_on(const char* method, double power) {
  const std::string id = std::string("translation.algebraic.") + method;
  for (const lab::PaperClaim& claim :
       families::separation_translation_report(rounds(power), "command").claims) {
    if (claim.id == id) return claim;
  }
  ADD_FAILURE() << "no claim " << id;
  return {};
}

TEST(SeparationGrowth, SaturatedCountsAreNotFitted) {
  const lab::PaperClaim claim = claim_on("separation_hysteresis", 1);
  EXPECT_EQ(claim.verdict, lab::Verdict::kConfirmed) << claim.observed;
  EXPECT_THAT(claim.observed, HasSubstr("mu from 4 to 128"));
  EXPECT_THAT(claim.observed, testing::ContainsRegex("\\(mu\\)\\^(1\\.00|0\\.99)"))
      << claim.observed;
}

// Steeper counts reach the bound sooner, and are not taken for flat ones.
TEST(SeparationGrowth, SteepCountsAreRefutedBelowTheBound) {
  const lab::PaperClaim claim = claim_on("separation_hysteresis", 1.5);
  EXPECT_EQ(claim.verdict, lab::Verdict::kRefuted) << claim.observed;
}

}  // namespace separation_growth_test
}  // namespace kinex
