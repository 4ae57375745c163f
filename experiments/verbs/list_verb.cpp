// SPDX-License-Identifier: GPL-3.0-or-later
// kinex list: the names that other verbs take.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/numbers/near_names.h"
#include "experiments/formats/input_error.h"
#include "experiments/formats/json_writer.h"
#include "experiments/formats/structure_list.h"
#include "experiments/formats/structure_schema.h"
#include "experiments/lab/arithmetics.h"
#include "experiments/lab/structure_words.h"
#include "experiments/lab/workload.h"
#include "experiments/reproduce/papers.h"
#include "experiments/verbs/option_values.h"
#include "experiments/verbs/verbs.h"
#include "experiments/verbs/voice.h"
#include "structures/registry.h"

namespace kinex::verbs {

namespace {

struct ListOptions {
  std::string what, family;
  bool json = false;
  bool markdown = false;
  bool schema = false;
};

struct Listed {
  std::string name, summary;
  std::string more;  // with -v
};

const std::vector<std::string>& subjects() {
  static const std::vector<std::string> kSubjects{"structures", "workloads", "papers",
                                                  "arithmetics"};
  return kSubjects;
}

// Its family and its group.
std::string more_of(const StructureInfo& info) {
  return "family " + std::string(family_of(info.name)) +
         (info.group.empty() ? "" : ", one of the structures for " + std::string(info.group));
}

// Its axes, and the options of kinex gen that it takes beside --n.
std::string more_of(const lab::Workload& workload) {
  std::string text = std::to_string(workload.min_dimension);
  if (workload.max_dimension > workload.min_dimension)
    text += " to " + std::to_string(workload.max_dimension);
  text += workload.max_dimension == 1 ? " axis" : " axes";
  if (workload.takes_m)
    text += ", --m (" + (workload.default_m == 0 ? "that of --n" : std::to_string(workload.default_m)) + ")";
  if (workload.random) text += ", --seed";
  if (workload.takes_degree) text += ", --degree";
  if (workload.separation) text += ", --separation (" + workload.separation->to_string() + ")";
  if (workload.takes_turns) text += ", --turns";
  return text;
}

std::string more_of(const lab::ArithmeticInfo& info) {
  return "promise: " + std::string(info.promise);
}

template <class Infos>
std::vector<Listed> listed(const Infos& infos) {
  std::vector<Listed> all;
  for (const auto& info : infos) {
    all.push_back({std::string(info.name), std::string(info.summary), more_of(info)});
  }
  return all;
}

std::vector<Listed> listed_papers() {
  std::vector<Listed> all;
  for (const lab::Paper& paper : reproduce::papers()) {
    std::string parts;
    for (const lab::PaperPart& part : paper.parts)
      parts += (parts.empty() ? "parts: " : ", ") + std::string(part.name);
    all.push_back({std::string(paper.name), std::string(paper.title), parts});
  }
  return all;
}

// The structures of a family; empty: all.
std::vector<Listed> listed_structures(const std::string& family) {
  std::vector<StructureInfo> infos;
  for (const StructureInfo& info : structure_infos()) {
    if (family.empty() || family_of(info.name) == family) infos.push_back(info);
  }
  return listed(infos);
}

std::vector<Listed> names_of(const std::string& what, const std::string& family) {
  if (what == "structures") return listed_structures(family);
  if (what == "workloads") return listed(lab::workloads());
  if (what == "papers") return listed_papers();
  if (what == "arithmetics") return listed(lab::arithmetic_infos());
  throw formats::InputError(
      "list", "", show_text(what) + " is nothing that is listed",
      did_you_mean(what, subjects(),
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
  if (voice.quiet) {
    std::string names;
    for (const Listed& one : all) names += one.name + "\n";
    return names;
  }
  std::size_t width = 0;
  for (const Listed& one : all) width = std::max(width, one.name.size());
  std::string text;
  for (const Listed& one : all) {
    text += voice.heading(one.name) + std::string(width - one.name.size() + 2, ' ') + one.summary +
            "\n";
    if (!voice.verbose || one.more.empty()) continue;
    text += std::string(width + 2, ' ') + one.more + "\n";
  }
  return text;
}

void check_family(const std::string& family) {
  std::vector<std::string> known;
  for (const StructureInfo& info : structure_infos()) {
    const std::string one(family_of(info.name));
    if (family == one) return;
    if (known.empty() || known.back() != one) known.push_back(one);
  }
  std::string all;
  for (const std::string& one : known) all += (all.empty() ? "write one of " : ", ") + one;
  throw formats::InputError("--family", "", show_text(family) + " is not a family of structures",
                            did_you_mean(family, known, all));
}

void list(const ListOptions& options, const Voice& voice) {
  const bool structures = options.what == "structures";
  const char* const of_structures = !options.family.empty() ? "--family"
                                    : options.markdown      ? "--markdown"
                                    : options.schema        ? "--schema"
                                                            : nullptr;
  if (!structures && of_structures != nullptr) {
    names_of(options.what, "");  // what is no list is named first
    throw formats::InputError(of_structures, "", "is for structures, not for " + options.what,
                              "write kinex list structures " + std::string(of_structures) +
                                  (options.family.empty() ? "" : " " + options.family));
  }
  if (!options.family.empty()) check_family(options.family);
  if (options.schema) {
    print(formats::structure_definitions() + "\n");
  } else if (options.markdown) {
    print(lab::structure_table(options.family));
  } else {
    const std::vector<Listed> all = names_of(options.what, options.family);
    if (options.json) {
      print(structures ? formats::structure_list(options.family) : json_text(all));
    } else {
      print(plain_text(all, voice));
    }
  }
}

}  // namespace

void add_list_verb(CLI::App& app, int&) {
  auto options = std::make_shared<ListOptions>();
  CLI::App* verb = app.add_subcommand("list", "Lists structures, workloads, papers or arithmetics");
  verb->add_option("WHAT", options->what, "structures, workloads, papers or arithmetics")
      ->required();
  CLI::Option* json =
      verb->add_flag("--json", options->json,
                     "Print a JSON array of names and summaries; of structures their descriptors");
  CLI::Option* family =
      verb->add_option("--family", options->family, "Of structures: those of this family alone");
  CLI::Option* markdown = verb->add_flag(
      "--markdown", options->markdown,
      "Of structures: print a table in Markdown, as in the documents (from their descriptors)");
  CLI::Option* schema =
      verb->add_flag("--schema", options->schema,
                     "Of structures: print the definitions that the schema of scenes has of them");
  markdown->excludes(json);
  schema->excludes(json)->excludes(markdown)->excludes(family);
  add_voice(*verb, "Print the names alone, one a line",
            "Print a second line for each: of structures family and group, of workloads axes and "
            "options, of papers parts, of arithmetics the promise");
  verb->footer("kinex explain NAME says more of each.\nExample:\n  kinex list structures");
  verb->callback([options, verb] { list(*options, voice_of(*verb)); });
}

}  // namespace kinex::verbs
