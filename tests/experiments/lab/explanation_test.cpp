// SPDX-License-Identifier: GPL-3.0-or-later
// Everything that is listed can be explained, and nothing essential is missing.
#include "experiments/lab/explanation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

#include "experiments/lab/scene_run.h"
#include "structures/registry.h"

namespace kinex::lab {
namespace explanation_test {

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;

const std::vector<std::string>* part(const Explanation& explanation, const std::string& heading) {
  for (const auto& [name, lines] : explanation.parts) {
    if (name == heading) return &lines;
  }
  return nullptr;
}

TEST(Explanation, EveryStructureSaysWhatItIs) {
  ASSERT_FALSE(structure_infos().empty());
  for (const StructureInfo& info : structure_infos()) {
    SCOPED_TRACE(info.name);
    const Explanation explanation = explain(info);
    for (const char* heading :
         {"maintains", "for", "certificates", "ties", "bounds", "source", "example"}) {
      const std::vector<std::string>* const lines = part(explanation, heading);
      ASSERT_NE(lines, nullptr) << heading;
      for (const std::string& line : *lines) {
        EXPECT_FALSE(line.empty()) << heading;
        EXPECT_NE(line.back(), '.') << line;
        EXPECT_EQ(line.find('{'), std::string::npos) << line;  // all arguments are named
      }
    }
    if (info.has_events) {
      EXPECT_NE(part(explanation, "predicates"), nullptr);
      const std::vector<std::string>* const events = part(explanation, "events");
      EXPECT_EQ(events == nullptr ? 0 : events->size(), info.kinds.size());
    }
    EXPECT_THAT(part(explanation, "example")->front(),
                HasSubstr("--maintain " + std::string(info.name)));
    if (const std::vector<std::string>* const rows = part(explanation, "predicates")) {
      EXPECT_LE(rows->size(), 16u);
      for (const std::string& row : *rows) {
        EXPECT_THAT(row, Not(HasSubstr("degree 0d")));
        EXPECT_THAT(row, Not(HasSubstr(" there")));
      }
    }
    for (const std::string& row : *part(explanation, "bounds"))
      EXPECT_THAT(row, Not(HasSubstr("(there ")));
  }
}

TEST(Explanation, DegreesAndBoundsOfTheTriangulation) {
  const Explanation explanation = explain(*find_structure_info("delaunay_2"));
  EXPECT_THAT(*part(explanation, "predicates"),
              AllOf(Contains(HasSubstr(
                        "in_circle_2(a, b, c, d), degree 4d in t: d is not inside the circle")),
                    Contains(HasSubstr("orientation_2(a, b, c), degree 2d in t"))));
  EXPECT_THAT(*part(explanation, "bounds"), Contains(HasSubstr("delaunay_2.compactness: ")));
  EXPECT_THAT(*part(explanation, "to verify"), Contains(HasSubstr("delaunay_2.uniform.growth: ")));
}

// One row a predicate, however often an object is several arguments.
TEST(Explanation, RowsOfPredicatesAreFew) {
  const Explanation rectangle = explain(*find_structure_info("min_area_rectangle_directions"));
  EXPECT_THAT(*part(rectangle, "predicates"),
              Contains(AllOf(HasSubstr("order_box_area(a, b, c, d, e, f, g, h), degree 2d in t: "),
                             HasSubstr("; and where an object is several of these, in "),
                             HasSubstr(" objects"))));
  EXPECT_THAT(*part(rectangle, "predicates"),
              Contains(HasSubstr("line_slope_order(a, b), constant in t: ")));
}

// An example in which nothing happens explains nothing.
TEST(Explanation, ExamplesHaveEvents) {
  for (const StructureInfo& info : structure_infos()) {
    if (info.kinds.empty()) continue;  // it has none
    SCOPED_TRACE(info.name);
    const ExampleScene example = example_scene(info);
    ASSERT_NE(example.workload, nullptr);
    const Scene scene = generate_scene(example.workload->name, example.parameters, info.name);
    const std::unique_ptr<Simulator> simulator = make_simulator(scene, "exact", {});
    run_scene(*simulator, {});
    std::uint64_t events = 0;
    for (StructureId id = 0; id < simulator->structures(); ++id) {
      if (simulator->structure(id).name() != info.name) continue;
      events += simulator->ledger(id).external + simulator->ledger(id).internal;
    }
    EXPECT_GT(events, 0u);
  }
}

// Certificates of lines are about slopes and crossings, not about the points that stand for lines.
TEST(Explanation, CertificatesOfLines) {
  EXPECT_THAT(*part(explain(*find_structure_info("line_arrangement_2")), "predicates"),
              testing::ElementsAre(
                  HasSubstr("order_x(a, b), degree d in t: the slope of a is at most that of b"),
                  HasSubstr("order_y(a, b), degree d in t: a is not above b at x = 0"),
                  HasSubstr("orientation_2(a, b, c), degree 2d in t: c is not below the crossing "
                            "of a and b, if a has the "
                            "smaller slope, and not above it otherwise")));
  EXPECT_THAT(
      *part(explain(*find_structure_info("trapezoids_2")), "predicates"),
      Contains(HasSubstr(
          "the crossing of c and d is not to the right of that of a and b, if slopes grow")));
}

// No certificate says that something is at least itself.
TEST(Explanation, ExtentsOfTheSamePoints) {
  EXPECT_THAT(
      *part(explain(*find_structure_info("mst_polygon_list")), "predicates"),
      Contains(HasSubstr(
          "order_extent_2(a, b), degree d in t: the extent from b to a along one direction is at "
          "least that along another")));
}

TEST(Explanation, EveryWorkloadAndItsOptions) {
  for (const Workload& workload : workloads()) {
    SCOPED_TRACE(workload.name);
    const Explanation explanation = explain(workload);
    const std::vector<std::string>& options = *part(explanation, "options");
    const auto has = [&](const std::string& option) {
      return std::any_of(options.begin(), options.end(),
                         [&](const std::string& line) { return line.starts_with(option + " "); });
    };
    EXPECT_TRUE(has("--n"));
    EXPECT_THAT(options.front(),
                AllOf(HasSubstr("--n  " + std::string(workload.n_counts) + ": "),
                      HasSubstr(std::to_string(workload.default_n) + " by default")));
    EXPECT_EQ(has("--seed"), workload.random);
    EXPECT_EQ(has("--m"), workload.takes_m);
    EXPECT_EQ(has("--degree"), workload.takes_degree);
    EXPECT_EQ(has("--separation"), workload.separation.has_value());
    EXPECT_EQ(has("--turns"), workload.takes_turns);
  }
}

TEST(Explanation, Arithmetics) {
  for (const ArithmeticInfo& info : arithmetic_infos()) {
    EXPECT_EQ(find_arithmetic_info(info.name), &info);
    EXPECT_EQ(find_arithmetic_info(info.example), &info);
    EXPECT_NE(part(explain(info), "promise"), nullptr);
  }
  EXPECT_EQ(find_arithmetic_info("mpfr"), find_arithmetic_info("mpfr:P"));
  EXPECT_EQ(find_arithmetic_info("abacus"), nullptr);
}

}  // namespace explanation_test
}  // namespace kinex::lab
