// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/lab/checked_by.h"

#include "experiments/formats/json_writer.h"

namespace kinex::lab {

namespace {

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
  switch (finding) {
    case Finding::kFine:
      return "nothing wrong";
    case Finding::kRefused:
      return "refused: " + message;
    case Finding::kNotChecked:
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
    json.key("workload").string(checked.run.workload).key("n").number(checked.run.parameters.n);
    json.key("seed").number(checked.run.parameters.seed).key("run").string(checked.run.text());
  }
  if (!checked.left_out.empty()) json.key("left_out").string(checked.left_out);
  json.key("verdict").string(checked.verdict()).end_object();
}

template <class Archive>
void fields(Archive& archive, CheckedBy& value) {
  archive(value.program, value.levels, value.left_out, value.finding, value.message);
}

Fields check_fields(const CheckedBy& checked) { return to_fields(checked); }

std::optional<CheckedBy> check_of(const Fields& fields) { return from_fields<CheckedBy>(fields); }

}  // namespace kinex::lab
