// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numbers/integer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace kinex {
namespace integer_test {

TEST(Integer, HoldsTheWholeRangeOfInt128) {
  const Int128 one = 1;
  const Int128 smallest = -(one << 126) - (one << 126);
  EXPECT_EQ(Integer(smallest), -Integer::power_of_two(127));
  EXPECT_EQ(Integer(-(smallest + 1)), Integer::power_of_two(127) - Integer(1));
  EXPECT_EQ(Integer(one << 64), Integer::power_of_two(64));
  EXPECT_EQ(Integer(static_cast<Int128>(-5)), Integer(-5));
  EXPECT_TRUE(Integer(static_cast<Int128>(0)).is_zero());
}

TEST(Integer, ParsesDecimalDigitsAndNothingElse) {
  EXPECT_EQ(Integer::parse("-00123456789012345678901234567890").value().to_string(),
            "-123456789012345678901234567890");
  EXPECT_EQ(Integer::parse("+7"), Integer(7));
  EXPECT_EQ(Integer::parse("-0"), Integer(0));
  for (const char* garbage : {"", "+", "-", "--1", "1 ", " 1", "1 2", "0x1", "1e3", "1.0", "1_0"}) {
    EXPECT_FALSE(Integer::parse(garbage)) << '"' << garbage << '"';
  }
  EXPECT_FALSE(Integer::parse(std::string_view("1\0", 2)));
}

TEST(Integer, ComesFromIntegralDoublesOnly) {
  EXPECT_EQ(Integer::from_double(-3.0), Integer(-3));
  EXPECT_EQ(Integer::from_double(0x1p1000), Integer::power_of_two(1000));
  EXPECT_FALSE(Integer::from_double(0.5));
  EXPECT_FALSE(Integer::from_double(std::nan("")));
  EXPECT_FALSE(Integer::from_double(-std::numeric_limits<double>::infinity()));
}

TEST(Integer, BecomesADoubleTowardsZero) {
  EXPECT_EQ((Integer::power_of_two(53) + Integer(1)).to_double(), 0x1p53);
  EXPECT_EQ((-Integer::power_of_two(53) - Integer(1)).to_double(), -0x1p53);
  EXPECT_EQ((Integer::power_of_two(1024) - Integer(1)).to_double(),
            std::numeric_limits<double>::max());
  EXPECT_EQ(Integer::power_of_two(1024).to_double(), std::numeric_limits<double>::infinity());
  EXPECT_EQ((-Integer::power_of_two(5000)).to_double(), -std::numeric_limits<double>::infinity());
}

TEST(Integer, ShiftsRoundDown) {
  EXPECT_EQ(Integer(-1) >> 3, Integer(-1));
  EXPECT_EQ(Integer(-9) >> 3, Integer(-2));
  EXPECT_EQ(Integer(9) >> 3, Integer(1));
  EXPECT_EQ(Integer(-3) << 2, Integer(-12));
  EXPECT_EQ(floor_divide(Integer(-7), Integer(2)), Integer(-4));
  EXPECT_EQ(floor_divide(Integer(7), Integer(-2)), Integer(-4));
  EXPECT_THROW(floor_divide(Integer(1), Integer(0)), std::logic_error);
}

TEST(Integer, DivisorsAndMultiples) {
  EXPECT_EQ(gcd(Integer(-12), Integer(18)), Integer(6));
  EXPECT_EQ(gcd(Integer(0), Integer(0)), Integer(0));
  EXPECT_EQ(gcd(Integer(0), Integer(-5)), Integer(5));
  EXPECT_EQ(lcm(Integer(-4), Integer(6)), Integer(12));
  EXPECT_EQ(power(Integer(-3), 5), Integer(-243));
  EXPECT_EQ(power(Integer(0), 0), Integer(1));
  EXPECT_EQ(abs(Integer(-8)), Integer(8));
}

TEST(Integer, BitsOfZeroAndPowers) {
  EXPECT_EQ(Integer(0).bit_length(), 0U);
  EXPECT_EQ(Integer(0).trailing_zeros(), 0U);
  EXPECT_EQ(Integer(-8).bit_length(), 4U);
  EXPECT_EQ(Integer(-24).trailing_zeros(), 3U);
  EXPECT_TRUE(Integer(std::numeric_limits<std::int64_t>::min()).fits_int64());
  EXPECT_FALSE(Integer::power_of_two(63).fits_int64());
}

TEST(Integer, MovesLeaveAUsableValueBehind) {
  Integer a(5);
  Integer b(std::move(a));
  a = Integer(7);  // NOLINT(bugprone-use-after-move): assignable again
  EXPECT_EQ(b, Integer(5));
  EXPECT_EQ(a, Integer(7));
  Integer& alias = b;
  b = alias;
  EXPECT_EQ(b, Integer(5));
}

}  // namespace integer_test
}  // namespace kinex
