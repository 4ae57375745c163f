// SPDX-License-Identifier: GPL-3.0-or-later
// ClosestPairRangeTree: the closest pair of moving points in the plane, by four sorted lists and
// range trees over them, without a triangulation.
//
// Certificates.
//   the order of the points by x, y, x + y and x - y (cone_offers.h): n - 1 each, degree d for
//   motions of degree d
//   the shortest of the pairs that the range trees of octants or of quadrants offer (cone_pairs.h),
//   among which is every closest pair: degree 2d
//
// Quality, for n points:
//
//                         octants                    quadrants
//   range trees           4                          2
//   offers of a node      2                          5, of two lookers and two seen
//   pairs offered         at most 8 n ceil(log2 n)   at most 10 n ceil(log2 n)
//   an order that fails   O(log^2 n) steps and offers that change, mostly to what they were, O(log
//                         n) certificates each
//
// A failure of the tournament renews O(log n). Near-quadratic: at most 4d C(n, 2) exchanges without
// flight-plan changes, against the nearly cubic events of a triangulation. A point is in at most 8
// order certificates. An insertion or erasure makes O(log n) certificates in the lists and amortised
// O(log^3 n) steps in the range trees; twice as many pairs may be offered then. Quadrants are those of
// the paper, which keeps three candidates; in the order after a turn two suffice.
//
// Ties. Of pairs whose distances are identically equal the lexicographically smallest one.
//
// Source: Basch, Guibas, Zhang, "Proximity problems on moving points" (1997); Agarwal, Kaplan,
// Sharir, "Kinetic and dynamic data structures for closest pair and all nearest neighbors" (2008).
// The octants are ours: rational cones that cover the plane, whose nearest points are first in a
// rational direction.
#ifndef KINEX_STRUCTURES_PROXIMITY_CLOSEST_PAIR_RANGE_TREE_H
#define KINEX_STRUCTURES_PROXIMITY_CLOSEST_PAIR_RANGE_TREE_H

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "core/engine/structure.h"
#include "structures/parts/front_pair.h"
#include "structures/parts/pair_distances.h"
#include "structures/proximity/cone_offers.h"
#include "structures/proximity/offer_counts.h"

namespace kinex {

class ClosestPairRangeTree final : public FrontPair<PairDistances> {
  auto exchanged() {
    return [this](ObjectId before, ObjectId after) {
      kernel_->report(id_, kOrder, {before, after}, false);
    };
  }

 public:
  // Two neighbours of a list have changed places: the one that was in front, the other.
  static constexpr std::uint8_t kOrder = kTie + 1;

  ClosestPairRangeTree(Kernel& kernel, StructureId id, const Scene& scene, ConeOffers::Cones cones);

  std::string_view name() const override { return "closest_pair_range_tree"; }
  std::vector<std::string_view> event_kinds() const override {
    return common_event_kinds({"replace", "tie", "order"});
  }
  void build(std::span<const ObjectId> objects) override;
  void rebuild() override;
  void certificate_failed(CertificateId failed) override;
  void insert(ObjectId object) override;
  void erase(ObjectId object) override;
  void motions_changed(std::span<const ObjectId> objects) override;
  void visit_proof(ProofVisitor& visitor) const override;
  std::vector<BoundCheck> bounds(const BoundContext& context) const override;
  void check_invariants(AuditReport& report) const override;
  void audit(const Snapshot& snapshot, AuditReport& report) const override;
  std::size_t bytes() const override;

 private:
  ConeOffers::Cones cones_;
  KeptPoints kept_;
  OfferCounts<Pair> counts_;
  ConeOffers offers_;
};

}  // namespace kinex

#endif
