// SPDX-License-Identifier: GPL-3.0-or-later
// Runs one scene through every structure that accepts it, and compares the results that must agree.
#ifndef KINEX_TESTS_FAMILIES_CHECK_SCENE_H
#define KINEX_TESTS_FAMILIES_CHECK_SCENE_H

#include <string>
#include <vector>

#include "tests/families/family.h"

namespace kinex::families {

struct SceneCheck {
  // Arithmetics beside `exact`. `sturm` must report the same events as `exact`; the others must
  // end.
  std::vector<std::string> arithmetics{"sturm"};
  // In these the attribute must change as in `exact`: for scenes without close instants.
  std::vector<std::string> faithful;
  double max_seconds = 20;  // of one run
};

// `text` is a scene as JSON without "maintain". Rules, for every structure that the reader accepts
// for it:
//   - `exact`, audited after every event, ends without a violation and with every bound held;
//   - `sturm` reports the same events (kinds, objects, external or not) in the same order;
//   - an inexact arithmetic ends, and reports corruption, never throws;
//   - structures of one attribute report the same external events in the same order.
// Scenes are refused by an InputError only.
void check_scene(const std::string& text, const SceneCheck& what, Tally& tally);

}  // namespace kinex::families

#endif
