// SPDX-License-Identifier: GPL-3.0-or-later
// AttributeChange: the difference between consecutive values of an attribute. It can be applied in
// both directions, so a replay needs no copies of whole values.
#ifndef KINEX_EXPERIMENTS_VIEW_ATTRIBUTE_CHANGE_H
#define KINEX_EXPERIMENTS_VIEW_ATTRIBUTE_CHANGE_H

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/engine/structure.h"

namespace kinex::view {

struct AttributeChange {
  std::uint64_t event = 0;  // the number of the event that made it, from 1; 0: before any
  // Sequences, cycles and objects: at place `at` the ids `removed` are replaced by `added`. Sets of
  // tuples: both are tuples, flattened and sorted; `at` is 0.
  std::size_t at = 0;
  std::vector<ObjectId> removed, added;

  bool empty() const { return removed.empty() && added.empty(); }
  friend bool operator==(const AttributeChange&, const AttributeChange&) = default;
};

// The smallest change of this form. Requires equal shapes. O(size).
AttributeChange difference(const Attribute& before, const Attribute& after);

// Throws std::logic_error if the change does not fit.
void apply(const AttributeChange& change, Attribute& attribute);

}  // namespace kinex::view

#endif
