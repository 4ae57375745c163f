// SPDX-License-Identifier: GPL-3.0-or-later
// TournamentEpochs: the hard bound on the failures of a tournament, whatever changes it.
//
// The tree lies in an array: the children of node v are 2v and 2v + 1, the leaves are n .. 2n - 1.
// A change below a node begins a new epoch of the node. In one epoch the winners of a node with m
// leaves below form a Davenport-Schinzel sequence of order D, where D is the degree in t of the
// claims: each winner is strictly in front of the last one right after an instant at which they
// are level, roots counted with multiplicity, and the first one is in front of none that were in
// front of it at the beginning. So an epoch has at most lambda_D(m) - 1 failures at the node.
//
//            1                 time         leaf 5 changes
//         ___|___              node 1  |--- L(4) - 1 ---|--- L(4) - 1 ---     L = lambda_D
//        2       3             node 2  |--- L(2) - 1 ---|--- L(2) - 1 ---
//       _|_     _|_            node 3  |---------- L(2) - 1 -------------
//      4  [5]  6   7
//                              bound: 2 (L(4) - 1) + 3 (L(2) - 1) failures
#ifndef KINEX_STRUCTURES_PARTS_TOURNAMENT_EPOCHS_H
#define KINEX_STRUCTURES_PARTS_TOURNAMENT_EPOCHS_H

#include <bit>
#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "core/numbers/integer.h"

namespace kinex {

// The depth of a tournament of n leaves, ceil(log2 n): an item is in at most as many certificates.
inline std::uint64_t tournament_depth(std::size_t leaves) {
  return leaves < 2 ? 0 : static_cast<std::uint64_t>(std::bit_width(leaves - 1));
}

class TournamentEpochs {
 public:
  using Node = std::uint32_t;

  // A tree of n leaves was built.
  void built(std::size_t leaves) { ++trees_[leaves]; }
  // Changes begin at these nodes of a tree of n leaves: begins an epoch of each of them and of those above,
  // once. 0 and leaves that once were inner nodes are left out. O(k log n) for k nodes.
  void begin(std::span<const Node> nodes, std::size_t leaves);
  // The bound, for claims of this degree. O(n), and O(n) per size of a tree that was built.
  Integer most_failures(int degree) const;
  // Likewise, if two items, one below each child of a node, have at most `failures` failures there in
  // an epoch.
  Integer most_failures_of_pairs(int failures) const;
  std::size_t bytes() const {
    return nodes_.capacity() * sizeof(std::uint64_t) + trees_.size() * 64 +  // of a map, about
           paths_.capacity() * sizeof(Node);
  }

 private:
  // most(m): of one epoch at a node of m leaves.
  template <class Most>
  Integer most_in_epochs(const Most& most) const;

  // Epochs of nodes by their number of leaves: of single changes, and (trees_) of whole trees, by the number
  // of leaves of these.
  std::vector<std::uint64_t> nodes_;
  std::map<std::size_t, std::uint64_t> trees_;
  std::vector<Node> paths_;  // scratch
};

}  // namespace kinex

#endif
