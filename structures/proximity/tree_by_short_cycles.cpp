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

// The edge between two vertices, kNoItem if there is none.
Item TreeByShortCycles::edge_between(std::uint32_t u, std::uint32_t v) const {
  for (const EdgeAt& one : adjacent_->at(u)) {
    if (one.vertex == v) return has(one.edge) ? one.edge : kNoItem;
  }
  return kNoItem;
}

// A cycle of the fewest edges, among those that are all shorter than `outside`: the last one added.
void TreeByShortCycles::find_shortest(Item outside) {
  const auto [u, v] = edges_->ends(outside);
  from_.resize(vertices_, kNoItem);
  passed_.assign(1, u);
  from_[u] = outside;
  for (std::size_t i = 0; from_[v] == kNoItem; ++i) {
    for (const EdgeAt& one : adjacent_->at(passed_[i])) {
      if (!has(one.edge) || one.edge == outside || from_[one.vertex] != kNoItem) continue;
      from_[one.vertex] = one.edge;
      passed_.push_back(one.vertex);
    }
  }
  cycle_.clear();
  for (std::uint32_t at = v; at != u;) {
    cycle_.push_back(from_[at]);
    const auto ends = edges_->ends(from_[at]);
    at = ends[0] == at ? ends[1] : ends[0];
  }
  for (const std::uint32_t at : passed_) from_[at] = kNoItem;
}

// The cycle of `outside` without `gone`, which is outside the tree, and with the other edges of its
// cycle. False if that is long, or not all are shorter than `outside`.
bool TreeByShortCycles::join_cycles(Item outside, Item gone) {
  cycle_.clear();
  bool fits = true;
  for (const Item owner : {outside, gone}) {
    for (const Place place : records_.cycle(owner)) {
      const Item inside = records_[place].inside;
      if (inside == gone) continue;
      if (inside == outside) fits = false;
      std::uint8_t& mark = marks_[inside];
      if (mark == 0) cycle_.push_back(inside);
      // An edge of both is in neither.
      mark = mark == 1 ? 3 : owner == outside ? 1 : 2;
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
  if (!fits) return false;
  make_simple(outside);
  if (cycle_.size() > 2) make_shorter(outside, gone);
  return true;
}

// Of edges that meet every vertex an even number of times, `outside` counted: those of one cycle, from
// end to end. The walk from one end to the other drops its loops. passed_: its vertices.
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
    *next = cycle_.back();
    cycle_.pop_back();
    passed_.erase(std::find(passed_.begin(), passed_.end(), to), passed_.end());
    passed_.push_back(to);
    walk_.resize(passed_.size() - 1);
  }
  cycle_.swap(walk_);
}

// Two edges of the walk that follow each other give way to the third one of a triangle, if it is shorter
// than `outside`.
void TreeByShortCycles::make_shorter(Item outside, Item gone) {
  std::size_t size = 0;  // edges kept; their vertices are one more
  for (std::size_t i = 0; i < cycle_.size(); ++i) {
    Item edge = cycle_[i];
    const std::uint32_t to = passed_[i + 1];
    while (size > 0) {
      const Item chord = edge_between(passed_[size - 1], to);
      if (chord == kNoItem || chord == outside || chord == gone) break;
      if (!is_shorter(chord, outside)) break;
      edge = chord;
      --size;
    }
    cycle_[size++] = edge;
    passed_[size] = to;
  }
  cycle_.resize(size);
}

void TreeByShortCycles::find_path(Item outside) {
  const auto [u, v] = edges_->ends(outside);
  cycle_ = forest().path(u, v);
  std::sort(cycle_.begin(), cycle_.end());
}

// cycle_ becomes the cycle of `outside`. Its records stay, but for `stale`, where the edges of both
// sides do; the others say that an edge is at most as long as the owner.
void TreeByShortCycles::prove(Item outside, Place stale) {
  enum : std::uint8_t { kNone, kWanted, kProved };
  const std::span<const Place> old = records_.cycle(outside);
  own_.assign(old.begin(), old.end());
  for (const Item item : cycle_) marks_[item] = kWanted;
  marks_[outside] = kProved;
  const auto sort_out = [this](const auto& stays) {
    std::size_t others = 0;
    for (const Place place : own_) {
      if (!stays(place)) own_[others++] = place;
    }
    own_.resize(others);
  };
  sort_out([&](Place place) {
    const Record& record = records_[place];
    const bool stays = place != stale && marks_[record.inside] != kNone && marks_[record.outside] != kNone;
    if (stays) marks_[record.inside] = kProved;
    return stays;
  });
  sort_out([&](Place place) {
    const Item inside = records_[place].inside;
    if (marks_[inside] != kWanted) return false;
    marks_[inside] = kProved;
    records_.change(place, inside, outside);
    return true;
  });
  for (const Item item : cycle_) {
    if (marks_[item] == kWanted) {
      if (own_.empty()) {
        records_.add(item, outside, outside);
      } else {
        records_.change(own_.back(), item, outside);
        own_.pop_back();
      }
    }
    marks_[item] = kNone;
  }
  marks_[outside] = kNone;
  for (const Place place : own_) records_.drop(place);
}

// Makes cycle_ a cycle of an edge in whose cycle `gone` is longer than it is, or leaves the graph.
void TreeByShortCycles::find_cycle_without(Item outside, Item gone) {
  if (find_triangle(outside, gone)) return;
  if (in_tree(gone) || !join_cycles(outside, gone)) find_path(outside);
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

// The inside of a record is longer than its outside now. `is_alone`: all other records hold.
void TreeByShortCycles::repair(Place place, bool is_alone) {
  const Record record = records_[place];
  const Item before = record.inside, after = record.outside;
  if (after != record.owner) {
    for (const Place other : records_.cycle(record.owner)) {
      if (records_[other].inside == after) return records_.change(place, before, records_[other].outside);
    }
  }
  if (in_tree(before) && (is_alone || is_on_path(before, after))) return swap(before, after);
  find_cycle_without(after, before);
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
      find_shortest(item);
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
  enter_graph(item);
  if (!find_triangle(item, kNoItem)) {
    const auto [u, v] = edges_->ends(item);
    if (!forest().connected(u, v)) return put_in_late(item);
    find_path(item);
  }
  prove(item, kNoPlace);
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
  owners_.clear();
  for (const Place place : records_.uses(item)) owners_.push_back(records_[place].owner);
  for (const Item owner : owners_) {
    find_cycle_without(owner, item);
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
         (cycle_.capacity() + walk_.capacity() + from_.capacity() + owners_.capacity()) * sizeof(Item) +
         (passed_.capacity() + own_.capacity()) * sizeof(std::uint32_t);
}

}  // namespace kinex
