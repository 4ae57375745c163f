// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/proximity/closest_pair_octants.h"

#include <algorithm>

#include "structures/proximity/static_closest_pair_audit.h"

namespace kinex {

ClosestPairOctants::ClosestPairOctants(Kernel& kernel, StructureId id,
                                       const ConeNeighbours& octants, std::string_view name)
    : FrontPair(kernel, id, "pairs", "pairs by distance", PairDistances(kernel, 2), octants.id()),
      octants_(&octants),
      name_(name) {
  octants.add_watcher(*this);
}

void ClosestPairOctants::read_all() {
  read_new_build();
  begin();
}

// The pairs of points that come and go, and those of events, are known already.
void ClosestPairOctants::read_new_build() {
  if (builds_ == octants_->builds()) return;
  builds_ = octants_->builds();
  pairs_.assign(octants_->pairs());
}

// A candidate comes or goes, probably.
void ClosestPairOctants::pointer_changed(ObjectId point, ObjectId old, ObjectId fresh) {
  pairs_.prefetch({std::min(point, old), std::max(point, old)});
  pairs_.prefetch({std::min(point, fresh), std::max(point, fresh)});
}

// A candidate has come or gone.
void ClosestPairOctants::pair_changed(const Pair& pair, bool is_there) {
  if (is_there) {
    pairs_.come(pair);
  } else {
    pairs_.go(pair);
  }
}

// The tournament changes when the octants have told all of the instant, and a change of the closest pair
// is reported when the instant is over: certificates of this structure may fail at it, too.
void ClosestPairOctants::watched_changed(const Event*) {
  read_new_build();
  kernel_->settle_later(id_);
}

std::vector<BoundCheck> ClosestPairOctants::bounds(const BoundContext& context) const {
  const std::size_t n = context.objects();
  const Integer all = kinex::pairs(counted(n));
  return tournament_bounds(context, std::min(all, counted(4 * n)),
                           "a tournament of at most four pairs a point, or all pairs",
                           2 * context.degree, all);
}

void ClosestPairOctants::check_invariants(AuditReport& report) const {
  FrontPair::check_invariants(report);
  report.check(pairs_.values() == octants_->pairs(),
               [] { return "it has missed a change of the octants"; });
}

void ClosestPairOctants::audit(const Snapshot& snapshot, AuditReport& report) const {
  check_closest_pairs(
      snapshot, attribute().ids, [this](const Pair& pair) { return pairs_.has(pair); }, report);
}

}  // namespace kinex
