// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/range/leaf_sequence.h"

#include <algorithm>

namespace kinex {

void LeafSequence::assign(std::vector<ObjectId> leaves) {
  leaves_ = std::move(leaves);
  for (std::size_t i = 0; i < leaves_.size(); ++i) {
    place_[leaves_[i]] = static_cast<std::uint32_t>(i);
  }
}

void LeafSequence::move_behind(ObjectId leaf, ObjectId previous) {
  const auto at = [this](std::size_t i) {
    return leaves_.begin() + static_cast<std::ptrdiff_t>(i);
  };
  const std::size_t from = place_[leaf];
  const std::size_t behind = previous == kNoObject ? 0 : place_[previous] + std::size_t{1};
  if (from < behind) {
    std::rotate(at(from), at(from + 1), at(behind));
  } else {
    std::rotate(at(behind), at(from), at(from + 1));
  }
  for (std::size_t i = std::min(from, behind); i < std::max(from + 1, behind); ++i) {
    place_[leaves_[i]] = static_cast<std::uint32_t>(i);
  }
}

// A leaf moves when the one that it is behind has its place. Nothing gets between the two later on:
// no other leaf is behind the same one.
void LeafSequence::apply(Moves& moves) {
  while (!moves.empty()) {
    const auto waits = [&moves](const std::pair<ObjectId, ObjectId>& move) {
      return std::any_of(moves.begin(), moves.end(),
                         [&](const auto& other) { return other.first == move.second; });
    };
    const auto next = std::find_if_not(moves.begin(), moves.end(), waits);
    if (next == moves.end()) return;  // no tree has such a sequence
    move_behind(next->first, next->second);
    moves.erase(next);
  }
}

}  // namespace kinex
