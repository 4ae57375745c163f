// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/hull/convex_hull_2.h"

#include <algorithm>
#include <utility>

namespace kinex {

ConvexHull2::ConvexHull2(Kernel& kernel, StructureId id, const Scene& scene, Variant variant)
    : HullSource(kernel, id),
      variant_(variant),
      exact_(kernel.is_exact()),
      signs_(kernel),
      parts_{Slots(kernel, id, "x"),         Slots(kernel, id, "y"),
             Slots(kernel, id, "s"),         Slots(kernel, id, "s of tangents"),
             Slots(kernel, id, "left ends"), Slots(kernel, id, "right ends")},
      leaf_of_(scene.objects.size(), kNone) {}

std::vector<std::string_view> ConvexHull2::event_kinds() const {
  return HullEvents::kinds({"x", "yl", "yr", "yb", "yt", "sl", "sr", "st", "end"});
}

void ConvexHull2::give_up(const std::string& what) {
  if (corrupt_) return;
  corrupt_ = true;
  kernel_->corrupt(id_, what);
}

// The points of a chain, from left to right, without those that only the rule for ties puts on it.
std::vector<ObjectId> ConvexHull2::strict_chain(Index node) const {
  std::vector<ObjectId> chain;
  for (Index e = nodes_[node].first; e != kNone; e = edges_[e].next) {
    const ObjectId id = edges_[e].point;
    if (signs_.tied()) {
      if (!chain.empty() && signs_.equal(chain.back(), id)) {
        chain.back() = std::min(chain.back(), id);
        continue;
      }
      while (chain.size() > 1 && signs_.collinear(chain[chain.size() - 2], chain.back(), id)) {
        chain.pop_back();
      }
    }
    chain.push_back(id);
  }
  return chain;
}

std::vector<ObjectId> ConvexHull2::hull_cycle() const {
  if (root_ == kNone) return {};
  std::vector<ObjectId> cycle = strict_chain(2 * root_ + Half::kLower);
  const std::vector<ObjectId> upper = strict_chain(2 * root_ + Half::kUpper);
  for (std::size_t i = upper.size(); i-- > 0;) {
    if (upper[i] != cycle.back() && upper[i] != cycle.front()) cycle.push_back(upper[i]);
  }
  start_at_smallest(cycle);
  return cycle;
}

Attribute ConvexHull2::attribute() const {
  if (corrupt_) return {Attribute::Shape::kCycle, {}};
  // As last read: an inexact arithmetic might read another one now.
  if (!exact_) return told();
  return {Attribute::Shape::kCycle, hull_cycle()};
}

std::size_t ConvexHull2::bytes() const {
  return sizeof *this + edges_.capacity() * sizeof(Edge) + nodes_.capacity() * sizeof(Node) +
         tree_.capacity() * sizeof(TreeNode) + events_.bytes() +
         (free_edges_.capacity() + free_tree_nodes_.capacity() + leaf_of_.capacity() +
          stale_.capacity()) *
             sizeof(Index) +
         (todo_.capacity() + tied_.capacity()) * sizeof(Claimed);
}

}  // namespace kinex
