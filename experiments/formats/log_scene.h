// SPDX-License-Identifier: GPL-3.0-or-later
// Checks that an event log belongs to a scene and that the scene maintains the log's structures.
#ifndef KINEX_EXPERIMENTS_FORMATS_LOG_SCENE_H
#define KINEX_EXPERIMENTS_FORMATS_LOG_SCENE_H

#include <string>

#include "core/motion/scene.h"
#include "experiments/formats/log_reader.h"

namespace kinex::formats {

// Throws InputError if the log is of a scene with another hash.
void require_same_scene(const LogHeader& header, const std::string& file, const std::string& hash);
// True if the scene maintains the log's structures, with the same labels and keys.
bool maintains_as_logged(const Scene& scene, const LogHeader& header);
// Replaces the scene's "maintain" by the log's structures. Throws InputError that names the log.
void maintain_as_logged(Scene& scene, const LogHeader& header, const std::string& file);
// "a, b": the labels; of the structures of a log, or of a run of the scene.
std::string structures_of(const LogHeader& header);
std::string structures_of(const Scene& scene);

}  // namespace kinex::formats

#endif
