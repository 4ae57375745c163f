// SPDX-License-Identifier: GPL-3.0-or-later
// OctantsLocal: of every point, which point comes next in each of four octants around it, without
// sorted lists.
//
// Certificates. By the swap rule (schnyder_wood.h) a wood changes only where two points change their
// order of which one is next in a cone of the other. So a wood proves itself: for every point p and
// cone with a next point q, "q is in the cone of p", two claims of degree d for motions of degree d
// (octant_orders.h). At most 12n for n points, with the two quadrants that make the woods whole; a
// point may be in many.
//
// Quality: a failure changes two pointers and, of those between the two points and their next ones,
// as many as the swap rule says; each renews two certificates. Compact, not local. There is no order
// of points that are far from each other: failures are those of two near points that enter another
// cone of each other, at most 3n (lambda_3(n) - 1) for linear motions without flight-plan changes.
// Two or more failures of a wood at an instant, new flight plans, insertions and erasures make a wood from
// sorted points when the instant is settled: O(n log n) signs, and the certificates of the pointers
// that have changed.
//
// Ties. See octant_neighbours.h, which has the attribute and the events, too.
//
// Source: ours, for a modification without sorted lists that Guibas, "Kinetic data structures: a
// state of the art report" (1998), mentions in section 7 without a description.
#ifndef KINEX_STRUCTURES_PROXIMITY_OCTANTS_LOCAL_H
#define KINEX_STRUCTURES_PROXIMITY_OCTANTS_LOCAL_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "structures/parts/slots.h"
#include "structures/proximity/octant_neighbours.h"
#include "structures/proximity/octant_orders.h"

namespace kinex {

class OctantsLocal final : public OctantNeighbours {
 public:
  // kOrder: a point was next in a cone of another one, and has left the cone: that point, the other
  // one.
  enum OwnKind : std::uint8_t { kOrder = kFirstOwnKind };

  OctantsLocal(Kernel& kernel, StructureId id, const Scene& scene);

  std::string_view name() const override { return "octants_local"; }
  std::vector<std::string_view> event_kinds() const override {
    return common_event_kinds({"point", "order"});
  }
  void build(std::span<const ObjectId> objects) override;
  void rebuild() override;
  void certificate_failed(CertificateId failed) override;
  void insert(ObjectId object) override;
  void erase(ObjectId object) override;
  void motions_changed(std::span<const ObjectId>) override { stale_.fill(true); }
  void instant_settled() override { make_stale_woods(); }
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
  Query query(const Claim& c) const;
  void pointer_changed(std::size_t cone, ObjectId p) override { changed_.emplace_back(cone, p); }
  void certify(std::size_t cone, ObjectId p);
  void certify_changed();
  void make_woods();
  void make_stale_woods();

  Slots slots_;
  std::vector<OctantOrder> orders_;                             // by OctantAxis
  std::vector<ObjectId> members_;                               // ascending
  std::vector<CertificateId> certificates_;                     // by tag
  std::vector<std::pair<std::size_t, ObjectId>> changed_;       // pointers to be certified
  std::array<std::uint64_t, OctantWoods::kWoods> failed_at_{};  // number of the last such instant
  std::array<bool, OctantWoods::kWoods> stale_{};  // to be made when the instant is settled
};

}  // namespace kinex

#endif
