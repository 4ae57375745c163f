// SPDX-License-Identifier: GPL-3.0-or-later
// The studies of section 7 of Guibas's report (1998): verdicts follow the tables, and the hubs are hubs.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "core/engine/simulator.h"
#include "experiments/families/arrangement/experiments.h"
#include "experiments/families/proximity/experiments.h"
#include "experiments/families/proximity/hub_scenes.h"
#include "experiments/lab/scene_run.h"
#include "structures/plan.h"

namespace kinex {
namespace kds_studies_test {

lab::StudyResult table_of(std::vector<std::vector<std::string>> rows) {
  lab::StudyResult result;
  result.table.rows = std::move(rows);
  return result;
}

// How many entries of the attribute at the end name each object.
std::vector<std::size_t> entries_of(Scene scene, const char* structure) {
  scene.maintain = {Request{structure, structure, {}}};
  const auto simulator = lab::make_simulator(scene, "exact", {});
  simulator->start();
  simulator->run_until(std::nullopt);
  EXPECT_TRUE(simulator->violations().empty());
  std::vector<std::size_t> degree(scene.objects.size());
  for (const ObjectId id : simulator->structure(asked_structure(scene)).attribute().ids)
    ++degree[id];
  return degree;
}

TEST(Hubs, NearlyAllPointsAreNextToTheHubInTheDelaunayTriangulation) {
  for (const int n : {8, 17, 40}) {
    const auto degree = entries_of(families::hub_of_points(n), "delaunay_2");
    EXPECT_GE(degree[0] + 2, static_cast<std::size_t>(n)) << n;
    EXPECT_EQ(std::max_element(degree.begin(), degree.end()), degree.begin()) << n;
  }
}

TEST(Hubs, TheSmallestGapIsAlwaysThatOfTheLargeDisc) {
  for (const int n : {8, 17, 40}) {
    const auto degree = entries_of(families::hub_of_discs(n), "closest_pair_discs");
    EXPECT_EQ(degree[0], 1u) << n;
  }
  const auto degree = entries_of(families::hub_of_discs(12), "disc_pairs_all");
  EXPECT_EQ(std::count(degree.begin(), degree.end(), 0u), 12);  // no two meet
}

TEST(ApproximateTrees, OneEdgeAboveTheBoundRefutes) {
  const auto verdict = [](const char* violations, const char* longer) {
    const auto claims = families::kds_section_7_approximation_report(
                            table_of({{"12", "uniform-square", "8", "4", "100", violations, "280",
                                       longer, "1.04"}}),
                            "command")
                            .claims;
    EXPECT_EQ(claims.size(), 1u);
    return claims.front().verdict;
  };
  EXPECT_EQ(verdict("0", "0"), lab::Verdict::kOpen);  // a bound on all motions
  EXPECT_EQ(verdict("0", "1"), lab::Verdict::kRefuted);
  EXPECT_EQ(verdict("1", "0"), lab::Verdict::kRefuted);
}

lab::Verdict balls_verdict(int power) {
  std::vector<std::vector<std::string>> rows;
  for (const int n : {32, 64, 128, 256, 512}) {
    const int count = power == 0 ? 60 + (n / 32) % 3 : 6 * n;
    rows.push_back({"closest_pair_discs", "hub", std::to_string(n), "1", "9", std::to_string(count),
                    "0", "9", "5", "8"});
  }
  for (const lab::PaperClaim& claim :
       families::kds_section_7_locality_report(table_of(rows), "command").claims) {
    if (claim.id == "7.6.balls-local") return claim.verdict;
  }
  ADD_FAILURE() << "no claim on balls";
  return lab::Verdict::kOpen;
}

TEST(Locality, TheGrowthDecides) {
  EXPECT_EQ(balls_verdict(1), lab::Verdict::kConfirmed);
  EXPECT_EQ(balls_verdict(0), lab::Verdict::kRefuted);
}

// What the study of clusters says of certificates that grow like these powers of the vertices.
std::string clusters_text(double clusters, double cycles, std::size_t sizes) {
  std::vector<std::vector<std::string>> rows;
  int n = 16;
  for (std::size_t i = 0; i < sizes; ++i, n *= 2) {
    const double wobble = i % 2 == 0 ? 1.001 : 0.999;
    const double of_clusters = 4 * std::pow(n, clusters) * wobble,
                 of_cycles = 3 * std::pow(n, cycles) / wobble;
    rows.push_back({"uniform-square", std::to_string(n), "8", "9", std::to_string(of_clusters),
                    std::to_string(of_clusters / 500), "1", std::to_string(of_cycles),
                    std::to_string(of_cycles / 500)});
  }
  return families::kds_section_7_clusters_report(table_of(rows), "command").claims.at(0).observed;
}

TEST(Clusters, TheTableDecidesWhatIsSaid) {
  const auto says = [](const std::string& text, const char* words) {
    return text.find(words) != std::string::npos;
  };
  const std::string pays = clusters_text(0.3, 1, 6), costs = clusters_text(1, 0.3, 6),
                    few = clusters_text(1, 0.3, 3);
  EXPECT_TRUE(
      says(costs, "Cycles make fewer certificates at every size; the ratio of the two grows"));
  EXPECT_TRUE(
      says(costs, "by clusters they grow faster than n^(2/3); by cycles they grow more slowly"));
  EXPECT_TRUE(says(costs, "No size here shows that clusters pay"));
  EXPECT_TRUE(says(pays, "at 0 of 6 sizes") && says(pays, "the ratio of the two falls with n"))
      << pays;
  EXPECT_TRUE(
      says(pays, "by clusters they grow more slowly than n^(2/3); by cycles they grow faster"));
  EXPECT_FALSE(says(pays, "No size here"));
  EXPECT_TRUE(says(few, "whether the ratio of the two grows is not told")) << few;
}

TEST(TreeDiameter, TheTableDecidesWhatIsSaid) {
  const auto text = [](double power) {
    std::vector<std::vector<std::string>> rows;
    for (const int n : {50, 100, 200, 400, 800}) {
      const double edges = 2 * std::pow(n, power) * (n % 200 == 0 ? 1.001 : 0.999);
      rows.push_back({std::to_string(n), "16", std::to_string(edges), std::to_string(edges / 500)});
    }
    return families::kds_section_7_diameter_report(table_of(rows), "command").claims.at(0).observed;
  };
  EXPECT_NE(text(0.65).find("faster than n^(1/2), the side"), std::string::npos);
  EXPECT_NE(text(0.4).find("more slowly than n^(1/2), the side"), std::string::npos);
  EXPECT_NE(text(1.2).find("and faster than n."), std::string::npos) << text(1.2);
}

TEST(Hitting, TheShareIsThatOfTheTable) {
  std::vector<std::vector<std::string>> rows;
  for (const int n : {12, 24, 48, 96}) {
    rows.push_back({"random-discs", std::to_string(n), "8", "5", std::to_string(2 * n),
                    std::to_string(n), std::to_string(n == 48 ? 24.5 : 1.0 * n), "0.1", "0"});
  }
  const auto report = families::kds_section_7_hitting_report(table_of(rows), "command");
  for (const char* const said :
       {"At least 51 % of the maximal sets were chosen", "p = 24.0 at n = 12, 192.0 at n = 96",
        "At n = 96 there are 2.0 pairs for each point"}) {
    EXPECT_NE(report.claims.at(0).observed.find(said), std::string::npos)
        << report.claims.at(0).observed;
  }
}

TEST(Cuttings, OtherChangesRefute) {
  std::vector<std::vector<std::string>> rows;
  for (const int n : {27, 45, 64, 125}) {
    rows.push_back({"n^(1/2)", std::to_string(n), "5", "4", std::to_string(40 * n), "1",
                    std::to_string(n * n), "1"});
  }
  lab::StudyResult study = table_of(rows);
  const auto verdict = [&study] {
    return families::kds_section_7_cuttings_report(study, "command").claims.at(0).verdict;
  };
  EXPECT_EQ(verdict(), lab::Verdict::kOpen);
  study.checks.emplace_back();
  EXPECT_EQ(verdict(), lab::Verdict::kOpen);  // a check that is right
  study.checks.back().verdict = lab::Verdict::kRefuted;
  EXPECT_EQ(verdict(), lab::Verdict::kRefuted);
}

}  // namespace kds_studies_test
}  // namespace kinex
