// SPDX-License-Identifier: GPL-3.0-or-later
// LeafSequence: the leaves of a tree, depth first, as they were at one time, with the place of each.
// A few leaves that move are followed without a walk through the tree.
//
//   a b c d e     b goes behind d, the others keep their order     a c d b e
//
// Cost: a move is O(the number of leaves passed).
#ifndef KINEX_STRUCTURES_RANGE_LEAF_SEQUENCE_H
#define KINEX_STRUCTURES_RANGE_LEAF_SEQUENCE_H

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/motion/scene.h"

namespace kinex {

class LeafSequence {
 public:
  // Of objects below this number.
  explicit LeafSequence(std::size_t objects) : place_(objects) {}

  const std::vector<ObjectId>& leaves() const { return leaves_; }
  // In place of those that were there.
  void assign(std::vector<ObjectId> leaves);
  // kNoObject: the leaf is the first one. Requires that it is in the sequence.
  ObjectId previous(ObjectId leaf) const {
    return place_[leaf] == 0 ? kNoObject : leaves_[place_[leaf] - 1];
  }
  // Distinct leaves and what each of them is behind now (kNoObject: nothing). The others keep their
  // order among themselves.
  using Moves = std::vector<std::pair<ObjectId, ObjectId>>;
  // Moves that make the sequence that of a tree. Afterwards `moves` is empty.
  void apply(Moves& moves);
  std::size_t bytes() const {
    return leaves_.capacity() * sizeof(ObjectId) + place_.capacity() * sizeof(std::uint32_t);
  }

 private:
  void move_behind(ObjectId leaf, ObjectId previous);

  std::vector<ObjectId> leaves_;
  std::vector<std::uint32_t> place_;  // per object
};

}  // namespace kinex

#endif
