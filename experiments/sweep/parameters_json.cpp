// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/sweep/parameters_json.h"

#include <charconv>
#include <cstdint>
#include <string>

namespace kinex::sweep {

void write_parameters(formats::JsonWriter& json, const lab::WorkloadParameters& parameters) {
  json.key("n").number(parameters.n).key("seed").number(parameters.seed);
  json.key("degree").number(parameters.degree).key("dimension").number(parameters.dimension);
  if (parameters.m != 0) json.key("m").number(parameters.m);
  if (parameters.separation) json.key("separation").quoted(*parameters.separation);
  if (parameters.turns != -1) json.key("turns").number(parameters.turns);
}

lab::WorkloadParameters read_parameters(const formats::JsonNode& node) {
  lab::WorkloadParameters parameters;
  parameters.n = node.member("n").integer(1, lab::kMaxWorkloadSize);
  const formats::JsonNode seed = node.member("seed");
  const std::string_view text = seed.value().text();
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, parameters.seed);
  if (error != std::errc() || rest != end) seed.refuse("a seed", "a whole number from 0 on");
  parameters.degree = node.member("degree").integer(0, lab::kMaxWorkloadDegree);
  parameters.dimension = node.member("dimension").integer(0, 3);
  if (const auto m = node.find("m")) parameters.m = m->integer(1, lab::kMaxWorkloadSize);
  if (const auto separation = node.find("separation")) {
    parameters.separation = separation->rational();
  }
  if (const auto turns = node.find("turns")) {
    parameters.turns = turns->integer(0, lab::kMaxWorkloadTurns);
  }
  return parameters;
}

}  // namespace kinex::sweep
