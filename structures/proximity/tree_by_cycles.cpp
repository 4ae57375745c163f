// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/proximity/tree_by_cycles.h"

#include <algorithm>
#include <array>

#include "core/engine/bound.h"
#include "structures/parts/merge_sort.h"

namespace kinex {

// Proves that an edge outside the tree, which has no records, is the longest of its cycle.
void TreeByCycles::prove(Item outside) {
  const auto [u, v] = edges_->ends(outside);
  std::vector<Item> path = forest_.path(u, v);
  std::sort(path.begin(), path.end());
  for (const Item inside : path) records_.add(inside, outside, outside);
}

// ---- the tree

// `after`, outside the tree, takes the place of `before`, which is on its path. All edges that
// cross the cut, those with a record of `before`, have other paths then. Returns the cycle, ascending:
// `after` and what was its path.
std::vector<Item> TreeByCycles::replace(Item before, Item after) {
  std::vector<Item> crossing, cycle{after};
  for (const Place place : records_.uses(before)) crossing.push_back(records_[place].outside);
  for (const Place place : records_.cycle(after)) cycle.push_back(records_[place].inside);
  std::sort(crossing.begin(), crossing.end());
  std::sort(cycle.begin(), cycle.end());
  records_.drop_cycle(after);
  take_out(before);
  put_in(after);
  for (const Item item : cycle) marks_[item] = kOnCycle;
  for (const Item item : crossing) {
    if (item != after) exchange_along(cycle, item);
  }
  for (const Item item : cycle) marks_[item] = kNotOnCycle;
  return cycle;
}

// The path of `outside` was on one side of the cycle, and is on the other side now:
//
//         b -- c -- d           the path  ..abcd..  becomes  ..afed..
//    .. a             .. d ..
//         f -- e --
//
// A record of an edge that left the path becomes that of one that came.
void TreeByCycles::exchange_along(std::span<const Item> cycle, Item outside) {
  gone_.clear();
  for (const Place place : records_.cycle(outside)) {
    Mark& mark = marks_[records_[place].inside];
    if (mark == kNotOnCycle) continue;
    mark = kOnCycleAndPath;
    gone_.push_back(place);
  }
  std::size_t used = 0;
  for (const Item inside : cycle) {
    if (marks_[inside] == kOnCycleAndPath) {
      marks_[inside] = kOnCycle;
    } else if (used < gone_.size()) {
      records_.change(gone_[used++], inside, outside);
    } else {
      records_.add(inside, outside, outside);
    }
  }
  for (; used < gone_.size(); ++used) records_.drop(gone_[used]);
}

void TreeByCycles::swap(Item before, Item after) {
  for (const Item inside : replace(before, after)) {
    if (inside != before) records_.add(inside, before, before);
  }
}

// The shortest edge that crosses the cut of a tree edge right after now; kNoItem: there is none.
Item TreeByCycles::replacement_of(Item item) const {
  Item best = kNoItem;
  for (const Place place : records_.uses(item)) {
    const Item outside = records_[place].outside;
    if (best == kNoItem || in_front(*kernel_, order(), outside, best)) best = outside;
  }
  return best;
}

// ---- the edges

// In Kruskal's order no swap is needed.
void TreeByCycles::build(std::vector<Item> items) {
  records_.clear();
  marks_.clear();
  clear();
  merge_sort(items, [this](Item a, Item b) { return in_front(*kernel_, order(), a, b); });
  for (const Item item : items) add(item);
  finish(Change::kSized);
}

void TreeByCycles::add(Item item) {
  enter(item);
  records_.make_room(item + std::size_t{1});
  if (marks_.size() <= item) marks_.resize(item + std::size_t{1}, kNotOnCycle);
  const auto [u, v] = edges_->ends(item);
  if (forest_.connected(u, v)) {
    prove(item);
  } else {
    put_in(item);
  }
}

void TreeByCycles::remove(Item item) {
  if (in_tree(item)) {
    const Item other = replacement_of(item);
    if (other == kNoItem) {
      take_out(item);
    } else {
      replace(item, other);
    }
  }
  records_.drop_cycle(item);
  leave(item);
}

void TreeByCycles::finish(Change change) {
  settle_ties();
  if (change == Change::kSized) settle_failures();
  records_.forget_failing();  // they fail next
}

// ---- ties and failures

// Of level edges the one that goes first is in the tree.
void TreeByCycles::settle_ties() {
  for (std::uint64_t steps = 0;; ++steps) {
    if (!may_go_on(steps)) return records_.give_up();
    const auto place = records_.next_tie();
    if (!place) return;
    const Record record = records_[*place];
    swap(record.inside, record.outside);
    events_->tied(ids(record.inside), ids(record.outside));
    kernel_->settle_later(id_);
  }
}

// While points come and go nothing may be left to fail.
void TreeByCycles::settle_failures() {
  for (std::uint64_t steps = 0;; ++steps) {
    if (!may_go_on(steps)) return records_.give_up();
    const auto place = records_.next_failing();
    if (!place) return;
    const Record record = records_[*place];
    swap(record.inside, record.outside);
    settle_ties();
  }
}

void TreeByCycles::certificate_failed(CertificateId failed) {
  const Record record = records_[records_.failed(failed)];
  swap(record.inside, record.outside);
  records_.forget_failing();  // they fail next
  events_->repaired(ids(record.inside), ids(record.outside));
  settle_ties();
}

void TreeByCycles::motions_changed(std::span<const ObjectId> objects) {
  records_.note_ties(objects);
  settle_ties();
  records_.forget_failing();
}

void TreeByCycles::renew(std::span<const Item> items) {
  records_.renew(items);
  settle_ties();
  records_.forget_failing();  // they fail next
}

// ---- checks

void TreeByCycles::visit_proof(ProofVisitor& visitor) const {
  ProofGroup group;
  group.kind = "edge outside the tree";
  for (const Item item : present()) {
    if (in_tree(item) || records_.cycle(item).empty()) continue;
    group.about = about(std::array{item});
    visitor.group(group);
    for (const Place place : records_.cycle(item)) {
      visitor.certificate(records_[place].certificate, "longer than an edge of its path");
    }
  }
}

// The tree of a connected graph of n vertices has n - 1 edges; that of another has fewer, and its
// paths are shorter. For m edges, k of them in the tree, at most (m - k) k.
Integer TreeByCycles::most_certificates(std::size_t edges, std::size_t vertices) const {
  const std::size_t k = vertices == 0 ? 0 : std::min(vertices - 1, edges / 2);
  return counted(edges - k) * counted(k);
}

void TreeByCycles::check(AuditReport& report) const {
  LinkCutForest forest = forest_;
  for (const Item item : present()) {
    const auto [u, v] = edges_->ends(item);
    if (!forest.connected(u, v)) {
      report.check(false, [] { return "the ends of an edge are not connected"; });
      continue;
    }
    std::vector<Item> path = forest.path(u, v);
    if (in_tree(item)) {
      report.check(path == std::vector<Item>{item}, [] { return "the forest lacks an edge"; });
      continue;
    }
    std::vector<Item> proved;
    for (const Place place : records_.cycle(item)) {
      proved.push_back(records_[place].inside);
      report.check(records_[place].outside == item && in_tree(records_[place].inside),
                   [] { return "a cycle of something else"; });
    }
    records_.check(item, report);
    std::sort(path.begin(), path.end());
    std::sort(proved.begin(), proved.end());
    report.check(path == proved, [] { return "a cycle is not proved"; });
  }
  records_.check_all(report);
}

std::size_t TreeByCycles::bytes() const {
  return base_bytes() + records_.bytes() + marks_.capacity();
}

}  // namespace kinex
