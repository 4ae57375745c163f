// SPDX-License-Identifier: GPL-3.0-or-later
// The runs of studies are audited, and what is wrong in one refutes what is said of them.
#include "experiments/lab/study_runs.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiments/lab/scene_run.h"
#include "experiments/lab/workload.h"

namespace kinex {
namespace study_runs_test {

using ::testing::HasSubstr;

lab::StudyResult study_of(const Scene& scene, const char* arithmetic) {
  lab::StudyResult study;
  study.name = "study";
  SimulatorOptions options;
  options.audit = AuditLevel::kNone;
  const auto simulator = lab::make_simulator(scene, arithmetic, options);
  simulator->start();
  simulator->run_until(std::nullopt);
  lab::check_run(*simulator, "the run", study);
  return study;
}

TEST(StudyRuns, ARightRunLeavesNothing) {
  const Scene scene = lab::generate_scene("grid", {.n = 36, .seed = 2}, "closest_pair_all");
  EXPECT_TRUE(study_of(scene, "exact").checks.empty());
}

// In doubles the ties of this grid end with another pair than the closest.
TEST(StudyRuns, AWrongRunRefutesTheClaim) {
  const Scene scene = lab::generate_scene("grid", {.n = 36, .seed = 2}, "closest_pair_all");
  const lab::StudyResult study = study_of(scene, "double");
  ASSERT_EQ(study.checks.size(), 1u);
  EXPECT_EQ(study.checks[0].claim, "study.runs");
  EXPECT_EQ(study.checks[0].verdict, lab::Verdict::kRefuted);
  lab::PaperClaim claim;
  claim.verdict = lab::Verdict::kConfirmed;
  claim.observed = "seen";
  lab::refute_by_checks(study, claim);
  EXPECT_EQ(claim.verdict, lab::Verdict::kRefuted);
  EXPECT_THAT(claim.observed,
              HasSubstr("seen; a check of the runs failed, the first: study.runs: the run: "));
}

TEST(StudyRuns, ConfirmedChecksRefuteNothing) {
  lab::StudyResult study;
  study.checks.emplace_back();
  lab::PaperClaim claim;
  claim.verdict = lab::Verdict::kConfirmed;
  lab::refute_by_checks(study, claim);
  EXPECT_EQ(claim.verdict, lab::Verdict::kConfirmed);
  study.checks.back().verdict = lab::Verdict::kRefuted;
  study.checks.emplace_back(study.checks.back());
  lab::refute_by_checks(study, claim);
  EXPECT_EQ(claim.verdict, lab::Verdict::kRefuted);
  EXPECT_THAT(claim.observed, HasSubstr("2 checks of the runs failed"));
}

}  // namespace study_runs_test
}  // namespace kinex
