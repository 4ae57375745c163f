// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/sweep/plan.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <utility>

#include "experiments/formats/canonical_json.h"
#include "experiments/formats/file_io.h"
#include "experiments/formats/input_error.h"
#include "experiments/formats/json_node.h"
#include "experiments/formats/json_writer.h"
#include "experiments/formats/sha256.h"
#include "experiments/formats/utf8.h"
#include "experiments/sweep/block.h"

namespace kinex::sweep {

namespace {

constexpr int kMostSeconds = 100000000;
constexpr int kMostMegabytes = 1 << 30;
constexpr int kFewestMegabytes = 16;  // what the program itself needs

void read_version(const formats::JsonNode& root) {
  const formats::JsonNode version = root.member("kinex_plan");
  if (!version.is(formats::JsonValue::Kind::kNumber) || version.value().text() != "1") {
    version.refuse("a version of plans that is known", "write \"kinex_plan\": 1");
  }
}

Limits read_limits(const formats::JsonNode& node) {
  node.require_object({"seconds", "megabytes"});
  Limits limits;
  if (const auto seconds = node.find("seconds")) limits.seconds = seconds->integer(1, kMostSeconds);
  if (const auto megabytes = node.find("megabytes")) {
    limits.megabytes = megabytes->integer(kFewestMegabytes, kMostMegabytes);
  }
  return limits;
}

PlanCell planned(const RunCell& cell) {
  return make_cell(cell.structure + " " + cell.arithmetic, cell_text(cell), expected_cost(cell));
}

void read_blocks(const formats::JsonNode& blocks, PlanCheck check, std::vector<PlanCell>& cells) {
  blocks.require_array();
  if (blocks.size() == 0) blocks.fail("a plan without blocks", "write one");
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    const formats::JsonNode block = blocks.at(i);
    expand_block(block, check, [&](const RunCell& cell) {
      if (cells.size() == kMostCells) too_many_cells(block);
      cells.push_back(planned(cell));
    });
  }
}

std::vector<std::string> read_strings(const formats::JsonNode& node) {
  node.require_array();
  std::vector<std::string> strings;
  for (std::size_t i = 0; i < node.size(); ++i) strings.emplace_back(node.at(i).string());
  return strings;
}

void read_selection(const formats::JsonNode& node, const Experiments& experiments,
                    std::vector<PlanCell>& cells) {
  node.require_object({"experiment", "names", "quick", "options"});
  Selection selection;
  const formats::JsonNode name = node.member("experiment");
  selection.experiment = name.string();
  const Experiment* experiment = experiments.find(selection.experiment);
  if (experiment == nullptr) {
    std::string names;
    for (const Experiment& known : experiments.all) {
      names += (names.empty() ? "" : ", ") + known.name;
    }
    name.refuse("an experiment", names);
  }
  if (const auto names = node.find("names")) selection.names = read_strings(*names);
  if (const auto quick = node.find("quick")) selection.quick = quick->boolean();
  if (const auto options = node.find("options")) {
    if (!options->is(formats::JsonValue::Kind::kObject))
      options->refuse("options", "write {\"seeds\": [\"8\"]}");
    for (const formats::JsonValue& key : options->value().keys()) {
      const std::string option(key.text());
      selection.options[option] = read_strings(options->member(option));
    }
  }
  cells = experiment->cells(selection);
}

void sort_and_unite(std::vector<PlanCell>& cells) {
  std::sort(cells.begin(), cells.end(), [](const PlanCell& a, const PlanCell& b) {
    return a.cost != b.cost ? a.cost > b.cost : a.key < b.key;
  });
  const auto same = [](const PlanCell& a, const PlanCell& b) { return a.key == b.key; };
  cells.erase(std::unique(cells.begin(), cells.end(), same), cells.end());
}

}  // namespace

Plan parse_plan(std::string_view text, const std::string& file, PlanCheck check,
                const Experiments& experiments) {
  const formats::JsonDocument document = formats::parse_json(text, file);
  const formats::JsonValue& tree = *document;
  const formats::JsonSource source{file, text};
  const formats::JsonNode root(tree, source);
  if (root.is(formats::JsonValue::Kind::kObject) && root.find("kinex") && !root.find("kinex_plan")) {
    root.fail("this is a scene, not a plan",
              "run the scene by kinex run; a plan names workloads, of which kinex sweep run makes scenes (kinex help sweep)");
  }
  root.require_object(
      {"kinex_plan", "name", "description", "blocks", "select", "limits", "$schema"});
  read_version(root);
  Plan plan;
  plan.name = root.member("name").string();
  for (const char* words : {"description", "$schema"}) {
    if (const auto field = root.find(words)) field->string();
  }
  if (const auto limits = root.find("limits")) plan.limits = read_limits(*limits);
  if (const auto selection = root.find("select")) {
    if (root.find("blocks")) root.fail("both blocks and a selection", "make two plans of it");
    read_selection(*selection, experiments, plan.cells);
  } else {
    read_blocks(root.member("blocks"), check, plan.cells);
  }
  sort_and_unite(plan.cells);
  plan.text = formats::canonical_json(tree);
  plan.hash = formats::sha256_hex(plan.text);
  return plan;
}

Plan read_plan(const std::string& path, const Experiments& experiments) {
  return parse_plan(formats::read_text_file(path), path, PlanCheck::kScenes, experiments);
}

PlanText plan_text(const Selection& selection) {
  std::string text;
  formats::JsonWriter json(text);
  const auto strings = [&](const std::vector<std::string>& values) {
    json.begin_array();
    for (const std::string& value : values) json.string(formats::utf8_or_shown(value));
    json.end_array();
  };
  json.begin_object()
      .key("kinex_plan")
      .number(1)
      .key("name")
      .string(formats::utf8_or_shown(selection.command()));
  json.key("select").begin_object().key("experiment").string(selection.experiment);
  json.key("names");
  strings(selection.names);
  json.key("quick").boolean(selection.quick).key("options").begin_object();
  for (const auto& [option, values] : selection.options) {
    json.key(formats::utf8_or_shown(option));
    strings(values);
  }
  json.end_object().end_object().end_object();
  PlanText plan;
  plan.name = selection.command();
  plan.text = formats::canonical_json(*formats::parse_json(text, "a plan"));
  plan.hash = formats::sha256_hex(plan.text);
  return plan;
}

Plan plan_of(const Selection& selection, const Experiments& experiments) {
  return parse_plan(plan_text(selection).text, selection.command(), PlanCheck::kFormOnly,
                    experiments);
}

RunCell parse_cell(std::string_view text, const std::string& file) {
  const formats::JsonDocument document = formats::parse_json(text, file);
  const formats::JsonValue& tree = *document;
  const formats::JsonSource source{file, text};
  const formats::JsonNode root(tree, source);
  std::optional<RunCell> found;
  expand_block(root, PlanCheck::kFormOnly, [&](RunCell cell) {
    if (found) root.fail("more than one cell", "write one value for each member");
    found = std::move(cell);
  });
  return *std::move(found);
}

Shard parse_shard(const std::string& text) {
  const auto number = [](std::string_view digits) -> std::optional<int> {
    int value = 0;
    const char* const end = digits.data() + digits.size();
    const auto [rest, error] = std::from_chars(digits.data(), end, value);
    if (error != std::errc() || rest != end) return std::nullopt;
    return value;
  };
  const std::size_t slash = text.find('/');
  if (slash != std::string::npos) {
    const auto index = number(std::string_view(text).substr(0, slash));
    const auto count = number(std::string_view(text).substr(slash + 1));
    if (index && count && *index >= 0 && *index < *count && *count <= kMostShards) {
      return {*index, *count};
    }
  }
  throw formats::InputError("--shard", "", show_text(text) + " is not a shard",
                   "write I/N, I from 0 to N - 1: 0/4 is the first of four");
}

std::string shard_text(const Shard& shard) {
  return std::to_string(shard.index) + "/" + std::to_string(shard.count);
}

std::vector<PlanCell> shard_of(const Plan& plan, const Shard& shard) {
  std::vector<PlanCell> cells;
  const auto step = static_cast<std::size_t>(shard.count);
  for (std::size_t i = static_cast<std::size_t>(shard.index); i < plan.cells.size(); i += step) {
    cells.push_back(plan.cells[i]);
  }
  return cells;
}

}  // namespace kinex::sweep
