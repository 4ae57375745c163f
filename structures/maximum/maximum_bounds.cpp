// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/maximum/maximum_bounds.h"

#include <string>
#include <utility>

namespace kinex {

namespace {

Integer counted(std::uint64_t k) { return Integer(static_cast<std::int64_t>(k)); }

Integer crossings(const KeyOrder& order, const BoundContext& context) {
  return pair_sign_changes(order.member_pieces(context), order.degree(context.degree),
                           order.reference_pieces(context));
}

// The pieces of the members' keys: a new motion of the reference begins a new piece of every key.
Integer key_pieces(const KeyOrder& order, const BoundContext& context) {
  Integer sum(0);
  for (const int pieces : order.member_pieces(context)) {
    sum += Integer(pieces + order.reference_pieces(context) - 1);
  }
  return sum;
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
  const auto ties = ledger.by_kind.find("tie");
  const Integer tied = counted(ties == ledger.by_kind.end() ? 0 : ties->second);
  const int degree = order.degree(context.degree);
  const auto changes = [](Integer envelope) {
    return envelope.is_zero() ? envelope : envelope - Integer(1);
  };
  if (context.plain()) {
    add(changes(davenport_schinzel_bound(degree, n)) + tied,
        "pieces of the upper envelope of n functions, Davenport-Schinzel numbers; "
        "Guibas 1998, section 5");
    return result;
  }
  const Integer envelope =
      changes(davenport_schinzel_bound(degree + 2, key_pieces(order, context)));
  const Integer crossing = crossings(order, context);
  add((envelope < crossing ? envelope : crossing) + tied,
      "pieces of the upper envelope of functions on intervals, Davenport-Schinzel numbers of order "
      "degree + 2, or one per crossing");
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
