// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/proximity/tree_by_cycles.h"

#include <algorithm>
#include <array>

#include "core/engine/bound.h"
#include "structures/parts/merge_sort.h"

namespace kinex {

// ---- records

std::uint32_t TreeByCycles::list(Item item, Place place) {
  places_[item].push_back(place);
  return static_cast<std::uint32_t>(places_[item].size() - 1);
}

// The last of the list comes to its place.
void TreeByCycles::unlist(Item item, std::uint32_t at) {
  std::vector<Place>& places = places_[item];
  Record& last = records_[places.back()];
  (last.inside == item ? last.at_inside : last.at_outside) = at;
  places[at] = places.back();
  places.pop_back();
}

void TreeByCycles::add_record(Item inside, Item outside) {
  Place place;
  if (free_.empty()) {
    place = static_cast<Place>(records_.size());
    records_.emplace_back();
  } else {
    place = free_.back();
    free_.pop_back();
  }
  records_[place] = {inside, outside, kNoCertificate, list(inside, place), list(outside, place)};
  certify(place);
}

void TreeByCycles::certify(Place place) {
  Record& record = records_[place];
  const Query claim = edges_->claim(record.inside, record.outside);
  const Outlook outlook = slots_.set(record.certificate, claim, place);
  if (outlook == Outlook::kIdenticallyZero) tied_.push_back(place);
  if (outlook == Outlook::kFailsNow) failing_.push_back(place);
}

void TreeByCycles::drop_record(Place place) {
  Record& record = records_[place];
  slots_.drop(record.certificate);
  unlist(record.inside, record.at_inside);
  unlist(record.outside, record.at_outside);
  record = {};
  free_.push_back(place);
}

void TreeByCycles::drop_records(Item item) {
  while (!places_[item].empty()) drop_record(places_[item].back());
}

// Proves that an edge outside the tree, which has no records, is the longest of its cycle.
void TreeByCycles::prove(Item outside) {
  const auto [u, v] = edges_->ends(outside);
  std::vector<Item> path = forest_.path(u, v);
  std::sort(path.begin(), path.end());
  for (const Item inside : path) add_record(inside, outside);
}

// ---- the tree

// `after`, outside the tree, takes the place of `before`, which is on its path. All edges that
// cross the cut, those with a record of `before`, have other paths then. Returns the cycle, ascending:
// `after` and what was its path.
std::vector<Item> TreeByCycles::replace(Item before, Item after) {
  std::vector<Item> crossing, cycle{after};
  for (const Place place : places_[before]) crossing.push_back(records_[place].outside);
  for (const Place place : places_[after]) cycle.push_back(records_[place].inside);
  std::sort(crossing.begin(), crossing.end());
  std::sort(cycle.begin(), cycle.end());
  drop_records(after);
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
  for (const Place place : places_[outside]) {
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
      const Place place = gone_[used++];
      Record& record = records_[place];
      unlist(record.inside, record.at_inside);
      record.inside = inside;
      record.at_inside = list(inside, place);
      certify(place);
    } else {
      add_record(inside, outside);
    }
  }
  for (; used < gone_.size(); ++used) drop_record(gone_[used]);
}

void TreeByCycles::swap(Item before, Item after) {
  for (const Item inside : replace(before, after)) {
    if (inside != before) add_record(inside, before);
  }
}

// The shortest edge that crosses the cut of a tree edge right after now; kNoItem: there is none.
Item TreeByCycles::replacement_of(Item item) const {
  Item best = kNoItem;
  for (const Place place : places_[item]) {
    const Item outside = records_[place].outside;
    if (best == kNoItem || in_front(*kernel_, order(), outside, best)) best = outside;
  }
  return best;
}

// ---- the edges

// In Kruskal's order no swap is needed.
void TreeByCycles::build(std::vector<Item> items) {
  for (Place place = 0; place < records_.size(); ++place) slots_.drop(records_[place].certificate);
  records_.clear();
  free_.clear();
  places_.clear();
  marks_.clear();
  tied_.clear();
  failing_.clear();
  clear();
  merge_sort(items, [this](Item a, Item b) { return in_front(*kernel_, order(), a, b); });
  for (const Item item : items) add(item);
  finish(Change::kSized);
}

void TreeByCycles::add(Item item) {
  enter(item);
  if (places_.size() <= item) {
    places_.resize(item + std::size_t{1});
    marks_.resize(places_.size(), kNotOnCycle);
  }
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
  drop_records(item);
  leave(item);
}

void TreeByCycles::finish(Change change) {
  settle_ties();
  if (change == Change::kSized) settle_failures();
  failing_.clear();  // they fail next
}

// ---- ties and failures

// Of level edges the one that goes first is in the tree.
void TreeByCycles::settle_ties() {
  for (std::uint64_t steps = 0; !tied_.empty(); ++steps) {
    if (!may_go_on(steps)) return;
    const Record record = records_[tied_.back()];
    tied_.pop_back();
    if (!slots_.is_tie(record.certificate)) continue;
    if (edges_->goes_first(record.inside, record.outside)) continue;
    swap(record.inside, record.outside);
    events_->tied(ids(record.inside), ids(record.outside));
    kernel_->settle_later(id_);
  }
}

// While points come and go nothing may be left to fail.
void TreeByCycles::settle_failures() {
  for (std::uint64_t steps = 0; !failing_.empty(); ++steps) {
    if (!may_go_on(steps)) return;
    const Record record = records_[failing_.back()];
    failing_.pop_back();
    if (record.certificate == kNoCertificate) continue;
    if (kernel_->outlook(record.certificate) != Outlook::kFailsNow) continue;
    swap(record.inside, record.outside);
    settle_ties();
  }
}

void TreeByCycles::certificate_failed(CertificateId failed) {
  const Record record = records_[slots_.failed(failed)];
  swap(record.inside, record.outside);
  failing_.clear();  // they fail next
  events_->repaired(ids(record.inside), ids(record.outside));
  settle_ties();
}

void TreeByCycles::motions_changed(std::span<const ObjectId> objects) {
  for (const ObjectId object : objects) {
    for (const CertificateId c : kernel_->certificates_of(object)) {
      if (slots_.is_tie(c) && slots_.owns(c)) tied_.push_back(kernel_->tag(c));
    }
  }
  settle_ties();
  failing_.clear();
}

void TreeByCycles::renew(std::span<const Item> items) {
  for (const Item item : items) {
    for (const Place place : places_[item]) {
      const Record& record = records_[place];
      const Query claim = edges_->claim(record.inside, record.outside);
      if (!slots_.holds(record.certificate, claim, place)) {
        certify(place);
      } else if (slots_.is_tie(record.certificate)) {
        tied_.push_back(place);
      }
    }
  }
  settle_ties();
  failing_.clear();  // they fail next
}

// ---- checks

void TreeByCycles::visit_proof(ProofVisitor& visitor) const {
  ProofGroup group;
  group.kind = "edge outside the tree";
  for (const Item item : present()) {
    if (in_tree(item) || places_[item].empty()) continue;
    group.about = about(std::array{item});
    visitor.group(group);
    for (const Place place : places_[item]) {
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
    for (const Place place : places_[item]) {
      const Record& record = records_[place];
      proved.push_back(record.inside);
      report.check(record.outside == item && in_tree(record.inside) &&
                       slots_.holds(record.certificate, edges_->claim(record.inside, item), place),
                   [] { return "a certificate of something else"; });
      report.check(!slots_.is_tie(record.certificate) || edges_->goes_first(record.inside, item),
                   [] { return "a tie in the wrong order"; });
    }
    std::sort(path.begin(), path.end());
    std::sort(proved.begin(), proved.end());
    report.check(path == proved, [] { return "a cycle is not proved"; });
  }
  report.check(slots_.line().live == records_.size() - free_.size(),
               [] { return "a record without an edge"; });
}

std::size_t TreeByCycles::bytes() const {
  std::size_t total = base_bytes() + records_.capacity() * sizeof(Record) + marks_.capacity() +
                      places_.capacity() * sizeof(std::vector<Place>);
  for (const auto& places : places_) total += places.capacity() * sizeof(Place);
  return total;
}

}  // namespace kinex
