// SPDX-License-Identifier: GPL-3.0-or-later
// The relation of two queries by a permutation of arguments in which their predicate alternates.
#ifndef KINEX_CORE_ARITHMETIC_QUERY_RELATION_H
#define KINEX_CORE_ARITHMETIC_QUERY_RELATION_H

#include <array>
#include <cstddef>
#include <utility>

#include "core/arithmetic/query.h"

namespace kinex {

// +1 or -1: the polynomial of `a` is that of `b` times this sign, if their predicates have the same
// polynomial; 0: no such relation. `alternating` is Predicate::alternating() of both.
inline int query_relation(const Query& a, const Query& b, int alternating) {
  const std::size_t k = alternating < 2 ? 0 : static_cast<std::size_t>(alternating);
  for (std::size_t i = k; i < a.arity; ++i) {
    if (a.ids[i] != b.ids[i]) return 0;
  }
  if (k == 0) return 1;
  if (k == 2) {
    if (a.ids[0] == b.ids[0] && a.ids[1] == b.ids[1]) return 1;
    return a.ids[0] == b.ids[1] && a.ids[1] == b.ids[0] ? -1 : 0;
  }
  // Sort a copy into the order of b, counting exchanges.
  std::array<ObjectId, kMaxArity> ids = a.ids;
  int parity = 1;
  for (std::size_t i = 0; i < k; ++i) {
    std::size_t j = i;
    while (j < k && ids[j] != b.ids[i]) ++j;
    if (j == k) return 0;
    if (j != i) {
      std::swap(ids[i], ids[j]);
      parity = -parity;
    }
  }
  return parity;
}

// For Predicate::alternates_in_halves().
inline bool has_halves_exchanged(const Query& a, const Query& b) {
  const std::size_t half = a.arity / 2u;
  for (std::size_t i = 0; i < half; ++i) {
    if (a.ids[i] != b.ids[half + i] || a.ids[half + i] != b.ids[i]) return false;
  }
  return true;
}

}  // namespace kinex

#endif
