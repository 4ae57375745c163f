// SPDX-License-Identifier: GPL-3.0-or-later
// kinex list: the names that other verbs take.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "experiments/formats/input_error.h"
#include "experiments/formats/json_writer.h"
#include "experiments/formats/near_names.h"
#include "experiments/lab/arithmetics.h"
#include "experiments/lab/workload.h"
#include "experiments/reproduce/papers.h"
#include "experiments/verbs/option_values.h"
#include "experiments/verbs/verbs.h"
#include "experiments/verbs/voice.h"
#include "structures/registry.h"

namespace kinex::verbs {

namespace {

struct ListOptions {
  std::string what;
  bool json = false;
};

struct Listed {
  std::string name, summary;
};

const std::vector<std::string>& subjects() {
  static const std::vector<std::string> kSubjects{"structures", "workloads", "papers",
                                                  "arithmetics"};
  return kSubjects;
}

template <class Infos>
std::vector<Listed> listed(const Infos& infos) {
  std::vector<Listed> all;
  for (const auto& info : infos) all.push_back({std::string(info.name), std::string(info.summary)});
  return all;
}

std::vector<Listed> listed_papers() {
  std::vector<Listed> all;
  for (const lab::Paper& paper : reproduce::papers()) {
    all.push_back({std::string(paper.name), std::string(paper.title)});
  }
  return all;
}

std::vector<Listed> names_of(const std::string& what) {
  if (what == "structures") return listed(structure_infos());
  if (what == "workloads") return listed(lab::workloads());
  if (what == "papers") return listed_papers();
  if (what == "arithmetics") return listed(lab::arithmetic_infos());
  throw formats::InputError(
      "list", "", show_text(what) + " is nothing that is listed",
      formats::did_you_mean(what, subjects(),
                            "write structures, workloads, papers or arithmetics"));
}

std::string json_text(const std::vector<Listed>& all) {
  std::string text;
  formats::JsonWriter json(text);
  json.begin_array();
  for (const Listed& one : all) {
    json.begin_object()
        .key("name")
        .string(one.name)
        .key("summary")
        .string(one.summary)
        .end_object();
  }
  json.end_array();
  return text + "\n";
}

std::string plain_text(const std::vector<Listed>& all, const Voice& voice) {
  std::size_t width = 0;
  for (const Listed& one : all) width = std::max(width, one.name.size());
  std::string text;
  for (const Listed& one : all) {
    text += voice.heading(one.name) + std::string(width - one.name.size() + 2, ' ') + one.summary +
            "\n";
  }
  return text;
}

}  // namespace

void add_list_verb(CLI::App& app, int&) {
  auto options = std::make_shared<ListOptions>();
  CLI::App* verb = app.add_subcommand("list", "Lists structures, workloads, papers or arithmetics");
  verb->add_option("WHAT", options->what, "structures, workloads, papers or arithmetics")
      ->required();
  verb->add_flag("--json", options->json, "Print a JSON array of names and summaries");
  verb->footer("kinex explain NAME says more of each.\nExample:\n  kinex list structures");
  verb->callback([options, verb] {
    const std::vector<Listed> all = names_of(options->what);
    print(options->json ? json_text(all) : plain_text(all, voice_of(*verb)));
  });
}

}  // namespace kinex::verbs
