// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/formats/log_ending.h"

#include <string_view>

#include "core/numbers/time_text.h"

namespace kinex::formats {

namespace {

constexpr std::string_view kAbout = "about ";  // of time_text()

}  // namespace

LogEnding ending_of(const LogReader& reader) {
  if (!reader.end()) return {};
  return {reader.end()->status, reader.end()->reached};
}

std::string ending_text(const LogEnding& ending) {
  if (ending.whole()) return "";
  if (ending.status == "cut off") return "was cut off";
  if (!ending.reached) return "ends early: " + ending.status;
  std::string time = time_text(*ending.reached);
  const bool about = time.starts_with(kAbout);
  if (about) time.erase(0, kAbout.size());
  return std::string(about ? "ends at about t = " : "ends at t = ") + time + ": " + ending.status;
}

std::string ending_note(const LogEnding& ending, const std::string& file) {
  if (ending.whole()) return "";
  if (ending.status == "cut off") {
    return file +
           ": the log has no last line: its run was cut off, and what is shown is all that was "
           "written; for a whole log run the scene again (kinex run SCENE --events FILE)";
  }
  return file + ": the log " + ending_text(ending) + "; run the scene " +
         (ending.status == "limit" ? "with a larger limit" : "again") + " for the rest";
}

}  // namespace kinex::formats
