// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/sweep/experiment.h"

#include <new>

#include "experiments/formats/input_error.h"
#include "experiments/lab/child_process.h"
#include "experiments/sweep/plan.h"

namespace kinex::sweep {

namespace {

CellReport run_kind(const CellKind& kind, const formats::JsonNode& content) {
  CellReport report;
  try {
    report = kind.run(content);
  } catch (const formats::InputError& error) {
    report.outcome = Outcome::kRefused;
    report.message = error.what();
  } catch (const std::bad_alloc&) {
    report.outcome = Outcome::kMemory;
    report.message = "there is not enough memory";
  }
  report.peak_kb = lab::own_peak_kb();
  return report;
}

}  // namespace

std::string Selection::command() const {
  std::string text = experiment;
  for (const std::string& name : names) text += " " + name;
  if (quick) text += " --quick";
  for (const auto& [option, values] : options) {
    for (const std::string& value : values) text += " --" + option + " " + value;
  }
  return text;
}

const Experiment* Experiments::find(std::string_view name) const {
  for (const Experiment& experiment : all) {
    if (experiment.name == name) return &experiment;
  }
  return nullptr;
}

CellReport run_any(const std::string& text, const Experiments& experiments) {
  const std::string file = "the cell";
  const formats::JsonDocument document = formats::parse_json(text, file);
  const formats::JsonValue& tree = *document;
  const formats::JsonSource source{file, text};
  const formats::JsonNode root(tree, source);
  for (const CellKind& kind : experiments.kinds) {
    if (const auto content = root.find(kind.member)) {
      root.require_object({kind.member});
      return run_kind(kind, *content);
    }
  }
  return run_cell(parse_cell(text, file));
}

}  // namespace kinex::sweep
