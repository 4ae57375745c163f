// SPDX-License-Identifier: GPL-3.0-or-later
// HullRing: the vertices of a convex hull as a ring, counter-clockwise.
//
// A vertex is a strict one; of equal points it is the smallest id. A ring of two vertices is a
// segment, traversed there and back; of one vertex, all points are equal; of none, there are none.
//
// Cost: O(1) for a neighbour and for a vertex that comes or goes; O(h) for the cycle of h vertices.
#ifndef KINEX_STRUCTURES_HULL_HULL_RING_H
#define KINEX_STRUCTURES_HULL_HULL_RING_H

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "core/motion/scene.h"

namespace kinex {

// Turns a cycle so that it starts at its smallest id.
inline void start_at_smallest(std::vector<ObjectId>& cycle) {
  std::rotate(cycle.begin(), std::min_element(cycle.begin(), cycle.end()), cycle.end());
}

class HullRing {
 public:
  std::size_t size() const { return size_; }
  bool has(ObjectId vertex) const { return vertex < links_.size() && links_[vertex].next != kNoObject; }
  // Require has(vertex). In a ring of one vertex, itself.
  ObjectId next(ObjectId vertex) const { return links_[vertex].next; }
  ObjectId previous(ObjectId vertex) const { return links_[vertex].previous; }
  // Some vertex; kNoObject if there is none.
  ObjectId any() const { return any_; }
  // From the smallest id on.
  std::vector<ObjectId> cycle() const;

  // The ring is this cycle. False, with nothing changed, if it passes a vertex twice.
  bool assign(std::span<const ObjectId> cycle);
  // `vertex` comes between the neighbours `from` and `to`, or leaves from between them. False, with
  // nothing changed, if the ring contradicts that. A ring keeps at least two vertices.
  bool enter(ObjectId vertex, ObjectId from, ObjectId to);
  bool leave(ObjectId vertex, ObjectId from, ObjectId to);

  std::size_t bytes() const { return links_.capacity() * sizeof(Link); }

 private:
  struct Link {
    ObjectId next = kNoObject, previous = kNoObject;
  };
  void link(ObjectId from, ObjectId to) {
    links_[from].next = to;
    links_[to].previous = from;
  }

  std::vector<Link> links_;  // by object
  std::size_t size_ = 0;
  ObjectId any_ = kNoObject;
};

}  // namespace kinex

#endif
