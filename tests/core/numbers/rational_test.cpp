// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numbers/rational.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "tests/core/numbers/polynomial_fixture.h"

namespace kinex {
namespace rational_test {

using fixture::rational;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(Rational, IsAlwaysCanonical) {
  EXPECT_EQ(Rational(Integer(2), Integer(-6)).to_string(), "-1/3");
  EXPECT_EQ(Rational(Integer(0), Integer(-6)).to_string(), "0");
  EXPECT_EQ(rational("2/6"), rational("1/3"));
  EXPECT_EQ(rational("4/2").to_string(), "2");
  EXPECT_THROW(Rational(Integer(1), Integer(0)), std::logic_error);
}

TEST(Rational, ParsesEveryDocumentedForm) {
  const std::pair<const char*, const char*> cases[] = {
      {"-7", "-7"},       {"+7", "7"},        {"007", "7"},        {"1/3", "1/3"},
      {"-10/4", "-5/2"},  {"0.1", "1/10"},    {".5", "1/2"},       {"2.", "2"},
      {"-0.250", "-1/4"}, {"1e3", "1000"},    {"1E-3", "1/1000"},  {"1.5e+2", "150"},
      {"25e-2", "1/4"},   {"0x1.8p+3", "12"}, {"-0X.8P0", "-1/2"}, {"0x10", "16"},
      {"0x1p-3", "1/8"},  {"0e5", "0"},       {"-0", "0"},         {"0x1.p1", "2"},
      {"0/5", "0"},       {"1.e1", "10"},
  };
  for (const auto& [text, expected] : cases) {
    const auto parsed = Rational::parse(text);
    ASSERT_TRUE(parsed) << text;
    EXPECT_EQ(parsed->to_string(), expected) << text;
  }
  EXPECT_EQ(rational("1e-300") * rational("1e300"), Rational(1));
}

TEST(Rational, RefusesEverythingElse) {
  for (const char* garbage :
       {"",       "+",     "-",        ".",         "-.",         "1/0",
        "0/0",    "1/00",  "/2",       "1/",        "1//2",       "1/-2",
        "1/+2",   "1/2/3", "1.5/2",    "1e2/3",     "1/2e3",      "e5",
        ".e5",    "1e",    "1e+",      "1e-",       "1e1.5",      "1ee5",
        "--1",    "+-1",   "nan",      "NaN",       "inf",        "-infinity",
        "0x",     "0x.",   "0xp1",     "0x1p",      "0xg",        "x1",
        "1x",     " 1",    "1 ",       "1 /2",      "1\n",        "\t1",
        "1,5",    "1.2.3", "1e100001", "1e-100001", "0x1p100001", "1e99999999999999999999",
        "0x1e+5", "1p3",   "0x1/2",    "1'000"}) {
    EXPECT_FALSE(Rational::parse(garbage)) << '"' << garbage << '"';
  }
  EXPECT_FALSE(Rational::parse(std::string_view("1\0002", 3)));
  EXPECT_TRUE(Rational::parse("1e100000"));
  EXPECT_TRUE(Rational::parse("1e-100000"));
}

TEST(Rational, PrintsWhatItParses) {
  for (const char* text : {"0", "-7", "1/3", "-22/7", "123456789012345678901234567891/7"}) {
    EXPECT_EQ(rational(text).to_string(), text);
  }
}

TEST(Rational, TakesDoublesExactly) {
  EXPECT_EQ(Rational::from_double(0.1).value().to_string(), "3602879701896397/36028797018963968");
  EXPECT_EQ(Rational::from_double(0x1p-1074).value() * Rational(Integer::power_of_two(1074)),
            Rational(1));
  EXPECT_EQ(Rational::from_double(-0.0).value(), Rational(0));
  EXPECT_FALSE(Rational::from_double(std::nan("")));
  EXPECT_FALSE(Rational::from_double(kInfinity));
}

//   (1) lower <= value <= upper   (2) lower and upper are equal or neighbours
//   (3) they are equal exactly for doubles
void expect_enclosed(const Rational& value) {
  const double lower = value.lower_double();
  const double upper = value.upper_double();
  if (std::isfinite(lower)) {
    EXPECT_LE(Rational::from_double(lower).value(), value);
  }
  if (std::isfinite(upper)) {
    EXPECT_GE(Rational::from_double(upper).value(), value);
  }
  const bool exact = std::isfinite(lower) && Rational::from_double(lower).value() == value;
  EXPECT_EQ(std::nextafter(lower, kInfinity), exact ? std::nextafter(upper, kInfinity) : upper);
  const double nearest = value.to_double();
  EXPECT_TRUE(nearest == lower || nearest == upper) << value.to_string();
}

TEST(Rational, DirectedDoublesEncloseTheValue) {
  for (const char* text : {"1/3", "0.1", "12", "1e22", "1e23", "9007199254740993", "1/1024"}) {
    expect_enclosed(rational(text));
    expect_enclosed(-rational(text));
  }
}

TEST(Rational, DirectedDoublesAreRightAtTheEndsOfTheRange) {
  const double largest = std::numeric_limits<double>::max();
  const double smallest = std::numeric_limits<double>::denorm_min();
  const Rational huge = rational("1e400");
  EXPECT_EQ(huge.lower_double(), largest);
  EXPECT_EQ(huge.upper_double(), kInfinity);
  EXPECT_EQ((-huge).lower_double(), -kInfinity);
  EXPECT_EQ((-huge).upper_double(), -largest);
  const Rational tiny = rational("1e-400");
  EXPECT_EQ(tiny.lower_double(), 0.0);
  EXPECT_EQ(tiny.upper_double(), smallest);
  EXPECT_EQ((-tiny).lower_double(), -smallest);
  EXPECT_EQ((-tiny).upper_double(), 0.0);
  const Rational just_above = Rational::from_double(largest).value() + Rational(1);
  EXPECT_EQ(just_above.lower_double(), largest);
  EXPECT_EQ(just_above.upper_double(), kInfinity);
  // Between subnormals, where rounding to 53 bits first must not matter.
  for (const char* text : {"1e-310", "3e-324", "7.4e-324", "2.2250738585072011e-308"}) {
    expect_enclosed(rational(text));
    expect_enclosed(-rational(text));
  }
}

TEST(Rational, DecimalsAreCutOff) {
  EXPECT_EQ(decimal(rational("2/3"), 4), "0.6666");
  EXPECT_EQ(decimal(rational("-2/3"), 4), "-0.6666");
  EXPECT_EQ(decimal(rational("-1/2"), 4), "-0.5000");
  EXPECT_EQ(decimal(rational("12345.678"), 0), "12345");
  EXPECT_EQ(decimal(rational("1/1000"), 2), "0.00");
  EXPECT_EQ(decimal(rational("-1/1000"), 2), "-0.00");  // the sign is right
  EXPECT_EQ(decimal(Rational(0), 3), "0.000");
  EXPECT_EQ(decimal(rational("999/1000"), 2), "0.99");
  EXPECT_THROW(decimal(Rational(1), -1), std::logic_error);
}

TEST(Rational, KnowsDyadicNumbers) {
  EXPECT_TRUE(rational("3/8").is_dyadic());
  EXPECT_TRUE(Rational(0).is_dyadic());
  EXPECT_TRUE(Rational(-5).is_dyadic());
  EXPECT_FALSE(rational("1/3").is_dyadic());
  EXPECT_FALSE(rational("1/6").is_dyadic());
}

}  // namespace rational_test
}  // namespace kinex
