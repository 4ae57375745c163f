// SPDX-License-Identifier: GPL-3.0-or-later
// SceneChange: a change of a workload's scenes that an experiment makes, and `kinex gen` does not.
#ifndef KINEX_EXPERIMENTS_LAB_SCENE_CHANGE_H
#define KINEX_EXPERIMENTS_LAB_SCENE_CHANGE_H

#include <string_view>

namespace kinex {
struct Scene;
}  // namespace kinex

namespace kinex::lab {

// Each is a constant of a family. Equal names, numbers and scenes give equal scenes.
struct SceneChange {
  std::string_view name;               // an adjective, for names of scenes and for records
  void (*apply)(Scene& scene, int k);  // k: the number of the scene in its experiment, from 0
};

}  // namespace kinex::lab

#endif
