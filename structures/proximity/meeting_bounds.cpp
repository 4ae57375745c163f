// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/proximity/meeting_bounds.h"

#include <algorithm>

namespace kinex {

std::vector<BoundCheck> end_bounds(const std::string& owner, const BoxOverlaps& overlaps,
                                   const BoundContext& context) {
  const Integer n = counted(context.objects()), axes(overlaps.axes());
  Integer certificates(0), in_lists(0), swaps(0);
  for (const PartLedger& part : context.ledger->parts) {
    if (!part.name.starts_with("ends along ")) continue;
    in_lists = in_lists + counted(part.max_live);
    swaps = swaps + counted(part.failures);
  }
  certificates = std::max(Integer(0), axes * (Integer(2) * n - Integer(1)));
  return {at_most(owner + ".certificates", "neighbours among 2n ends along every axis",
                  certificates, in_lists),
          at_most(owner + ".swaps",
                  "four pairs of ends of two boxes change their order at every root, and where "
                  "pieces meet",
                  Integer(4) * axes * pair_sign_changes(context.pieces, context.degree), swaps)};
}

BoundCheck meeting_bound(const std::string& owner, int functions, int factor,
                         const BoundContext& context) {
  const Integer n = counted(context.objects()), external = counted(context.ledger->external);
  if (context.plain() && context.degree <= 1) {
    return at_most(owner + ".external", "two objects of linear motion meet in one interval of time",
                   std::max(Integer(0), n * (n - Integer(1))), external);
  }
  return at_most(owner + ".external",
                 "a pair changes only at a root of its polynomials, and where pieces meet",
                 Integer(functions) * pair_sign_changes(context.pieces, factor * context.degree),
                 external);
}

}  // namespace kinex
