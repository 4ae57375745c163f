// SPDX-License-Identifier: GPL-3.0-or-later
// Slots: the certificates of one part of a structure, each in a slot that the part keeps wherever
// it chooses (an array, a node, a label of a half-edge).
//
// A slot is a CertificateId, kNoCertificate while it is empty. Each part has its own space of tags:
// two parts of one structure may use the same ones. In `certificate_failed` the structure finds the
// part by owns(), or by Kernel::part().
//
// Cost: that of the kernel's calls and a few counters, which no benchmark row can measure.
#ifndef KINEX_STRUCTURES_PARTS_SLOTS_H
#define KINEX_STRUCTURES_PARTS_SLOTS_H

#include <algorithm>
#include <string>
#include <utility>

#include "core/engine/kernel.h"

namespace kinex {

class Slots {
 public:
  // `name`: of the part's line in the structure's ledger.
  Slots(Kernel& kernel, StructureId structure, std::string name)
      : Slots(kernel, structure, kernel.add_part(structure, std::move(name))) {}

  Kernel& kernel() const { return *kernel_; }
  StructureId structure() const { return structure_; }
  const PartLedger& line() const { return *line_; }

  // Creates the certificate "query >= 0" in an empty slot, or replaces the one in it.
  Outlook set(CertificateId& slot, const Query& query, std::uint32_t tag) {
    ++line_->created;
    if (slot != kNoCertificate) {
      ++line_->retracted;
      return kernel_->replace(slot, query, tag);
    }
    line_->max_live = std::max(line_->max_live, ++line_->live);
    const Kernel::Created created = kernel_->create(structure_, query, tag, part_);
    slot = created.id;
    return created.outlook;
  }
  // As set(), but a certificate that claims this already is kept, and only gets the tag.
  Outlook renew(CertificateId& slot, const Query& query, std::uint32_t tag) {
    if (slot == kNoCertificate || !kernel_->claims(slot, query)) return set(slot, query, tag);
    kernel_->set_tag(slot, tag);
    return kernel_->outlook(slot);
  }
  // As set() for one full slot after the other, in less time: Kernel::replace.
  void set(Kernel::Group& group) {
    line_->created += group.size;
    line_->retracted += group.size;
    kernel_->replace(group);
  }
  // Retracts the certificate, if there is one.
  void drop(CertificateId& slot) {
    if (slot == kNoCertificate) return;
    --line_->live;
    ++line_->retracted;
    kernel_->retract(slot);
    slot = kNoCertificate;
  }
  // True if a live certificate, of any structure, belongs to this part.
  bool owns(CertificateId c) const {
    return kernel_->part(c) == part_ && kernel_->structure_of(c) == structure_;
  }
  bool is_tie(CertificateId slot) const {
    return slot != kNoCertificate && kernel_->outlook(slot) == Outlook::kIdenticallyZero;
  }
  // Its certificate has failed: counts it. Returns the tag.
  std::uint32_t failed(CertificateId c) {
    ++line_->failures;
    return kernel_->tag(c);
  }
  // For audits: true if the slot holds a certificate of this query and tag.
  bool holds(CertificateId slot, const Query& query, std::uint32_t tag) const {
    return slot != kNoCertificate && owns(slot) && kernel_->tag(slot) == tag &&
           kernel_->claims(slot, query);
  }

 private:
  Slots(Kernel& kernel, StructureId structure, const Kernel::NewPart& part)
      : kernel_(&kernel), structure_(structure), part_(part.id), line_(&part.line) {}

  Kernel* kernel_;
  StructureId structure_;
  PartId part_;
  PartLedger* line_;  // in the structure's ledger
};

}  // namespace kinex

#endif
