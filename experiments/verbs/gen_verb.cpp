// SPDX-License-Identifier: GPL-3.0-or-later
// kinex gen: writes a scene of a workload.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>
#include <memory>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "core/numbers/near_names.h"
#include "experiments/formats/counted.h"
#include "experiments/formats/input_error.h"
#include "experiments/formats/plain_text.h"
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
  std::optional<int> n, m, dimension, turns;
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

// "Objects, or what the workload counts (100; tournament-worst: 64)": the workloads whose default is another one.
std::string size_text(const std::string& text, const std::string& usual, int lab::Workload::*size,
                      int usual_size) {
  std::string others;
  for (const lab::Workload& workload : lab::workloads()) {
    if (workload.*size == usual_size) continue;
    others += (others.empty() ? "; " : ", ") + std::string(workload.name) + ": " +
              std::to_string(workload.*size);
  }
  return text + " (" + usual + others + ")";
}

// What stands below the options: of the workload that was named, or of all.
std::string footer_of(const std::string& name) {
  const lab::Workload* const workload = lab::find_workload(name);
  if (workload == nullptr) {
    return "Workloads:\n" + listed(80) +
           "\nThe options of one: kinex gen WORKLOAD --help"
           "\nExample:\n  kinex gen uniform-square --n 100 --seed 7 -o square.json";
  }
  std::string text = name + ": " + std::string(workload->summary) + "\nIt takes:\n";
  for (const std::string& option : lab::options_of(*workload)) text += "  " + option + "\n";
  return text + "Example:\n  kinex gen " + name + " -o " + name + ".json";
}

// In WorkloadParameters 0 means the default; --m 0 does not.
lab::WorkloadParameters parameters_of(const GenOptions& options, const lab::Workload& workload) {
  lab::WorkloadParameters parameters = options.parameters;
  parameters.n = options.n.value_or(workload.default_n);
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

// The structures that --maintain names, in the order of the registry.
std::vector<const StructureInfo*> structures_in(const std::vector<std::string>& maintain) {
  std::set<std::string> words;
  for (const std::string& text : maintain) {
    std::string word;
    for (const char c : text + ",") {
      if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_') {
        word += c;
        continue;
      }
      words.insert(std::exchange(word, {}));
    }
  }
  std::vector<const StructureInfo*> structures;
  for (const StructureInfo& info : structure_infos()) {
    if (words.count(std::string(info.name)) != 0) structures.push_back(&info);
  }
  return structures;
}

// Extents with which all of them can be maintained, if there are such: discs are boxes and have weights, too.
Extents extents_for(const std::vector<const StructureInfo*>& structures) {
  Extents chosen = Extents::kNone;
  for (const StructureInfo* info : structures) {
    const Extents usual = info->usual_extents();
    if (usual == Extents::kNone || usual == chosen) continue;
    chosen = chosen == Extents::kNone ? usual : Extents::kRadius;
  }
  return chosen;
}

// Makes the points of a scene what the structures need.
void suit(Scene& scene, const std::vector<const StructureInfo*>& structures) {
  for (const StructureInfo* info : structures) {
    if (info->graph) lab::join_vertices(scene);
  }
  lab::give_extents(scene, extents_for(structures));
  for (const StructureInfo* info : structures) lab::make_lines(scene, info->lines);
}

// What to do about a structure that is refused in the workload's scene of these parameters.
std::string remedy_for(const StructureInfo& info, const lab::Workload& workload,
                       lab::WorkloadParameters parameters, const Refusal& refusal) {
  parameters = lab::resolved(workload, parameters);
  parameters.n = std::max(8, workload.min_n);
  const auto fits = [&] {
    return !refusal_of(info, lab::generate_scene(workload.name, parameters, info.name));
  };
  if (fits())
    return "maintain it in a scene of its own: the objects would have to be of another kind";
  for (const int dimension : {1, 2, 3}) {
    if (dimension < workload.min_dimension || dimension > workload.max_dimension) continue;
    parameters.dimension = dimension;
    if (fits()) return "give --dimension " + std::to_string(dimension);
  }
  if (parameters.degree > 1) return refusal.remedy;
  const lab::ExampleScene example = lab::example_scene(info);
  if (example.workload == nullptr) return refusal.remedy;
  return "choose another workload: kinex gen " + std::string(example.workload->name) +
         " --maintain " + std::string(info.name);
}

// What to do about a scene that the reader refuses.
std::string remedy_for(const Scene& scene, const lab::Workload& workload,
                       const std::vector<const StructureInfo*>& structures) {
  if (scene.has_bodies()) return "choose sizes and --separation nearer to 1";
  for (const StructureInfo* info : structures) {
    const lab::ExampleScene example = lab::example_scene(*info);
    if (example.workload == nullptr || example.workload == &workload) continue;
    return "choose another workload: kinex gen " + std::string(example.workload->name) +
           " --maintain " + std::string(info->name);
  }
  return "choose smaller sizes (kinex gen " + std::string(workload.name) + " --help names them)";
}

// What is written must be read. Polygons of extreme sizes may degenerate in the doubles with which some families place
// vertices, degrees may grow with a size, and objects of one kind cannot be given what those of another have.
void check_scene(const Scene& scene, const std::string& text, const lab::Workload& workload,
                 const std::vector<const StructureInfo*>& structures) {
  try {
    formats::parse_scene(text, "the scene");
  } catch (const formats::InputError& error) {
    throw formats::InputError(
        "gen", "", std::string(workload.name) + " cannot be made of these " +
                       (scene.has_bodies() ? "sizes: " : "options: ") + error.place() + ": " + error.problem(),
        remedy_for(scene, workload, structures));
  }
}

void generate(const GenOptions& options, const Voice& voice) {
  if (options.list) {
    print(listed(kAnyLength));
    return;
  }
  const lab::Workload* workload = lab::find_workload(options.workload);
  if (workload == nullptr) refuse(options.workload);
  const lab::WorkloadParameters parameters = parameters_of(options, *workload);
  Scene scene = lab::generate_scene(*workload, parameters);
  if (!options.name.empty()) scene.name = name_option(options.name);
  const std::vector<const StructureInfo*> structures = structures_in(options.maintain);
  suit(scene, structures);
  for (const StructureInfo* info : structures) {
    if (const std::optional<Refusal> refusal = refusal_of(*info, scene)) {
      throw formats::InputError("--maintain", "", show_text(info->name) + " " + refusal->problem,
                                remedy_for(*info, *workload, parameters, *refusal));
    }
  }
  if (!options.maintain.empty()) formats::set_maintain(scene, options.maintain);
  lab::name_colours(scene);
  const std::string text = formats::write_scene(scene);
  check_scene(scene, text, *workload, structures);
  write_result(options.output, options.force, text);
  voice.detail(formats::plain(scene.name) + ", " + formats::counted(scene.objects.size(), "object", "objects") +
               ", hash " + formats::scene_hash(scene));
}

}  // namespace

void add_gen_verb(CLI::App& app, int&) {
  auto options = std::make_shared<GenOptions>();
  CLI::App* verb = app.add_subcommand("gen", "Writes a scene of a named workload");
  verb->add_option("WORKLOAD", options->workload, "The workload, as kinex list workloads names it");
  verb->add_flag("--list", options->list, "List the workloads and stop");
  const lab::WorkloadParameters usual;
  verb->add_option("--n", options->n,
                   size_text("Size: objects, or what the workload says", std::to_string(usual.n),
                             &lab::Workload::default_n, usual.n));
  verb->add_option("--m", options->m,
                   size_text("Second size, where a workload has one", "same as --n",
                             &lab::Workload::default_m, 0));
  verb->add_option("--seed", options->seed, "Seed of the random workloads (1)");
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
  verb->footer("");  // not that of the program
  verb->footer([options] { return footer_of(options->workload); });
  verb->callback([options, verb] {
    if (options->workload.empty() && !options->list) throw CLI::RequiredError("WORKLOAD");
    generate(*options, voice_of(*verb));
  });
}

}  // namespace kinex::verbs
