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

// ---- cycles

// The first triangle, by its third vertex, whose other edges are shorter right after now. Triangles
// with `longer`, which is longer or leaves the graph, are passed over.
bool TreeByShortCycles::find_triangle(Item outside, Item longer) {
  const auto [u, v] = edges_->ends(outside);
  const std::span<const EdgeAt> at_u = adjacent_->at(u), at_v = adjacent_->at(v);
  for (auto a = at_u.begin(), b = at_v.begin(); a != at_u.end() && b != at_v.end();) {
    if (a->vertex < b->vertex) {
      ++a;
    } else if (b->vertex < a->vertex) {
      ++b;
    } else {
      const Item x = a++->edge, y = b++->edge;
      if (!has(x) || !has(y) || x == longer || y == longer) continue;
      if (!is_shorter(x, outside) || !is_shorter(y, outside)) continue;
      cycle_.assign({x, y});
      return true;
    }
  }
  return false;
}

// The cycle of `outside` without `gone`, which is outside the tree, and with the other edges of its
// cycle. False if that is long, or not all are shorter than `outside`.
bool TreeByShortCycles::join_cycles(Item outside, Item gone) {
  cycle_.clear();
  bool fits = true;
  for (const Item owner : {outside, gone}) {
    for (const Place place : records_.of(owner)) {
      const Record& record = records_[place];
      if (record.outside != owner || record.inside == gone) continue;
      if (record.inside == outside) fits = false;
      std::uint8_t& mark = marks_[record.inside];
      if (mark == 0) cycle_.push_back(record.inside);
      // An edge of both is in neither.
      mark = mark == 0 ? (owner == gone ? 2 : 1) : 3;
    }
  }
  std::size_t left = 0;
  for (const Item item : cycle_) {
    if (fits && marks_[item] != 3) {
      fits = left < kLongest && (marks_[item] == 1 || is_shorter(item, outside));
      cycle_[left++] = item;
    }
    marks_[item] = 0;
  }
  cycle_.resize(left);
  if (fits) make_simple(outside);
  return fits;
}

// Of edges that meet every vertex an even number of times, `outside` counted: those of one cycle. The
// walk from one end to the other drops its loops.
void TreeByShortCycles::make_simple(Item outside) {
  const auto [u, v] = edges_->ends(outside);
  walk_.clear();
  passed_.assign(1, u);
  while (passed_.back() != v) {
    const std::uint32_t at = passed_.back();
    const auto next = std::find_if(cycle_.begin(), cycle_.end(), [&](Item item) {
      const auto ends = edges_->ends(item);
      return ends[0] == at || ends[1] == at;
    });
    const auto ends = edges_->ends(*next);
    const std::uint32_t to = ends[0] == at ? ends[1] : ends[0];
    walk_.push_back(*next);
    cycle_.erase(next);
    const auto before = std::find(passed_.begin(), passed_.end(), to);
    passed_.erase(before, passed_.end());
    passed_.push_back(to);
    walk_.resize(passed_.size() - 1);
  }
  cycle_.assign(walk_.begin(), walk_.end());
}

void TreeByShortCycles::find_path(Item outside) {
  const auto [u, v] = edges_->ends(outside);
  cycle_ = forest().path(u, v);
  std::sort(cycle_.begin(), cycle_.end());
}

// own_ becomes the records of the cycle of `outside`.
void TreeByShortCycles::collect(Item outside) {
  own_.clear();
  for (const Place place : records_.of(outside)) {
    if (records_[place].outside == outside) own_.push_back(place);
  }
}

// cycle_ becomes the cycle of `outside`. Records that it has already stay, but for `stale`.
void TreeByShortCycles::prove(Item outside, Place stale) {
  collect(outside);
  for (const Item item : cycle_) marks_[item] = 1;
  std::size_t others = 0;
  for (const Place place : own_) {
    std::uint8_t& mark = marks_[records_[place].inside];
    if (mark == 1 && place != stale) {
      mark = 0;
    } else {
      own_[others++] = place;
    }
  }
  std::size_t used = 0;
  for (const Item item : cycle_) {
    if (marks_[item] == 0) continue;
    marks_[item] = 0;
    if (used < others) {
      records_.change(own_[used++], item, outside);
    } else {
      records_.add(item, outside);
    }
  }
  for (; used < others; ++used) records_.drop(own_[used]);
}

// Proves anew an edge of whose cycle `gone` is longer than it is, or leaves the graph.
void TreeByShortCycles::prove_without(Item outside, Item gone, Place stale) {
  if (!find_triangle(outside, gone) && (in_tree(gone) || !join_cycles(outside, gone))) {
    find_path(outside);
  }
  prove(outside, stale);
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

// `after` takes the place of `before`, an edge of its cycle and of its path.
void TreeByShortCycles::swap(Item before, Item after) {
  take_out_late(before);
  put_in_late(after);
  collect(after);
  for (const Place place : own_) {
    const Item inside = records_[place].inside;
    records_.change(place, inside == before ? after : inside, before);
  }
}

// `inside` is longer than `outside` now. `is_alone`: all other records hold.
void TreeByShortCycles::repair(Place place, bool is_alone) {
  const Record record = records_[place];
  if (in_tree(record.inside) && (is_alone || is_on_path(record.inside, record.outside))) {
    swap(record.inside, record.outside);
  } else {
    prove_without(record.outside, record.inside, place);
  }
}

// The shortest edge across the cut of a tree edge right after now; kNoItem: there is none. It has a
// record of the edge, unless records fail now: then all edges are looked at.
Item TreeByShortCycles::replacement_of(Item item) {
  Item best = kNoItem;
  const auto offer = [&](Item outside) {
    if (in_tree(outside) || !is_on_path(item, outside)) return;
    if (best == kNoItem || is_shorter(outside, best)) best = outside;
  };
  for (const Place place : records_.of(item)) offer(records_[place].outside);
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
    prove(best);
  }
  return best;
}

// ---- the edges

// In Kruskal's order no swap is needed.
void TreeByShortCycles::build(std::vector<Item> items) {
  records_.clear();
  late_.clear();
  marks_.clear();
  clear();
  merge_sort(items, [this](Item a, Item b) { return is_shorter(a, b); });
  for (const Item item : items) add(item);
  finish(Change::kSized);
}

void TreeByShortCycles::add(Item item) {
  enter(item);
  records_.make_room(item + std::size_t{1});
  if (marks_.size() <= item) marks_.resize(item + std::size_t{1}, 0);
  const auto [u, v] = edges_->ends(item);
  if (find_triangle(item, kNoItem)) {
    prove(item);
  } else if (forest().connected(u, v)) {
    find_path(item);
    prove(item);
  } else {
    put_in_late(item);
  }
}

void TreeByShortCycles::remove(Item item) {
  if (in_tree(item)) {
    const Item other = replacement_of(item);
    if (other == kNoItem) {
      take_out_late(item);
    } else {
      swap(item, other);
    }
  }
  std::vector<Item> owners;
  for (const Place place : records_.of(item)) {
    if (records_[place].inside == item) owners.push_back(records_[place].outside);
  }
  for (const Item owner : owners) prove_without(owner, item);
  records_.drop_all(item);
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
  repair(place, kernel_->is_exact() && kernel_->instant_is_over(id_));
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
    if (in_tree(item) || records_.of(item).empty()) continue;
    group.about = about(std::array{item});
    visitor.group(group);
    for (const Place place : records_.of(item)) {
      if (records_[place].outside != item) continue;
      visitor.certificate(records_[place].certificate, "longer than another edge of its cycle");
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
    const auto count = [&](Item edge) {
      for (const std::uint32_t end : edges_->ends(edge)) ++degrees[end];
    };
    for (const Place place : records_.of(item)) {
      if (records_[place].outside != item) continue;
      const Item inside = records_[place].inside;
      report.check(has(inside) && inside != item, [] { return "a cycle of something else"; });
      count(inside);
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
         (cycle_.capacity() + walk_.capacity()) * sizeof(Item) +
         (passed_.capacity() + own_.capacity()) * sizeof(std::uint32_t);
}

}  // namespace kinex
