// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/maximum_bounds.h"

#include <string>

namespace kinex {

std::vector<BoundCheck> maximum_bounds(std::string_view name, const KeyOrder& order,
                                       const BoundContext& context) {
  const auto counted = [](std::uint64_t k) { return Integer(static_cast<std::int64_t>(k)); };
  const Integer n = counted(order.member_pieces(context).size());
  const StructureLedger& ledger = *context.ledger;
  std::vector<BoundCheck> result;
  result.push_back(at_most(std::string(name) + ".certificates",
                           "one certificate per object that is not the winner",
                           n.is_zero() ? Integer(0) : n - Integer(1), counted(ledger.max_live)));
  if (!context.plain()) return result;
  const auto ties = ledger.by_kind.find("tie");
  Integer changes = davenport_schinzel_bound(order.degree(context.degree), n);
  if (!changes.is_zero()) changes -= Integer(1);
  if (ties != ledger.by_kind.end()) changes += counted(ties->second);
  result.push_back(
      at_most(std::string(name) + ".external",
              "pieces of the upper envelope of n functions, Davenport-Schinzel numbers; "
              "Guibas 1998, section 5",
              changes, counted(ledger.external)));
  return result;
}

}  // namespace kinex
