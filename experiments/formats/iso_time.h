// SPDX-License-Identifier: GPL-3.0-or-later
// Dates and times of ISO 8601 (RFC 3339) as exact numbers of seconds.
#ifndef KINEX_EXPERIMENTS_FORMATS_ISO_TIME_H
#define KINEX_EXPERIMENTS_FORMATS_ISO_TIME_H

#include <optional>
#include <string>
#include <string_view>

#include "core/numbers/rational.h"

namespace kinex::formats {

struct IsoTime {
  Rational seconds;         // since 1970-01-01T00:00:00Z; no leap seconds
  bool has_offset = false;  // from UTC; without one it is taken as UTC
};

// True for text that begins as a date does, four digits and two, and is no number.
bool looks_like_date(std::string_view text);

//   2024-05-01T12:30:05.25Z   2024-05-01 12:30:05,25+02:00   2024-05-01T12:30   2024-05-01
//   20240501T123005Z
// Years 0001 to 9999 (Gregorian); fractions of seconds of up to 1000 digits, exact. nullopt, and
// the reason in `problem` ("there is no month 13"), for anything else; leap seconds are refused.
std::optional<IsoTime> parse_iso_time(std::string_view text, std::string& problem);

// True for years 0001 to 9999, and seconds with a finite decimal of at most 1000 digits after the point.
bool has_iso_text(const Rational& seconds);
// The time as "2024-05-01T12:30:05.25Z". Requires that it has one.
std::string iso_text(const Rational& seconds);

// The number as a decimal, exactly: "-0.25". nullopt if it has none, or one of more than `digits` digits
// after the point.
std::optional<std::string> finite_decimal(const Rational& value, int digits = 1000);

}  // namespace kinex::formats

#endif
