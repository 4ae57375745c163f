// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/formats/iso_time.h"

#include <gtest/gtest.h>

namespace kinex::formats {
namespace iso_time_test {

std::string seconds(const std::string& text) {
  std::string problem;
  const std::optional<IsoTime> time = parse_iso_time(text, problem);
  return time ? time->seconds.to_string() + (time->has_offset ? " Z" : "") : problem;
}

TEST(IsoTime, SecondsSince1970) {
  EXPECT_EQ(seconds("1970-01-01T00:00:00Z"), "0 Z");
  EXPECT_EQ(seconds("1970-01-01"), "0");
  EXPECT_EQ(seconds("1969-12-31T23:59:59Z"), "-1 Z");
  EXPECT_EQ(seconds("2000-03-01T00:00:00Z"), "951868800 Z");
  EXPECT_EQ(seconds("2024-02-29 12:30:05Z"), "1709209805 Z");
  EXPECT_EQ(seconds("20240229T123005Z"), "1709209805 Z");
  EXPECT_EQ(seconds("2024-02-29T12:30"), "1709209800");
  EXPECT_EQ(seconds("2024-02-29T14:30:05+02:00"), "1709209805 Z");
  EXPECT_EQ(seconds("2024-02-29T10:00:05-0230"), "1709209805 Z");
  EXPECT_EQ(seconds("1970-01-01T00:00:00.1Z"), "1/10 Z");
  EXPECT_EQ(seconds("1970-01-01T00:00:00,000000000001Z"), "1/1000000000000 Z");
  EXPECT_EQ(seconds("0001-01-01T00:00:00Z"), "-62135596800 Z");
  EXPECT_EQ(seconds("9999-12-31T23:59:59Z"), "253402300799 Z");
}

TEST(IsoTime, WhatIsNoTime) {
  EXPECT_EQ(seconds("2023-02-29"), "there is no day 29 in that month");
  EXPECT_EQ(seconds("1900-02-29"), "there is no day 29 in that month");
  EXPECT_EQ(seconds("2024-00-01"), "there is no month 0");
  EXPECT_EQ(seconds("0000-01-01"), "there is no year 0");
  EXPECT_EQ(seconds("2024-01-01T24:00:00Z"), "there is no such hour");
  EXPECT_EQ(seconds("2024-01-01T23:60:00Z"), "there is no such minute");
  EXPECT_EQ(seconds("2024-01-01T23:59:60Z"), "leap seconds are not counted");
  EXPECT_EQ(seconds("2024-01-01T23:59:59.Z"), "after its point there are no digits");
  for (const char* text : {"", "2024", "24-01-01", "2024-1-1", "2024-01-01T", "2024-01-01T12",
                           "2024-01-01T12:3Z", "2024-01-01T12:30Zulu", "2024-01-01T12:30+2",
                           "2024-01-01X12:30", "2024-01-01T12:30+25:00"}) {
    std::string problem;
    EXPECT_FALSE(parse_iso_time(text, problem)) << text;
    EXPECT_FALSE(problem.empty()) << text;
  }
}

TEST(IsoTime, DatesAndNumbersAreToldApart) {
  for (const char* date : {"2024-01-01", "2024-13-77", "20240101T00:00Z", "2024-01-01T00:00"})
    EXPECT_TRUE(looks_like_date(date));
  for (const char* other :
       {"", "7", "2024", "20240101", "-2024-01", "1e-7", "12345678.5", "noon", "2024/01/01"}) {
    EXPECT_FALSE(looks_like_date(other)) << other;
  }
}

// Back and forth over all months, leap years and fractions.
TEST(IsoTime, TextOfTheTime) {
  for (std::int64_t t = -62135596800; t < 253402300800; t += 86400 * 29 * 7 + 12345) {
    const std::string text = iso_text(Rational(t));
    EXPECT_EQ(seconds(text), std::to_string(t) + " Z") << text;
  }
  EXPECT_EQ(iso_text(Rational(0)), "1970-01-01T00:00:00Z");
  EXPECT_EQ(iso_text(*Rational::parse("-0.25")), "1969-12-31T23:59:59.75Z");
  EXPECT_EQ(iso_text(*Rational::parse("951782399.5")), "2000-02-28T23:59:59.5Z");
  EXPECT_EQ(iso_text(Rational(std::int64_t{951782400})), "2000-02-29T00:00:00Z");
}

TEST(IsoTime, FiniteDecimals) {
  EXPECT_EQ(finite_decimal(*Rational::parse("-1/8")), "-0.125");
  EXPECT_EQ(finite_decimal(Rational(7)), "7");
  EXPECT_EQ(finite_decimal(*Rational::parse("1/3")), std::nullopt);
  EXPECT_EQ(finite_decimal(*Rational::parse("1/1024"), 9), std::nullopt);
  EXPECT_EQ(finite_decimal(*Rational::parse("1/1024"), 10), "0.0009765625");
}

}  // namespace iso_time_test
}  // namespace kinex::formats
