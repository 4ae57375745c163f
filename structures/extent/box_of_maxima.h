// SPDX-License-Identifier: GPL-3.0-or-later
// BoxOfMaxima: the smallest box with sides along the axes, read off structures that maintain the
// extreme object of each axis: bounding_box by another kind of maximum.
//
// It watches 2 dim structures, a minimum and a maximum of each axis, and has no certificates of its
// own.
//
//      minimum_heap by x   maximum_heap by x   minimum_heap by y   maximum_heap by y
//            \___________________ \______________ / _________________/
//                              the box: 2 dim ids
//
// Quality: that of what it reads (structures/maximum/README.md), O(dim) time for a change. External
// events: one for each instant that changes a side, at most those of bounding_box.
//
// Ties. Of points with identically equal coordinates the smallest id is on the side.
//
// Source: Guibas, "Kinetic data structures: a state of the art report" (1998), sections 5 and 6.7.
#ifndef KINEX_STRUCTURES_EXTENT_BOX_OF_MAXIMA_H
#define KINEX_STRUCTURES_EXTENT_BOX_OF_MAXIMA_H

#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/engine/structure.h"
#include "structures/parts/attribute_events.h"

namespace kinex {

class BoxOfMaxima final : public Structure {
 public:
  // `extrema`: of the first axis the minimum and the maximum, of the next axis, and so on. They
  // outlive this structure and are watched by it; their attribute is one object.
  BoxOfMaxima(Kernel& kernel, StructureId id, std::string_view name,
              std::vector<const Structure*> extrema)
      : kernel_(&kernel),
        id_(id),
        name_(name),
        extrema_(std::move(extrema)),
        events_(kernel, id, Attribute::Shape::kSequence) {}

  std::string_view name() const override { return name_; }
  std::vector<std::string_view> event_kinds() const override { return common_event_kinds({}); }
  void build(std::span<const ObjectId>) override { begin(); }
  void rebuild() override { begin(); }
  // Never called: it has no certificates.
  void certificate_failed(CertificateId) override {}
  // Points come and go in what it reads; the change of the box that they cause is no event.
  void insert(ObjectId) override { begin(); }
  void erase(ObjectId) override { begin(); }
  void instant_over() override { events_.over(box()); }
  void watched_changed(const Event*) override {
    if (box() != events_.told().ids) kernel_->settle_later(id_);
  }
  // New motions may separate points that were tied, or tie them, without an event.
  void motions_changed(std::span<const ObjectId>) override { kernel_->settle_later(id_); }
  // The extreme points: the first axis' minimum and maximum, those of the next axis, and so on.
  Attribute attribute() const override { return {Attribute::Shape::kSequence, box()}; }
  Attribute told() const override { return events_.told(); }
  std::vector<BoundCheck> bounds(const BoundContext& context) const override;
  void check_invariants(AuditReport& report) const override;
  void audit(const Snapshot& snapshot, AuditReport& report) const override;
  std::size_t bytes() const override {
    return extrema_.capacity() * sizeof extrema_[0] + events_.bytes();
  }

 private:
  std::vector<ObjectId> box() const;
  void begin() { events_.begin(box()); }

  Kernel* kernel_;
  StructureId id_;
  std::string_view name_;
  std::vector<const Structure*> extrema_;
  AttributeEvents events_;
};

}  // namespace kinex

#endif
