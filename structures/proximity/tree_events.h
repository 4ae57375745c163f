// SPDX-License-Identifier: GPL-3.0-or-later
// TreeEvents: the external events of a spanning tree, in one form for all structures that maintain
// it.
//
// An instant changes the tree from what it was just before to what it is just after. The i-th edge
// that is gone, in ascending order, is paired with the i-th that came: one event of the kind `swap`
// for each pair, with the ids of both edges, and the change of the attribute (Event::gone, came).
// Where more edges are gone than came, or the reverse (in an inexact arithmetic, or where a graph
// has become connected), one event "settled" has the difference. So structures that have nothing
// else in common report the same changes at the same instants.
#ifndef KINEX_STRUCTURES_PROXIMITY_TREE_EVENTS_H
#define KINEX_STRUCTURES_PROXIMITY_TREE_EVENTS_H

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "core/engine/kernel.h"
#include "core/engine/structure.h"
#include "structures/proximity/tree_edges.h"

namespace kinex {

// The kinds of events of all structures of this form, by rank.
enum TreeEventKind : std::uint8_t {
  kTreeSwap,    // external: the edge that is gone, the edge that came
  kTreeInside,  // internal: a failure was repaired; the two edges, "order" or "cycle", for example
  kTreeTie,     // the same, because two lengths have become identically equal
};

class TreeEvents {
 public:
  // `reads`: the structure that has the edges; nullopt: none.
  TreeEvents(Kernel& kernel, StructureId id, std::optional<StructureId> reads)
      : kernel_(&kernel), id_(id), reads_(reads) {}

  virtual ~TreeEvents() = default;

  void came(const EdgeIds& edge) { count(edge, 1); }
  void gone(const EdgeIds& edge) { count(edge, -1); }
  // What has changed and was not reported: edges in ascending order, flattened.
  AttributeDifference net() const;
  bool any() const { return !changes_.empty(); }
  // Nothing is left to be reported.
  void begin() { changes_.clear(); }
  // A failure was repaired: the order of these two edges has changed, or the second has taken the
  // place of the first in the tree. Reports one event.
  virtual void repaired(const EdgeIds& before, const EdgeIds& after);
  // Reports a tie that was resolved.
  virtual void tied(const EdgeIds& before, const EdgeIds& after) {
    report(kTreeTie, before, after, false);
  }
  // What has changed will be reported when the instant is over.
  void settle_later() { kernel_->settle_later(id_); }
  // The instant is over: reports what has changed.
  void over() { tell(); }
  // The tree before the changes that have not been reported.
  Attribute told(Attribute now) const;
  std::size_t bytes() const {
    return changes_.size() * (sizeof(EdgeIds) + 48) +
           (gone_.capacity() + came_.capacity()) * sizeof(EdgeIds);
  }

 private:
  void count(const EdgeIds& edge, int change);
  void report(TreeEventKind kind, const EdgeIds& before, const EdgeIds& after, bool external);
  bool tell();

  Kernel* kernel_;
  StructureId id_;
  std::optional<StructureId> reads_;
  std::map<EdgeIds, int> changes_;  // how often it came, less how often it is gone; not 0
  std::vector<EdgeIds> gone_, came_;  // of tell()
};

}  // namespace kinex

#endif
