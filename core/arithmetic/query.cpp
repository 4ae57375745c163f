// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/arithmetic/query.h"

namespace kinex {

bool repeats_an_object_of_many(const Query& q) {
  for (std::size_t i = 0; i < q.arity; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (q.ids[i] == q.ids[j]) return true;
    }
  }
  return false;
}

}  // namespace kinex
