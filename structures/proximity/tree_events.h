// SPDX-License-Identifier: GPL-3.0-or-later
// TreeEvents: the external events of a spanning tree, in one form for all structures that maintain
// it.
//
// An instant changes the tree from what it was just before to what it is just after. The i-th edge
// that is gone, in ascending order, is paired with the i-th that came: one event of the kind `swap`
// for each pair, with the ends of both edges, and the change of the attribute (Event::gone, came).
// Where more edges are gone than came, or the reverse (only in an inexact arithmetic), one event
// "settled" has the difference. So structures that have nothing else in common report the same
// changes at the same instants.
#ifndef KINEX_STRUCTURES_PROXIMITY_TREE_EVENTS_H
#define KINEX_STRUCTURES_PROXIMITY_TREE_EVENTS_H

#include <cstddef>
#include <cstdint>
#include <utility>

#include "core/engine/kernel.h"
#include "core/engine/structure.h"
#include "structures/parts/edge_changes.h"
#include "structures/proximity/edge_lengths.h"

namespace kinex {

class TreeEvents {
 public:
  using Edge = EdgeLengths::Edge;

  // `reads`: the structure that has the edges. `swap`: external. `inside`: its internal twin.
  TreeEvents(Kernel& kernel, StructureId id, StructureId reads, std::uint8_t swap,
             std::uint8_t inside)
      : kernel_(&kernel), id_(id), reads_(reads), swap_(swap), inside_(inside) {}

  void came(const Edge& edge) { changes_.came(edge[0], edge[1]); }
  void gone(const Edge& edge) { changes_.gone(edge[0], edge[1]); }
  bool any() const { return changes_.size() != 0; }
  // Nothing is left to be reported.
  void begin() { changes_.clear(); }
  // A failure was repaired: the order of these two edges has changed, or the second has taken the
  // place of the first in the tree. Reports one event.
  void repaired(const Edge& before, const Edge& after);
  // The instant is over: reports what has changed.
  void over() { tell(); }
  // The tree before the changes that have not been reported.
  Attribute told(Attribute now) const { return changes_.undone(std::move(now)); }
  std::size_t bytes() const { return changes_.bytes(); }

 private:
  bool instant_is_over(StructureId structure) const;
  bool tell();

  Kernel* kernel_;
  StructureId id_, reads_;
  std::uint8_t swap_, inside_;
  EdgeChanges changes_;
};

}  // namespace kinex

#endif
