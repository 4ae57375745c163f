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

#include "experiments/formats/input_error.h"
#include "experiments/lab/scene_run.h"
#include "experiments/sweep/canonical_json.h"

namespace kinex::sweep {

namespace {

constexpr int kMostInt = std::numeric_limits<int>::max();
constexpr int kMostAxes = 3;

// One value of an axis: its effect on a cell, and its place in the file.
struct Choice {
  std::function<void(Cell&)> set;
  const JsonNode* node;
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

std::string workload_names() {
  std::string text = "known are ";
  for (const Workload& workload : workloads()) {
    text += (&workload == &workloads().front() ? "" : ", ") + std::string(workload.name);
  }
  return text;
}

std::uint64_t read_seed(const JsonNode& node) {
  std::uint64_t seed = 0;
  const std::string& text = node.value().text;
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, seed);
  if (!node.is(JsonValue::Kind::kNumber) || error != std::errc() || rest != end) {
    node.refuse("a seed", "write an integer from 0 to 18446744073709551615");
  }
  return seed;
}

// An entry of "maintain", as set_maintain takes it.
std::string read_structure(const JsonNode& node) {
  if (node.is(JsonValue::Kind::kObject)) return canonical_json(node.value());
  if (!node.is(JsonValue::Kind::kString) || node.string().empty() ||
      node.string().find_first_of(",{} \t\r\n") != std::string::npos) {
    node.refuse("a structure",
                "write a name, NAME:AXIS, {\"structure\": NAME, ..}, or an array of these to be "
                "maintained in one run");
  }
  return node.string();
}

class BlockReader {
 public:
  explicit BlockReader(const JsonNode& block) : block_(block) {
    block.require_object({"structure", "workload", "n", "m", "degree", "dimension", "separation",
                          "turns", "seed", "arithmetic", "scheduling", "audit", "until",
                          "max_events"});
    block.member("n");
    structures(block.member("structure"));
    read_workloads(block.member("workload"));
    integers("n", 1, kMaxWorkloadSize, [](int value, Cell& cell) { cell.parameters.n = value; });
    integers("m", 1, kMaxWorkloadSize, [](int value, Cell& cell) { cell.parameters.m = value; });
    integers("degree", 1, kMaxWorkloadDegree,
             [](int value, Cell& cell) { cell.parameters.degree = value; });
    integers("dimension", 1, kMostAxes,
             [](int value, Cell& cell) { cell.parameters.dimension = value; });
    rationals("separation",
              [](const Rational& value, Cell& cell) { cell.parameters.separation = value; });
    integers("turns", 1, kMaxWorkloadTurns,
             [](int value, Cell& cell) { cell.parameters.turns = value; });
    seeds();
    for_each("arithmetic", [&](const JsonNode& node) {
      return [name = node.string()](Cell& cell) { cell.arithmetic = name; };
    });
    words("scheduling", {"lazy", "eager"}, &Cell::scheduling);
    words("audit", {"end", "events", "none"}, &Cell::audit);
    rationals("until", [](const Rational& value, Cell& cell) { cell.until = value; });
    integers("max_events", 1, kMostInt, [](int value, Cell& cell) { cell.max_events = value; });
  }

  void expand(PlanCheck check, const std::function<void(Cell)>& take) {
    std::size_t cells = 1;
    for (const Axis& axis : axes_) {
      cells *= axis.choices.size();
      if (cells > kMostCells) too_many_cells(block_);
    }
    std::vector<std::size_t> at(axes_.size(), 0);
    for (bool more = true; more;) {
      Cell cell;
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
    Cell cell;
    Place at;
  };

  // A child refers to its parent: both stay here.
  const JsonNode& keep(const JsonNode& node) { return nodes_.emplace_back(node); }

  template <class MakeSetter>
  void add(std::string_view name, const JsonNode& given, const MakeSetter& setter) {
    Axis axis{name, {}};
    const JsonNode& node = keep(given);
    if (!node.is(JsonValue::Kind::kArray)) {
      axis.choices.push_back({setter(node), &node});
    } else {
      if (node.size() == 0) node.fail("an axis without values", "write one, or leave it out");
      for (std::size_t i = 0; i < node.size(); ++i) {
        const JsonNode& one = keep(node.at(i));
        axis.choices.push_back({setter(one), &one});
      }
    }
    axes_.push_back(std::move(axis));
  }
  template <class MakeSetter>
  void for_each(std::string_view name, const MakeSetter& setter) {
    if (const auto node = block_.find(name)) add(name, *node, setter);
  }

  void structures(const JsonNode& given) {
    add("structure", given, [&](const JsonNode& node) {
      std::vector<std::string> entries;
      if (node.is(JsonValue::Kind::kArray)) {
        if (node.size() == 0) node.fail("nothing is to be maintained", "write a structure");
        for (std::size_t i = 0; i < node.size(); ++i) entries.push_back(read_structure(node.at(i)));
      } else {
        entries.push_back(read_structure(node));
      }
      const bool alone = node.is(JsonValue::Kind::kArray) && node.size() == 1;
      const JsonValue& value = alone ? node.value().items[0] : node.value();
      return [text = canonical_json(value), entries](Cell& cell) {
        cell.structure = text;
        cell.maintain = entries;
      };
    });
  }

  void read_workloads(const JsonNode& given) {
    add("workload", given, [](const JsonNode& node) {
      const std::string& name = node.string();
      if (find_workload(name) == nullptr) node.refuse("a workload", workload_names());
      return [name](Cell& cell) { cell.workload = name; };
    });
  }

  template <class Set>
  void integers(std::string_view name, int low, int high, Set set) {
    for_each(name, [&](const JsonNode& node) {
      return [value = node.integer(low, high), set](Cell& cell) { set(value, cell); };
    });
  }
  template <class Set>
  void rationals(std::string_view name, Set set) {
    for_each(name, [&](const JsonNode& node) {
      return [value = node.rational(), set](Cell& cell) { set(value, cell); };
    });
  }
  void words(std::string_view name, std::initializer_list<const char*> known,
             std::string Cell::*member) {
    for_each(name, [&](const JsonNode& node) {
      const std::string word = node.string();
      if (std::find(known.begin(), known.end(), word) == known.end()) {
        node.refuse("known here", quoted_list(known));
      }
      return [word, member](Cell& cell) { cell.*member = word; };
    });
  }

  void seeds() {
    const auto given = block_.find("seed");
    if (!given) return;
    const auto setter = [](std::uint64_t seed) {
      return [seed](Cell& cell) { cell.parameters.seed = seed; };
    };
    if (!given->is(JsonValue::Kind::kObject)) {
      add("seed", *given, [&](const JsonNode& node) { return setter(read_seed(node)); });
      return;
    }
    const JsonNode& node = keep(*given);
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
  [[noreturn]] void fail(const InputError& error, std::string option, const Place& at) const {
    if (option.rfind("--", 0) == 0) option.erase(0, 2);
    for (std::size_t a = 0; a < axes_.size(); ++a) {
      if (axes_[a].name == option)
        axes_[a].choices[at[a]].node->fail(error.problem(), error.remedy());
    }
    block_.fail(option + ": " + error.problem(), error.remedy());
  }

  void resolve(Cell& cell, const Place& at) const {
    const Workload& workload = *find_workload(cell.workload);
    if (!workload.random) cell.parameters.seed = 1;
    try {
      cell.parameters = resolved(workload, cell.parameters);
    } catch (const InputError& error) {
      fail(error, error.place(), at);
    }
  }

  // Cells that differ in size and seed alone are of one kind.
  void note_kind(const Cell& cell, const Place& at) {
    Cell kind = cell;
    kind.parameters.n = kind.parameters.m = 1;
    kind.parameters.seed = 1;
    const auto [found, is_new] = kinds_.try_emplace(cell_text(kind), Example{cell, at});
    const auto size = [](const Cell& one) { return one.parameters.n + one.parameters.m; };
    if (!is_new && size(cell) < size(found->second.cell)) found->second = {cell, at};
  }

  void check_scene(const Example& example) const {
    try {
      Scene scene = scene_of(example.cell);
      shorten(scene, example.cell);
      arithmetic_option(example.cell.arithmetic, scene);
    } catch (const InputError& error) {
      std::string option = error.place().empty() ? error.file() : error.place();
      if (error.file() == "--maintain") option = "structure";
      fail(error, std::move(option), example.at);
    }
  }

  const JsonNode& block_;
  std::deque<JsonNode> nodes_;
  std::vector<Axis> axes_;
  std::map<std::string, Example> kinds_;
};

}  // namespace

void too_many_cells(const JsonNode& block) {
  block.fail("more than " + std::to_string(kMostCells) + " cells", "make two plans of it");
}

void expand_block(const JsonNode& block, PlanCheck check, const std::function<void(Cell)>& take) {
  BlockReader(block).expand(check, take);
}

}  // namespace kinex::sweep
