// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/convex_hull_2.h"

#include <gtest/gtest.h>

#include "tests/structures/hull_support.h"

namespace kinex::test {
namespace {

TEST(ConvexHull2, RandomMotionIsAuditedAtEveryEvent) {
  for (const int degree : {1, 2, 3}) {
    for (const int n : {1, 2, 3, 4, 5, 8, 13, 40}) {
      HullRun run(random_plane(n, static_cast<std::uint64_t>(100 * degree + n), degree));
      run.to_end();
      run.expect_clean();
      EXPECT_EQ(run.hull().node_rebuilds(), 0u) << "degree " << degree << ", n " << n;
    }
  }
}

}  // namespace
}  // namespace kinex::test
