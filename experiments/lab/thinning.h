// SPDX-License-Identifier: GPL-3.0-or-later
// Thinning: fewer objects of a scene that stand for all of them (`kinex thin`).
#ifndef KINEX_EXPERIMENTS_LAB_THINNING_H
#define KINEX_EXPERIMENTS_LAB_THINNING_H

#include <string>

#include "core/motion/scene.h"
#include "core/numbers/rational.h"

namespace kinex::lab {

struct ThinnedScene {
  Scene scene;
  std::string guarantee;  // what it has of the whole scene, in words
};

// A method of a family.
struct Thinning {
  Rational (*least_error)();  // of those that it takes: from this, less than 1
  // Why it does not take the scene: problem and remedy, parted by "; "; empty if it does.
  std::string (*refusal)(const Scene& scene);
  // Requires an empty refusal, and an error that it takes.
  ThinnedScene (*thin)(const Scene& scene, const Rational& error);
};

}  // namespace kinex::lab

#endif
