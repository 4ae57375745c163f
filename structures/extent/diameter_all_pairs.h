// SPDX-License-Identifier: GPL-3.0-or-later
// DiameterAllPairs: the farthest pair of moving points, by a tournament of all pairs. The baseline
// for diameter_2: without a hull, in 1 to 3 axes.
//
// Certificates. "This pair is at least as far apart as that one": n(n-1)/2 - 1 of them for n
// points, degree 2d for motions of degree d.
//
// Quality: a point is in up to 2 (n - 1) log2 n certificates; a failure renews O(log n), an
// insertion or erasure O(n log n). External events: one for each instant that changes the pair, at
// most lambda_2d(n(n-1)/2) - 1 without flight-plan changes: n(n-1) - 2 for linear motion.
//
// Ties. Of pairs at identically equal distances the lexicographically smallest one.
//
// Source: Guibas, "Kinetic data structures: a state of the art report" (1998), sections 5 and 6.7.
#ifndef KINEX_STRUCTURES_EXTENT_DIAMETER_ALL_PAIRS_H
#define KINEX_STRUCTURES_EXTENT_DIAMETER_ALL_PAIRS_H

#include <span>
#include <string_view>
#include <vector>

#include "core/engine/structure.h"
#include "structures/parts/front_pair.h"
#include "structures/parts/member_pairs.h"
#include "structures/parts/pair_distances.h"

namespace kinex {

// The pair that is farther apart is in front.
class FarPairs {
 public:
  using Value = PairDistances::Value;
  FarPairs(Kernel& kernel, int dimension) : distances_(kernel, dimension) {}
  Query claim(const Value& front, const Value& back) const { return distances_.claim(back, front); }
  bool goes_first(const Value& a, const Value& b) const { return a < b; }

 private:
  PairDistances distances_;
};

class DiameterAllPairs final : public FrontPair<FarPairs> {
 public:
  DiameterAllPairs(Kernel& kernel, StructureId id, const Scene& scene)
      : FrontPair(kernel, id, "pairs", "pairs by distance", FarPairs(kernel, scene.dimension)) {}

  std::string_view name() const override { return "diameter_all_pairs"; }
  void build(std::span<const ObjectId> objects) override;
  void insert(ObjectId object) override;
  void erase(ObjectId object) override;
  std::vector<BoundCheck> bounds(const BoundContext& context) const override;
  void check_invariants(AuditReport& report) const override;
  void audit(const Snapshot& snapshot, AuditReport& report) const override;
  std::size_t bytes() const override { return members_.bytes() + FrontPair::bytes(); }

 private:
  MemberPairs members_;
};

}  // namespace kinex

#endif
