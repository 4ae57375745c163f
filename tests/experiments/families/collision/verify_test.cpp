// SPDX-License-Identifier: GPL-3.0-or-later
// The experiments on collisions: what is in them, and that their checks can fail.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>
#include <string>

#include "experiments/families/collision/experiments.h"
#include "experiments/families/collision/axes.h"
#include "experiments/families/collision/story.h"
#include "experiments/families/collision/turned_scene.h"
#include "experiments/verify/catalogue.h"
#include "experiments/verify/plots.h"
#include "experiments/verify/report_text.h"
#include "experiments/verify/runner.h"
#include "tests/sanitized.h"

namespace kinex {
namespace verify_test {

using ::testing::HasSubstr;

constexpr const char* kMethods[] = {"separation_mixed",      "separation_minkowski",
                                    "separation_hysteresis", "closest_features",
                                    "inner_tangents",        "bounding_volumes"};

lab::Cell round(const char* structure, int n, const char* separation) {
  lab::Cell cell;
  cell.question = "test";
  cell.structure = structure;
  cell.workload = "polygon-orbit";
  cell.parameters.n = n;
  cell.parameters.separation = Rational::parse(separation);
  cell.family = "B1 round, test";
  cell.family_row = "B1 round";
  cell.axis = families::mu_axis(cell);
  return cell;
}

void expect(lab::Cell& cell, lab::ExpectationKind kind, std::int64_t count) {
  lab::Expectation expectation;
  expectation.claim = "test.claim";
  expectation.kind = kind;
  expectation.quantity = "processed";
  expectation.exact = Integer(count);
  expectation.source = "test";
  cell.expectations = {expectation};
}

lab::Verdict verdict_of(const lab::Cell& cell) { return verify::run_cell(cell, {})->verdict(); }

// Of the same values of mu the paper's claims have this tolerance.
TEST(CollisionCatalogue, LawsOfMuHaveTheToleranceOfThePaper) {
  std::multiset<std::string> laws;
  for (const lab::GrowthClaim& growth :
       verify::make_catalogue("collision", lab::Extent::kFull).growths) {
    if (growth.claim != "collision.round.mu" && growth.claim != "collision.rigid.mu") continue;
    laws.insert(growth.claim);
    EXPECT_EQ(growth.tolerance, 0.1) << growth.claim << " of " << growth.structure;
  }
  EXPECT_EQ(laws.count("collision.round.mu"), 3u);
  EXPECT_EQ(laws.count("collision.rigid.mu"), 1u);
}

TEST(CollisionCatalogue, IsAGroupOfAllStructuresForBodies) {
  const lab::Catalogue group = verify::make_catalogue("collision", lab::Extent::kQuick);
  std::set<std::string> structures, common;
  for (const lab::Cell& cell : group.cells) {
    structures.insert(cell.structure);
    if (cell.question == "Do the hard bounds hold?") common.insert(cell.structure);
  }
  const std::set<std::string> all(std::begin(kMethods), std::end(kMethods));
  EXPECT_TRUE(std::includes(structures.begin(), structures.end(), all.begin(), all.end()));
  EXPECT_EQ(common, structures);
  EXPECT_EQ(group.studies.size(), 4u);
  EXPECT_EQ(verify::make_catalogue("all", lab::Extent::kQuick).studies.size(), 11u);
  EXPECT_EQ(verify::make_catalogue("separation_hysteresis", lab::Extent::kQuick).studies.size(), 1u);
  EXPECT_EQ(verify::make_catalogue("outer_hierarchy", lab::Extent::kQuick).studies.size(), 1u);
  EXPECT_EQ(verify::make_catalogue("inner_tangents", lab::Extent::kQuick).studies.size(), 1u);
  EXPECT_TRUE(verify::make_catalogue("minimum", lab::Extent::kQuick).studies.empty());
}

TEST(CollisionCatalogue, ExpectsTheCountsOfTheFans) {
  std::map<std::pair<std::string, int>, std::string> counts;
  for (const lab::Cell& cell : verify::make_catalogue("collision", lab::Extent::kQuick).cells) {
    for (const lab::Expectation& expectation : cell.expectations) {
      if (expectation.kind != lab::ExpectationKind::kExact) continue;
      if (expectation.claim.find(".fan") == std::string::npos) continue;
      counts[{cell.structure, cell.parameters.n}] = expectation.exact.to_string();
    }
  }
  EXPECT_EQ((counts[{"closest_features", 8}]), "208");
  EXPECT_EQ((counts[{"closest_features", 16}]), "800");
  EXPECT_EQ((counts[{"inner_tangents", 8}]), "144");
  EXPECT_EQ((counts[{"inner_tangents", 16}]), "544");
}

// A round of R = 2 + 1/8 about rho = 2 cos(pi/16) takes pi / arccos(rho / R) = 7.96 certificates.
TEST(CollisionCatalogue, KnowsTheLowerBound) {
  const lab::Catalogue group = verify::make_catalogue("separation_mixed", lab::Extent::kFull);
  int bounds = 0;
  for (const lab::Cell& cell : group.cells) {
    for (const lab::Expectation& expectation : cell.expectations) {
      if (expectation.kind != lab::ExpectationKind::kAtLeast) continue;
      const double s = cell.parameters.separation->to_double();
      const double asymptotic = std::acos(-1.0) / std::sqrt(s);
      const double bound = expectation.exact.to_double() + 1;
      ++bounds;
      EXPECT_LE(bound, std::min(asymptotic * (1 + s), 1.0 * cell.parameters.n) + 1) << s;
      EXPECT_GE(bound, asymptotic / 2.5) << s;
    }
  }
  EXPECT_GT(bounds, 9);
}

TEST(CollisionJudge, TellsBoundsFromBothSides) {
  lab::Cell cell = round("separation_minkowski", 16, "1/10");  // 16 events
  expect(cell, lab::ExpectationKind::kAtLeast, 16);
  EXPECT_EQ(verdict_of(cell), lab::Verdict::kConfirmed);
  expect(cell, lab::ExpectationKind::kAtLeast, 17);
  EXPECT_EQ(verdict_of(cell), lab::Verdict::kRefuted);
  expect(cell, lab::ExpectationKind::kAtMost, 16);
  EXPECT_EQ(verdict_of(cell), lab::Verdict::kConfirmed);
  expect(cell, lab::ExpectationKind::kAtMost, 15);
  EXPECT_EQ(verdict_of(cell), lab::Verdict::kRefuted);
  EXPECT_THAT(verify::table_row(*verify::run_cell(cell, {})), HasSubstr("expected <= 15, observed 16"));
}

TEST(CollisionJudge, FitsAgainstMu) {
  lab::Catalogue catalogue;
  for (const char* separation : {"1/8", "1/32", "1/128", "1/512"}) {
    catalogue.cells.push_back(round("separation_mixed", 64, separation));
  }
  lab::GrowthClaim claim;
  claim.claim = "test";
  claim.structure = "separation_mixed";
  claim.family = "B1 round, test";
  claim.quantity = "processed";
  claim.exponent = 1;
  claim.tolerance = 0.3;
  catalogue.growths.push_back(claim);
  claim.exponent = 2;
  catalogue.growths.push_back(claim);
  claim.at_most = true;
  catalogue.growths.push_back(claim);
  claim.exponent = -1;
  catalogue.growths.push_back(claim);
  const verify::VerifyResult result = verify::run_catalogue(catalogue, {});
  ASSERT_EQ(result.growths.size(), 4u);
  ASSERT_EQ(result.growths[0].points.size(), 4u);
  EXPECT_DOUBLE_EQ(result.growths[0].points[0].n, 4);
  EXPECT_DOUBLE_EQ(result.growths[0].points[3].n, 32);
  EXPECT_NE(result.growths[0].check.verdict, lab::Verdict::kRefuted);
  EXPECT_EQ(result.growths[1].check.verdict, lab::Verdict::kRefuted);
  EXPECT_EQ(result.growths[2].check.verdict, lab::Verdict::kConfirmed);
  EXPECT_EQ(result.growths[3].check.verdict, lab::Verdict::kRefuted);
  EXPECT_THAT(result.growths[0].check.observed, HasSubstr("(mu)^"));
}

TEST(CollisionJudge, LimitsTheSignsOfTilesOnly) {
  lab::Cell cell = round("separation_mixed", 64, "1/32");  // mu = 8
  ASSERT_TRUE(families::signs_limit(cell));
  EXPECT_DOUBLE_EQ(*families::signs_limit(cell), 4 * 3 + 45);
  EXPECT_FALSE(families::signs_limit(round("closest_features", 64, "1/32")));
  cell.family_row.clear();
  EXPECT_FALSE(families::signs_limit(cell));
  expect(cell, lab::ExpectationKind::kAtMost, 57);
  cell.expectations[0].quantity = "signs_per_event";
  EXPECT_EQ(verdict_of(cell), lab::Verdict::kConfirmed);
  expect(cell, lab::ExpectationKind::kAtMost, 2);
  cell.expectations[0].quantity = "signs_per_event";
  EXPECT_EQ(verdict_of(cell), lab::Verdict::kRefuted);
}

TEST(StudyTangents, CountsEachTangentApart) {
  const lab::StudyResult result = families::study_tangents(true, [] { return true; });
  ASSERT_EQ(result.checks.size(), 2u);
  EXPECT_EQ(result.verdict(), lab::Verdict::kConfirmed);
  ASSERT_GE(result.table.rows.size(), 3u);
  EXPECT_EQ(result.table.rows[0], (std::vector<std::string>{"8", "8", "144", "136", "8"}));
}

TEST(TurnedScene, IsTheSameMotionInAnotherDirection) {
  lab::WorkloadParameters parameters;
  parameters.n = 8;
  Scene scene = lab::generate_scene(*lab::find_workload("polygon-line"), parameters);
  const auto distance = [&](const Rational& t) {
    Rational sum;
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const auto at = [&](std::size_t i) {
        return scene.objects[i].motion.pieces[0].trajectory.position(axis, t);
      };
      sum += (at(1) - at(0)) * (at(1) - at(0));
    }
    return sum;
  };
  const auto length = [&](std::size_t i) {
    const Vertex2& v = scene.objects[0].polygon[i];
    return v[0] * v[0] + v[1] * v[1];
  };
  const Rational before = distance(Rational(Integer(1), Integer(3))), first = length(3);
  const Vertex2 corner = scene.objects[0].polygon[0];
  std::set<std::string> directions;
  for (int k = 0; k < 5; ++k) {
    scene = lab::generate_scene(*lab::find_workload("polygon-line"), parameters);
    families::turn_scene(scene, k);
    EXPECT_EQ(distance(Rational(Integer(1), Integer(3))), before);
    EXPECT_EQ(length(3), first);
    EXPECT_GT(scene.objects[0].polygon[0][1], corner[1]);
    directions.insert(scene.objects[0].polygon[0][0].to_string());
  }
  EXPECT_EQ(directions.size(), 5u);
}

TEST(CollisionStory, HasARowPerScene) {
  lab::Catalogue catalogue;
  for (const char* structure : kMethods) catalogue.cells.push_back(round(structure, 8, "1/10"));
  const verify::VerifyResult result = verify::run_catalogue(catalogue, {});
  const auto table = families::events_table(result.cells);
  ASSERT_TRUE(table);
  ASSERT_EQ(table->rows.size(), 1u);
  EXPECT_EQ(table->header.size(), table->rows[0].size());
  EXPECT_EQ(table->rows[0][0], "B1 round");
  EXPECT_THAT(table->rows[0], ::testing::Contains("32"));  // 4n changes of the closest features
  ASSERT_TRUE(families::signs_table(result.cells));
  EXPECT_TRUE(families::collision_figures(result.cells).empty());  // one size is no curve
  EXPECT_FALSE(families::events_table({}));
}

TEST(CollisionStudies, ContactsAgree) {
  int scenes = 0;
  const lab::StudyResult study = families::study_contacts(true, [&] { return ++scenes <= 6; });
  EXPECT_EQ(study.verdict(), lab::Verdict::kConfirmed) << verify::table_row(study);
  EXPECT_GE(study.checks.size(), 6u);
}

TEST(CollisionStudies, OuterHierarchiesKeepTheirBounds) {
  int polygons = 0;
  const lab::StudyResult whole = families::study_outer_hierarchies(true, [&] { return ++polygons <= 100; });
  EXPECT_EQ(whole.verdict(), lab::Verdict::kConfirmed) << verify::table_row(whole);
  EXPECT_EQ(whole.table.rows.size(), 4u * 4u * 4u);
  EXPECT_EQ(whole.checks.size(), 4u * 3u + 1u);
}

TEST(CollisionStudies, WedgesAreFewerThanBalls) {
  int runs = 0;
  const lab::StudyResult study =
      families::study_wedge_cover(true, [&] { return !test::kSanitized || ++runs <= 8; });
  EXPECT_EQ(study.verdict(), lab::Verdict::kConfirmed) << verify::table_row(study);
  ASSERT_EQ(study.checks.size(), 4u);
  ASSERT_GE(study.table.rows.size(), 8u);
  for (const auto& row : study.table.rows) EXPECT_EQ(row.size(), study.table.header.size());
}

}  // namespace verify_test
}  // namespace kinex
