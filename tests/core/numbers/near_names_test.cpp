// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numbers/near_names.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace kinex {
namespace near_names_test {

using testing::ElementsAre;
using testing::IsEmpty;

const std::vector<std::string> kNames{"sorted_list", "delaunay_2", "convex_hull_2", "maximum_heap",
                                      "maximum_hanger"};

TEST(NearNames, Distances) {
  EXPECT_EQ(name_distance("", ""), 0u);
  EXPECT_EQ(name_distance("", "abc"), 3u);
  EXPECT_EQ(name_distance("kitten", "sitting"), 3u);
  EXPECT_EQ(name_distance("run", "rnu"), 1u);  // two neighbours exchanged
  EXPECT_EQ(name_distance("ab", "ba"), 1u);
  EXPECT_EQ(name_distance("Delaunay-2", "delaunay_2"), 0u);
  EXPECT_EQ(name_distance("abc", "cba"), name_distance("cba", "abc"));
}

TEST(NearNames, TheNearestFirstAndNothingThatIsFar) {
  EXPECT_THAT(near_names("delauney_2", kNames), ElementsAre("delaunay_2"));
  EXPECT_THAT(near_names("delauney", kNames), ElementsAre("delaunay_2"));  // the number is left out
  EXPECT_THAT(near_names("sortedlist", kNames), ElementsAre("sorted_list"));
  EXPECT_THAT(near_names("hull", kNames), ElementsAre("convex_hull_2"));  // a part
  EXPECT_THAT(near_names("maximum", kNames), ElementsAre("maximum_heap", "maximum_hanger"));
  EXPECT_THAT(near_names("con", kNames), ElementsAre("convex_hull_2"));  // a beginning
  EXPECT_THAT(near_names("co", kNames), IsEmpty());
  EXPECT_THAT(near_names("ull", kNames), IsEmpty());
  EXPECT_THAT(near_names("voronoi", kNames), IsEmpty());
  EXPECT_THAT(near_names("", kNames), IsEmpty());
  EXPECT_THAT(near_names(std::string(1000, 'd'), kNames), IsEmpty());
  EXPECT_THAT(near_names("ad", {"aa", "ab", "ac", "ae"}), testing::SizeIs(3));
}

TEST(NearNames, Remedies) {
  EXPECT_EQ(did_you_mean("rnu", {"run", "gen"}, "write a verb"), "did you mean run?");
  EXPECT_EQ(did_you_mean("maximum", kNames, ""), "did you mean maximum_heap or maximum_hanger?");
  EXPECT_EQ(did_you_mean("ad", {"aa", "ab", "ac", "ae"}, ""), "did you mean aa, ab or ac?");
  EXPECT_EQ(did_you_mean("voronoi", kNames, "known are .."), "known are ..");
}

}  // namespace near_names_test
}  // namespace kinex
