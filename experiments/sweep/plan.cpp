// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/sweep/plan.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <utility>

#include "experiments/formats/file_io.h"
#include "experiments/formats/input_error.h"
#include "experiments/formats/json_node.h"
#include "experiments/formats/sha256.h"
#include "experiments/sweep/block.h"
#include "experiments/sweep/canonical_json.h"

namespace kinex::sweep {

namespace {

constexpr int kMostSeconds = 100000000;
constexpr int kMostMegabytes = 1 << 30;
constexpr int kFewestMegabytes = 16;  // what the program itself needs

void read_version(const JsonNode& root) {
  const JsonNode version = root.member("kinex_plan");
  if (!version.is(JsonValue::Kind::kNumber) || version.value().text != "1") {
    version.refuse("a version of plans that is known", "write \"kinex_plan\": 1");
  }
}

Limits read_limits(const JsonNode& node) {
  node.require_object({"seconds", "megabytes"});
  Limits limits;
  if (const auto seconds = node.find("seconds")) limits.seconds = seconds->integer(1, kMostSeconds);
  if (const auto megabytes = node.find("megabytes")) {
    limits.megabytes = megabytes->integer(kFewestMegabytes, kMostMegabytes);
  }
  return limits;
}

PlannedCell planned(Cell cell) {
  PlannedCell result;
  result.text = cell_text(cell);
  result.key = sha256_hex(result.text);
  result.cost = expected_cost(cell);
  result.cell = std::move(cell);
  return result;
}

void sort_and_unite(std::vector<PlannedCell>& cells) {
  std::sort(cells.begin(), cells.end(), [](const PlannedCell& a, const PlannedCell& b) {
    return a.cost != b.cost ? a.cost > b.cost : a.key < b.key;
  });
  const auto same = [](const PlannedCell& a, const PlannedCell& b) { return a.key == b.key; };
  cells.erase(std::unique(cells.begin(), cells.end(), same), cells.end());
}

}  // namespace

Plan parse_plan(std::string_view text, const std::string& file, PlanCheck check) {
  const JsonValue tree = parse_json(text, file);
  const JsonSource source{file, text};
  const JsonNode root(tree, source);
  root.require_object({"kinex_plan", "name", "description", "blocks", "limits", "$schema"});
  read_version(root);
  Plan plan;
  plan.name = root.member("name").string();
  for (const char* words : {"description", "$schema"}) {
    if (const auto field = root.find(words)) field->string();
  }
  if (const auto limits = root.find("limits")) plan.limits = read_limits(*limits);
  const JsonNode blocks = root.member("blocks");
  blocks.require_array();
  if (blocks.size() == 0) blocks.fail("a plan without blocks", "write one");
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    const JsonNode block = blocks.at(i);
    expand_block(block, check, [&](Cell cell) {
      if (plan.cells.size() == kMostCells) too_many_cells(block);
      plan.cells.push_back(planned(std::move(cell)));
    });
  }
  sort_and_unite(plan.cells);
  plan.text = canonical_json(tree);
  plan.hash = sha256_hex(plan.text);
  return plan;
}

Plan read_plan(const std::string& path) {
  return parse_plan(read_text_file(path), path, PlanCheck::kScenes);
}

Cell parse_cell(std::string_view text, const std::string& file) {
  const JsonValue tree = parse_json(text, file);
  const JsonSource source{file, text};
  const JsonNode root(tree, source);
  std::optional<Cell> found;
  expand_block(root, PlanCheck::kFormOnly, [&](Cell cell) {
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
  throw InputError("--shard", "", show_text(text) + " is not a shard",
                   "write I/N, I from 0 to N - 1: 0/4 is the first of four");
}

std::string shard_text(const Shard& shard) {
  return std::to_string(shard.index) + "/" + std::to_string(shard.count);
}

std::vector<PlannedCell> shard_of(const Plan& plan, const Shard& shard) {
  std::vector<PlannedCell> cells;
  const auto step = static_cast<std::size_t>(shard.count);
  for (std::size_t i = static_cast<std::size_t>(shard.index); i < plan.cells.size(); i += step) {
    cells.push_back(plan.cells[i]);
  }
  return cells;
}

}  // namespace kinex::sweep
