// SPDX-License-Identifier: GPL-3.0-or-later
// SceneWords: the members of a scene's file that are for people and tests; no run looks at them.
#ifndef KINEX_EXPERIMENTS_FORMATS_SCENE_WORDS_H
#define KINEX_EXPERIMENTS_FORMATS_SCENE_WORDS_H

#include <optional>
#include <string>

#include "experiments/formats/json_node.h"
#include "experiments/formats/json_writer.h"

namespace kinex::formats {

struct SceneWords {
  std::optional<std::string> schema, source, description;
  std::string expect;  // canonical JSON; empty: none
};

// "$schema", "source", "description" and "expect" of an object, those that are there.
SceneWords read_words(const JsonNode& node);
// Writes them into the open object.
void write_words(JsonWriter& json, const SceneWords& words);

}  // namespace kinex::formats

#endif
