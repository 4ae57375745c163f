// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/sweep/block.h"

#include <algorithm>
#include <charconv>
#include <deque>
#include <initializer_list>
#include <limits>
#include <map>
#include <optional>
#include <string_view>
#include <utility>

#include "core/numbers/near_names.h"
#include "experiments/formats/canonical_json.h"
#include "experiments/formats/input_error.h"
#include "experiments/formats/scene_reader.h"
#include "experiments/lab/scene_run.h"
#include "experiments/lab/workload.h"
#include "structures/registry.h"

namespace kinex::sweep {

namespace {

constexpr int kMostInt = std::numeric_limits<int>::max();
constexpr int kMostAxes = 3;
constexpr int kFew = 8;  // objects of a scene that is tried

// One value of an axis: its effect on a cell, and its place in the file.
struct Choice {
  std::function<void(RunCell&)> set;
  const formats::JsonNode* node;
};
struct Axis {
  std::string_view name;
  std::vector<Choice> choices;
};

std::string quoted_list(std::initializer_list<const char*> names) {
  std::string text;
  for (const char* name : names)
    text += (text.empty() ? "write \"" : ", \"") + std::string(name) + "\"";
  return text;
}

std::vector<std::string> workload_names() {
  std::vector<std::string> names;
  for (const lab::Workload& workload : lab::workloads()) names.emplace_back(workload.name);
  return names;
}

std::uint64_t read_seed(const formats::JsonNode& node) {
  std::uint64_t seed = 0;
  const std::string_view text = node.value().text();
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, seed);
  if (!node.is(formats::JsonValue::Kind::kNumber) || error != std::errc() || rest != end) {
    node.refuse("a seed", "write an integer from 0 to 18446744073709551615");
  }
  return seed;
}

// An entry of "maintain", as set_maintain takes it.
std::string read_structure(const formats::JsonNode& node) {
  if (node.is(formats::JsonValue::Kind::kObject)) return formats::canonical_json(node.value());
  if (!node.is(formats::JsonValue::Kind::kString) || node.string().empty() ||
      node.string().find_first_of(",{} \t\r\n") != std::string::npos) {
    node.refuse("a structure",
                "write a name, NAME:AXIS, {\"structure\": NAME, ..}, or an array of these to be "
                "maintained in one run");
  }
  return std::string(node.string());
}

// Of the structure that an error of set_maintain names first; nullptr: of none.
const StructureInfo* named_first(const std::string& problem) {
  if (problem.empty() || problem.front() != '"') return nullptr;
  return find_structure_info(problem.substr(1, problem.find('"', 1) - 1));
}

// A workload whose scenes the structure takes: "uniform-square"; empty: there is none.
std::string workload_for(const StructureInfo& info) {
  for (const lab::Workload& workload : lab::workloads()) {
    lab::WorkloadParameters few;
    few.n = std::max(kFew, workload.min_n);
    few.dimension = info.any_dimension ? std::max(info.min_dimension, workload.default_dimension)
                                       : info.min_dimension;
    few.dimension = std::clamp(few.dimension, workload.min_dimension, workload.max_dimension);
    try {
      if (refusal_of(info, lab::generate_scene(workload, few))) continue;
    } catch (const formats::InputError&) {
      continue;  // it cannot be of this size
    }
    return std::string(workload.name) +
           (few.dimension == workload.default_dimension
                ? ""
                : " with \"dimension\": " + std::to_string(few.dimension));
  }
  return {};
}

// What suits a plan, which has workloads and no scenes, where a structure refuses the scene of a cell.
formats::InputError in_a_plan(const formats::InputError& error, const RunCell& cell) {
  const StructureInfo* const info = named_first(error.problem());
  if (info == nullptr) return error;
  const lab::Workload& workload = *lab::find_workload(cell.workload);
  const Scene scene = lab::generate_scene(workload, cell.parameters);
  if (!refusal_of(*info, scene) || scene.degree_without_weights() > info->largest_degree)
    return error;
  std::string problem = error.problem();
  const std::string_view here = ", the scene has";
  if (const std::size_t at = problem.find(here); at != std::string::npos) {
    problem.replace(at, here.size(), ", a scene of " + cell.workload + " has");
  } else {
    problem += " in a scene of " + cell.workload;
  }
  lab::WorkloadParameters there = cell.parameters;
  there.dimension = info->min_dimension;
  if (workload.min_dimension <= there.dimension && there.dimension <= workload.max_dimension &&
      !refusal_of(*info, lab::generate_scene(workload, there))) {
    return {error.file(), error.place(), problem,
            "write \"dimension\": " + std::to_string(there.dimension)};
  }
  const std::string other = workload_for(*info);
  return {error.file(), error.place(), problem,
          other.empty() ? "name another structure; no workload makes such scenes"
                        : "name another structure, or another workload, as " + other};
}

// Fails at the part of `node` that an error's place, a path from there, leads to.
[[noreturn]] void fail_within(const formats::JsonNode& node, std::string_view place,
                              const formats::InputError& error) {
  for (std::size_t i = 0; i < node.size(); ++i) {
    const formats::JsonNode part = node.at(i);
    const std::string step = part.path().substr(node.path().size());
    if (!place.starts_with(step)) continue;
    const std::string_view rest = place.substr(step.size());
    if (rest.empty() || rest.front() == '/') fail_within(part, rest, error);
  }
  node.fail(error.problem(), error.remedy());
}

class BlockReader {
 public:
  explicit BlockReader(const formats::JsonNode& block) : block_(block) {
    block.require_object({"structure", "workload", "n", "m", "degree", "dimension", "separation",
                          "turns", "seed", "arithmetic", "scheduling", "audit", "until",
                          "max_events"});
    block.member("n");
    structures(block.member("structure"));
    read_workloads(block.member("workload"));
    integers("n", 1, lab::kMaxWorkloadSize,
             [](int value, RunCell& cell) { cell.parameters.n = value; });
    integers("m", 1, lab::kMaxWorkloadSize,
             [](int value, RunCell& cell) { cell.parameters.m = value; });
    integers("degree", 1, lab::kMaxWorkloadDegree,
             [](int value, RunCell& cell) { cell.parameters.degree = value; });
    integers("dimension", 1, kMostAxes,
             [](int value, RunCell& cell) { cell.parameters.dimension = value; });
    rationals("separation",
              [](const Rational& value, RunCell& cell) { cell.parameters.separation = value; });
    integers("turns", 1, lab::kMaxWorkloadTurns,
             [](int value, RunCell& cell) { cell.parameters.turns = value; });
    seeds();
    for_each("arithmetic", [&](const formats::JsonNode& node) {
      return [name = node.string()](RunCell& cell) { cell.arithmetic = name; };
    });
    words("scheduling", {"lazy", "eager"}, &RunCell::scheduling);
    words("audit", {"end", "events", "none"}, &RunCell::audit);
    rationals("until", [](const Rational& value, RunCell& cell) { cell.until = value; });
    integers("max_events", 1, kMostInt, [](int value, RunCell& cell) { cell.max_events = value; });
  }

  void expand(PlanCheck check, const std::function<void(RunCell)>& take) {
    std::size_t cells = 1;
    for (const Axis& axis : axes_) {
      cells *= axis.choices.size();
      if (cells > kMostCells) too_many_cells(block_);
    }
    std::vector<std::size_t> at(axes_.size(), 0);
    for (bool more = true; more;) {
      RunCell cell;
      for (std::size_t a = 0; a < axes_.size(); ++a) axes_[a].choices[at[a]].set(cell);
      resolve(cell, at);
      if (check == PlanCheck::kScenes) note_kind(cell, at);
      take(std::move(cell));
      more = false;
      for (std::size_t a = axes_.size(); a > 0 && !more; --a) {
        more = ++at[a - 1] < axes_[a - 1].choices.size();
        if (!more) at[a - 1] = 0;
      }
    }
    for (const auto& [kind, smallest] : kinds_) check_scene(smallest);
  }

 private:
  using Place = std::vector<std::size_t>;
  struct Example {
    RunCell cell;
    Place at;
  };

  // A child refers to its parent: both stay here.
  const formats::JsonNode& keep(const formats::JsonNode& node) { return nodes_.emplace_back(node); }

  template <class MakeSetter>
  void add(std::string_view name, const formats::JsonNode& given, const MakeSetter& setter) {
    Axis axis{name, {}};
    const formats::JsonNode& node = keep(given);
    if (!node.is(formats::JsonValue::Kind::kArray)) {
      axis.choices.push_back({setter(node), &node});
    } else {
      if (node.size() == 0) node.fail("an axis without values", "write one, or leave it out");
      for (std::size_t i = 0; i < node.size(); ++i) {
        const formats::JsonNode& one = keep(node.at(i));
        axis.choices.push_back({setter(one), &one});
      }
    }
    axes_.push_back(std::move(axis));
  }
  template <class MakeSetter>
  void for_each(std::string_view name, const MakeSetter& setter) {
    if (const auto node = block_.find(name)) add(name, *node, setter);
  }

  void structures(const formats::JsonNode& given) {
    add("structure", given, [&](const formats::JsonNode& node) {
      std::vector<std::string> entries;
      if (node.is(formats::JsonValue::Kind::kArray)) {
        if (node.size() == 0) node.fail("nothing is to be maintained", "write a structure");
        for (std::size_t i = 0; i < node.size(); ++i) entries.push_back(read_structure(node.at(i)));
      } else {
        entries.push_back(read_structure(node));
      }
      const bool alone = node.is(formats::JsonValue::Kind::kArray) && node.size() == 1;
      const formats::JsonValue& value = alone ? node.value().items()[0] : node.value();
      return [text = formats::canonical_json(value), entries](RunCell& cell) {
        cell.structure = text;
        cell.maintain = entries;
      };
    });
  }

  void read_workloads(const formats::JsonNode& given) {
    add("workload", given, [](const formats::JsonNode& node) {
      const std::string_view name = node.string();
      if (lab::find_workload(name) == nullptr) {
        node.refuse("a workload", did_you_mean(name, workload_names(),
                                                        "kinex list workloads names them"));
      }
      return [name](RunCell& cell) { cell.workload = name; };
    });
  }

  template <class Set>
  void integers(std::string_view name, int low, int high, Set set) {
    for_each(name, [&](const formats::JsonNode& node) {
      return [value = node.integer(low, high), set](RunCell& cell) { set(value, cell); };
    });
  }
  template <class Set>
  void rationals(std::string_view name, Set set) {
    for_each(name, [&](const formats::JsonNode& node) {
      return [value = node.rational(), set](RunCell& cell) { set(value, cell); };
    });
  }
  void words(std::string_view name, std::initializer_list<const char*> known,
             std::string RunCell::*member) {
    for_each(name, [&](const formats::JsonNode& node) {
      const std::string word(node.string());
      if (std::find(known.begin(), known.end(), word) == known.end()) {
        node.refuse("known here", quoted_list(known));
      }
      return [word, member](RunCell& cell) { cell.*member = word; };
    });
  }

  void seeds() {
    const auto given = block_.find("seed");
    if (!given) return;
    const auto setter = [](std::uint64_t seed) {
      return [seed](RunCell& cell) { cell.parameters.seed = seed; };
    };
    if (!given->is(formats::JsonValue::Kind::kObject)) {
      add("seed", *given, [&](const formats::JsonNode& node) { return setter(read_seed(node)); });
      return;
    }
    const formats::JsonNode& node = keep(*given);
    node.require_object({"from", "to"});
    const std::uint64_t from = read_seed(node.member("from")), to = read_seed(node.member("to"));
    if (from > to || to - from >= kMostCells) {
      node.fail("seeds from " + std::to_string(from) + " to " + std::to_string(to),
                "write from <= to, and at most " + std::to_string(kMostCells) + " seeds");
    }
    Axis axis{"seed", {}};
    for (std::uint64_t k = 0; k <= to - from; ++k)
      axis.choices.push_back({setter(from + k), &node});
    axes_.push_back(std::move(axis));
  }

  // The errors of generators, readers and arithmetics name an option: the axis of that name.
  [[noreturn]] void fail(const formats::InputError& error, std::string option, const Place& at) const {
    if (option.rfind("--", 0) == 0) option.erase(0, 2);
    for (std::size_t a = 0; a < axes_.size(); ++a) {
      if (axes_[a].name == option)
        axes_[a].choices[at[a]].node->fail(error.problem(), error.remedy());
    }
    block_.fail(option + ": " + error.problem(), error.remedy());
  }

  void resolve(RunCell& cell, const Place& at) const {
    const lab::Workload& workload = *lab::find_workload(cell.workload);
    if (!workload.random) cell.parameters.seed = 1;
    try {
      cell.parameters = lab::resolved(workload, cell.parameters);
    } catch (const formats::InputError& error) {
      fail(error, error.place(), at);
    }
  }

  // Cells that differ in size and seed alone are of one kind.
  void note_kind(const RunCell& cell, const Place& at) {
    RunCell kind = cell;
    kind.parameters.n = kind.parameters.m = 1;
    kind.parameters.seed = 1;
    const auto [found, is_new] = kinds_.try_emplace(cell_text(kind), Example{cell, at});
    const auto size = [](const RunCell& one) { return one.parameters.n + one.parameters.m; };
    if (!is_new && size(cell) < size(found->second.cell)) found->second = {cell, at};
  }

  void check_scene(const Example& example) const {
    try {
      Scene scene = scene_of(example.cell);
      shorten(scene, example.cell);
      lab::arithmetic_option(example.cell.arithmetic, scene);
    } catch (const formats::InputError& error) {
      std::string option = error.place().empty() ? error.file() : error.place();
      if (error.file() != "--maintain") fail(error, std::move(option), example.at);
      fail_at_structure(example);
      fail(in_a_plan(error, example.cell), "structure", example.at);
    }
  }

  // Fails at the first of the cell's structures that its scene does not take, if it is one of them.
  void fail_at_structure(const Example& example) const {
    const RunCell& cell = example.cell;
    Scene scene = lab::generate_scene(*lab::find_workload(cell.workload), cell.parameters);
    const auto axis = std::find_if(axes_.begin(), axes_.end(),
                                   [](const Axis& one) { return one.name == "structure"; });
    const std::size_t chosen = example.at[static_cast<std::size_t>(axis - axes_.begin())];
    const formats::JsonNode& node = *axis->choices[chosen].node;
    for (std::size_t i = 0; i < cell.maintain.size(); ++i) {
      try {
        formats::set_maintain(scene, {cell.maintain.begin(),
                                      cell.maintain.begin() + static_cast<std::ptrdiff_t>(i) + 1});
      } catch (const formats::InputError& error) {
        const formats::InputError here = in_a_plan(error, cell);
        if (!node.is(formats::JsonValue::Kind::kArray)) fail_within(node, here.place(), here);
        const formats::JsonNode entry = node.at(i);
        fail_within(entry, here.place(), here);
      }
    }
  }

  const formats::JsonNode& block_;
  std::deque<formats::JsonNode> nodes_;
  std::vector<Axis> axes_;
  std::map<std::string, Example> kinds_;
};

}  // namespace

void too_many_cells(const formats::JsonNode& block) {
  block.fail("more than " + std::to_string(kMostCells) + " cells", "make two plans of it");
}

void expand_block(const formats::JsonNode& block, PlanCheck check,
                  const std::function<void(RunCell)>& take) {
  BlockReader(block).expand(check, take);
}

}  // namespace kinex::sweep
