// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/formats/log_pairs.h"

#include <algorithm>
#include <optional>
#include <string_view>

#include "experiments/formats/canonical_json.h"
#include "experiments/formats/input_error.h"
#include "experiments/formats/json_document.h"
#include "structures/registry.h"

namespace kinex::formats {

namespace {

// A structure as "maintain" or "over" names it: a name, or an object with its options; nullptr: none.
struct Named {
  const StructureInfo* info;
  const JsonValue* options;

  const JsonValue* find(std::string_view name) const {
    return options == nullptr ? nullptr : options->find(name);
  }
};

std::string canonical(const JsonValue* value) {
  return value == nullptr ? "" : canonical_json(*value);
}

std::string_view value_of(const ParameterInfo& parameter, const Named& structure) {
  const JsonValue* const value = structure.find(parameter.name);
  return value == nullptr ? parameter.usual : value->text();
}

// What "over" names, or what is read without it; no info: nothing can be chosen.
Named chosen(const Named& structure) {
  const Reading* const reading = reading_of_choice(*structure.info);
  if (reading == nullptr) return {nullptr, nullptr};
  const JsonValue* const over = structure.find("over");
  if (over == nullptr) return {find_structure_info(reading->structure), nullptr};
  const JsonValue* const name = over->find("structure");
  return {find_structure_info((name == nullptr ? over : name)->text()),
          name == nullptr ? nullptr : over};
}

// The values of parameters that both have are the same, and those of what both let choose.
bool are_alike(const Named& a, const Named& b) {
  for (const ParameterInfo& one : a.info->parameters) {
    for (const ParameterInfo& other : b.info->parameters) {
      if (one.name == other.name && value_of(one, a) != value_of(other, b)) return false;
    }
  }
  const Named over_a = chosen(a), over_b = chosen(b);
  return over_a.info == nullptr || over_b.info == nullptr || are_alike(over_a, over_b);
}

bool is_same(const LogStructure& a, const LogStructure& b) {
  return a.structure == b.structure && a.key == b.key && a.options == b.options;
}

// Both maintain the same attribute. A name that this program does not know is like itself alone.
bool has_same_attribute(const LogStructure& a, const LogStructure& b) {
  if (is_same(a, b)) return true;
  const StructureInfo* const info_a = find_structure_info(a.structure);
  const StructureInfo* const info_b = find_structure_info(b.structure);
  if (info_a == nullptr || info_b == nullptr || a.key != b.key) return false;
  if (info_a != info_b && (info_a->group.empty() || info_a->group != info_b->group)) return false;
  std::optional<JsonDocument> text_a, text_b;
  if (!a.options.empty()) text_a = parse_json(a.options, "");
  if (!b.options.empty()) text_b = parse_json(b.options, "");
  const Named one{info_a, text_a ? &text_a->root() : nullptr};
  const Named other{info_b, text_b ? &text_b->root() : nullptr};
  for (const std::string_view objects : {"of", "query", "colours"}) {
    if (canonical(one.find(objects)) != canonical(other.find(objects))) return false;
  }
  return are_alike(one, other);
}

// "delaunay_2, sorted_list by "x"": with key and parameters where `other` has the same structure.
std::string described(const LogHeader& header, const LogHeader& other) {
  std::string text;
  for (const LogStructure& one : header.structures) {
    text += (text.empty() ? "" : ", ") + one.structure;
    const bool in_both =
        std::any_of(other.structures.begin(), other.structures.end(),
                    [&](const LogStructure& there) { return there.structure == one.structure; });
    if (!in_both) continue;
    if (!one.key.empty()) text += " by " + one.key;
    if (!one.options.empty()) text += " with " + one.options;
  }
  return text;
}

}  // namespace

LogPairs pair_structures(const LogHeader& a, const std::string& file_a, const LogHeader& b,
                         const std::string& file_b, Compared compared) {
  LogPairs pairs;
  const auto pair_up = [&](const auto& fits) {
    for (const LogStructure& one : a.structures) {
      for (const LogStructure& other : b.structures) {
        if (pairs.labels_a.contains(one.label) || pairs.labels_b.contains(other.label) ||
            !fits(one, other)) {
          continue;
        }
        pairs.labels_a.emplace(one.label, one.label);
        pairs.labels_b.emplace(other.label, one.label);
        if (one.label != other.label) pairs.other_labels.push_back({one.label, other.label});
      }
    }
  };
  pair_up([](const LogStructure& one, const LogStructure& other) {
    return one.label == other.label && is_same(one, other);
  });
  if (compared == Compared::kAttributes) {
    pair_up([](const LogStructure& one, const LogStructure& other) {
      return one.label == other.label && has_same_attribute(one, other);
    });
  }
  pair_up(is_same);
  if (compared == Compared::kAttributes) pair_up(has_same_attribute);
  for (const LogStructure& one : a.structures) {
    if (!pairs.labels_a.contains(one.label)) pairs.only_a.push_back(one.label);
  }
  for (const LogStructure& one : b.structures) {
    if (!pairs.labels_b.contains(one.label)) pairs.only_b.push_back(one.label);
  }
  if (pairs.labels_a.empty() && !(pairs.only_a.empty() && pairs.only_b.empty())) {
    const bool attributes = compared == Compared::kAttributes;
    throw InputError(
        file_b, "line 1",
        std::string(attributes ? "it has no attribute in common with "
                               : "it has no structure in common with ") +
            file_a + ": it maintains " + described(b, a) + ", the other " + described(a, b),
        attributes ? "compare runs of structures for one attribute (kinex list structures has "
                     "their groups), by the same key and with the same parameters"
                   : "compare runs with a structure in common, by the same key and with the same "
                     "parameters; --attributes compares structures for one attribute");
  }
  return pairs;
}

}  // namespace kinex::formats
