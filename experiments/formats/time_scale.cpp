// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/formats/time_scale.h"

#include <utility>

#include "core/numbers/show_text.h"
#include "experiments/formats/csv_fields.h"
#include "experiments/formats/input_error.h"
#include "experiments/formats/number_defect.h"

namespace kinex::formats {

namespace {

constexpr const char* kDateRemedy = "write dates as 2024-05-01T12:30:05Z, or numbers";

Rational date_of(const OptionTime& option) {
  std::string problem;
  const std::optional<IsoTime> time = parse_iso_time(option.text, problem);
  if (time) return time->seconds;
  throw InputError(option.option, "", show_text(option.text) + " is not a date: " + problem,
                   kDateRemedy);
}

}  // namespace

Rational TimeScale::read(std::string_view text, const std::string& file, const std::string& place,
                         const std::string& field) {
  const bool date = looks_like_date(text);
  if (form_ == Form::kNone) {
    form_ = date ? Form::kDates : Form::kNumbers;
    first_ = text;
  } else if (date != (form_ == Form::kDates)) {
    throw InputError(file, place,
                     field + (date ? " is a date, " : " is no date, ") + show_text(first_) +
                         (date ? " is none" : " is one"),
                     "write all times as dates, or all as numbers");
  }
  if (!date) {
    const std::optional<Rational> number = csv_number(std::string(text));
    if (!number) {
      const NumberDefect defect =
          number_defect(text, csv_number_remedy(text) + ", or dates as 2024-05-01T12:30:05Z");
      throw InputError(file, place, field + " " + defect.problem, defect.remedy);
    }
    return *number;
  }
  std::string problem;
  std::optional<IsoTime> time = parse_iso_time(text, problem);
  if (!time) throw InputError(file, place, field + " is not a date: " + problem, kDateRemedy);
  if (earliest_ && time->has_offset != offsets_) {
    throw InputError(file, place,
                     field +
                         (offsets_ ? " has no offset from UTC, " : " has an offset from UTC, ") +
                         show_text(first_) + (offsets_ ? " has one" : " has none"),
                     "write all with one (Z is that of UTC), or all without");
  }
  offsets_ = time->has_offset;
  return read_seconds(std::move(time->seconds));
}

Rational TimeScale::read_seconds(Rational seconds) {
  form_ = Form::kDates;
  if (!earliest_ || seconds < *earliest_) earliest_ = seconds;
  return seconds;
}

Rational TimeScale::settle(const std::optional<OptionTime>& zero) {
  if (zero && form_ != Form::kDates) {
    throw InputError(zero->option, "", "the file's times are numbers", "leave it out");
  }
  if (form_ == Form::kDates) zero_ = zero ? date_of(*zero) : *earliest_;
  return zero_;
}

Rational TimeScale::read(const OptionTime& option) const {
  if (looks_like_date(option.text)) {
    if (form_ != Form::kDates) {
      throw InputError(option.option, "",
                       show_text(option.text) + " is a date, the file's times are numbers",
                       "write a number");
    }
    return date_of(option) - zero_;
  }
  std::optional<Rational> value = Rational::parse(option.text);
  if (!value) {
    const NumberDefect defect = number_defect(option.text, kCsvNumberRemedy);
    throw InputError(option.option, "", show_text(option.text) + " " + defect.problem, defect.remedy);
  }
  return *std::move(value);
}

std::string TimeScale::zero_text() const { return form_ == Form::kDates ? iso_text(zero_) : ""; }

}  // namespace kinex::formats
