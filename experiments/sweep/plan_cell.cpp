// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/sweep/plan_cell.h"

#include <utility>

#include "experiments/formats/canonical_json.h"
#include "experiments/formats/json_document.h"
#include "experiments/formats/sha256.h"

namespace kinex::sweep {

PlanCell make_cell(std::string kind, const std::string& json, std::uint64_t cost) {
  PlanCell cell;
  cell.kind = std::move(kind);
  cell.text = formats::canonical_json(*formats::parse_json(json, "a cell"));
  cell.key = formats::sha256_hex(cell.text);
  cell.cost = cost;
  return cell;
}

}  // namespace kinex::sweep
