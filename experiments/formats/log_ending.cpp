// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/formats/log_ending.h"

#include <string_view>

#include "core/numbers/time_text.h"
#include "experiments/formats/plain_text.h"

namespace kinex::formats {

namespace {

constexpr std::string_view kAbout = "about ";  // of time_text()

}  // namespace

LogEnding ending_of(const LogReader& reader) {
  LogEnding ending;
  ending.cut_line = reader.cut_line();
  if (reader.end()) {
    ending.status = reader.end()->status;
    ending.reached = reader.end()->reached;
    ending.corrupt = reader.end()->corrupt;
  }
  return ending;
}

std::string ending_text(const LogEnding& ending) {
  if (ending.whole()) return "";
  if (ending.status == "cut off") {
    return "was cut off" +
           (ending.cut_line == 0 ? "" : " within line " + std::to_string(ending.cut_line));
  }
  if (!ending.reached) return "ends early: " + ending.status;
  std::string time = time_text(*ending.reached);
  const bool about = time.starts_with(kAbout);
  if (about) time.erase(0, kAbout.size());
  return std::string(about ? "ends at about t = " : "ends at t = ") + time + ": " + ending.status;
}

std::string ending_note(const LogEnding& ending, const std::string& file) {
  if (ending.whole()) return "";
  if (ending.status == "cut off") {
    const std::string what =
        ending.cut_line == 0
            ? ": the log has no last line: its run was cut off, and what is shown is all that was "
              "written"
            : ": line " + std::to_string(ending.cut_line) +
                  ": the log was cut off within this line; what is shown is all whole lines before "
                  "it";
    return file + what + "; for a whole log run the scene again (kinex run SCENE --events FILE)";
  }
  return file + ": the log " + ending_text(ending) + "; run the scene " +
         (ending.status == "limit" ? "with a larger limit" : "again") + " for the rest";
}

std::vector<std::string> corruption_texts(const std::vector<LogCorruption>& corrupt) {
  std::vector<std::string> texts;
  for (const LogCorruption& one : corrupt) {
    texts.push_back(plain(one.label + " is corrupt: " + one.text) +
                    "; it has no records from then on");
  }
  return texts;
}

}  // namespace kinex::formats
