// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numbers/short_rational.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <string>

#include "tests/core/numbers/polynomial_fixture.h"

namespace kinex {
namespace short_rational_test {

using fixture::rational;

std::string shown(const ShortRational& value) {
  return std::to_string(value.numerator) + "/" + std::to_string(value.denominator);
}

TEST(ShortRational, ReadsWhatIsShort) {
  const std::pair<const char*, const char*> cases[] = {
      {"0", "0/1"},         {"-0", "0/1"},       {"007", "7/1"},    {"-7", "-7/1"},
      {"-10/4", "-5/2"},    {"0/5", "0/1"},      {"0.25", "1/4"},   {"-0.250", "-1/4"},
      {"2.", "2/1"},        {"12.5", "25/2"},    {"1/007", "1/7"},  {"-0.000", "0/1"},
      {"999999999999999999", "999999999999999999/1"},
      {"-1/999999999999999999", "-1/999999999999999999"},
      {"0.00000000000000001", "1/100000000000000000"},
  };
  for (const auto& [text, expected] : cases) {
    const auto parsed = parse_short(text);
    ASSERT_TRUE(parsed) << text;
    EXPECT_EQ(shown(*parsed), expected) << text;
  }
}

TEST(ShortRational, AbstainsFromEverythingElse) {
  for (const char* text : {"", "-", "+1", ".5", "1e3", "1/0", "1/", "/2", "1//2", "1/-2", "1.5/2", "1/2/3",
                           "1.2.3", "--1", " 1", "1 ", "0x1", "1,5", "1000000000000000000",
                           "1/1000000000000000000", "0.000000000000000001", "12345678901234567.89"}) {
    EXPECT_FALSE(parse_short(text)) << '"' << text << '"';
  }
  EXPECT_FALSE(parse_short(std::string_view("1\0002", 3)));
}

TEST(ShortRational, GoesToRationalsAndBack) {
  for (const char* text : {"0", "-7", "1/3", "-9223372036854775807/9223372036854775806"}) {
    const auto words = shortened(rational(text));
    ASSERT_TRUE(words) << text;
    Rational back = rational("123456789012345678901234567890/7");
    assign(back, *words);
    EXPECT_EQ(back, rational(text));
  }
  for (const char* text : {"9223372036854775808", "-1/9223372036854775808", "18446744073709551616"}) {
    EXPECT_FALSE(shortened(rational(text))) << text;
  }
}

// Lines through a common point, and lines that miss it by as little as there is, in numbers of all lengths.
TEST(ShortRational, LinesAreEqualWhereRationalsSaySo) {
  std::mt19937_64 random(14);
  const auto number = [&](int bits) {
    const std::int64_t value = static_cast<std::int64_t>(random() >> (64 - bits));
    return random() % 2 == 0 ? value : -value;
  };
  const auto fraction = [&](int bits) { return Rational(Integer(number(bits)), Integer(std::abs(number(bits)) + 1)); };
  int equal = 0, unequal = 0, abstained = 0;
  for (int round = 0; round < 20000; ++round) {
    const int bits = 1 + static_cast<int>(random() % 30);
    const Rational a0 = fraction(bits), a1 = fraction(bits), b1 = fraction(bits), t = fraction(bits);
    Rational b0 = a0 + (a1 - b1) * t;
    if (random() % 2 == 0) b0 += Rational(Integer(1), Integer(1) << static_cast<unsigned long>(bits));
    const auto words = {shortened(a0), shortened(a1), shortened(b0), shortened(b1), shortened(t)};
    const auto w = words.begin();
    if (!w[0] || !w[1] || !w[2] || !w[3] || !w[4]) continue;
    const auto answer = equal_lines(*w[0], *w[1], *w[2], *w[3], *w[4]);
    ++(answer ? *answer ? equal : unequal : abstained);
    if (answer) {
      EXPECT_EQ(*answer, a0 + a1 * t == b0 + b1 * t);
    }
  }
  EXPECT_GT(equal, 1000);
  EXPECT_GT(unequal, 1000);
  EXPECT_GT(abstained, 20);
}

TEST(ShortRational, LargestWordsDoNotOverflow) {
  constexpr std::int64_t kMost = std::numeric_limits<std::int64_t>::max();
  const ShortRational most{kMost, kMost - 1}, least{-kMost, kMost - 1};
  EXPECT_EQ(equal_lines(most, least, most, least, most), true);
  EXPECT_EQ(equal_lines(most, least, least, most, {kMost, 1}), std::nullopt);
}

}  // namespace short_rational_test
}  // namespace kinex
