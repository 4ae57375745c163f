// SPDX-License-Identifier: GPL-3.0-or-later
// kinex explain: what a name stands for.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/numbers/near_names.h"
#include "experiments/formats/input_error.h"
#include "experiments/formats/model_text.h"
#include "experiments/lab/explanation.h"
#include "experiments/lab/scene_run.h"
#include "experiments/reproduce/papers.h"
#include "experiments/verbs/option_values.h"
#include "experiments/verbs/verbs.h"
#include "experiments/verbs/voice.h"
#include "structures/family_summary.h"
#include "structures/registry.h"

namespace kinex::verbs {

namespace {

constexpr std::size_t kHeading = 14;  // characters, with the space after it

lab::Explanation explain_paper(const lab::Paper& paper) {
  const std::string name(paper.name);
  lab::Explanation result{name, std::string(paper.title), {}};
  std::vector<std::string> parts;
  for (const lab::PaperPart& part : paper.parts) {
    parts.push_back(std::string(part.name) + ": " + std::string(part.summary));
  }
  result.parts.emplace_back("parts", std::move(parts));
  std::vector<std::string> example{"kinex reproduce " + name + " --quick"};
  if (!paper.parts.empty()) {
    const std::string part(paper.parts.front().name);
    example.insert(example.begin(), "kinex reproduce " + name + " " + part + " --quick -o " + part);
  }
  result.parts.emplace_back("example", std::move(example));
  return result;
}

lab::Explanation explain_group(std::string_view group) {
  const std::string name(group);
  lab::Explanation result{name, "all structures for one attribute, which they report alike", {}};
  std::vector<std::string> members;
  for (const StructureInfo& info : structure_infos()) {
    if (info.group == group)
      members.push_back(std::string(info.name) + ": " + std::string(info.summary));
  }
  result.parts.emplace_back("structures", std::move(members));
  result.parts.emplace_back("example",
                            std::vector<std::string>{"kinex verify " + name + " --quick"});
  return result;
}

// Its groups, with their structures, and the structures that are in none.
std::vector<std::string> groups_of(std::string_view family) {
  std::vector<std::string> lines;
  for (const std::string_view group : structure_groups()) {
    std::string members;
    for (const StructureInfo& info : structure_infos()) {
      if (info.group != group || family_of(info.name) != family) continue;
      members += (members.empty() ? "" : ", ") + std::string(info.name);
    }
    if (!members.empty()) lines.push_back(std::string(group) + ": " + members);
  }
  return lines;
}

lab::Explanation explain_family(const FamilySummary& family) {
  const std::string name(family.name);
  lab::Explanation result{name, "a family of structures: " + std::string(family.summary), {}};
  std::vector<std::string> members;
  for (const StructureInfo& info : structure_infos()) {
    if (family_of(info.name) == family.name)
      members.push_back(std::string(info.name) + ": " + std::string(info.summary));
  }
  result.parts.emplace_back("structures", std::move(members));
  std::vector<std::string> groups = groups_of(family.name);
  if (!groups.empty()) {
    groups.insert(groups.begin(),
                  "structures of one group maintain the same attribute and report it alike");
    result.parts.emplace_back("groups", std::move(groups));
  }
  result.parts.emplace_back("example",
                            std::vector<std::string>{"kinex list structures --family " + name,
                                                     "kinex verify " + name + " --quick"});
  return result;
}

std::vector<std::string> known_names() {
  std::vector<std::string> names;
  for (const FamilySummary& family : family_summaries()) names.emplace_back(family.name);
  for (const StructureInfo& info : structure_infos()) names.emplace_back(info.name);
  for (const std::string_view group : structure_groups()) names.emplace_back(group);
  for (const lab::Workload& workload : lab::workloads()) names.emplace_back(workload.name);
  for (const lab::Paper& paper : reproduce::papers()) names.emplace_back(paper.name);
  for (const lab::ArithmeticInfo& info : lab::arithmetic_infos()) names.emplace_back(info.name);
  return names;
}

// The model of a run of the example scene, as kinex run --explain prints it.
void add_model(const StructureInfo& structure, lab::Explanation& explanation) {
  const lab::ExampleScene example = lab::example_scene(structure);
  if (example.workload == nullptr) return;
  const Scene scene =
      lab::generate_scene(example.workload->name, example.parameters, structure.name);
  const std::string text =
      formats::explain_model(scene, *lab::make_simulator(scene, "exact", SimulatorOptions{}));
  std::vector<std::string> lines;
  for (std::size_t at = 0; at < text.size(); at = text.find('\n', at) + 1)
    lines.push_back(text.substr(at, text.find('\n', at) - at));
  explanation.parts.emplace_back("its model", std::move(lines));
}

lab::Explanation explanation_of(const std::string& name, const Voice& voice) {
  if (const StructureInfo* structure = find_structure_info(name)) {
    lab::Explanation result = lab::explain(*structure);
    if (voice.verbose) add_model(*structure, result);
    return result;
  }
  for (const FamilySummary& family : family_summaries()) {
    if (family.name == name) return explain_family(family);  // it says which groups it has
  }
  for (const std::string_view group : structure_groups()) {
    if (group == name) return explain_group(group);
  }
  if (const lab::Workload* workload = lab::find_workload(name)) return lab::explain(*workload);
  for (const lab::Paper& paper : reproduce::papers()) {
    if (paper.name == name) return explain_paper(paper);
  }
  if (const lab::ArithmeticInfo* arithmetic = lab::find_arithmetic_info(name))
    return lab::explain(*arithmetic);
  throw formats::InputError(
      "explain", "",
      show_text(name) + " is no name of a structure, group, family, workload, paper or arithmetic",
      did_you_mean(name, known_names(), "kinex list structures, and so on, names them"));
}

std::string text_of(const lab::Explanation& explanation, const Voice& voice) {
  if (voice.quiet) return explanation.summary + "\n";
  std::string text = voice.heading(explanation.name) + "  " + explanation.summary + "\n\n";
  for (const auto& [heading, lines] : explanation.parts) {
    for (std::size_t i = 0; i < lines.size(); ++i) {
      const std::string left = i == 0 ? voice.heading(heading) : "";
      const std::size_t width = i == 0 ? heading.size() : 0;
      text += left + std::string(kHeading - std::min(kHeading - 1, width), ' ') + lines[i] + "\n";
    }
  }
  return text;
}

}  // namespace

void add_explain_verb(CLI::App& app, int&) {
  auto name = std::make_shared<std::string>();
  CLI::App* verb =
      app.add_subcommand("explain", "Explains a structure, family, workload, paper or arithmetic");
  verb->add_option("NAME", *name,
                   "A structure, workload, paper or arithmetic, as kinex list names it, or a group "
                   "or a family of structures")
      ->required();
  add_voice(*verb, "Print the summary alone",
            "Of a structure: print the model of a run of the example, too");
  verb->footer(
      "Of a structure: what it maintains and for which scenes, its certificates with\n"
      "their degrees (d is that of the motions), events, ties, hard bounds with sources\n"
      "and their values in a run of the example scene, what kinex verify expects of it,\n"
      "and example commands.\n"
      "Example:\n"
      "  kinex explain " +
      example_structure(2) + "\n  kinex explain uniform-square\n  kinex explain " +
      std::string(family_of(example_structure(2))));
  verb->callback([name, verb] {
    const Voice voice = voice_of(*verb);
    print(text_of(explanation_of(*name, voice), voice));
  });
}

}  // namespace kinex::verbs
