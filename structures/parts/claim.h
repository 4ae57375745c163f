// SPDX-License-Identifier: GPL-3.0-or-later
// Claims: the interface through which a part compares its items: for two of them, the query that
// says that the first is in front.
//
// An item is an integer that the owner of the part interprets: an object, or the number of a pair
// of objects, of an edge, of a derived object. The owner also chooses the meaning of "in front":
// first in a list, above in a heap, winner of a duel.
#ifndef KINEX_STRUCTURES_PARTS_CLAIM_H
#define KINEX_STRUCTURES_PARTS_CLAIM_H

#include <concepts>
#include <cstdint>

#include "core/engine/kernel.h"
#include "core/motion/scene.h"

namespace kinex {

using Item = ObjectId;  // whatever the owner compares
inline constexpr Item kNoItem = kNoObject;  // none

// For distinct items a and b:
//   claim(a, b)       is >= 0 iff a is in front of b or level with it; it names no object twice
//   goes_first(a, b)  a is in front of b if they are level identically; a strict total order
// The claims must be transitive in an exact arithmetic: an order of the items at every instant.
template <class C>
concept Claims = requires(const C& claims, Item a, Item b) {
  { claims.claim(a, b) } -> std::same_as<Query>;
  { claims.goes_first(a, b) } -> std::convertible_to<bool>;
};

// a is in front of b right after now.
template <Claims C>
bool in_front(Kernel& kernel, const C& claims, Item a, Item b) {
  const Sign sign = kernel.sign_after(claims.claim(a, b));
  return sign == Sign::kPositive || (sign == Sign::kZero && claims.goes_first(a, b));
}

// Calls reported(a, b) for two items of one part that are level identically from now on, where b
// takes the place of a.
template <class F>
concept TieReport = std::invocable<const F&, Item, Item>;

}  // namespace kinex

#endif
