// SPDX-License-Identifier: GPL-3.0-or-later
// CellChanges: the cells that have joined and left an attribute, and their net effect.
#ifndef KINEX_STRUCTURES_TRIANGULATION_CELL_CHANGES_H
#define KINEX_STRUCTURES_TRIANGULATION_CELL_CHANGES_H

#include <array>
#include <cstddef>
#include <vector>

#include "core/engine/structure.h"
#include "core/motion/scene.h"

namespace kinex {

// Width: vertices of a cell; 3 or 4.
template <std::size_t Width>
class CellChanges {
 public:
  using Cell = std::array<ObjectId, Width>;  // in any order

  void came(Cell cell) { add(cell, true); }
  void gone(Cell cell) { add(cell, false); }
  void clear() { changes_.clear(); }
  std::size_t size() const { return changes_.size(); }
  // A cell that left and joined again, or the reverse, does not count. O(k log k).
  AttributeDifference net() const;
  // The attribute as it was before the changes.
  Attribute undone(Attribute after) const;
  std::size_t bytes() const { return changes_.capacity() * sizeof(Change); }

 private:
  struct Change {
    Cell cell;
    bool came;
  };
  void add(Cell cell, bool came);

  std::vector<Change> changes_;
};

}  // namespace kinex

#endif
