// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/extent/diameter_all_pairs.h"

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
  const Integer all = kinex::pairs(counted(context.objects()));
  return tournament_bounds(context, all, "a tournament of all pairs", 2 * context.degree, all,
                           "upper");
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
