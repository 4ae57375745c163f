// SPDX-License-Identifier: GPL-3.0-or-later
// TimeScale: the times of an imported file, which are numbers or dates.
#ifndef KINEX_EXPERIMENTS_FORMATS_TIME_SCALE_H
#define KINEX_EXPERIMENTS_FORMATS_TIME_SCALE_H

#include <optional>
#include <string>
#include <string_view>

#include "core/numbers/rational.h"
#include "experiments/formats/iso_time.h"

namespace kinex::formats {

// The value of a command-line option that is a time, as written: a number or a date.
struct OptionTime {
  std::string option, text;
};

// The times of a file are either all numbers or all dates (iso_time.h); dates all have an offset from UTC,
// or none has. Dates are counted in seconds from the time zero: that of an option, else the first date.
class TimeScale {
 public:
  // As written: a number, or the seconds of a date since 1970. Throws InputError with `file`, `place`
  // (the line, or a JSON path) and `field` ("\"noon\" in column \"t\"").
  Rational read(std::string_view text, const std::string& file, const std::string& place,
                const std::string& field);
  // The same for seconds since 1970 that a file has as a number (has_iso_text()).
  Rational read_seconds(Rational seconds);

  // When all times have been read: sets the time zero, and gives the number that is subtracted from
  // every time; 0 for numbers. `zero`: that of the option; throws InputError if it is not a date, or if
  // the file's times are not dates.
  Rational settle(const std::optional<OptionTime>& zero);
  // A time of an option in the scene's time, after settle().
  Rational read(const OptionTime& option) const;
  // The time zero of dates as a date; empty for numbers.
  std::string zero_text() const;

 private:
  enum class Form { kNone, kNumbers, kDates };
  Form form_ = Form::kNone;
  bool offsets_ = false;  // of dates
  std::string first_;     // as it is written
  std::optional<Rational> earliest_;
  Rational zero_;
};

}  // namespace kinex::formats

#endif
