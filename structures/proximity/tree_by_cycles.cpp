// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/proximity/tree_by_cycles.h"

#include <algorithm>
#include <array>

#include "core/engine/bound.h"
#include "structures/parts/merge_sort.h"

namespace kinex {

// ---- records

void TreeByCycles::add_record(Item inside, Item outside) {
  Place place;
  if (free_.empty()) {
    place = static_cast<Place>(records_.size());
    records_.emplace_back();
  } else {
    place = free_.back();
    free_.pop_back();
  }
  Record& record = records_[place];
  record = {inside, outside, kNoCertificate};
  places_[inside].push_back(place);
  places_[outside].push_back(place);
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
  for (const Item item : {record.inside, record.outside}) std::erase(places_[item], place);
  record = {};
  free_.push_back(place);
}

void TreeByCycles::drop_records(Item item) {
  while (!places_[item].empty()) drop_record(places_[item].back());
}

// The edges of the tree between the ends of an edge, ascending.
std::vector<Item> TreeByCycles::path_of(Item item) {
  const auto [u, v] = edges_->ends(item);
  std::vector<Item> path = forest_.path(u, v);
  std::sort(path.begin(), path.end());
  return path;
}

// Proves that an edge outside the tree is the longest of its cycle: keeps what is proved already.
void TreeByCycles::prove(Item outside) {
  const std::vector<Item> path = path_of(outside);
  std::vector<Item> proved;
  const std::vector<Place> places = places_[outside];
  for (const Place place : places) {
    const Item inside = records_[place].inside;
    if (std::binary_search(path.begin(), path.end(), inside)) {
      proved.push_back(inside);
    } else {
      drop_record(place);
    }
  }
  std::sort(proved.begin(), proved.end());
  for (const Item inside : path) {
    if (!std::binary_search(proved.begin(), proved.end(), inside)) add_record(inside, outside);
  }
}

// ---- the tree

// `after`, outside the tree, takes the place of `before`, which is on its path. All edges that
// cross the cut, those with a record of `before`, have other paths then.
void TreeByCycles::replace(Item before, Item after) {
  std::vector<Item> crossing;
  for (const Place place : places_[before]) crossing.push_back(records_[place].outside);
  std::sort(crossing.begin(), crossing.end());
  drop_records(after);
  take_out(before);
  put_in(after);
  for (const Item item : crossing) {
    if (item != after) prove(item);
  }
}

void TreeByCycles::swap(Item before, Item after) {
  replace(before, after);
  prove(before);
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
  tied_.clear();
  failing_.clear();
  clear();
  merge_sort(items, [this](Item a, Item b) { return in_front(*kernel_, order(), a, b); });
  for (const Item item : items) add(item);
  finish(Change::kSized);
}

void TreeByCycles::add(Item item) {
  enter(item);
  if (places_.size() <= item) places_.resize(item + std::size_t{1});
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
  std::size_t total = base_bytes() + records_.capacity() * sizeof(Record) +
                      places_.capacity() * sizeof(std::vector<Place>);
  for (const auto& places : places_) total += places.capacity() * sizeof(Place);
  return total;
}

}  // namespace kinex
