// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/maximum/maximum_bounds.h"

#include <string>
#include <utility>

#include "structures/parts/extremum_bounds.h"

namespace kinex {

namespace {

Integer crossings(const KeyOrder& order, const BoundContext& context) {
  return pair_sign_changes(order.member_pieces(context), order.degree(context.degree),
                           order.reference_pieces(context));
}

}  // namespace

std::vector<BoundCheck> maximum_bounds(std::string_view name, const KeyOrder& order,
                                       const BoundContext& context,
                                       std::optional<std::uint64_t> certificates) {
  const Integer n = counted(order.member_pieces(context).size());
  const StructureLedger& ledger = *context.ledger;
  const std::string own(name);
  std::vector<BoundCheck> result;
  if (certificates) {
    result.push_back(at_most(own + ".certificates", "of the winner and the next one",
                             counted(*certificates), counted(ledger.max_live)));
  } else {
    result.push_back(at_most(own + ".certificates",
                             "one certificate per object that is not the winner",
                             n.is_zero() ? Integer(0) : n - Integer(1), counted(ledger.max_live)));
  }
  // If every event is external this bounds all events.
  const auto add = [&](Integer most, const std::string& source) {
    if (certificates) {
      result.push_back(at_most(own + ".events", source, most, counted(ledger.processed)));
    }
    result.push_back(at_most(own + ".external", source, std::move(most), counted(ledger.external)));
  };
  add(extremum_changes(context, order.member_pieces(context), order.reference_pieces(context),
                       order.degree(context.degree)),
      context.plain() ? "pieces of the upper envelope of n functions, Davenport-Schinzel numbers; "
                        "Guibas 1998, section 5"
                      : "pieces of the upper envelope of functions on intervals, "
                        "Davenport-Schinzel numbers of order degree + 2, or one per crossing");
  return result;
}

BoundCheck crossing_bound(std::string_view name, const KeyOrder& order,
                          const BoundContext& context) {
  return at_most(std::string(name) + ".events",
                 "every pair of keys fails at each of its roots, and where pieces meet, at most",
                 crossings(order, context), counted(context.ledger->failures));
}

BoundCheck no_internal_events(std::string_view name, const BoundContext& context) {
  return at_most(std::string(name) + ".internal", "every event changes the maximum", Integer(0),
                 counted(context.ledger->internal));
}

}  // namespace kinex
