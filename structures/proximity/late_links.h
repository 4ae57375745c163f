// SPDX-License-Identifier: GPL-3.0-or-later
// LateLinks: the changes of a forest that its LinkCutForest has not made yet. For owners that change
// the forest often and seldom ask for a path.
#ifndef KINEX_STRUCTURES_PROXIMITY_LATE_LINKS_H
#define KINEX_STRUCTURES_PROXIMITY_LATE_LINKS_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "structures/parts/link_cut_forest.h"
#include "structures/proximity/tree_edges.h"

namespace kinex {

class LateLinks {
 public:
  // The edge has come into the forest, or has left it. Its number may be that of another edge later.
  void note(Item edge) {
    if (links_.size() <= edge) links_.resize(edge + std::size_t{1});
    if (links_[edge].is_stale) return;
    links_[edge].is_stale = true;
    stale_.push_back(edge);
  }
  // Makes the changes. `inside(edge)`: it is in the forest now. O(log n) a change, amortised; an edge
  // that came and left is none.
  template <class Inside>
  void update(LinkCutForest& forest, const TreeEdges& edges, const Inside& inside) {
    for (const Item edge : stale_) {
      Link& link = links_[edge];
      link.is_stale = false;
      const bool stays = inside(edge) && link.is_linked && link.ends == edges.ends(edge);
      if (link.is_linked && !stays) {
        forest.cut(edge, link.ends[0], link.ends[1]);
        link.is_linked = false;
      }
    }
    for (const Item edge : stale_) {
      Link& link = links_[edge];
      if (link.is_linked || !inside(edge)) continue;
      link.ends = edges.ends(edge);
      link.is_linked = true;
      forest.link(edge, link.ends[0], link.ends[1]);
    }
    stale_.clear();
  }
  // The LinkCutForest is empty, and so is the forest.
  void clear() {
    links_.clear();
    stale_.clear();
  }
  std::size_t bytes() const {
    return links_.capacity() * sizeof(Link) + stale_.capacity() * sizeof(Item);
  }

 private:
  struct Link {
    std::array<std::uint32_t, 2> ends{};  // as it was linked
    bool is_linked = false, is_stale = false;
  };
  std::vector<Link> links_;  // by edge
  std::vector<Item> stale_;
};

}  // namespace kinex

#endif
