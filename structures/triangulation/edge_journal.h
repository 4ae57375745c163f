// SPDX-License-Identifier: GPL-3.0-or-later
// EdgeJournal: which edges of a triangulation may have come or gone, in order, so that a reader that has
// seen the edges at one time need not read all of them at the next.
//
//   touched   ab  cd  ac  ...  ef  gh     The reader asks of ef and gh whether they are edges now.
//                          ^ seen         That they have come and gone in between does not matter.
//
// The journal keeps the last few thousand edges: a reader that stays further behind, and one that has seen a
// triangulation that was dropped, has to read all edges again.
//
// Cost: amortised O(1) for an edge; O(k log k) for what k touched edges were. At most 32 KB.
#ifndef KINEX_STRUCTURES_TRIANGULATION_EDGE_JOURNAL_H
#define KINEX_STRUCTURES_TRIANGULATION_EDGE_JOURNAL_H

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/motion/scene.h"
#include "structures/parts/sort_unique.h"

namespace kinex {

class EdgeJournal {
 public:
  using Edge = std::array<ObjectId, 2>;  // ascending
  using Position = std::uint64_t;        // in the journal, from 1 on; 0: of no reader

  // The edge has come or gone, or is to be asked for in any case.
  void touch(ObjectId a, ObjectId b) {
    if (touched_.size() == kMost) forget_half();
    touched_.push_back({std::min(a, b), std::max(a, b)});
  }
  // All edges may have come or gone.
  void forget() {
    begin_ += touched_.size() + 1;
    touched_.clear();
  }

  // The end.
  Position position() const { return begin_ + touched_.size(); }
  // The edges touched since, ascending and without repetitions; nullopt: they are not known any more.
  std::optional<std::vector<Edge>> since(Position seen) const {
    if (seen < begin_) return std::nullopt;
    const auto from = touched_.begin() + static_cast<std::ptrdiff_t>(seen - begin_);
    std::vector<Edge> edges(from, touched_.end());
    sort_unique(edges);
    return edges;
  }
  // Behind the edges of one change, if a reader has seen all before them and they were touched next, each
  // once; else where it was.
  Position behind(Position seen, std::span<const Edge> change) const {
    if (seen < begin_ || position() - seen < change.size()) return seen;
    const auto from = touched_.begin() + static_cast<std::ptrdiff_t>(seen - begin_);
    const auto to = from + static_cast<std::ptrdiff_t>(change.size());
    return std::is_permutation(from, to, change.begin(), change.end()) ? seen + change.size()
                                                                       : seen;
  }
  std::size_t bytes() const { return touched_.capacity() * sizeof(Edge); }

 private:
  // The older one.
  void forget_half() {
    touched_.erase(touched_.begin(), touched_.begin() + kMost / 2);
    begin_ += kMost / 2;
  }

  static constexpr std::size_t kMost = 4096;

  Position begin_ = 1;  // the position of touched_.front()
  std::vector<Edge> touched_;
};

}  // namespace kinex

#endif
