// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/proximity/closest_pair_all.h"

#include <utility>

#include "structures/proximity/static_closest_pair_audit.h"

namespace kinex {

ClosestPairAll::ClosestPairAll(Kernel& kernel, StructureId id, const Scene& scene,
                               std::optional<TwoClasses> classes)
    : FrontPair(kernel, id, "pairs", "pairs by distance", PairDistances(kernel, scene.dimension)),
      classes_(std::move(classes)) {}

std::vector<ClosestPairAll::Pair> ClosestPairAll::all_pairs() const {
  return members_.all([this](ObjectId a, ObjectId b) { return counts(a, b); });
}

void ClosestPairAll::build(std::span<const ObjectId> objects) {
  members_.assign(objects);
  pairs_.assign(all_pairs());
  begin();
}

void ClosestPairAll::insert(ObjectId object) {
  members_.insert(object, [this](const Pair& pair) {
    if (counts(pair[0], pair[1])) pairs_.come(pair);
  });
  begin();
}

void ClosestPairAll::erase(ObjectId object) {
  members_.erase(object, [this](const Pair& pair) {
    if (counts(pair[0], pair[1])) pairs_.go(pair);
  });
  begin();
}

std::vector<BoundCheck> ClosestPairAll::bounds(const BoundContext& context) const {
  const Integer all = classes_ ? counted(classes_->size(0)) * counted(classes_->size(1))
                               : kinex::pairs(counted(context.objects()));
  return tournament_bounds(context, all, "a tournament of all pairs", 2 * context.degree, all);
}

void ClosestPairAll::check_invariants(AuditReport& report) const {
  FrontPair::check_invariants(report);
  report.check(pairs_.values() == all_pairs(),
               [] { return "other pairs than those of its points"; });
}

void ClosestPairAll::audit(const Snapshot& snapshot, AuditReport& report) const {
  const auto pair =
      static_closest_pair(snapshot, [this](ObjectId a, ObjectId b) { return counts(a, b); });
  report.check(pair == attribute().ids, [] { return "another pair is the closest"; });
}

}  // namespace kinex
