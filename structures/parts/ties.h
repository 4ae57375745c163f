// SPDX-License-Identifier: GPL-3.0-or-later
// Ties: the tags of a part's certificates that have become identically zero, until the owner has
// put the level items in the order of its rule.
//
// A certificate that is identically zero never fails, so a part notes it where it is made, and
// where a new motion makes it so. each_tie: the same for a structure whose parts settle their ties
// together.
#ifndef KINEX_STRUCTURES_PARTS_TIES_H
#define KINEX_STRUCTURES_PARTS_TIES_H

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/motion/scene.h"
#include "structures/parts/slots.h"

namespace kinex {

// Calls visit(certificate) for the ties of a structure, of whatever part, that came with the new
// motions of these objects; for one of several such objects several times. O(1) for each of their
// certificates.
template <class Visit>
void each_tie(Kernel& kernel, StructureId structure, std::span<const ObjectId> objects,
              const Visit& visit) {
  for (const ObjectId object : objects) {
    for (const CertificateId c : kernel.certificates_of(object)) {
      const bool tie = kernel.outlook(c) == Outlook::kIdenticallyZero;
      if (tie && kernel.structure_of(c) == structure) visit(c);
    }
  }
}

class Ties {
 public:
  // As Slots::set; notes the tag if the new certificate is identically zero.
  void set(Slots& slots, CertificateId& slot, const Query& query, std::uint32_t tag) {
    if (slots.set(slot, query, tag) == Outlook::kIdenticallyZero) note(tag);
  }
  // The same for full slots together (Slots::set).
  void set(Slots& slots, Kernel::Group& group) {
    slots.set(group);
    for (std::size_t i = 0; i < group.size; ++i) {
      if (group.outlooks[i] == Outlook::kIdenticallyZero) note(group.tags[i]);
    }
  }
  // Notes a certificate to be examined.
  void note(std::uint32_t tag) { tags_.push_back(tag); }
  // Notes the ties that came with the new motions of these objects.
  void note_of(const Slots& slots, std::span<const ObjectId> objects) {
    each_tie(slots.kernel(), slots.structure(), objects, [&](CertificateId c) {
      if (slots.owns(c)) note(slots.kernel().tag(c));
    });
  }
  // Calls settle(tag), the latest first, until no tag is left, including those noted meanwhile. A
  // tag may come twice, and its certificate may have changed since: `settle` must check it.
  template <class Settle>
  void settle(const Settle& settle) {
    while (!tags_.empty()) {
      const std::uint32_t tag = tags_.back();
      tags_.pop_back();
      settle(tag);
    }
  }
  bool empty() const { return tags_.empty(); }
  void clear() { tags_.clear(); }
  std::size_t bytes() const { return tags_.capacity() * sizeof(std::uint32_t); }

 private:
  std::vector<std::uint32_t> tags_;
};

}  // namespace kinex

#endif
