// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/bench/ratios.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "experiments/formats/input_error.h"
#include "experiments/formats/json_document.h"
#include "experiments/lab/workload.h"

namespace kinex::bench {

namespace {

const std::vector<std::string>& kinds() {
  static const std::vector<std::string> kKinds{"points in random motion", "points full of ties",
                                               "points full of new plans", "worst cases",
                                               "collisions"};
  return kKinds;
}

std::size_t kind_of(const Ratio& ratio) {
  const lab::Workload* workload = lab::find_workload(ratio.scene);
  if (workload == nullptr) return 3;
  if (workload->bodies) return 4;
  switch (workload->scenes) {
    case lab::SceneKind::kRandom:
      return 0;
    case lab::SceneKind::kTies:
      return 1;
    case lab::SceneKind::kNewPlans:
      return 2;
    case lab::SceneKind::kWorst:
      break;
  }
  return 3;
}

struct Range {
  const Ratio* least = nullptr;
  const Ratio* most = nullptr;
  int rows = 0, astray = 0;

  void add(const Ratio& ratio) {
    ++rows;
    if (!(ratio.value > 0)) {
      ++astray;
      return;
    }
    if (least == nullptr || ratio.value < least->value) least = &ratio;
    if (most == nullptr || most->value < ratio.value) most = &ratio;
  }
};

std::string scene_text(const Ratio& ratio) {
  return fmt::format("{}, {}, degree {}, n = {}", ratio.structure, ratio.scene, ratio.degree,
                     ratio.n);
}

}  // namespace

std::vector<Ratio> exact_over_double(std::string_view lines, const std::string& file) {
  std::vector<Ratio> ratios;
  std::size_t begin = 0, number = 1;
  for (std::size_t end; (end = lines.find('\n', begin)) != lines.npos; begin = end + 1, ++number) {
    const formats::JsonDocument row_document =
        formats::parse_json(lines.substr(begin, end - begin), file, number);
    const formats::JsonValue& row = *row_document;
    const auto text = [&](const char* key) {
      const formats::JsonValue* found = row.find(key);
      return found == nullptr ? std::string() : std::string(found->text());
    };
    if (text("bench") != "speed" || text("arithmetic") != "exact" || text("first") != "double") {
      continue;
    }
    ratios.push_back({text("structure"), text("scene"), std::atoi(text("degree").c_str()),
                      std::atoi(text("n").c_str()),
                      std::strtod(text("time_over_first").c_str(), nullptr)});
  }
  return ratios;
}

std::string ratios_text(const std::vector<Ratio>& ratios) {
  if (ratios.empty()) return "";
  std::vector<Range> by_kind(kinds().size());
  std::vector<std::pair<std::pair<std::string, std::size_t>, Range>> by_structure;
  for (const Ratio& ratio : ratios) {
    const std::size_t kind = kind_of(ratio);
    by_kind[kind].add(ratio);
    const std::pair key(ratio.structure, kind);
    auto found = std::find_if(by_structure.begin(), by_structure.end(),
                              [&](const auto& one) { return one.first == key; });
    if (found == by_structure.end()) found = by_structure.insert(found, {key, {}});
    found->second.add(ratio);
  }
  std::string text =
      "\n## exact over double\n\nCPU time of whole runs in `exact` over the same structure in "
      "doubles, without log and digest, where both handle the same events:\n\n";
  for (std::size_t kind = 0; kind < by_kind.size(); ++kind) {
    const Range& range = by_kind[kind];
    if (range.rows == 0) continue;
    text += "- " + kinds()[kind] + ": ";
    if (range.most == nullptr) {
      text += "doubles handle other events in every row\n";
      continue;
    }
    text += fmt::format("{:.2f} to {:.2f}; worst: {}", range.least->value, range.most->value,
                        scene_text(*range.most));
    if (range.astray > 0) {
      text += fmt::format(" (in {} of {} rows doubles handle other events, or do not finish)",
                          range.astray, range.rows);
    }
    text += "\n";
  }
  text +=
      "\n| structure | scenes | rows | doubles astray | least | most | at |\n"
      "| --- | --- | ---: | ---: | ---: | ---: | --- |\n";
  for (const auto& [key, range] : by_structure) {
    text += fmt::format(
        "| {} | {} | {} | {} | {} | {} | {} |\n", key.first, kinds()[key.second], range.rows,
        range.astray, range.least == nullptr ? "-" : fmt::format("{:.2f}", range.least->value),
        range.most == nullptr ? "-" : fmt::format("{:.2f}", range.most->value),
        range.most == nullptr ? "-"
                              : fmt::format("{}, degree {}, n = {}", range.most->scene,
                                            range.most->degree, range.most->n));
  }
  return text;
}

}  // namespace kinex::bench
