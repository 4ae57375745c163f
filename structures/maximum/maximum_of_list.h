// SPDX-License-Identifier: GPL-3.0-or-later
// MaximumOfList: the object with the largest (or smallest) key, read off a SortedList of that key.
//
// Certificates. None of its own: it watches the list and changes when the list's end does. The list
// may be maintained for its own sake, or be shared by a maximum and a minimum.
//
// Quality: that of the list, whose whole cost is paid for one object: up to n(n-1)/2 swaps for
// n - 1 changes of the maximum. It is the inefficient baseline with which the report begins.
// Events: one per instant that changes the maximum, however many neighbours change places at it.
//
// Ties. Of objects with identically equal keys the smallest id wins.
//
// Source: Guibas, "Kinetic data structures: a state of the art report" (1998), section 5.
#ifndef KINEX_STRUCTURES_MAXIMUM_MAXIMUM_OF_LIST_H
#define KINEX_STRUCTURES_MAXIMUM_MAXIMUM_OF_LIST_H

#include <span>
#include <string_view>
#include <vector>

#include "core/engine/kernel.h"
#include "core/engine/structure.h"
#include "structures/parts/attribute_events.h"
#include "structures/order/sorted_list.h"
#include "structures/parts/key_order.h"

namespace kinex {

class MaximumOfList final : public Structure {
 public:
  enum Kind : std::uint8_t {
    kReplace,  // another maximum: the old one, the new one
  };

  // `list` outlives this structure and is watched by it.
  MaximumOfList(Kernel& kernel, StructureId id, const SortedList& list, Extremum extremum)
      : list_(&list), extremum_(extremum), events_(kernel, id, kReplace) {}

  std::string_view name() const override {
    return extremum_ == Extremum::kMaximum ? "maximum_sorted_list" : "minimum_sorted_list";
  }
  std::vector<std::string_view> event_kinds() const override;
  void build(std::span<const ObjectId> objects) override;
  void rebuild() override { events_.begin(extreme()); }
  // Never called: it has no certificates.
  void certificate_failed(CertificateId) override {}
  // Objects come and go in the list; the change of the maximum that they cause is no event.
  void insert(ObjectId) override { events_.begin(extreme()); }
  void erase(ObjectId) override { events_.begin(extreme()); }
  // New motions may separate objects that were tied, without a swap.
  void instant_settled() override { events_.over(extreme()); }
  void watched_changed(const Event* event) override;
  Attribute attribute() const override;
  std::vector<BoundCheck> bounds(const BoundContext& context) const override;
  void check_invariants(AuditReport& report) const override;
  void audit(const Snapshot& snapshot, AuditReport& report) const override;
  std::size_t bytes() const override { return sizeof *this; }

  // The object at the end of the list; kNoObject if the list is empty. O(1).
  ObjectId winner() const { return events_.object(); }

 private:
  ObjectId extreme() const { return list_->extreme(extremum_); }

  const SortedList* list_;
  Extremum extremum_;
  AttributeEvents events_;
};

}  // namespace kinex

#endif
