// SPDX-License-Identifier: GPL-3.0-or-later
// The commands that make a workload's scene again, run it, and show it.
#ifndef KINEX_EXPERIMENTS_LAB_SCENE_COMMAND_H
#define KINEX_EXPERIMENTS_LAB_SCENE_COMMAND_H

#include <string>

#include "experiments/lab/workload.h"

namespace kinex::lab {

// "kinex gen WORKLOAD .. -o scene.json", "kinex run scene.json ..", "kinex view scene.json ..", a line
// each. The scene's file is that of generate_scene with these arguments, byte by byte.
std::string scene_commands(const std::string& workload, const WorkloadParameters& parameters,
                           const std::string& structure);

}  // namespace kinex::lab

#endif
