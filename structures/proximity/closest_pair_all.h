// SPDX-License-Identifier: GPL-3.0-or-later
// ClosestPairAll: the closest pair of moving points, or the closest pair of two points of different
// classes, by a tournament of all pairs. The baseline, without a triangulation, in 1 to 3 axes:
// closest_pair_all and bichromatic_pair_all.
//
// Certificates. "This pair is at most as far apart as that one": one for each match of the
// tournament, n(n-1)/2 - 1 for n points, mn - 1 for two classes of m and n points; degree 2d for
// motions of degree d.
//
// Quality: a point is in up to (n - 1) ceil(log2 (n(n-1)/2)) certificates; a failure renews O(log
// n), an insertion or erasure O(n log n). External events: one for each instant that changes the
// pair, at most lambda_2d(pairs) - 1 without flight-plan changes.
//
// Ties. Of pairs at identically equal distances the lexicographically smallest one.
//
// Source: Guibas, "Kinetic data structures: a state of the art report" (1998), sections 5 and 7.
#ifndef KINEX_STRUCTURES_PROXIMITY_CLOSEST_PAIR_ALL_H
#define KINEX_STRUCTURES_PROXIMITY_CLOSEST_PAIR_ALL_H

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/engine/structure.h"
#include "structures/parts/front_pair.h"
#include "structures/parts/member_pairs.h"
#include "structures/parts/object_sets.h"
#include "structures/parts/pair_distances.h"

namespace kinex {

class ClosestPairAll final : public FrontPair<PairDistances> {
 public:
  // `classes`: pairs of two points of different classes alone; nullopt: all pairs.
  ClosestPairAll(Kernel& kernel, StructureId id, const Scene& scene,
                 std::optional<TwoClasses> classes);

  std::string_view name() const override {
    return classes_ ? "bichromatic_pair_all" : "closest_pair_all";
  }
  void build(std::span<const ObjectId> objects) override;
  void insert(ObjectId object) override;
  void erase(ObjectId object) override;
  std::vector<BoundCheck> bounds(const BoundContext& context) const override;
  void check_invariants(AuditReport& report) const override;
  void audit(const Snapshot& snapshot, AuditReport& report) const override;
  std::size_t bytes() const override {
    return members_.bytes() + FrontPair::bytes() + (classes_ ? classes_->bytes() : 0);
  }

 private:
  bool counts(ObjectId a, ObjectId b) const { return !classes_ || classes_->differ(a, b); }
  std::vector<Pair> all_pairs() const;

  std::optional<TwoClasses> classes_;
  MemberPairs members_;
};

}  // namespace kinex

#endif
