// SPDX-License-Identifier: GPL-3.0-or-later
// ConesLocal: the next point in each of some cones around every point, maintained without sorted
// lists: octants_local in octants, cones_local in the cones of a polygon (cone_frame.h).
//
// Certificates. By the swap rule (schnyder_wood.h) a wood changes only when two points change places
// in an order while one of them is next in a cone of the other. So a wood proves itself: for every point p and
// cone with a next point q, "q is in the cone of p", two claims of degree d for motions of degree d
// (turned_order.h). With the cones that make the woods whole, at most 6n a wood for n points: 12n in
// octants, 36n or 60n for a polygon of 12 or 20 corners. A point may be in many.
//
//            .    r          q: the next point of p in the octant 0 <= y < x, the first along x
//          .                 claims: y_p <= y_q and (x - y)_p <= (x - y)_q, one for each ray
//        .   q               No claim compares q with r. If they change places along x, either one
//      p . . . . . . .       is next in a cone of the other, and a claim about these two fails, or
//                            no pointer changes (the swap rule).
//
// Quality: a failure changes two pointers and, of those between the two points and their next ones,
// as many as the swap rule says; each renews two certificates. Compact, not local. There is no order
// of points that are far from each other: failures are those of two near points that enter another
// cone of each other, at most 3n (lambda_3(n) - 1) / 2 a wood for linear motions without flight-plan
// changes, where no two of a wood share an instant: each changes two pointers by the swap rule, from just
// before to just after, and a pointer follows the lower envelope of n - 1 segments. Failures that share
// an instant may change fewer pointers; they are not counted in that bound.
// Several failures of a wood at an instant are repaired one after the other while no two of them share a
// point, and those in one order are at different places of it. Otherwise a wood is made from sorted points
// when the instant is settled: O(n log n) signs, and the certificates of the pointers that have changed. The
// bound `remade` counts these woods.
// New flight plans change what certificates claim, and no pointer: a wood proves itself (schnyder_wood.h). A
// claim that does not hold right after now fails at once, like all others. Only where two points become
// identically equal in the wrong order of their ids is a wood made anew. A point that comes is compared with
// all others, O(n) signs a wood; one that goes, of d neighbours, with these, O(d^2) signs, or for many
// neighbours leaves the wood to be made anew.
// Why one after the other: the swap of p and q compares no points but with p or q, and of other points
// changes only pointers to q. So it neither reads what another such swap changes nor changes its pointer;
// and in one order points that are not level are moved independently.
//
// Ties. See cone_neighbours.h, which has the attribute and the events, too.
//
// Source: ours, for a modification without sorted lists that Guibas, "Kinetic data structures: a
// state of the art report" (1998), mentions in section 7 without a description.
#ifndef KINEX_STRUCTURES_PROXIMITY_CONES_LOCAL_H
#define KINEX_STRUCTURES_PROXIMITY_CONES_LOCAL_H

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "structures/parts/slots.h"
#include "structures/proximity/cone_neighbours.h"
#include "structures/proximity/turned_order.h"

namespace kinex {

class ConesLocal final : public ConeNeighbours {
 public:
  // kOrder: a point was next in a cone of another one, and has left the cone: that point, the other
  // one.
  enum OwnKind : std::uint8_t { kOrder = kFirstOwnKind };

  // `name`: as registered.
  ConesLocal(Kernel& kernel, StructureId id, const Scene& scene, const ConeFrame& frame,
             std::string_view name);

  std::string_view name() const override { return name_; }
  std::vector<std::string_view> event_kinds() const override {
    return common_event_kinds({"point", "order"});
  }
  void build(std::span<const ObjectId> objects) override;
  void rebuild() override;
  void certificate_failed(CertificateId failed) override;
  void insert(ObjectId object) override;
  void erase(ObjectId object) override;
  void motions_changed(std::span<const ObjectId> objects) override;
  void instant_settled() override;
  void visit_proof(ProofVisitor& visitor) const override;
  std::vector<BoundCheck> bounds(const BoundContext& context) const override;
  std::uint64_t most_repairs(std::uint64_t certificates) const override { return 8 * certificates; }
  void check_invariants(AuditReport& report) const override;
  std::size_t bytes() const override;

 private:
  // The two claims of a pointer: in the orders of the colours behind its own and before it.
  static constexpr std::size_t kClaims = 2;
  struct Claim {
    std::size_t cone;
    ObjectId point;
    std::size_t which;
  };
  std::uint32_t tag(const Claim& c) const {
    return static_cast<std::uint32_t>((c.cone * objects() + c.point) * kClaims + c.which);
  }
  Claim claim(std::uint32_t tag) const;
  static std::size_t order_of(const Claim& c);
  std::string_view kind_of(std::size_t cone) const;
  struct Compared {  // a claim is that `before` is before `after` in the order
    const TurnedOrder* order;
    ObjectId before, after;
  };
  Compared compared(const Claim& c) const;
  Query query(const Claim& c) const;
  bool is_right(const Claim& c) const;
  const CertificateId& slot_of(const Claim& c) const {
    return certificates_[(c.point * frame().cones() + c.cone) * kClaims + c.which];
  }
  CertificateId& slot_of(const Claim& c) {
    return certificates_[(c.point * frame().cones() + c.cone) * kClaims + c.which];
  }
  void pointer_changed(std::size_t cone, ObjectId p) override;
  // Two points that change places in an order of a wood.
  struct Exchange {
    std::size_t wood, order;
    ObjectId before, after;
  };
  bool is_independent(const Exchange& one, const Exchange& other) const;
  // Of all of the wood at this instant, by now.
  bool is_independent(const Exchange& one) const;
  void certify(std::size_t cone, ObjectId p, bool points_elsewhere);
  void certify_changed(bool point_elsewhere);
  void prefetch_points(std::size_t wood, std::span<const ObjectId> points) const;
  void prefetch_next() const;
  void make_woods();
  void make_stale_woods();

  std::string_view name_;
  Slots slots_;
  std::vector<TurnedOrder> orders_;                        // by axis
  std::vector<ObjectId> members_;                          // ascending
  std::vector<CertificateId> certificates_;                // by point, cone and claim
  std::vector<std::pair<std::size_t, ObjectId>> changed_;  // pointers to be certified
  std::uint64_t instant_ = 0;        // the number of the last one with a failure
  std::vector<Exchange> exchanges_;  // its failures, but for woods that are to be made
  // By wood: whether its failure at that instant is the only one, by now, and whether the wood is to be made
  // when the instant is settled.
  std::vector<bool> is_alone_, stale_;
  std::uint64_t alone_ = 0;   // failures that are the only ones of a wood at their instants
  std::uint64_t remade_ = 0;  // woods that were, at the end of an instant
};

}  // namespace kinex

#endif
