// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numbers/short_dyadic.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <string>

namespace kinex {
namespace short_dyadic_test {

std::string shortest(double lo, double hi) {
  const auto found = shortest_dyadic(lo, hi);
  if (!found) return "none";
  EXPECT_EQ(found->to_rational(), *Rational::from_double(found->to_double()));
  return found->to_rational().to_string();
}

TEST(ShortDyadic, HasTheFewestPlaces) {
  EXPECT_EQ(shortest(0.9, 1.1), "1");
  EXPECT_EQ(shortest(1, 1), "1");
  EXPECT_EQ(shortest(-0.3, 0.3), "0");
  EXPECT_EQ(shortest(-1.1, -0.9), "-1");
  EXPECT_EQ(shortest(0.3, 0.6), "1/2");
  EXPECT_EQ(shortest(0.26, 0.45), "3/8");
  EXPECT_EQ(shortest(-0.45, -0.26), "-3/8");
  EXPECT_EQ(shortest(0.3, 5.2), "1");  // of several the least
  EXPECT_EQ(shortest(0x1p-10, 0x1p-10), "1/1024");
  EXPECT_EQ(shortest(0x1p30, 0x1p30), "1073741824");
  EXPECT_EQ(shortest(-0x1p30 + 0x1p-10, -0x1p30 + 0x1p-10), "-1099511627775/1024");
}

TEST(ShortDyadic, AbstainsFromLongOnes) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(shortest(0x1p-11, 0x1p-11), "none");
  EXPECT_EQ(shortest(0.1, 0.1), "none");
  EXPECT_EQ(shortest(0x1.8p30, 0x1.8p30), "none");
  EXPECT_EQ(shortest(-kInfinity, 0), "none");
  EXPECT_EQ(shortest(0, kInfinity), "none");
  EXPECT_EQ(shortest(std::numeric_limits<double>::quiet_NaN(), 1), "none");
  EXPECT_EQ(shortest(1.1, 1.1), "none");
}

TEST(ShortDyadic, IsInTheInterval) {
  std::mt19937_64 random(1);
  int found = 0;
  for (int i = 0; i < 20000; ++i) {
    const double width = 1 / static_cast<double>(1 + random() % 5000);
    const double lo = static_cast<double>(random() % 2'000'001) * 0x1p-10 - 976.5 + width / 3;
    const auto t = shortest_dyadic(lo, lo + width);
    if (!t) continue;
    ++found;
    const double value = t->to_double();
    EXPECT_TRUE(lo <= value && value <= lo + width);
    EXPECT_TRUE(t->places == 0 || t->numerator % 2 != 0);
    // None with fewer places.
    for (int places = 0; places < t->places; ++places) {
      const double scale = static_cast<double>(1 << places);
      EXPECT_LT(std::floor((lo + width) * scale), lo * scale);
    }
  }
  EXPECT_GT(found, 5000);
}

}  // namespace short_dyadic_test
}  // namespace kinex
