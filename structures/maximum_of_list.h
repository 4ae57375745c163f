// SPDX-License-Identifier: GPL-3.0-or-later
// MaximumOfList: the object with the largest (or smallest) key, read off a SortedList of that key.
//
// Certificates. None of its own: it watches the list, and changes when the list's end does. The
// list may be maintained for its own sake, or be shared by a maximum and a minimum.
//
// Quality: that of the list, all of which is paid for one object: every swap is an event of the
// list, and n(n-1)/2 of them may come with n - 1 changes of the maximum. The inefficient baseline
// that the report begins with.
// Events: at an instant at which several neighbours of the list change places the maximum may pass
// through objects that all have the largest key at it.
//
// Ties. Of objects whose keys are equal for ever the smallest id wins.
//
// Source: Guibas, "Kinetic data structures: a state of the art report" (1998), section 5.
#ifndef KINEX_STRUCTURES_MAXIMUM_OF_LIST_H
#define KINEX_STRUCTURES_MAXIMUM_OF_LIST_H

#include <span>
#include <string_view>
#include <vector>

#include "core/kernel.h"
#include "core/structure.h"
#include "structures/key_order.h"
#include "structures/sorted_list.h"

namespace kinex {

class MaximumOfList final : public Structure {
 public:
  enum Kind : std::uint8_t {
    kReplace,  // another maximum: the old one, the new one
  };

  // `list` outlives this structure and is watched by it.
  MaximumOfList(Kernel& kernel, StructureId id, const SortedList& list, Extremum extremum)
      : kernel_(&kernel), id_(id), list_(&list), extremum_(extremum) {}

  std::string_view name() const override {
    return extremum_ == Extremum::kMaximum ? "maximum_sorted_list" : "minimum_sorted_list";
  }
  std::vector<std::string_view> event_kinds() const override;
  void build(std::span<const ObjectId> objects) override;
  void rebuild() override { winner_ = list_->extreme(extremum_); }
  // Never called: it has no certificates.
  void certificate_failed(CertificateId) override {}
  // Objects come and go in the list.
  void insert(ObjectId) override {}
  void erase(ObjectId) override {}
  // New motions may part objects that were tied, without a swap.
  void instant_settled() override { look(true); }
  void watched_changed(const Event* event) override { look(event != nullptr); }
  Attribute attribute() const override;
  std::vector<BoundCheck> bounds(const BoundContext& context) const override;
  void check_invariants(AuditReport& report) const override;
  void audit(const Snapshot& snapshot, AuditReport& report) const override;
  std::size_t bytes() const override { return sizeof *this; }

  // kNoObject if there is none.
  ObjectId winner() const { return winner_; }

 private:
  void look(bool report);

  Kernel* kernel_;
  StructureId id_;
  const SortedList* list_;
  Extremum extremum_;
  ObjectId winner_ = kNoObject;
};

}  // namespace kinex

#endif
