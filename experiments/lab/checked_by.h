// SPDX-License-Identifier: GPL-3.0-or-later
// CheckedBy: the verdict of a second program, which shares nothing with this one, on the log of a
// small run.
#ifndef KINEX_EXPERIMENTS_LAB_CHECKED_BY_H
#define KINEX_EXPERIMENTS_LAB_CHECKED_BY_H

#include <optional>
#include <string>
#include <vector>

#include "experiments/lab/field_archive.h"
#include "experiments/lab/run_record.h"

namespace kinex::formats {
class JsonWriter;
}

namespace kinex::lab {

struct CheckedBy {
  enum class Finding {
    kFine,
    kRefused,
    kNotChecked,
  };
  std::string program;      // "kinex-logcheck"
  RunKey run;               // the run that made the log; without a structure: no run
  std::vector<int> levels;  // the levels checked, see experiments/logcheck
  std::string left_out;     // levels not checked, or parts not followed, and why
  Finding finding = Finding::kNotChecked;
  std::string message;  // the reason for kRefused or kNotChecked

  // "nothing wrong", "refused: line 3: ..", "not checked: python3 was not found"
  std::string verdict() const;
  // One sentence: the program, the levels, the run and the verdict.
  std::string text() const;
};

// The object "checked_by" of claims.json.
void write_checked_by(formats::JsonWriter& json, const CheckedBy& checked);

// The check as text, and back: nullopt if the texts are not of a check. Of its run, nothing.
Fields check_fields(const CheckedBy& checked);
std::optional<CheckedBy> check_of(const Fields& fields);

}  // namespace kinex::lab

#endif
