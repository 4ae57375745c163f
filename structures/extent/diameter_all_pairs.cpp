// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/extent/diameter_all_pairs.h"

#include <algorithm>

#include "structures/extent/farthest_pair_audit.h"

namespace kinex {

void DiameterAllPairs::build(std::span<const ObjectId> objects) {
  members_.assign(objects.begin(), objects.end());
  std::vector<Pair> all;
  for (std::size_t i = 0; i < members_.size(); ++i) {
    for (std::size_t j = i + 1; j < members_.size(); ++j) all.push_back({members_[i], members_[j]});
  }
  pairs_.assign(all);
  begin();
}

void DiameterAllPairs::insert(ObjectId object) {
  for (const ObjectId other : members_) {
    pairs_.come({std::min(object, other), std::max(object, other)});
  }
  members_.insert(std::lower_bound(members_.begin(), members_.end(), object), object);
  begin();
}

void DiameterAllPairs::erase(ObjectId object) {
  members_.erase(std::lower_bound(members_.begin(), members_.end(), object));
  for (const ObjectId other : members_) {
    pairs_.go({std::min(object, other), std::max(object, other)});
  }
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
  const std::size_t n = members_.size();
  report.check(pairs_.size() == (n == 0 ? 0 : n * (n - 1) / 2),
               [] { return "a wrong number of pairs"; });
}

void DiameterAllPairs::audit(const Snapshot& snapshot, AuditReport& report) const {
  report.check(static_farthest_pair(snapshot) == attribute().ids,
               [] { return "another pair is the farthest"; });
}

}  // namespace kinex
