// SPDX-License-Identifier: GPL-3.0-or-later
// NumberNeeds: what the numbers of a run have to hold. The scene's objects need their axes and the
// degree of their motions; structures add the weights that they read and the objects that they derive
// (structures/plan.h). An arithmetic is made for the sum: what nobody needs has no room in it.
#ifndef KINEX_CORE_ARITHMETIC_NUMBER_NEEDS_H
#define KINEX_CORE_ARITHMETIC_NUMBER_NEEDS_H

#include <string>
#include <vector>

#include "core/motion/scene.h"

namespace kinex {

// Derived objects of one construction.
struct DerivedKind {
  std::string name;  // of the construction
  int axes = 1;
  int degree = 0;  // the largest, for the motions of the scene
  // The coefficients cancel far from t = 0: motions are also kept in t less a time near now, shifted
  // exactly. Such scenes have no machine integers.
  bool anchored = false;
  friend bool operator==(const DerivedKind&, const DerivedKind&) = default;
};

struct NumberNeeds {
  int axes = 0;    // of the widest object; 0: unknown, predicates are not checked against it
  int degree = 0;  // the largest of any motion
  bool weights = false;   // the weight of a point is its last axis, 0 if it has none
  bool anchored = false;  // some derived kind is
  std::vector<DerivedKind> derived;  // in the order in which they were added, each once

  // Requires kind.axes <= kMostAxes.
  void add(const DerivedKind& kind);
  // Requires a scene of points.
  void add_weights(const Scene& scene);
};

// More axes than any object has.
inline constexpr int kMostAxes = 32;

// Those of the scene's own objects. O(coefficients).
NumberNeeds needs_of_objects(const Scene& scene);

}  // namespace kinex

#endif
