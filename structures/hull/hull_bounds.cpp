// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/hull/hull_bounds.h"

#include <string>

#include "structures/parts/binomial.h"

namespace kinex {

Integer turns_of_triples(const BoundContext& context) {
  return Integer(2 * context.degree) *
         binomial(Integer(static_cast<std::int64_t>(context.objects())), 3);
}

std::uint64_t events_of(const StructureLedger& ledger, std::initializer_list<const char*> kinds) {
  std::uint64_t total = 0;
  for (const char* kind : kinds) {
    const auto it = ledger.by_kind.find(kind);
    if (it != ledger.by_kind.end()) total += it->second;
  }
  return total;
}

// A point that enters or leaves is then collinear with its two neighbours: at least one triple for
// each, and at one instant all three points of a triple may change.
std::vector<BoundCheck> hull_bounds(std::string_view name, const BoundContext& context, bool tied) {
  std::vector<BoundCheck> checks;
  if (!context.plain() || tied) return checks;
  checks.push_back(at_most(std::string(name) + ".changes",
                           "points enter and leave where three are on one line: each triple is "
                           "that at most 2d times, and at most its three points change then",
                           Integer(3) * turns_of_triples(context),
                           counted(events_of(*context.ledger, {"enter", "leave"}))));
  return checks;
}

}  // namespace kinex
