// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/bench/ratios.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiments/formats/input_error.h"

namespace kinex::bench {
namespace ratios_test {

using ::testing::HasSubstr;
using ::testing::Not;

std::string row(const char* structure, const char* scene, int n, const char* ratio,
                const char* arithmetic = "exact", const char* first = "double") {
  return std::string("{\"bench\": \"speed\", \"structure\": \"") + structure + "\", \"scene\": \"" +
         scene + "\", \"degree\": 1, \"n\": " + std::to_string(n) + ", \"arithmetic\": \"" +
         arithmetic + "\", \"first\": \"" + first + "\", \"time_over_first\": " + ratio + "}\n";
}

TEST(BenchRatios, TheRangeAndTheWorstOfEveryKindOfScene) {
  const std::string lines =
      row("sorted_list", "uniform-square", 10, "1.02") +
      row("delaunay_2", "uniform-square", 9, "1.31") +
      row("delaunay_2", "uniform-square", 8, "7.5", "gsl") +
      row("delaunay_2", "uniform-square", 7, "9", "exact", "sturm") +
      row("delaunay_2", "lattice", 30, "4.5") + row("delaunay_2", "meet", 31, "0") +
      "{\"bench\": \"queue\", \"n\": 3}\n" + row("separation_mixed", "polygon-gears", 8, "2.75") +
      row("disc_pairs_grid", "random-discs", 8, "1.25") + row("delaunay_2", "walks", 8, "1.75") +
      row("min_circle_2", "seesaw", 8, "1.5");
  const std::vector<Ratio> ratios = exact_over_double(lines, "rows");
  EXPECT_EQ(ratios.size(), 8u);
  const std::string text = ratios_text(ratios);
  EXPECT_THAT(text, HasSubstr("points in random motion: 1.02 to 1.31; worst: delaunay_2, "
                              "uniform-square, degree 1, n = 9\n"));
  EXPECT_THAT(text, HasSubstr("points full of ties: 4.50 to 4.50; worst: delaunay_2, lattice, "
                              "degree 1, n = 30 (in 1 of 2 rows doubles handle other events"));
  EXPECT_THAT(text, HasSubstr("points full of new plans: 1.75 to 1.75; worst: delaunay_2, walks"));
  EXPECT_THAT(text, HasSubstr("worst cases: 1.50 to 1.50; worst: min_circle_2, seesaw"));
  EXPECT_THAT(text, HasSubstr("| disc_pairs_grid | points in random motion | 1 |"));
  EXPECT_THAT(text, HasSubstr("collisions: 2.75 to 2.75; worst: separation_mixed"));
  EXPECT_THAT(text, Not(HasSubstr("9.00")));
  EXPECT_EQ(ratios_text({}), "");
  EXPECT_THROW(exact_over_double("not json\n", "rows"), formats::InputError);
}

}  // namespace ratios_test
}  // namespace kinex::bench
