// SPDX-License-Identifier: GPL-3.0-or-later
// CheckedBy: the verdict of a second program, which shares nothing with this one, on the log of a
// small run.
#ifndef KINEX_EXPERIMENTS_LAB_CHECKED_BY_H
#define KINEX_EXPERIMENTS_LAB_CHECKED_BY_H

#include <string>
#include <string_view>
#include <vector>

#include "experiments/lab/run_record.h"

namespace kinex::formats {
class JsonWriter;
}

namespace kinex::lab {

struct CheckedBy {
  enum class Outcome {
    kFine,
    kRefused,
    kNotChecked,
  };
  std::string program;      // "kinex-logcheck"
  RunKey run;               // the run that made the log; without a structure: no run
  std::vector<int> levels;  // the levels checked, see experiments/logcheck
  std::string left_out;     // levels not checked, or parts not followed, and why
  Outcome outcome = Outcome::kNotChecked;
  std::string message;  // the reason for kRefused or kNotChecked

  // "nothing wrong", "refused: line 3: ..", "not checked: python3 was not found"
  std::string verdict() const;
  // One sentence: the program, the levels, the run and the verdict.
  std::string text() const;
};

// The object "checked_by" of claims.json.
void write_checked_by(formats::JsonWriter& json, const CheckedBy& checked);

// The check as a line of a RecordStore, and back; of the run only its key is restored.
std::string checked_by_line(const CheckedBy& checked);
bool is_checked_by_line(std::string_view line);
// Its key in a store: the run and the program.
std::string checked_by_key(const RunKey& run, const std::string& program);
struct StoredCheck {
  std::string key;
  CheckedBy checked;  // without its run
};
// Throws InputError that names the file and the line.
StoredCheck parse_checked_by(std::string_view line, const std::string& file, std::size_t number);

}  // namespace kinex::lab

#endif
