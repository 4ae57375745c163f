// SPDX-License-Identifier: GPL-3.0-or-later
// MaximumStructure: the common base class of structures for the object with the largest (or
// smallest) key: the name, the attribute, its external events, the audit.
#ifndef KINEX_STRUCTURES_MAXIMUM_MAXIMUM_STRUCTURE_H
#define KINEX_STRUCTURES_MAXIMUM_MAXIMUM_STRUCTURE_H

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "core/engine/kernel.h"
#include "core/engine/structure.h"
#include "core/motion/scene.h"
#include "structures/parts/attribute_events.h"
#include "structures/parts/key_order.h"

namespace kinex {

class MaximumStructure : public Structure {
 public:
  std::string_view name() const override { return name_; }
  void instant_settled() override { events_.over(winner()); }
  Attribute attribute() const override;
  Attribute told() const override { return events_.told(); }
  void audit(const Snapshot& snapshot, AuditReport& report) const override;

  // kNoObject if there is none.
  virtual ObjectId winner() const = 0;

 protected:
  // `replace`: the kind of the events that report a change of the maximum.
  MaximumStructure(Kernel& kernel, StructureId id, const Scene& scene, const Contest& contest,
                   std::string_view maximum_name, std::string_view minimum_name,
                   std::uint8_t replace)
      : kernel_(&kernel),
        id_(id),
        contest_(contest),
        objects_(scene.objects.size()),
        events_(kernel, id, replace),
        name_(contest.extremum() == Extremum::kMaximum ? maximum_name : minimum_name) {}

  // Checks that the maximum as last reported is the present one.
  void check_told(AuditReport& report) const;

  Kernel* kernel_;
  StructureId id_;
  Contest contest_;
  std::size_t objects_;  // of the scene
  AttributeEvents events_;

 private:
  std::string_view name_;
};

// The best (key, id) at exact positions is `attribute`: of equal keys the smallest id.
void audit_extremum(const Key& key, Extremum extremum, std::size_t objects,
                    const Attribute& attribute, const Snapshot& snapshot, AuditReport& report);

}  // namespace kinex

#endif
