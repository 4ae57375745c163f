// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/formats/iso_time.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

namespace kinex::formats {

namespace {

constexpr std::int64_t kDay = 86400;
constexpr std::size_t kMostFractionDigits = 1000;

bool is_digit(char c) { return c >= '0' && c <= '9'; }

bool is_leap(int year) { return (year % 4 == 0 && year % 100 != 0) || year % 400 == 0; }

int days_of(int year, int month) {
  constexpr std::array<int, 12> kDays{31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
  return month == 2 && is_leap(year) ? 29 : kDays[static_cast<std::size_t>(month - 1)];
}

// From 1970-01-01; years from 1 on.
std::int64_t days_before(int year) {
  const std::int64_t past = year - 1;
  return 365 * past + past / 4 - past / 100 + past / 400 - 719162;
}

std::int64_t days_since_epoch(int year, int month, int day) {
  std::int64_t days = days_before(year) + day - 1;
  for (int m = 1; m < month; ++m) days += days_of(year, m);
  return days;
}

class Parser {
 public:
  Parser(std::string_view text, std::string& problem) : text_(text), problem_(problem) {}

  std::optional<IsoTime> parse() {
    int year = 0, month = 0, day = 0;
    if (!number(4, year)) return fail("it does not begin with a year of four digits");
    extended_ = take('-');
    if (!number(2, month) || (extended_ && !take('-')) || !number(2, day)) {
      return fail("its date is not of the form 2024-05-01");
    }
    if (year < 1) return fail("there is no year 0");
    if (month < 1 || month > 12) return fail("there is no month " + std::to_string(month));
    if (day < 1 || day > days_of(year, month)) {
      return fail("there is no day " + std::to_string(day) + " in that month");
    }
    IsoTime time;
    time.seconds = Rational(days_since_epoch(year, month, day) * kDay);
    if (done()) return time;
    if (!take('T') && !take('t') && !take(' ')) return fail("between date and time there is no T");
    if (!read_clock(time)) return std::nullopt;
    return time;
  }

 private:
  bool done() const { return at_ == text_.size(); }
  bool take(char c) {
    if (done() || text_[at_] != c) return false;
    ++at_;
    return true;
  }
  bool number(std::size_t digits, int& value) {
    if (at_ + digits > text_.size()) return false;
    value = 0;
    for (std::size_t i = 0; i < digits; ++i) {
      if (!is_digit(text_[at_ + i])) return false;
      value = 10 * value + (text_[at_ + i] - '0');
    }
    at_ += digits;
    return true;
  }
  std::nullopt_t fail(std::string problem) {
    problem_ = std::move(problem);
    return std::nullopt;
  }

  bool read_clock(IsoTime& time) {
    const auto wrong = [&](const char* what) {
      problem_ = what;
      return false;
    };
    int hour = 0, minute = 0, second = 0;
    if (!number(2, hour)) return wrong("its time is not of the form 12:30:05");
    const bool minutes = extended_ ? take(':') : !done() && is_digit(text_[at_]);
    if (!minutes || !number(2, minute)) return wrong("its time is not of the form 12:30:05");
    const bool seconds = extended_ ? take(':') : !done() && is_digit(text_[at_]);
    if (seconds && !number(2, second)) return wrong("its time is not of the form 12:30:05");
    if (hour > 23) return wrong("there is no such hour");
    if (minute > 59) return wrong("there is no such minute");
    if (second == 60) return wrong("leap seconds are not counted");
    if (second > 60) return wrong("there is no such second");
    time.seconds += Rational(hour * 3600 + minute * 60 + second);
    if (seconds && (take('.') || take(','))) {
      const std::size_t begin = at_;
      while (!done() && is_digit(text_[at_])) ++at_;
      if (at_ == begin) return wrong("after its point there are no digits");
      if (at_ - begin > kMostFractionDigits) return wrong("its fraction is too long");
      time.seconds += *Rational::parse("0." + std::string(text_.substr(begin, at_ - begin)));
    }
    if (done()) return true;
    time.has_offset = true;
    if (take('Z') || take('z')) return done() || wrong("after its Z there is more");
    const int sign = take('+') ? 1 : take('-') ? -1 : 0;
    int hours = 0, minutes_off = 0;
    if (sign == 0 || !number(2, hours))
      return wrong("its offset from UTC is not of the form Z or +02:00");
    take(':');
    if (!done() && !number(2, minutes_off))
      return wrong("its offset from UTC is not of the form Z or +02:00");
    if (!done() || hours > 23 || minutes_off > 59) {
      return wrong("its offset from UTC is not of the form Z or +02:00");
    }
    time.seconds -= Rational(sign * (hours * 3600 + minutes_off * 60));
    return true;
  }

  std::string_view text_;
  std::string& problem_;
  std::size_t at_ = 0;
  bool extended_ = true;
};

std::string padded(std::int64_t value, std::size_t digits) {
  std::string text = std::to_string(value);
  return std::string(digits - std::min(digits, text.size()), '0') + text;
}

}  // namespace

bool looks_like_date(std::string_view text) {
  if (text.size() < 8) return false;
  for (std::size_t i = 0; i < 4; ++i) {
    if (!is_digit(text[i])) return false;
  }
  if (text[4] == '-') return is_digit(text[5]) && is_digit(text[6]);
  return text.size() > 8 && (text[8] == 'T' || text[8] == 't') && is_digit(text[4]);
}

std::optional<IsoTime> parse_iso_time(std::string_view text, std::string& problem) {
  return Parser(text, problem).parse();
}

std::optional<std::string> finite_decimal(const Rational& value, int digits) {
  Rational scaled = value;
  int places = 0;
  for (; !scaled.is_integer(); ++places) {
    if (places == digits) return std::nullopt;
    scaled *= Rational(10);
  }
  return decimal(value, places);
}

bool has_iso_text(const Rational& seconds) {
  return Rational(days_before(1) * kDay) <= seconds &&
         seconds < Rational(days_before(10000) * kDay) && finite_decimal(seconds).has_value();
}

std::string iso_text(const Rational& seconds) {
  const Rational days = seconds / Rational(kDay);
  std::int64_t day = floor_divide(days.numerator(), days.denominator()).to_int64();
  const Rational rest = seconds - Rational(day * kDay);  // in [0, kDay)
  int year = static_cast<int>(1970 + day / 366);
  while (days_before(year + 1) <= day) ++year;
  while (days_before(year) > day) --year;
  day -= days_before(year);
  int month = 1;
  for (; day >= days_of(year, month); ++month) day -= days_of(year, month);
  const std::string clock = *finite_decimal(rest);
  const std::size_t point = clock.find('.');
  const std::int64_t whole = std::stoll(clock.substr(0, point));
  std::string text = padded(year, 4) + "-" + padded(month, 2) + "-" + padded(day + 1, 2) + "T" +
                     padded(whole / 3600, 2) + ":" + padded(whole / 60 % 60, 2) + ":" +
                     padded(whole % 60, 2);
  if (point != std::string::npos) text += clock.substr(point);
  return text + "Z";
}

}  // namespace kinex::formats
