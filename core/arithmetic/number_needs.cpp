// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/arithmetic/number_needs.h"

#include <algorithm>

#include "core/numbers/check.h"

namespace kinex {

void NumberNeeds::add(const DerivedKind& kind) {
  require(kind.axes >= 1 && kind.axes <= kMostAxes, "derived objects of too many axes");
  if (std::find(derived.begin(), derived.end(), kind) != derived.end()) return;
  axes = std::max(axes, kind.axes);
  degree = std::max(degree, kind.degree);
  anchored = anchored || kind.anchored;
  derived.push_back(kind);
}

void NumberNeeds::add_weights(const Scene& scene) {
  require(!scene.has_bodies(), "bodies have no weights");
  weights = true;
  axes = std::max(axes, scene.dimension + 1);
  degree = std::max(degree, scene.degree());
}

NumberNeeds needs_of_objects(const Scene& scene) {
  NumberNeeds needs;
  needs.axes = scene.axes_without_weights();
  needs.degree = scene.degree_without_weights();
  return needs;
}

}  // namespace kinex
