// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/parts/extremum_bounds.h"

#include <algorithm>

namespace kinex {

Integer extremum_changes(const BoundContext& context, const std::vector<int>& pieces, int common,
                         int degree) {
  const auto changes = [](Integer envelope) {
    return envelope.is_zero() ? envelope : envelope - Integer(1);
  };
  const auto ties = context.ledger->by_kind.find("tie");
  const Integer tied = counted(ties == context.ledger->by_kind.end() ? 0 : ties->second);
  if (context.plain()) {
    return changes(davenport_schinzel_bound(degree, counted(pieces.size()))) + tied;
  }
  Integer functions(0);  // a new motion of the common object begins a new piece of every function
  for (const int p : pieces) functions += Integer(p + common - 1);
  return std::min(changes(davenport_schinzel_bound(degree + 2, functions)),
                  pair_sign_changes(pieces, degree, common)) +
         tied;
}

}  // namespace kinex
