// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/range/leaf_tree_2.h"

#include <algorithm>

namespace kinex {

void LeafTree2::changing(std::span<const ObjectId> named) {
  constexpr std::size_t kFew = 24;  // with more leaves a walk through the tree is no longer dear
  if (!is_told_) {
    told_.assign(leaves());
    is_told_ = true;
  }
  if (!is_changing_) {
    is_changing_ = true;
    moved_.clear();
    all_moved_ = false;
    kernel_->settle_later(id_);
  }
  all_moved_ = all_moved_ || moved_.size() + named.size() > kFew;
  if (!all_moved_) moved_.insert(moved_.end(), named.begin(), named.end());
}

void LeafTree2::changing_all() {
  changing({});
  all_moved_ = true;
}

void LeafTree2::instant_over() {
  if (!is_changing_) return;
  is_changing_ = false;
  const auto report = [this](const std::vector<ObjectId>& before) {
    kernel_->report_settled(id_, before, told_.leaves());
  };
  if (all_moved_) {
    std::vector<ObjectId> now = leaves();
    if (now == told_.leaves()) return;
    const std::vector<ObjectId> before = told_.leaves();
    told_.assign(std::move(now));
    return report(before);
  }
  std::sort(moved_.begin(), moved_.end());
  moved_.erase(std::unique(moved_.begin(), moved_.end()), moved_.end());
  LeafSequence::Moves moves;
  bool is_same = true;
  for (const ObjectId leaf : moved_) {
    moves.emplace_back(leaf, leaf_before(leaf));
    is_same = is_same && moves.back().second == told_.previous(leaf);
  }
  if (is_same) return;
  const std::vector<ObjectId> before = told_.leaves();
  told_.apply(moves);
  report(before);
}

void LeafTree2::check_invariants(AuditReport& report) const {
  RangeStructure::check_invariants(report);
  report.check(!is_told_ || is_changing_ || told_.leaves() == leaves(),
               [] { return "a change of the leaves has not been reported"; });
}

}  // namespace kinex
