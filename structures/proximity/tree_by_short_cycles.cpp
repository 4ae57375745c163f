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

// ---- the tree

void TreeByShortCycles::put_in_late(Item item) {
  count_in(item);
  late_.note(item);
  const auto [u, v] = edges_->ends(item);
  tree_at_[u].push_back({v, item});
  tree_at_[v].push_back({u, item});
}

void TreeByShortCycles::take_out_late(Item item) {
  count_out(item);
  late_.note(item);
  for (const std::uint32_t end : edges_->ends(item)) {
    std::vector<EdgeAt>& here = tree_at_[end];
    *std::find_if(here.begin(), here.end(),
                  [item](const EdgeAt& one) { return one.edge == item; }) = here.back();
    here.pop_back();
  }
}

// The cycle of `after` becomes that of another edge of it. O(1) certificates.
void TreeByShortCycles::hand_over(Item after, Item before) {
  records_.exchange_cycles(after, before);
  const bool all = records_.cycle(before).size() <= kRenewed;
  for (const Place place : records_.cycle(before)) {
    if (records_[place].inside == before) {
      records_.change(place, after, before);
      if (!all) return;
    } else if (all && records_[place].outside == after) {
      records_.change(place, records_[place].inside, before);
    }
  }
}

// `after` takes the place of `before`, an edge of its cycle and of its path.
void TreeByShortCycles::swap(Item before, Item after) {
  take_out_late(before);
  put_in_late(after);
  hand_over(after, before);
}

// At now itself no pair of the cycle outside the tree, `before` aside, is as long as the owner.
bool TreeByShortCycles::is_longest_now(Item owner, Item before) const {
  if (!kernel_->tells_sign_now()) return false;
  const std::span<const Place> cycle = records_.cycle(owner);
  return std::none_of(cycle.begin(), cycle.end(), [&](Place place) {
    const Item inside = records_[place].inside;
    if (inside == before || in_tree(inside)) return false;
    return kernel_->sign(edges_->claim(inside, owner), When::kNow) == Sign::kZero;
  });
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
  if (in_tree(before) &&
      ((is_alone && is_longest_now(after, before)) || is_on_path(before, after))) {
    return swap(before, after);
  }
  find_cycle_without(after, before, is_alone);
  const bool is_better = has(before) && !in_tree(before) &&
                         records_.cycle(after).size() + 1 < records_.cycle(before).size();
  if (is_better) hand_over(after, before);
  prove(after, is_better ? kNoPlace : place);
}

// The shortest edge across the cut of a tree edge right after now, with that in its cycle; kNoItem:
// there is none. O(m).
Item TreeByShortCycles::replacement_of(Item item) {
  const auto [u, v] = edges_->ends(item);
  reached_.resize(vertices_);
  passed_.assign(1, u);
  reached_[u].by = item;
  for (std::size_t i = 0; i < passed_.size(); ++i) {
    for (const EdgeAt& one : tree_at_[passed_[i]]) {
      if (one.edge == item || reached_[one.vertex].by != kNoItem) continue;
      reached_[one.vertex].by = one.edge;
      passed_.push_back(one.vertex);
    }
  }
  Item best = kNoItem;
  for (const std::uint32_t vertex : passed_) {
    for (const EdgeAt& one : adjacent_->at(vertex)) {
      if (one.edge == item || !has(one.edge) || reached_[one.vertex].by != kNoItem) continue;
      if (best == kNoItem || is_shorter(one.edge, best)) best = one.edge;
    }
  }
  for (const std::uint32_t vertex : passed_) reached_[vertex] = {};
  if (best == kNoItem) return best;
  const auto cycle = records_.cycle(best);
  if (std::none_of(cycle.begin(), cycle.end(),
                   [&](Place place) { return records_[place].inside == item; })) {
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
  tree_at_.assign(vertices_, {});
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
  records_.drop_cycle(item);
  leave(item);
}

void TreeByShortCycles::finish(Change change) {
  if (change == Change::kSized) release_vertices();
  settle_ties();
  if (change == Change::kSized) settle_failures();
  records_.forget_failing();  // they fail next
}

// ---- ties and failures

// Of level edges the one that goes first counts as the shorter.
void TreeByShortCycles::settle_ties() {
  for (std::uint64_t steps = 0;; ++steps) {
    if (!may_go_on(steps)) return records_.give_up();
    const auto place = records_.next_tie();
    if (!place) return;
    const Record record = records_[*place];
    repair(*place, false);
    events_->tied(ids(record.inside), ids(record.outside));
    kernel_->settle_later(id_);
  }
}

// The edges of points that have left the graph leave the proof.
void TreeByShortCycles::release_vertices() {
  const auto is_gone = [&](std::uint32_t vertex) {
    const auto here = adjacent_->at(vertex);
    return std::none_of(here.begin(), here.end(), [&](const EdgeAt& one) { return has(one.edge); });
  };
  for (Item item = 0; item < marks_.size(); ++item) {
    if (has(item) || records_.uses(item).empty()) continue;
    const auto [u, v] = edges_->ends(item);
    if (!is_gone(u) && !is_gone(v)) continue;
    owners_.clear();
    for (const Place place : records_.uses(item)) owners_.push_back(records_[place].owner);
    for (const Item owner : owners_) {
      find_cycle_without(owner, item, false);
      prove(owner, kNoPlace);
    }
  }
}

// While points come and go nothing may be left to fail.
void TreeByShortCycles::settle_failures() {
  for (std::uint64_t steps = 0;; ++steps) {
    if (!may_go_on(steps)) return records_.give_up();
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
      report.check(record.inside != item && longer.emplace(record.inside, record.outside).second,
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
         reached_.capacity() * sizeof(Reached) + crossings_.capacity() * sizeof(Crossing) +
         waiting_.capacity() * sizeof(Waiting) +
         (passed_.capacity() + own_.capacity()) * sizeof(std::uint32_t);
}

}  // namespace kinex
