// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/formats/scene_words.h"

#include <utility>

#include "experiments/formats/canonical_json.h"

namespace kinex::formats {

namespace {

constexpr const char* kSchema = "$schema";
constexpr const char* kSource = "source";
constexpr const char* kDescription = "description";
constexpr const char* kExpect = "expect";

}  // namespace

SceneWords read_words(const JsonNode& node) {
  SceneWords words;
  for (const auto& [name, text] : {std::pair(kSchema, &words.schema),
                                   {kSource, &words.source},
                                   {kDescription, &words.description}}) {
    if (const auto member = node.find(name)) *text = member->string();
  }
  if (const auto expect = node.find(kExpect)) words.expect = canonical_json(expect->value());
  return words;
}

void write_words(JsonWriter& json, const SceneWords& words) {
  if (words.schema) json.key(kSchema).string(*words.schema);
  if (words.source) json.key(kSource).string(*words.source);
  if (words.description) json.key(kDescription).string(*words.description);
  if (!words.expect.empty()) json.key(kExpect).raw(words.expect);
}

}  // namespace kinex::formats
