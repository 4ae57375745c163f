// SPDX-License-Identifier: GPL-3.0-or-later
// kinex gen: writes a scene of a workload.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "core/numbers/near_names.h"
#include "experiments/formats/counted.h"
#include "experiments/formats/input_error.h"
#include "experiments/formats/scene_reader.h"
#include "experiments/formats/scene_writer.h"
#include "experiments/lab/colours.h"
#include "experiments/lab/explanation.h"
#include "experiments/lab/workload.h"
#include "experiments/verbs/option_values.h"
#include "experiments/verbs/verbs.h"
#include "experiments/verbs/voice.h"
#include "structures/registry.h"

namespace kinex::verbs {

namespace {

struct GenOptions {
  std::string workload;
  lab::WorkloadParameters parameters;
  std::string seed;
  std::optional<int> m, dimension, turns;
  std::string separation;
  std::vector<std::string> maintain;
  std::string name, output;
  bool force = false;
  bool list = false;
};

constexpr std::size_t kAnyLength = std::string::npos;  // one workload a line

// Names and summaries in two columns, in lines of at most so many characters.
std::string listed(std::size_t line_length) {
  constexpr std::size_t kSecondColumn = 26;
  std::string text;
  for (const lab::Workload& workload : lab::workloads()) {
    std::string line = "  " + std::string(workload.name);
    line.resize(std::max<std::size_t>(line.size(), kSecondColumn - 1), ' ');
    std::istringstream words{std::string(workload.summary)};
    for (std::string word; words >> word;) {
      if (line.size() + 1 + word.size() > line_length) {
        text += line + "\n";
        line.assign(kSecondColumn - 1, ' ');
      }
      line += " " + word;
    }
    text += line + "\n";
  }
  return text;
}

// In WorkloadParameters 0 means the default; --m 0 does not.
lab::WorkloadParameters parameters_of(const GenOptions& options, const lab::Workload& workload) {
  lab::WorkloadParameters parameters = options.parameters;
  if (!options.seed.empty()) parameters.seed = seed_option("--seed", options.seed);
  if (options.m) {
    if (workload.takes_m) check_range("--m", *options.m, workload.min_m, lab::kMaxWorkloadSize);
    parameters.m = *options.m == 0 ? 1 : *options.m;  // refused where the workload takes none
  }
  if (options.dimension) {
    check_range("--dimension", *options.dimension, workload.min_dimension, workload.max_dimension);
    parameters.dimension = *options.dimension;
  }
  if (!options.separation.empty()) {
    parameters.separation = rational_option("--separation", options.separation);
  }
  if (options.turns) {
    if (workload.takes_turns) {
      check_range("--turns", *options.turns, workload.min_turns, lab::kMaxWorkloadTurns);
    }
    parameters.turns = std::max(0, *options.turns);  // refused where the workload takes none
  }
  return parameters;
}

// Polygons of extreme sizes may degenerate in the doubles with which some families place vertices.
void check_bodies(const Scene& scene, const lab::Workload& workload) {
  try {
    formats::parse_scene(formats::write_scene(scene), "the scene");
  } catch (const formats::InputError& error) {
    throw formats::InputError(
        "gen", "", std::string(workload.name) + " cannot be made of these sizes: " + error.what(),
        "choose sizes and --separation nearer to 1");
  }
}

// Structures are no workloads, but easily taken for them.
[[noreturn]] void refuse(const std::string& name) {
  std::vector<std::string> known, structures;
  for (const lab::Workload& one : lab::workloads()) known.emplace_back(one.name);
  for (const StructureInfo& info : structure_infos()) structures.emplace_back(info.name);
  const std::string problem = show_text(name) + " is not a workload";
  std::vector<std::string> meant;
  if (find_structure_info(name) != nullptr) {
    meant = {name};
  } else if (near_names(name, known).empty()) {
    meant = near_names(name, structures);
  }
  if (!meant.empty()) {
    const lab::ExampleScene example = lab::example_scene(*find_structure_info(meant.front()));
    if (example.workload != nullptr) {
      throw formats::InputError("gen", "",
                                problem + "; " + meant.front() + " is a structure",
                                "write kinex gen " + std::string(example.workload->name) +
                                    " --maintain " + meant.front());
    }
  }
  throw formats::InputError(
      "gen", "", problem,
      did_you_mean(name, known, "kinex list workloads names them"));
}

void generate(const GenOptions& options, const Voice& voice) {
  if (options.list) {
    print(listed(kAnyLength));
    return;
  }
  const lab::Workload* workload = lab::find_workload(options.workload);
  if (workload == nullptr) refuse(options.workload);
  Scene scene = lab::generate_scene(*workload, parameters_of(options, *workload));
  if (!options.name.empty()) scene.name = name_option(options.name);
  for (const StructureInfo& info : structure_infos()) {
    const auto names = [&info](const std::string& text) {
      return text.find(info.name) != std::string::npos;
    };
    if (std::any_of(options.maintain.begin(), options.maintain.end(), names)) {
      if (info.graph) lab::join_vertices(scene);
      lab::give_extents(scene, info.usual_extents());
      lab::make_lines(scene, info.lines);
    }
  }
  if (!options.maintain.empty()) formats::set_maintain(scene, options.maintain);
  lab::name_colours(scene);
  if (scene.has_bodies()) check_bodies(scene, *workload);
  write_result(options.output, options.force, formats::write_scene(scene));
  voice.detail(scene.name + ", " + formats::counted(scene.objects.size(), "object", "objects") +
               ", hash " + formats::scene_hash(scene));
}

}  // namespace

void add_gen_verb(CLI::App& app, int&) {
  auto options = std::make_shared<GenOptions>();
  CLI::App* verb = app.add_subcommand("gen", "Writes a scene of a named workload");
  verb->add_option("WORKLOAD", options->workload, "The workload, as kinex list workloads names it");
  verb->add_flag("--list", options->list, "List the workloads and stop");
  verb->add_option("--n", options->parameters.n, "Objects (100)");
  verb->add_option("--m", options->m, "Second size, where a family has one (same as --n)");
  verb->add_option("--seed", options->seed, "Seed of the random families (1)");
  verb->add_option("--degree", options->parameters.degree, "Degree of the motion (1)");
  verb->add_option("--dimension", options->dimension, "Axes, 1 to 3");
  verb->add_option("--separation", options->separation, "Distance between two bodies");
  verb->add_option("--turns", options->turns, "Full turns of one body around another (1)");
  add_maintain_option(*verb, options->maintain, "What to maintain");
  CLI::Option* const maintain = verb->get_option("--maintain");
  maintain->description(
      maintain->get_description() +
      ". Points get what a structure needs: radii, half extents, weights, ends of "
      "edges (on one axis), or \"line\" (each or every second one)");
  verb->add_option("--name", options->name, "Name of the scene");
  verb->add_option("-o,--output", options->output, "File to write (standard output)");
  verb->add_flag("--force", options->force, "Replace the file if it exists");
  add_voice(*verb, "Print the scene and errors",
            "Name the scene, its size and its hash, on standard error");
  verb->footer("Families:\n" + listed(80) +
               "\nExample:\n  kinex gen uniform-square --n 100 --seed 7 -o square.json");
  verb->callback([options, verb] {
    if (options->workload.empty() && !options->list) throw CLI::RequiredError("WORKLOAD");
    generate(*options, voice_of(*verb));
  });
}

}  // namespace kinex::verbs
