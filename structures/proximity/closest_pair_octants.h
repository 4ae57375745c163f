// SPDX-License-Identifier: GPL-3.0-or-later
// ClosestPairOctants: the closest pair of moving points in the plane, among the pairs of a point and
// the next one in an octant around it: closest_pair_cones, which reads octants_listed, and
// closest_pair_local, which reads octants_local.
//
// Certificates. It watches the octants and keeps the shortest of their pairs by a ChangingExtremum:
// "this pair is at most as far apart as that one", at most 4n - 1, of degree 2d for motions of
// degree d. Each closest pair, if there are several, is among these pairs (cone_pairs.h).
//
// Quality, for n points: a failure renews O(log n) certificates, and so does every pair that comes
// or goes. A point may be next for many others. External events: one for each instant that changes
// the closest pair, at most lambda_2d(n(n-1)/2) - 1 without flight-plan changes.
//
// Ties. Of pairs whose distances are identically equal the lexicographically smallest one.
//
// Source: after Basch, Guibas, Hershberger, "Data structures for mobile data" (1997), who keep, for
// every point and cone, the one pair with the last of those that choose the point: as many
// candidates, of which fewer change at a failure.
#ifndef KINEX_STRUCTURES_PROXIMITY_CLOSEST_PAIR_OCTANTS_H
#define KINEX_STRUCTURES_PROXIMITY_CLOSEST_PAIR_OCTANTS_H

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "structures/parts/front_pair.h"
#include "structures/parts/pair_distances.h"
#include "structures/proximity/cone_neighbours.h"

namespace kinex {

class ClosestPairOctants final : public FrontPair<PairDistances>, public ConeWatcher {
 public:
  // `octants` outlives this structure and is watched by it. `name`: as registered.
  ClosestPairOctants(Kernel& kernel, StructureId id, const ConeNeighbours& octants,
                     std::string_view name);

  std::string_view name() const override { return name_; }
  void build(std::span<const ObjectId>) override { read_all(); }
  void rebuild() override {
    FrontPair::rebuild();
    builds_ = 0;
    read_all();
  }
  // Points come and go in the octants, which have said what pairs do.
  void insert(ObjectId) override { read_all(); }
  void erase(ObjectId) override { read_all(); }
  // A failure of the octants brings several events: their pairs come and go together.
  void instant_settled() override { pairs_.apply(tied()); }
  void watched_changed(const Event* event) override;
  void pointer_changed(ObjectId point, ObjectId old, ObjectId fresh) override;
  void pair_changed(const Pair& pair, bool is_there) override;
  std::vector<BoundCheck> bounds(const BoundContext& context) const override;
  void check_invariants(AuditReport& report) const override;
  void audit(const Snapshot& snapshot, AuditReport& report) const override;

 private:
  void read_all();
  void read_new_build();

  const ConeNeighbours* octants_;
  std::string_view name_;
  std::uint64_t builds_ = 0;  // of the octants, as read
};

}  // namespace kinex

#endif
