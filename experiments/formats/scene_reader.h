// SPDX-License-Identifier: GPL-3.0-or-later
// Reads a scene: JSON of the form of schemas/scene.schema.json, to a core Scene.
//
// Numbers are read exactly as written: decimals, fractions or hexadecimal binary64. Everything that
// a run relies on is checked here: ids, dimensions, pieces and their continuity, polygons and
// rotors, bodies apart at the start, the structures to maintain. A returned scene is valid;
// anything else throws InputError with file, JSON path, offending text and remedy. Unknown fields
// are refused.
#ifndef KINEX_EXPERIMENTS_FORMATS_SCENE_READER_H
#define KINEX_EXPERIMENTS_FORMATS_SCENE_READER_H

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "core/motion/scene.h"
#include "core/numbers/stop.h"

namespace kinex::formats {

inline constexpr int kMaxDimension = 3;
inline constexpr int kMaxMotionDegree = 1000;
inline constexpr int kMaxRotorDegree = 100;
inline constexpr int kMaxExtentDegree = 100;
inline constexpr std::size_t kMaxIdLength = 1000;  // characters

// `file` is for messages only. `deadline` is polled between numbers (null: none); one number takes
// a fraction of a second at most.
Scene parse_scene(std::string_view text, const std::string& file, Deadline* deadline = nullptr);
// "-" reads standard input.
Scene read_scene(const std::string& path, Deadline* deadline = nullptr);

// Replaces scene.maintain by the values of --maintain, one or several texts: entries with commas
// between them. An entry is a name, a name and a coordinate to order by ("sorted_list:y", which is
// then the label too), or a JSON object as in a scene. Throws InputError that names the option.
void set_maintain(Scene& scene, const std::vector<std::string>& texts);

}  // namespace kinex::formats

#endif
