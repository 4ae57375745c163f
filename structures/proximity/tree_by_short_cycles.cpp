// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/proximity/tree_by_short_cycles.h"

#include <algorithm>
#include <array>
#include <map>

#include "core/engine/bound.h"
#include "structures/parts/merge_sort.h"

namespace kinex {

LinkCutForest& TreeByShortCycles::forest() {
  late_.update(forest_, *edges_, [this](Item item) { return in_tree(item); });
  return forest_;
}

// `item` is in the tree and on the path between the ends of `outside`.
bool TreeByShortCycles::is_on_path(Item item, Item outside) {
  const auto [u, v] = edges_->ends(outside);
  return forest().on_path(item, u, v);
}

// ---- the tree

void TreeByShortCycles::put_in_late(Item item) {
  count_in(item);
  late_.note(item);
}

void TreeByShortCycles::take_out_late(Item item) {
  count_out(item);
  late_.note(item);
}

// The cycle of `after` becomes that of another edge of it. O(1) certificates.
void TreeByShortCycles::hand_over(Item after, Item before) {
  records_.exchange_cycles(after, before);
  for (const Place place : records_.cycle(before)) {
    if (records_[place].inside == before) return records_.change(place, after, before);
  }
}

// `after` takes the place of `before`, an edge of its cycle and of its path.
void TreeByShortCycles::swap(Item before, Item after) {
  take_out_late(before);
  put_in_late(after);
  hand_over(after, before);
}

// The inside of a record is longer than its outside now. `is_alone`: no other claim fails at the
// instant, and the edges are those before it.
void TreeByShortCycles::repair(Place place, bool is_alone) {
  const Record record = records_[place];
  const Item before = record.inside, after = record.outside;
  if (after != record.owner) {
    for (const Place other : records_.cycle(record.owner)) {
      if (records_[other].inside == after) return records_.change(place, before, records_[other].outside);
    }
  }
  if (in_tree(before) && (is_alone || is_on_path(before, after))) return swap(before, after);
  find_cycle_without(after, before, is_alone);
  const bool is_better =
      !in_tree(before) && records_.cycle(after).size() < records_.cycle(before).size();
  if (is_better) hand_over(after, before);
  prove(after, is_better ? kNoPlace : place);
}

// The shortest edge across the cut of a tree edge right after now; kNoItem: there is none. The edge is
// in its cycle, unless records fail now: then all edges are looked at.
Item TreeByShortCycles::replacement_of(Item item) {
  Item best = kNoItem;
  const auto offer = [&](Item outside) {
    if (in_tree(outside) || !is_on_path(item, outside)) return;
    if (best == kNoItem || is_shorter(outside, best)) best = outside;
  };
  for (const Place place : records_.uses(item)) offer(records_[place].owner);
  if (best != kNoItem) return best;
  const auto is_leaf = [&](std::uint32_t vertex) {
    const auto here = adjacent_->at(vertex);
    return std::none_of(here.begin(), here.end(),
                        [&](const EdgeAt& one) { return one.edge != item && has(one.edge); });
  };
  const auto [u, v] = edges_->ends(item);
  if (is_leaf(u) || is_leaf(v)) return kNoItem;
  for (const Item other : present()) offer(other);
  if (best != kNoItem) {
    find_path(best);
    prove(best, kNoPlace);
  }
  return best;
}

// ---- the edges

// In Kruskal's order no swap is needed, and what is there is shorter than what comes.
void TreeByShortCycles::build(std::vector<Item> items) {
  records_.clear();
  late_.clear();
  marks_.clear();
  clear();
  merge_sort(items, [this](Item a, Item b) { return is_shorter(a, b); });
  for (const Item item : items) {
    const auto [u, v] = edges_->ends(item);
    enter_graph(item);
    if (forest().connected(u, v)) {
      find_short(item);
      prove(item, kNoPlace);
    } else {
      put_in_late(item);
    }
  }
  finish(Change::kSized);
}

void TreeByShortCycles::enter_graph(Item item) {
  enter(item);
  records_.make_room(item + std::size_t{1});
  if (marks_.size() <= item) marks_.resize(item + std::size_t{1}, 0);
}

void TreeByShortCycles::add(Item item) {
  last_change_ = kernel_->instant_number();
  enter_graph(item);
  if (!find_triangle(item, kNoItem)) {
    const auto [u, v] = edges_->ends(item);
    if (!forest().connected(u, v)) return put_in_late(item);
    find_path(item);
  }
  prove(item, kNoPlace);
}

void TreeByShortCycles::remove(Item item) {
  last_change_ = kernel_->instant_number();
  if (in_tree(item)) {
    const Item other = replacement_of(item);
    if (other == kNoItem) {
      take_out_late(item);
    } else {
      swap(item, other);
    }
  }
  const bool is_sure = kernel_->is_exact() && !kernel_->instant_is_shared(id_);
  owners_.clear();
  for (const Place place : records_.uses(item)) owners_.push_back(records_[place].owner);
  for (const Item owner : owners_) {
    find_cycle_without(owner, item, is_sure);
    prove(owner, kNoPlace);
  }
  records_.drop_cycle(item);
  leave(item);
}

void TreeByShortCycles::finish(Change change) {
  settle_ties();
  if (change == Change::kSized) settle_failures();
  records_.forget_failing();  // they fail next
}

// ---- ties and failures

// Of level edges the one that goes first counts as the shorter.
void TreeByShortCycles::settle_ties() {
  for (std::uint64_t steps = 0;; ++steps) {
    if (!may_go_on(steps)) return;
    const auto place = records_.next_tie();
    if (!place) return;
    const Record record = records_[*place];
    repair(*place, false);
    events_->tied(ids(record.inside), ids(record.outside));
    kernel_->settle_later(id_);
  }
}

// While points come and go nothing may be left to fail.
void TreeByShortCycles::settle_failures() {
  for (std::uint64_t steps = 0;; ++steps) {
    if (!may_go_on(steps)) return;
    const auto place = records_.next_failing();
    if (!place) return;
    repair(*place, false);
    settle_ties();
  }
}

void TreeByShortCycles::certificate_failed(CertificateId failed) {
  const Place place = records_.failed(failed);
  const Record record = records_[place];
  const bool is_alone = kernel_->is_exact() && kernel_->instant_is_over(id_) &&
                        last_change_ != kernel_->instant_number();
  repair(place, is_alone);
  records_.forget_failing();  // they fail next
  events_->repaired(ids(record.inside), ids(record.outside));
  settle_ties();
}

void TreeByShortCycles::motions_changed(std::span<const ObjectId> objects) {
  records_.note_ties(objects);
  settle_ties();
  records_.forget_failing();
}

void TreeByShortCycles::renew(std::span<const Item> items) {
  records_.renew(items);
  settle_ties();
  records_.forget_failing();  // they fail next
}

// ---- checks

void TreeByShortCycles::visit_proof(ProofVisitor& visitor) const {
  ProofGroup group;
  group.kind = "edge outside the tree";
  for (const Item item : present()) {
    if (records_.cycle(item).empty()) continue;
    group.about = about(std::array{item});
    visitor.group(group);
    for (const Place place : records_.cycle(item)) {
      const Record& record = records_[place];
      visitor.certificate(record.certificate, record.outside == item
                                                  ? "longer than an edge of its cycle"
                                                  : "an edge of its cycle longer than another one");
    }
  }
}

// A cycle of a connected graph of n vertices has n - 1 edges besides the longest, as many as the tree.
// For m edges, k of them in the tree, at most (m - k) k.
Integer TreeByShortCycles::most_certificates(std::size_t edges, std::size_t vertices) const {
  const std::size_t k = vertices == 0 ? 0 : std::min(vertices - 1, edges / 2);
  return counted(edges - k) * counted(k);
}

void TreeByShortCycles::check(AuditReport& report) const {
  LinkCutForest forest = forest_;
  LateLinks late = late_;
  late.update(forest, *edges_, [this](Item item) { return in_tree(item); });
  for (const Item item : present()) {
    const auto [u, v] = edges_->ends(item);
    if (!forest.connected(u, v)) {
      report.check(false, [] { return "the ends of an edge are not connected"; });
      continue;
    }
    std::map<std::uint32_t, int> degrees;
    std::map<Item, Item> longer;  // the other side of its record
    const auto count = [&](Item edge) {
      for (const std::uint32_t end : edges_->ends(edge)) ++degrees[end];
    };
    for (const Place place : records_.cycle(item)) {
      const Record& record = records_[place];
      report.check(has(record.inside) && record.inside != item &&
                       longer.emplace(record.inside, record.outside).second,
                   [] { return "a cycle of something else"; });
      count(record.inside);
    }
    for (const auto& [inside, outside] : longer) {
      Item top = outside;
      for (std::size_t i = 0; i < longer.size() && longer.contains(top); ++i) top = longer[top];
      report.check(top == item, [] { return "an edge of a cycle is not compared with its longest"; });
    }
    if (in_tree(item)) {
      report.check(degrees.empty(), [] { return "an edge of the tree has a cycle"; });
      report.check(forest.path(u, v) == std::vector<Item>{item},
                   [] { return "the forest lacks an edge"; });
      continue;
    }
    records_.check(item, report);
    count(item);
    report.check(std::all_of(degrees.begin(), degrees.end(),
                             [](const auto& one) { return one.second == 2; }),
                 [] { return "a cycle is not proved"; });
  }
  records_.check_all(report);
}

std::size_t TreeByShortCycles::bytes() const {
  return base_bytes() + records_.bytes() + late_.bytes() + marks_.capacity() +
         (cycle_.capacity() + walk_.capacity() + owners_.capacity()) * sizeof(Item) +
         reached_.capacity() * sizeof(Reached) + at_.capacity() * sizeof(EdgeAt) +
         (passed_.capacity() + own_.capacity()) * sizeof(std::uint32_t);
}

}  // namespace kinex
