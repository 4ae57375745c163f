// SPDX-License-Identifier: GPL-3.0-or-later
// OctantsListed: of every point, which point comes next in each of four octants around it, by four
// sorted lists.
//
// Certificates: the order of the points by x, y, x + y and x - y (turned_order.h), n - 1 each, of
// degree d for motions of degree d. The lists alone say which point is next in which octant. The
// pointers to the next points are kept as two Schnyder woods (schnyder_wood.h): when two neighbours
// of a list change places, the woods made from its order change by the swap rule.
//
// Quality, for n points: a point is in at most 8 certificates; a failure renews 3 and costs O(1) for
// each pointer that changes. At most 4d C(n, 2) failures without flight-plan changes. Most of them
// change nothing: octants_local has no order of points that are far from each other.
// Two points that pass through each other change places in several lists at one instant, in steps
// of which some leave the two ordered as no two points in the plane can be. Then the wood waits, and
// is made from the lists when the instant is settled, in O(n log n) without a certificate. A point that
// comes or goes changes the pointers that it has to (schnyder_wood.h), in O(n) steps; one of many
// neighbours that goes leaves the woods to be made so.
//
// Ties. See cone_neighbours.h, which has the attribute and the events, too.
//
// Source: after Basch, Guibas, Hershberger, "Data structures for mobile data" (1997). Their cones of
// 60 degrees have irrational sides; octants and woods are ours.
#ifndef KINEX_STRUCTURES_PROXIMITY_OCTANTS_LISTED_H
#define KINEX_STRUCTURES_PROXIMITY_OCTANTS_LISTED_H

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "structures/parts/kinetic_list.h"
#include "structures/proximity/cone_neighbours.h"
#include "structures/proximity/turned_order.h"

namespace kinex {

class OctantsListed final : public ConeNeighbours {
  using List = KineticList<TurnedOrder>;
  auto exchanged(OctantAxis axis) {
    return [this, axis](ObjectId before, ObjectId after) {
      kernel().report(id(), kOrder, {before, after}, false);
      exchange(axis, before, after);
    };
  }

 public:
  // kOrder: two neighbours of a list have changed places: the one that was in front, the other.
  enum OwnKind : std::uint8_t { kOrder = kFirstOwnKind };

  OctantsListed(Kernel& kernel, StructureId id, const Scene& scene);

  std::string_view name() const override { return "octants_listed"; }
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
  void check_invariants(AuditReport& report) const override;
  void audit(const Snapshot& snapshot, AuditReport& report) const override;
  std::size_t bytes() const override;

 private:
  void number_places();
  void make_woods();
  void exchange(OctantAxis axis, ObjectId before, ObjectId after);

  std::vector<List> lists_;                                     // by OctantAxis
  std::array<std::vector<std::uint32_t>, kOctantAxes> places_;  // of objects in the lists
  std::array<bool, 2> waits_{};                                 // woods to be made from the lists
  std::uint64_t remade_ = 0;  // woods that were, at the end of an instant
};

}  // namespace kinex

#endif
