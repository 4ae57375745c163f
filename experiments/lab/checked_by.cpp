// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/lab/checked_by.h"

#include <cstdlib>

#include "experiments/formats/input_error.h"
#include "experiments/formats/json_document.h"
#include "experiments/formats/json_writer.h"

namespace kinex::lab {

namespace {

constexpr std::string_view kStoredName = "check";

// "0-4", "0, 1, 5"
std::string levels_text(const std::vector<int>& levels) {
  if (levels.size() > 2 && levels.back() - levels.front() + 1 == static_cast<int>(levels.size())) {
    return std::to_string(levels.front()) + "-" + std::to_string(levels.back());
  }
  std::string text;
  for (const int level : levels) text += (text.empty() ? "" : ", ") + std::to_string(level);
  return text;
}

void write_levels(formats::JsonWriter& json, const CheckedBy& checked) {
  json.key("levels").begin_array();
  for (const int level : checked.levels) json.number(level);
  json.end_array();
}

}  // namespace

std::string CheckedBy::verdict() const {
  switch (outcome) {
    case Outcome::kFine:
      return "nothing wrong";
    case Outcome::kRefused:
      return "refused: " + message;
    case Outcome::kNotChecked:
      break;
  }
  return "not checked: " + message;
}

std::string CheckedBy::text() const {
  if (run.structure.empty()) return verdict();
  std::string what = program;
  if (!levels.empty()) {
    what += (levels.size() == 1 ? ", level " : ", levels ") + levels_text(levels);
  }
  return what + ", of " + run.text() + ": " + verdict() +
         (left_out.empty() ? "" : " (left out: " + left_out + ")");
}

void write_checked_by(formats::JsonWriter& json, const CheckedBy& checked) {
  json.begin_object().key("program").string(checked.program);
  write_levels(json, checked);
  if (!checked.run.structure.empty()) {
    json.key("structure").string(checked.run.structure);
    json.key("workload").string(checked.run.workload).key("n").number(checked.run.n);
    json.key("seed").number(checked.run.seed).key("run").string(checked.run.text());
  }
  if (!checked.left_out.empty()) json.key("left_out").string(checked.left_out);
  json.key("verdict").string(checked.verdict()).end_object();
}

std::string checked_by_key(const RunKey& run, const std::string& program) {
  return run.text() + " by " + program;
}

std::string checked_by_line(const CheckedBy& checked) {
  std::string text;
  formats::JsonWriter json(text);
  json.begin_object().key(kStoredName).string(checked_by_key(checked.run, checked.program));
  json.key("program").string(checked.program);
  write_levels(json, checked);
  json.key("left_out").string(checked.left_out);
  json.key("fine").boolean(checked.outcome == CheckedBy::Outcome::kFine);
  json.key("message").string(checked.message).end_object();
  return text;
}

bool is_checked_by_line(std::string_view line) {
  return line.rfind("{\"" + std::string(kStoredName) + "\"", 0) == 0;
}

StoredCheck parse_checked_by(std::string_view line, const std::string& file, std::size_t number) {
  const formats::JsonDocument document = formats::parse_json(line, file, number);
  const formats::JsonValue& value = *document;
  const auto member = [&](std::string_view name) -> const formats::JsonValue& {
    const formats::JsonValue* found = value.find(name);
    if (found == nullptr) {
      throw formats::InputError(file, "line " + std::to_string(number),
                       "there is no \"" + std::string(name) + "\"",
                       "remove the file to begin anew");
    }
    return *found;
  };
  StoredCheck stored;
  stored.key = member(kStoredName).text();
  stored.checked.program = member("program").text();
  for (const formats::JsonValue& level : member("levels").items()) {
    stored.checked.levels.push_back(std::atoi(std::string(level.text()).c_str()));
  }
  stored.checked.left_out = member("left_out").text();
  stored.checked.outcome =
      member("fine").boolean() ? CheckedBy::Outcome::kFine : CheckedBy::Outcome::kRefused;
  stored.checked.message = member("message").text();
  return stored;
}

}  // namespace kinex::lab
