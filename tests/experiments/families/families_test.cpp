// SPDX-License-Identifier: GPL-3.0-or-later
// What the families say of their experiments fits together, and to the structures.
#include "experiments/lab/family.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <string>

#include "experiments/lab/bench_row.h"
#include "experiments/reproduce/papers.h"
#include "experiments/verify/catalogue.h"
#include "structures/registry.h"

namespace kinex {
namespace families_test {

using ::testing::Contains;
using ::testing::Not;

TEST(Families, EveryStructureHasExperimentsOfItsFamily) {
  for (const StructureInfo& info : structure_infos()) {
    EXPECT_NE(lab::experiments_on(info.name), nullptr) << info.name;
  }
  EXPECT_EQ(lab::experiments_on("no_structure"), nullptr);
  std::set<std::string_view> names;
  for (const lab::FamilyExperiments& family : lab::experiment_families()) {
    EXPECT_TRUE(names.insert(family.name).second) << family.name;
  }
}

TEST(Families, WorkloadsHaveOneNameAndMaintainWhatIsThere) {
  std::set<std::string_view> names;
  for (const lab::Workload& workload : lab::workloads()) {
    EXPECT_TRUE(names.insert(workload.name).second) << workload.name;
    EXPECT_EQ(lab::find_workload(workload.name), &workload);
    if (workload.maintain.empty()) {
      for (int d = workload.min_dimension; d <= workload.max_dimension; ++d) {
        EXPECT_NE(find_structure_info(lab::usual_structure(workload.bodies, d)), nullptr)
            << workload.name;
      }
    } else {
      EXPECT_NE(find_structure_info(workload.maintain), nullptr) << workload.name;
    }
  }
}

TEST(Families, TheUsualStructureIsThatOfTheDimensionOrElseOfAny) {
  EXPECT_EQ(lab::usual_structure(false, 1), "sorted_list");
  EXPECT_EQ(lab::usual_structure(false, 2), "delaunay_2");
  EXPECT_EQ(lab::usual_structure(false, 3), "sorted_list");
  EXPECT_EQ(lab::usual_structure(true, 2), "separation_mixed");
}

TEST(Families, PlansAndRowsNameWhatIsThere) {
  for (const lab::FamilyExperiments& family : lab::experiment_families()) {
    for (const lab::TradePlan& plan : family.trade) {
      EXPECT_EQ(lab::experiments_on(plan.structure), &family) << plan.structure;
      EXPECT_NE(lab::find_workload(plan.worst), nullptr) << plan.structure;
    }
    if (family.bench_rows == nullptr) continue;
    const std::vector<lab::BenchRow> rows = family.bench_rows(1), small = family.bench_rows(100);
    EXPECT_GE(small.size(), rows.size()) << family.name;  // the largest sizes are left out
    for (const lab::BenchRow& row : rows) {
      const bool is_structure = find_structure_info(row.structure) != nullptr;
      if (is_structure) {
        EXPECT_EQ(lab::experiments_on(row.structure), &family) << row.text();
      }
      // Requests under a common name, or a workload alone.
      EXPECT_TRUE(is_structure || !row.maintain.empty() || row.structure.empty()) << row.text();
      EXPECT_NE(lab::find_workload(row.workload), nullptr) << row.text();
      EXPECT_EQ(row.arithmetics.size() < 2,
                row.benchmark != "speed" && row.benchmark != "collision")
          << row.benchmark << " " << row.text();
    }
  }
}

// The whole run of every structure is timed in `double` and in `exact`, so that the table has the
// ratio. Left out are those that no event concerns, and the mirror images of maxima.
TEST(Families, EveryStructureHasARowOfExactOverDouble) {
  std::set<std::string_view> timed;
  for (const lab::BenchRow& row : lab::bench_rows("speed", {})) {
    const std::vector<std::string_view>& ways = row.arithmetics;
    if (ways[0] == "double" && ways[1] == "exact") timed.insert(row.structure);
  }
  for (const StructureInfo& info : structure_infos()) {
    if (!info.has_events || info.kinds.empty() || info.name.starts_with("minimum_")) continue;
    EXPECT_TRUE(timed.contains(info.name)) << info.name;
  }
}

TEST(Families, StudiesAreFoundByTheirStructureAndByItsGroup) {
  for (const lab::FamilyExperiments& family : lab::experiment_families()) {
    for (const lab::FamilyStudy& study : family.studies) {
      for (const std::string_view asked : {study.group, study.structure}) {
        std::vector<std::string> names;
        for (const lab::Study& one : verify::make_catalogue(asked, lab::Extent::kQuick).studies) {
          names.push_back(one.name);
        }
        EXPECT_THAT(names, Contains(std::string(study.name))) << asked;
      }
    }
  }
  std::vector<std::string> names;
  for (const lab::Study& one : verify::make_catalogue("sorted_list", lab::Extent::kQuick).studies) {
    names.push_back(one.name);
  }
  EXPECT_THAT(names, Not(Contains("contacts")));
}

TEST(Families, PartsOfAPaperFromSeveralFamiliesAreInItsOrder) {
  ASSERT_EQ(reproduce::papers().size(), 2u);
  for (const lab::Paper& paper : reproduce::papers()) {
    EXPECT_FALSE(paper.title.empty());
    for (std::size_t i = 1; i < paper.parts.size(); ++i) {
      EXPECT_LT(paper.parts[i - 1].place, paper.parts[i].place) << paper.parts[i].name;
    }
  }
  const lab::Paper& report = reproduce::papers().front();
  EXPECT_EQ(report.name, "kds-report-1998");
  ASSERT_EQ(report.parts.size(), 16u);
  EXPECT_EQ(report.parts[0].name, "figure-3");
  EXPECT_EQ(report.parts[2].name, "section-9");
  EXPECT_EQ(report.parts[3].name, "section-6-circle");
  EXPECT_EQ(report.parts[4].name, "section-7-delaunay");
  EXPECT_EQ(report.parts[9].name, "section-7-tree-diameter");
}

}  // namespace families_test
}  // namespace kinex
