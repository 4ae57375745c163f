// SPDX-License-Identifier: GPL-3.0-or-later
// NumberNeeds: the axes and degrees for which the numbers of a run must have room. The scene's
// objects need their axes and the degree of their motions. Structures add the weights that they
// read and the objects that they derive (structures/plan.h). An arithmetic is made for the union of
// these needs and has no room for more: it leaves out what a motion has on further axes, weights
// that no structure reads.
//
// Predicates are not among the needs. What is kept for each object, and how wide its numbers are,
// depends on axes and degrees alone. The size of a predicate's polynomial follows from these and
// from the predicate's own degree: when the maker of a structure binds it (Arithmetic::bind), each
// predicate is sized on its own, in fixed arrays or, beyond kMaxFixedDegree, in dynamic ones. One
// that reads more axes than the needs have is refused there, by name. A list of predicates beside
// the makers would say the same a second time, and could contradict them.
#ifndef KINEX_CORE_ARITHMETIC_NUMBER_NEEDS_H
#define KINEX_CORE_ARITHMETIC_NUMBER_NEEDS_H

#include <string>
#include <vector>

#include "core/motion/scene.h"

namespace kinex {

// The derived objects of one construction.
struct DerivedKind {
  std::string name;  // Construction::name()
  int axes = 1;
  int degree = 0;  // the largest in t, for the motions of the scene
  // True if the coefficients cancel far from t = 0. Then motions are also kept as polynomials in
  // t - anchor, for an anchor near now, shifted exactly; machine integers are not used in the
  // scene.
  bool anchored = false;
  friend bool operator==(const DerivedKind&, const DerivedKind&) = default;
};

struct NumberNeeds {
  int axes = 0;    // the most axes of an object; 0: unknown, predicates are not checked against it
  int degree = 0;  // the largest degree in t of any motion
  bool weights = false;   // points have an axis behind their position, 0 if the scene gives none
  bool anchored = false;  // some derived kind is anchored
  std::vector<DerivedKind> derived;  // in the order in which they were added, each once

  // Requires kind.axes <= kMostAxes.
  void add(const DerivedKind& kind);
  // Structures read weights, or radii in their place. Requires a scene without bodies.
  void add_weights(const Scene& scene);
};

// No object has more axes.
inline constexpr int kMostAxes = 32;

// The needs of the scene's own objects, without the weights of points. O(coefficients).
NumberNeeds needs_of_objects(const Scene& scene);

}  // namespace kinex

#endif
