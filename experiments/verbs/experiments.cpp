// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/verbs/experiments.h"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <system_error>

#include "core/numbers/near_names.h"
#include "experiments/formats/input_error.h"
#include "experiments/reproduce/planned.h"
#include "experiments/trade/planned.h"
#include "experiments/verbs/option_values.h"
#include "experiments/verify/planned.h"

namespace kinex::verbs {

const sweep::Experiments& experiments() {
  static const sweep::Experiments kExperiments = [] {
    sweep::Experiments all;
    verify::add_experiment(all);
    trade::add_experiment(all);
    reproduce::add_experiment(all);
    return all;
  }();
  return kExperiments;
}

void PlanWords::add_options(CLI::App& verb) {
  verb.add_option("PLAN", words,
                  "A plan's file, - is standard input; or an experiment, and names of it: verify " +
                      example_structure(2));
  verb.add_flag("--quick", quick, "Of an experiment: smaller sizes");
  verb.add_option("--seeds", seeds, "Of verify: so many scenes")->expected(1);
  add_list_option(verb, "--arithmetic", arithmetics, "Of trade: these, beside exact and double")
      ->allow_extra_args(false);
}

std::string PlanWords::command() const {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
  if (quick) text += " --quick";
  for (const std::string& value : seeds) text += " --seeds " + value;
  for (const std::string& value : arithmetics) text += " --arithmetic " + value;
  return text;
}

sweep::Plan PlanWords::plan() const {
  if (words.empty()) {
    throw formats::InputError("PLAN", "", "there is none", "write a file, or an experiment");
  }
  if (experiments().find(words.front()) != nullptr) {
    sweep::Selection selection;
    selection.experiment = words.front();
    selection.names.assign(words.begin() + 1, words.end());
    selection.quick = quick;
    if (!seeds.empty()) selection.options["seeds"] = seeds;
    if (!arithmetics.empty()) selection.options["arithmetic"] = arithmetics;
    return sweep::plan_of(selection, experiments());
  }
  std::vector<std::string> known;
  for (const sweep::Experiment& one : experiments().all) known.push_back(one.name);
  if (words.size() > 1 || quick || !seeds.empty() || !arithmetics.empty()) {
    throw formats::InputError(
        "PLAN", "", show_text(words.front()) + " is not an experiment",
        did_you_mean(words.front(), known,
                              "write a plan's file alone; kinex sweep list names the experiments"));
  }
  std::error_code error;
  if (words.front() != "-" && !std::filesystem::exists(words.front(), error)) {
    throw formats::InputError(
        "PLAN", "", show_text(words.front()) + " is neither a file nor an experiment",
        did_you_mean(words.front(), known,
                              "write a plan's file; kinex sweep list names the experiments"));
  }
  return sweep::read_plan(words.front(), experiments());
}

}  // namespace kinex::verbs
