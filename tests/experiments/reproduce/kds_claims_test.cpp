// SPDX-License-Identifier: GPL-3.0-or-later
// The verdicts on claims of section 7 of Guibas's report: those of the numbers, whatever the paper says.
#include "experiments/families/points/kds_claims.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "experiments/families/arrangement/experiments.h"
#include "experiments/families/proximity/experiments.h"
#include "experiments/families/triangulation/experiments.h"

namespace kinex {
namespace kds_claims_test {

using ::testing::HasSubstr;
using families::KdsPower;

constexpr families::KdsRuns kRuns{"closest_pair_local", "pass-along-row"};

lab::SeriesResult result_of(families::KdsRuns runs, int n, std::vector<std::uint64_t> changes) {
  lab::SeriesResult result;
  result.point = families::kds_single(runs, n, n);
  for (std::size_t i = 0; i < changes.size(); ++i) {
    lab::RunKey key = result.point.key;
    key.parameters.seed = i + 1;
    lab::RunRecord record;
    record.key = key.text();
    record.external = changes[i];
    record.processed = 2 * changes[i];
    result.runs.push_back(record);
  }
  return result;
}

lab::Verdict count_verdict(const std::vector<lab::SeriesResult>& results) {
  return families::count_claim(results, {"id", "statement", kRuns, "external", "changes", "nm - 1",
                                         [](double n, double m) { return n * m - 1; }})
      .verdict;
}

TEST(KdsCounts, OneWrongRunRefutes) {
  const lab::SeriesResult three = result_of(kRuns, 3, {8, 8}), four = result_of(kRuns, 4, {15});
  EXPECT_EQ(count_verdict({three, four}), lab::Verdict::kConfirmed);
  EXPECT_EQ(count_verdict({three, result_of(kRuns, 4, {15, 14})}), lab::Verdict::kRefuted);
  EXPECT_EQ(count_verdict({}), lab::Verdict::kOpen);
  // Runs of others count for nothing.
  EXPECT_EQ(count_verdict({result_of({"closest_pair_all", kRuns.workload}, 3, {8})}),
            lab::Verdict::kOpen);
}

std::vector<lab::FitPoint> power(double exponent, double scatter) {
  std::vector<lab::FitPoint> points;
  double sign = 1;
  for (const double n : {10.0, 20.0, 40.0, 80.0, 160.0}) {
    points.push_back({n, std::pow(n, exponent) * (1 + sign * scatter), 0});
    sign = -sign;
  }
  return points;
}

TEST(KdsGrowth, TheWholeIntervalDecides) {
  const auto verdict = [](double exponent, double scatter, KdsPower kind) {
    return families::growth_claim(power(exponent, scatter),
                                  {"id", "statement", kRuns, "changes", 2, kind})
        .verdict;
  };
  EXPECT_EQ(verdict(2, 0.001, KdsPower::kTheta), lab::Verdict::kConfirmed);
  EXPECT_EQ(verdict(1.5, 0.001, KdsPower::kTheta), lab::Verdict::kRefuted);
  EXPECT_EQ(verdict(2, 0.3, KdsPower::kTheta), lab::Verdict::kOpen);
  EXPECT_EQ(verdict(1.5, 0.001, KdsPower::kAtMost), lab::Verdict::kConfirmed);
  EXPECT_EQ(verdict(2.5, 0.001, KdsPower::kAtMost), lab::Verdict::kRefuted);
  EXPECT_EQ(verdict(2.5, 0.001, KdsPower::kAtLeast), lab::Verdict::kConfirmed);
  EXPECT_EQ(verdict(1.5, 0.001, KdsPower::kAtLeast), lab::Verdict::kRefuted);
  EXPECT_EQ(verdict(2, 0.3, KdsPower::kAtLeast), lab::Verdict::kOpen);
}

TEST(KdsGrowth, NoRunConfirmsABoundOnAllMotions) {
  const auto claim = [](double exponent) {
    return families::growth_claim(power(exponent, 0.001),
                                  {"id", "statement", kRuns, "changes", 2, KdsPower::kOnAllMotion});
  };
  for (const double exponent : {1.0, 1.5, 2.0}) {
    EXPECT_EQ(claim(exponent).verdict, lab::Verdict::kOpen) << exponent;
    EXPECT_THAT(claim(exponent).observed, HasSubstr("consistent with the bound"));
  }
  EXPECT_EQ(claim(2.5).verdict, lab::Verdict::kRefuted);
  const lab::PaperClaim question = families::open_question("id", "?", "what was seen", kRuns);
  EXPECT_EQ(question.verdict, lab::Verdict::kOpen);
  EXPECT_FALSE(question.is_surprising());
}

TEST(KdsAgreement, NamesTheFirstSceneThatDiffers) {
  const families::KdsRuns other{"closest_pair_all", kRuns.workload};
  const auto agreement = [&](std::uint64_t changes) {
    return families::agreement_of({result_of(kRuns, 3, {8, 7}), result_of(other, 3, {8, changes}),
                                   result_of(other, 4, {99})},
                                  {kRuns.structure, other.structure});
  };
  EXPECT_EQ(agreement(7).scenes, 2u);  // n = 4 has one structure only
  EXPECT_EQ(agreement(7).difference, "");
  EXPECT_THAT(agreement(6).difference, HasSubstr("seed=2"));
}

TEST(KdsAgreement, AClaimNeedsASceneThatSeveralHave) {
  const families::KdsRuns other{"closest_pair_all", kRuns.workload};
  const auto verdict = [&](const std::vector<lab::SeriesResult>& results) {
    return families::agreement_claim(results, "id", "statement", kRuns,
                                     {kRuns.structure, other.structure})
        .verdict;
  };
  EXPECT_EQ(verdict({result_of(kRuns, 3, {8})}), lab::Verdict::kOpen);
  EXPECT_EQ(verdict({result_of(kRuns, 3, {8}), result_of(other, 3, {8})}),
            lab::Verdict::kConfirmed);
  EXPECT_EQ(verdict({result_of(kRuns, 3, {8}), result_of(other, 3, {7})}), lab::Verdict::kRefuted);
}

TEST(KdsRatios, AreTakenSceneByScene) {
  const std::vector<lab::SeriesResult> results{result_of(kRuns, 3, {8, 4}),
                                               result_of({"other", kRuns.workload}, 3, {2, 4})};
  EXPECT_EQ(families::ratios_of(results, kRuns, "processed", "external").at(0).count, 2);
  EXPECT_EQ(families::ratios_of(results, kRuns, {"other", kRuns.workload}, "external").at(0).count,
            (8.0 / 2 + 4.0 / 4) / 2);
}

// Every claim of a part can be judged by the runs that are made for it: none is without runs.
TEST(Section7, EveryClaimHasRuns) {
  using Points = std::vector<lab::SeriesPoint> (*)(bool);
  using Report = lab::PartReport (*)(const std::vector<lab::SeriesResult>&, const std::string&);
  const std::vector<std::pair<Points, Report>> parts{
      {families::kds_section_7_delaunay_points, families::kds_section_7_delaunay_report},
      {families::kds_section_7_pairs_points, families::kds_section_7_pairs_report},
      {families::kds_section_7_trees_points, families::kds_section_7_trees_report},
      {families::kds_section_7_meetings_points, families::kds_section_7_meetings_report},
      {families::kds_section_7_arrangements_points, families::kds_section_7_arrangements_report}};
  for (const auto& [points, report] : parts) {
    for (const bool quick : {true, false}) {
      std::vector<lab::SeriesResult> results;
      for (const lab::SeriesPoint& point : points(quick)) {
        // Not a run: any counts that grow.
        lab::SeriesResult result;
        result.point = point;
        const auto n = static_cast<std::uint64_t>(point.key.parameters.n);
        lab::RunRecord record;
        record.key = point.key.text();
        record.external = n * n;
        record.processed = record.max_live = record.max_per_object = n * n * n;
        result.runs = {record, record};
        results.push_back(std::move(result));
      }
      for (const lab::PaperClaim& claim : report(results, "command").claims) {
        EXPECT_FALSE(claim.small_run.structure.empty()) << claim.id << claim.no_small_run;
        EXPECT_NE(claim.observed, "no run") << claim.id;
        EXPECT_EQ(claim.observed.find("too few"), std::string::npos) << claim.id << claim.observed;
        EXPECT_EQ(claim.place, "section 7");
        EXPECT_EQ(claim.command, "command");
      }
    }
  }
}

TEST(Section7, LiftedDiscsSeeEachOtherIfTheDiscsMeet) {
  const lab::StudyResult study = families::study_lifted_discs(true, [] { return true; });
  const lab::PartReport report = families::kds_section_7_lifting_report(study, "command");
  ASSERT_EQ(report.claims.size(), 1u);
  EXPECT_EQ(report.claims[0].verdict, lab::Verdict::kConfirmed) << report.claims[0].observed;
  lab::StudyResult wrong = study;
  wrong.table.rows[1].back() = "1";
  EXPECT_EQ(families::kds_section_7_lifting_report(wrong, "command").claims[0].verdict,
            lab::Verdict::kRefuted);
}

}  // namespace kds_claims_test
}  // namespace kinex
