// SPDX-License-Identifier: GPL-3.0-or-later
// Writes a scene in one canonical form, and identifies it by the SHA-256 of that form.
#ifndef KINEX_EXPERIMENTS_FORMATS_SCENE_WRITER_H
#define KINEX_EXPERIMENTS_FORMATS_SCENE_WRITER_H

#include <string>

#include "core/motion/scene.h"
#include "experiments/formats/json_writer.h"
#include "experiments/formats/scene_words.h"

namespace kinex::formats {

// JSON, one object per line; equal scenes give equal bytes, and parse_scene reads the same scene
// back. Integers below 2^53 are bare numbers, everything else a string in lowest terms.
std::string write_scene(const Scene& scene);
// The same with the members that no run looks at; the hash is of the text without them.
std::string write_scene(const Scene& scene, const SceneWords& words);

// SHA-256 of write_scene: independent of formatting and of how numbers were written in the file.
std::string scene_hash(const Scene& scene);

// An entry of "maintain" as JSON.
std::string request_json(const Request& request, const Scene& scene);
// What the request says beside structure, key and label, as a JSON object; empty: nothing.
std::string options_json(const Request& request, const Scene& scene);
// A key as JSON: "x", {"direction": [..]}, {"squared_distance_to": ID}.
std::string key_json(const Key& key, const Scene& scene);
// "jumps" and "overlapping_starts", if they are not as usual, into the open object.
void write_choices(JsonWriter& json, const Scene& scene);
// "queries", if there are any.
void write_queries(JsonWriter& json, const Scene& scene);

}  // namespace kinex::formats

#endif
