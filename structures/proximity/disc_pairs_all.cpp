// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/proximity/disc_pairs.h"
#include "structures/proximity/meeting_bounds.h"

namespace kinex {

void DiscPairsAll::build(std::span<const ObjectId> objects) {
  members_.assign({});
  claims_.clear();
  for (const ObjectId object : objects) insert(object);
}

void DiscPairsAll::certificate_failed(CertificateId failed) {
  const auto [pair, meets] = claims_.failed(failed);
  events_.changed(pair[0], pair[1], meets);
  events_.repaired(pair[0], pair[1]);
}

void DiscPairsAll::insert(ObjectId object) {
  members_.insert(object, [this](const DiscClaims::Pair& pair) { claims_.add(pair); });
  events_.begin();
}

void DiscPairsAll::erase(ObjectId object) {
  members_.erase(object, [this](const DiscClaims::Pair& pair) { claims_.remove(pair); });
  events_.begin();
}

void DiscPairsAll::motions_changed(std::span<const ObjectId> objects) {
  claims_.motions_changed(objects, [this](const DiscClaims::Pair& pair) {
    events_.changed(pair[0], pair[1], true);
    events_.tied(pair[0], pair[1]);
  });
}

std::vector<BoundCheck> DiscPairsAll::bounds(const BoundContext& context) const {
  const Integer n = counted(context.objects());
  return {at_most("disc_pairs_all.certificates", "one a pair", pairs(n),
                  counted(context.ledger->max_live)),
          at_most("disc_pairs_all.events",
                  "a pair changes only at a root of its polynomial, and where pieces meet",
                  pair_sign_changes(context.pieces, 2 * context.degree),
                  counted(context.ledger->failures)),
          meeting_bound("disc_pairs_all", 1, 2, context)};
}

void DiscPairsAll::check_invariants(AuditReport& report) const {
  claims_.check(report);
  report.check(claims_.size() == members_.pairs(),
               [] { return "another number of pairs than there are"; });
  report.check(!events_.any(), [] { return "a change of the pairs was not reported"; });
}

}  // namespace kinex
