// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures of groups of points: what no picture may hide.
#include "experiments/lab/scatter.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace kinex::lab {
namespace scatter_test {

using ::testing::HasSubstr;

// The median of a group on that of another, and on two others, is a ring around them.
TEST(Scatter, NoMedianCoversAnother) {
  const ScatterPicture picture{"time", "error", 1e16, 0.2, {{"pt 7", "same", 0.4}}};
  const std::vector<ScatterGroup> groups{{"one", {{1, 0.5, 0}}},
                                         {"apart", {{20, 0.5, 0}}},
                                         {"on it", {{1.01, 0.5, 0}}},
                                         {"on both", {{1, 0.51, 0}}}};
  Figure figure;
  set_scatter(figure, picture, groups);
  EXPECT_THAT(figure.script,
              HasSubstr("$medians << EOD\n1 0.5 1.6\n20 0.5 1.6\n1.01 0.5 2.6\n1 0.51 3.6\nEOD\n"));
  EXPECT_THAT(figure.script, HasSubstr("$medians using 1:2:3 with points pt 6 ps variable"));
}

}  // namespace scatter_test
}  // namespace kinex::lab
