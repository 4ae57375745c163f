// SPDX-License-Identifier: GPL-3.0-or-later
// BichromaticPairMaximumNorm: the nearest two points of different colours in the maximum norm, in
// the plane, by four sorted lists and range trees over them.
//
// Certificates.
//   the order of the points by x, y, x + y and x - y (cone_offers.h): n - 1 each, degree d for
//   motions of degree d
//   the shortest of the pairs that the range trees of four octants offer (cone_pairs.h), each by
//   the linear function that is its length in the octant (norm_order.h): degree d
//
//          \ -y | y  /        A treap node offers the last red looker with the first blue seen, and
//        -x  \  |  /  x       the last blue looker with the first red seen. Which first and last
//         -----p-----         ones they are is known exactly, since lengths are linear in an
//          -x /  |  \  x      octant. In the Euclidean norm it is not: the first blue point in an
//          /    |    \        octant of a red one need not be the nearest.
//
// Quality, for n points, m and n - m of a colour: at most 12 n ceil(log2 n) pairs offered, and no
// more than 4 m (n - m) lengths at one instant. A failure of an order exchanges two neighbours of a
// list and makes O(log^2 n) steps in the range trees; it changes O(log^2 n) offers, mostly to what
// they were, O(log n) certificates each. A failure of the tournament renews O(log n).
// Near-quadratic: at most 4d C(n, 2) exchanges without flight-plan changes. A point is in at most 8
// order certificates. A new flight plan renews the matches of all lengths to the point. An insertion
// or erasure makes amortised O(log^3 n) steps in the range trees; twice as many pairs may be offered
// then.
//
// Ties. Of pairs with identically equal lengths the one that is shortest right after an
// infinitesimal turn of the plane, counter-clockwise; of those that are still level, the one that
// is shortest when the points are moved by their ids along (2, 1), much less; then the
// lexicographically smallest. (With the ids alone the pair need not be offered: many points may be
// level with the first one in an octant.)
//
// Proof that the pair is offered, whichever one it is. The lists are those of the points turned and
// moved, and of these no two are level in any list. So each pair of two colours is in one octant,
// has as its length the difference of its places' keys along the projection, and separates at one
// treap node. There the last looker of one colour and the first seen of the other are the only
// shortest pair of these two colours in this order. Hence of all pairs of two colours those of the
// smallest length, turned and moved, are all offered, and the ids decide between these.
//
// Source: after Basch, Guibas, Zhang, "Proximity problems on moving points" (1997), whose range trees
// find closest pairs of one colour; colours and the maximum norm are ours.
#ifndef KINEX_STRUCTURES_PROXIMITY_BICHROMATIC_PAIR_MAXIMUM_NORM_H
#define KINEX_STRUCTURES_PROXIMITY_BICHROMATIC_PAIR_MAXIMUM_NORM_H

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "core/engine/structure.h"
#include "structures/parts/front_pair.h"
#include "structures/parts/object_sets.h"
#include "structures/proximity/cone_offers.h"
#include "structures/proximity/norm_order.h"
#include "structures/proximity/offer_counts.h"

namespace kinex {

// Claims of a tournament (structures/parts/changing_extremum.h): lengths in the maximum norm.
class MaximumNormLengths {
 public:
  using Value = std::array<ObjectId, 3>;  // from, to, and the axis along which this is the length

  explicit MaximumNormLengths(Kernel& kernel) : order_(kernel, {{1, 0}, {0, 1}}) {}

  static NormForm form(const Value& value) {
    return {static_cast<std::uint8_t>(value[2]), value[0], value[1]};
  }
  static std::array<ObjectId, 2> pair_of(const Value& value) { return form(value).pair(); }
  Query claim(const Value& front, const Value& back) const {
    const NormForm one = form(front), other = form(back);
    return order_.claim({one, number(front)}, {other, number(back)});
  }
  bool goes_first(const Value& a, const Value& b) const {
    const NormForm one = form(a), other = form(b);
    return order_.goes_first({one, number(a)}, {other, number(b)});
  }
  std::size_t bytes() const { return order_.bytes(); }

 private:
  static std::uint32_t number(const Value& value) {
    return 2 * value[2] + (value[0] < value[1] ? 0 : 1);
  }
  NormOrder order_;
};

class BichromaticPairMaximumNorm final : public FrontPair<MaximumNormLengths> {
  auto exchanged() {
    return [this](ObjectId before, ObjectId after) {
      kernel_->report(id_, kOrder, {before, after}, false);
    };
  }

 public:
  // Two neighbours of a list have changed places: the one that was in front, the other.
  static constexpr std::uint8_t kOrder = kTie + 1;

  BichromaticPairMaximumNorm(Kernel& kernel, StructureId id, const Scene& scene,
                             TwoClasses classes);

  std::string_view name() const override { return "bichromatic_pair_maximum_norm"; }
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
  void offer(const ConeOffers::Offer& offer, int change);
  void renew(const std::vector<Value>& values);

  TwoClasses classes_;
  OfferCounts<Value> counts_;
  ConeOffers offers_;
};

}  // namespace kinex

#endif
