// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/extent/diameter_all_pairs.h"

#include <algorithm>

#include "structures/extent/farthest_pair_audit.h"

namespace kinex {

void DiameterAllPairs::build(std::span<const ObjectId> objects) {
  members_.assign(objects);
  pairs_.assign(members_.all([](ObjectId, ObjectId) { return true; }));
  begin();
}

void DiameterAllPairs::insert(ObjectId object) {
  members_.insert(object, [this](const Pair& pair) { pairs_.come(pair); });
  begin();
}

void DiameterAllPairs::erase(ObjectId object) {
  members_.erase(object, [this](const Pair& pair) { pairs_.go(pair); });
  begin();
}

std::vector<BoundCheck> DiameterAllPairs::bounds(const BoundContext& context) const {
  const StructureLedger& ledger = *context.ledger;
  const Integer all = kinex::pairs(counted(context.objects()));
  std::vector<BoundCheck> result{
      at_most("diameter_all_pairs.certificates", "a tournament of all pairs",
              std::max(Integer(0), all - Integer(1)), counted(ledger.max_live)),
      at_most("diameter_all_pairs.events", "the epochs of the nodes of the tournament",
              pairs_.most_failures(2 * context.degree), counted(ledger.failures))};
  if (context.plain() && context.objects() > 1) {
    result.push_back(at_most("diameter_all_pairs.external",
                             "pieces of the upper envelope of the distances of all pairs",
                             davenport_schinzel_bound(2 * context.degree, all) - Integer(1),
                             counted(ledger.external)));
  }
  return result;
}

void DiameterAllPairs::check_invariants(AuditReport& report) const {
  FrontPair::check_invariants(report);
  report.check(pairs_.size() == members_.pairs(), [] { return "a wrong number of pairs"; });
}

void DiameterAllPairs::audit(const Snapshot& snapshot, AuditReport& report) const {
  report.check(static_farthest_pair(snapshot) == attribute().ids,
               [] { return "another pair is the farthest"; });
}

}  // namespace kinex
