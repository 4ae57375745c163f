// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/lab/explanation.h"

#include <algorithm>
#include <map>
#include <memory>
#include <set>
#include <string_view>

#include "experiments/formats/claim_words.h"
#include "experiments/formats/counted.h"
#include "experiments/formats/input_error.h"
#include "experiments/formats/model_text.h"
#include "experiments/lab/family.h"
#include "experiments/lab/scene_run.h"
#include "experiments/lab/structure_words.h"
#include "structures/parts/range_search.h"
#include "structures/registry.h"

namespace kinex::lab {

namespace {

using Lines = std::vector<std::string>;

constexpr int kFewObjects = 8;

std::string effect_of(Effect effect) {
  switch (effect) {
    case Effect::kNever:
      return "internal";
    case Effect::kSometimes:
      return "internal or external";
    case Effect::kAlways:
      return "external";
  }
  return "";
}

constexpr std::string_view kLetters = "abcdefghij";  // of the arguments, kMaxArity

// "{0} is left of {1}" with letters in it: "a is left of b".
std::string claim_in_words(const ClaimForm& form) {
  std::string text(form.says);
  for (std::size_t i = 0; i < kLetters.size(); ++i) {
    const std::string place = "{" + std::to_string(i) + "}";
    for (std::size_t at = text.find(place); at != std::string::npos; at = text.find(place)) {
      text.replace(at, place.size(), 1, kLetters[i]);
    }
  }
  return text;
}

// "in_circle_2(a, b, c, d)"
std::string with_letters(const Predicate& predicate) {
  std::string text(predicate.name());
  for (std::size_t i = 0; i < static_cast<std::size_t>(predicate.arity()); ++i) {
    text += (i == 0 ? "(" : ", ") + std::string(1, kLetters[i]);
  }
  return text + ")";
}

// For points: as a multiple of d, the degree of the motions.
std::string degree_of(const Predicate& predicate, const StructureInfo& info, int held) {
  const int one = predicate.degree(1), two = predicate.degree(2);
  if (one == 0 && two == 0) return "constant in t";
  if (info.bodies || two != 2 * one)
    return "degree " + std::to_string(predicate.degree(held)) + " in t in the example";
  return "degree " + (one == 1 ? std::string() : std::to_string(one)) + "d in t";
}

// "order_box_area" of "order_box_area/01230145", which is about fewer objects than eight.
std::string whole_of(std::string_view predicate) {
  return std::string(predicate.substr(0, predicate.find('/')));
}

// What a run has of one predicate: forms with other words, as with "smaller" for "larger", and with fewer objects.
struct PredicateForms {
  std::string line;                // of the form that says it best
  std::set<std::string> words;     // of forms of as many objects as that one
  std::set<std::string> repeated;  // forms in which one object is several arguments
  int least = 0, most = 0;         // objects of these
};

std::string in_words(const PredicateForms& forms) {
  std::string text = forms.line;
  if (forms.words.size() > 1) {
    text += "; and " + formats::counted(forms.words.size() - 1, "form", "forms") + " like it";
  }
  if (forms.repeated.empty()) return text;
  return text + "; and where an object is several of these, in " +
         formats::counted(forms.repeated.size(), "form", "forms") + " of " +
         std::to_string(forms.least) +
         (forms.least == forms.most ? "" : " to " + std::to_string(forms.most)) + " objects";
}

Lines predicates_of(const StructureInfo& info, const Simulator& simulator) {
  const Arithmetic& numbers = simulator.arithmetic();
  std::vector<std::string> names;  // in the order of their first forms
  std::map<std::string, PredicateForms> all;
  for (PredicateId id = 0; id < numbers.predicates(); ++id) {
    const Predicate& predicate = numbers.predicate(id);
    const std::string name = whole_of(predicate.name()),
                      words = claim_in_words(formats::claim_form(predicate, simulator.scene()));
    std::string line = with_letters(predicate) + ", " +
                       degree_of(predicate, info, std::max(1, numbers.needs().degree));
    if (!words.empty()) line += ": " + words;
    const auto [place, is_new] = all.try_emplace(name);
    if (is_new) names.push_back(name);
    PredicateForms& forms = place->second;
    if (name == predicate.name()) {
      if (forms.words.empty()) forms.line = line;
      forms.words.insert(words);
      continue;
    }
    if (forms.line.empty()) forms.line = line;
    forms.least =
        forms.repeated.empty() ? predicate.arity() : std::min(forms.least, predicate.arity());
    forms.most = std::max(forms.most, predicate.arity());
    forms.repeated.insert(line);
  }
  Lines lines;
  for (const std::string& name : names) lines.push_back(in_words(all.at(name)));
  return lines;
}

Lines bounds_of(const Simulator& simulator, const formats::RunOutcome& outcome,
                std::string_view structure) {
  Lines lines;
  for (StructureId id = 0; id < simulator.structures(); ++id) {
    if (simulator.structure(id).name() != structure) continue;
    for (const BoundCheck& bound : outcome.bounds[id]) {
      lines.push_back(bound.id + ": " + bound.source + " (in the example " +
                      bound.observed.to_string() + ", at most " + bound.bound.to_string() +
                      " by the bound)");
    }
  }
  return lines;
}

// What kinex verify expects of it: growth claims, and the claims of single counts.
Lines claims_of(std::string_view structure) {
  const FamilyExperiments* const family = experiments_on(structure);
  if (family == nullptr || family->add_cells == nullptr) return {};
  Catalogue catalogue;
  family->add_cells(catalogue, Extent::kQuick);
  Lines lines;
  std::set<std::string> told;
  const auto add = [&](const std::string& claim, const std::string& source) {
    if (told.insert(claim).second) lines.push_back(claim + (source.empty() ? "" : ": " + source));
  };
  for (const Cell& cell : catalogue.cells) {
    if (cell.structure != structure) continue;
    for (const Expectation& expectation : cell.expectations)
      add(expectation.claim, expectation.source);
  }
  for (const GrowthClaim& growth : catalogue.growths) {
    if (growth.structure == structure) add(growth.claim, growth.source);
  }
  return lines;
}

std::string command_of(const Workload& workload, const WorkloadParameters& parameters) {
  std::string command =
      "kinex gen " + std::string(workload.name) + " --n " + std::to_string(parameters.n);
  if (workload.random) command += " --seed " + std::to_string(parameters.seed);
  return command;
}

// Of all families, for one structure after the other.
std::set<std::string> structures_with_claims_on(std::string_view workload) {
  std::set<std::string> names;
  for (const FamilyExperiments& family : experiment_families()) {
    if (family.add_cells == nullptr) continue;
    Catalogue catalogue;
    family.add_cells(catalogue, Extent::kQuick);
    for (const Cell& cell : catalogue.cells) {
      if (cell.workload == workload) names.insert(cell.structure);
    }
  }
  return names;
}

std::string joined(const std::set<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

// True if the structure has an event in a run of the example.
bool has_events_in(const StructureInfo& structure, const ExampleScene& example) {
  const Scene scene = generate_scene(example.workload->name, example.parameters, structure.name);
  const std::unique_ptr<Simulator> simulator = make_simulator(scene, "exact", {});
  run_scene(*simulator, {});
  for (StructureId id = 0; id < simulator->structures(); ++id) {
    if (simulator->structure(id).name() != structure.name) continue;
    const StructureLedger& ledger = simulator->ledger(id);
    if (ledger.external + ledger.internal > 0) return true;
  }
  return false;
}

// Doubles the example until the structure has an event in it; it stays as it is if none of a few sizes will do.
void enlarge(const StructureInfo& structure, ExampleScene& example) {
  ExampleScene larger = example;
  for (int doublings = 0; doublings < 3; ++doublings) {
    if (has_events_in(structure, larger)) {
      example = larger;
      return;
    }
    larger.parameters.n *= 2;
  }
}

}  // namespace

ExampleScene example_scene(const StructureInfo& structure) {
  for (const bool random : {true, false}) {
    for (const Workload& workload : workloads()) {
      if (workload.random != random || workload.bodies != structure.bodies) continue;
      ExampleScene example;
      example.workload = &workload;
      example.parameters.n = std::max(kFewObjects, workload.min_n);
      try {
        const Scene scene = generate_scene(workload.name, example.parameters, structure.name);
        if (refusal_of(structure, scene)) continue;
      } catch (const formats::InputError&) {
        continue;  // it cannot be of this size
      }
      if (!structure.kinds.empty()) enlarge(structure, example);
      example.command = command_of(workload, example.parameters);
      return example;
    }
  }
  return {};
}

namespace {

// True if the structure refuses its example without an end.
bool needs_an_end(const StructureInfo& info, const ExampleScene& example) {
  if (example.workload == nullptr) return false;
  Scene scene = generate_scene(example.workload->name, example.parameters, info.name);
  if (!scene.end) return false;
  scene.end.reset();
  return refusal_of(info, scene).has_value();
}

}  // namespace

Explanation explain(const StructureInfo& info) {
  const std::string name(info.name);
  Explanation result{name, std::string(info.summary), {}};
  const auto add = [&](const char* heading, Lines lines) {
    if (!lines.empty()) result.parts.emplace_back(heading, std::move(lines));
  };
  const auto text = [](std::string_view line) {
    return line.empty() ? Lines{} : Lines{std::string(line)};
  };
  add("maintains", {attribute_in_words(info)});
  const ExampleScene example = example_scene(info);
  std::string domain = domain_in_words(info);
  if (needs_an_end(info, example)) domain += "; scenes with an \"end\" only";
  add("for", {std::move(domain)});
  if (info.uses_key)
    add("key", {"x (default), y, z, a direction, or the squared distance to an object"});
  if (info.query) {
    add("query", {info.query_is_site ? "a site (default: the first)"
                                     : "an object (default: the first); the others are the sites"});
  }
  if (info.colours) {
    add("colours", {"two colours of objects (default: the objects at even and at odd places)"});
  }
  add("reads", readings_in_words(info));
  add("parameters", parameters_in_words(info));
  add("family",
      {std::string(family_of(info.name)) +
       (info.group.empty() ? "" : "; one of the structures for " + std::string(info.group))});
  add("certificates", text(info.certificates));
  Lines bounds;
  if (example.workload != nullptr) {
    const Scene scene = generate_scene(example.workload->name, example.parameters, info.name);
    const std::unique_ptr<Simulator> simulator = make_simulator(scene, "exact", {});
    const formats::RunOutcome outcome = run_scene(*simulator, {});
    add("predicates", predicates_of(info, *simulator));
    bounds = bounds_of(*simulator, outcome, info.name);
  }
  Lines events;
  for (const KindRule& rule : info.kinds)
    events.push_back(std::string(rule.kind) + ": " + std::string(rule.text) + " (" +
                     effect_of(rule.effect) + ")");
  add("events", std::move(events));
  add("ties", text(info.ties));
  add("bounds", std::move(bounds));
  add("to verify", claims_of(info.name));
  add("source", text(info.source));
  if (example.workload != nullptr) {
    // What is there to be searched shows nothing until it is asked.
    const char* const question = info.role == kRangeSearch ? " --at 1/2 --query 1/4,3/4,1/4,3/4" : "";
    add("example",
        {example.command + " --maintain " + name + " -o " + name + ".json",
         "kinex run " + name + ".json --audit events" + question, "kinex verify " + name + " --quick"});
  }
  return result;
}

std::vector<std::string> options_of(const Workload& workload) {
  const auto size = [](const std::string& option, std::string_view counts, const std::string& value,
                       int low) {
    return option + "  " + std::string(counts) + ": " + value + " by default, " +
           std::to_string(low) + " at least";
  };
  Lines options{size("--n", workload.n_counts, std::to_string(workload.default_n), workload.min_n)};
  if (workload.takes_m) {
    options.push_back(size("--m", workload.m_counts,
                           workload.default_m == 0 ? "as --n" : std::to_string(workload.default_m),
                           workload.min_m));
  }
  if (workload.random) options.push_back("--seed  1 by default");
  if (workload.takes_degree) {
    options.push_back("--degree  of the motions: 1 by default, " +
                      std::to_string(kMaxWorkloadDegree) + " at most");
  }
  if (workload.min_dimension < workload.max_dimension) {
    options.push_back("--dimension  axes: " + std::to_string(workload.default_dimension) +
                      " by default, " + std::to_string(workload.min_dimension) + " to " +
                      std::to_string(workload.max_dimension));
  }
  if (workload.separation) {
    options.push_back("--separation  distance of the bodies: " + workload.separation->to_string() +
                      " by default");
  }
  if (workload.takes_turns) {
    options.push_back("--turns  1 by default, " + std::to_string(workload.min_turns) + " at least");
  }
  return options;
}

Explanation explain(const Workload& workload) {
  Explanation result{std::string(workload.name), std::string(workload.summary), {}};
  const auto add = [&](const char* heading, Lines lines) {
    result.parts.emplace_back(heading, std::move(lines));
  };
  WorkloadParameters few;
  few.n = std::max(kFewObjects, workload.min_n);
  add("objects",
      {formats::objects_in_words(generate_scene(workload, few)) + " in " +
       formats::counted(static_cast<std::uint64_t>(workload.default_dimension), "axis", "axes")});
  add("scenes", {workload.random ? "random, the same for a seed on every machine"
                                 : "one for its parameters"});
  add("options", options_of(workload));
  const std::string structure = workload.maintain.empty()
                                    ? usual_structure(workload.bodies, workload.default_dimension)
                                    : std::string(workload.maintain);
  add("maintains", {structure + " unless --maintain says otherwise"});
  const std::set<std::string> claimed = structures_with_claims_on(workload.name);
  if (!claimed.empty()) add("to verify", {"by kinex verify: " + joined(claimed)});
  const std::string name(workload.name);
  add("example",
      {command_of(workload, few) + " -o " + name + ".json", "kinex run " + name + ".json"});
  return result;
}

Explanation explain(const ArithmeticInfo& arithmetic) {
  const std::string example(arithmetic.example);
  return {std::string(arithmetic.name),
          std::string(arithmetic.summary),
          {{"promise", {std::string(arithmetic.promise)}},
           {"for", {std::string(arithmetic.use)}},
           {"example",
            {"kinex gen uniform-square --n 20 -o square.json",
             "kinex run square.json --arithmetic " + example + " --events square.log"}}}};
}

}  // namespace kinex::lab
