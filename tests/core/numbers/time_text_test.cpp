// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numbers/time_text.h"

#include <gtest/gtest.h>

namespace kinex::test {
namespace time_text_test {

std::string text(const char* number) { return time_text(*Rational::parse(number)); }

TEST(TimeText, ShortTimesAreExact) {
  EXPECT_EQ(text("0"), "0");
  EXPECT_EQ(text("-7"), "-7");
  EXPECT_EQ(text("3/2"), "3/2 (1.5)");
  EXPECT_EQ(text("-1/3"), "-1/3 (-0.3333333333)");
  EXPECT_EQ(text("12345678901234567890"), "12345678901234567890");
  EXPECT_EQ(text("1/1000000000000"), "1/1000000000000 (1e-12)");
}

TEST(TimeText, LongTimesAreDecimals) {
  EXPECT_EQ(text("100000000000000000001/100000000000000000000"), "about 1");
  EXPECT_EQ(text("-12345678901234567891/3"), "about -4.1152263e+18");
  EXPECT_EQ(text("1e-5000"), "about 1e-5000");
  EXPECT_EQ(text("1e5000"), "about 1e+5000");
}

TEST(TimeText, InstantsAreNamedExactlyOrByTheirDecimal) {
  InstantName instant;
  instant.detail = InstantDetail::kName;
  instant.exact = true;
  instant.lower = instant.upper = *Rational::parse("3/2");
  instant.decimal = "1.500";
  EXPECT_EQ(time_text(instant), "3/2 (1.5)");
  instant.upper = Rational(2);  // irrational
  EXPECT_EQ(time_text(instant), "about 1.500");
  instant.upper = instant.lower;
  instant.exact = false;
  EXPECT_EQ(time_text(instant), "about 1.500");
}

}  // namespace time_text_test
}  // namespace kinex::test
