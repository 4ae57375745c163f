// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/proximity/emst_cycles.h"

#include <algorithm>

#include "structures/parts/merge_sort.h"
#include "structures/proximity/spanning_tree.h"

namespace kinex {

EmstCycles::EmstCycles(Kernel& kernel, StructureId id, const DelaunayGraph& triangulation)
    : kernel_(&kernel),
      id_(id),
      triangulation_(triangulation),
      slots_(kernel, id, "cycles"),
      lengths_(kernel, triangulation.dimension()),
      forest_(triangulation.objects()),
      events_(kernel, id, triangulation.id(), kSwap, kExchange) {}

// ---- records

void EmstCycles::add_record(Item inside, Item outside) {
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
  const Outlook outlook =
      slots_.set(record.certificate, lengths_.claim(inside, outside), place);
  if (outlook == Outlook::kIdenticallyZero) tied_.push_back(place);
  if (outlook == Outlook::kFailsNow) failing_.push_back(place);
}

void EmstCycles::drop_record(Place place) {
  Record& record = records_[place];
  slots_.drop(record.certificate);
  for (const Item item : {record.inside, record.outside}) std::erase(places_[item], place);
  record = {};
  free_.push_back(place);
}

void EmstCycles::drop_records(Item item) {
  while (!places_[item].empty()) drop_record(places_[item].back());
}

// Proves that an edge outside the tree is the longest of its cycle: keeps what is proved already.
void EmstCycles::prove(Item outside) {
  const Edge edge = lengths_.edge(outside);
  std::vector<Item> path = forest_.path(edge[0], edge[1]);
  std::sort(path.begin(), path.end());
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

void EmstCycles::put_in(Item item) {
  const Edge edge = lengths_.edge(item);
  in_tree_[item] = true;
  forest_.link(item, edge[0], edge[1]);
  events_.came(edge);
}

void EmstCycles::take_out(Item item) {
  const Edge edge = lengths_.edge(item);
  in_tree_[item] = false;
  forest_.cut(item, edge[0], edge[1]);
  events_.gone(edge);
}

// `after`, outside the tree, takes the place of `before`, which is on its path. All edges that
// cross the cut, those with a record of `before`, have other paths then.
void EmstCycles::replace(Item before, Item after) {
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

void EmstCycles::swap(Item before, Item after) {
  replace(before, after);
  prove(before);
}

// The shortest edge that crosses the cut of a tree edge right after now; kNoItem: there is none.
Item EmstCycles::replacement_of(Item item) const {
  Item best = kNoItem;
  for (const Place place : places_[item]) {
    const Item outside = records_[place].outside;
    if (best == kNoItem || in_front(*kernel_, lengths_, outside, best)) best = outside;
  }
  return best;
}

// ---- the edges

void EmstCycles::add(const Edge& edge) {
  if (lengths_.find(edge) != kNoItem) return;
  const Item item = lengths_.add(edge);
  if (places_.size() <= item) {
    in_tree_.resize(item + std::size_t{1}, false);
    places_.resize(item + std::size_t{1});
  }
  in_tree_[item] = false;
  if (forest_.connected(edge[0], edge[1])) {
    prove(item);
  } else {
    put_in(item);
  }
}

void EmstCycles::remove(const Edge& edge) {
  const Item item = lengths_.find(edge);
  if (item == kNoItem) return;
  if (in_tree(item)) {
    const Item other = replacement_of(item);
    if (other == kNoItem) {
      take_out(item);
    } else {
      replace(item, other);
    }
  }
  drop_records(item);
  lengths_.remove(item);
}

// The edges become those of the triangulation: first those that come, since they may have to take
// the place of others.
void EmstCycles::assign() {
  const std::vector<Edge> wanted = triangulation_.edges();
  std::vector<Edge> gone;
  for (const auto& [edge, item] : lengths_.items()) {
    if (!std::binary_search(wanted.begin(), wanted.end(), edge)) gone.push_back(edge);
  }
  if (lengths_.items().empty()) {
    std::vector<Edge> sorted = wanted;  // Kruskal's order: no swap is needed
    for (const Edge& edge : wanted) lengths_.add(edge);
    std::vector<Item> items;
    for (const auto& [edge, item] : lengths_.items()) items.push_back(item);
    merge_sort(items, [this](Item a, Item b) { return in_front(*kernel_, lengths_, a, b); });
    for (std::size_t i = 0; i < items.size(); ++i) sorted[i] = lengths_.edge(items[i]);
    for (const Item item : items) lengths_.remove(item);
    for (const Edge& edge : sorted) add(edge);
    return;
  }
  for (const Edge& edge : wanted) add(edge);
  for (const Edge& edge : gone) remove(edge);
}

// ---- calls

void EmstCycles::begin() {
  assign();
  settle_ties();
  settle_failures();
  events_.begin();
}

void EmstCycles::rebuild() {
  const std::vector<std::pair<Edge, Item>> all(lengths_.items().begin(), lengths_.items().end());
  for (const auto& [edge, item] : all) {
    drop_records(item);
    lengths_.remove(item);
  }
  forest_.clear();
  std::fill(in_tree_.begin(), in_tree_.end(), false);
  begin();
}

// Every swap makes the tree shorter, or gives it a smaller edge of the same length; in an inexact
// arithmetic signs may contradict each other.
bool EmstCycles::may_go_on(std::uint64_t steps) {
  const std::uint64_t edges = lengths_.items().size();
  if (kernel_->is_exact() || steps < 1000 + edges * edges) return true;
  kernel_->corrupt(id_, "no end of swaps while points come or go");
  return false;
}

// Of level edges the one that goes first is in the tree.
void EmstCycles::settle_ties() {
  for (std::uint64_t steps = 0; !tied_.empty(); ++steps) {
    if (!may_go_on(steps)) return;
    const Record record = records_[tied_.back()];
    tied_.pop_back();
    if (!slots_.is_tie(record.certificate)) continue;
    if (lengths_.goes_first(record.inside, record.outside)) continue;
    const Edge e = lengths_.edge(record.inside), f = lengths_.edge(record.outside);
    swap(record.inside, record.outside);
    kernel_->report(id_, kTie, {e[0], e[1], f[0], f[1]}, false);
    kernel_->settle_later(id_);
  }
}

// While points come and go nothing may be left to fail.
void EmstCycles::settle_failures() {
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

void EmstCycles::certificate_failed(CertificateId failed) {
  const Record record = records_[slots_.failed(failed)];
  const Edge e = lengths_.edge(record.inside), f = lengths_.edge(record.outside);
  swap(record.inside, record.outside);
  failing_.clear();  // they fail next
  events_.repaired(e, f);
  settle_ties();
}

void EmstCycles::motions_changed(std::span<const ObjectId> objects) {
  for (const ObjectId object : objects) {
    for (const CertificateId c : kernel_->certificates_of(object)) {
      if (slots_.is_tie(c) && slots_.owns(c)) tied_.push_back(kernel_->tag(c));
    }
  }
  settle_ties();
  failing_.clear();
}

// At an instant with several changes, the triangulation is read when it is settled.
void EmstCycles::watched_changed(const Event* event) {
  const auto change = event == nullptr ? std::nullopt : triangulation_.change(*event);
  if (change && kernel_->instant_is_shared(triangulation_.id())) {
    return kernel_->settle_later(id_);
  }
  if (change) {
    if (change->came) add(*change->came);
    if (change->gone) remove(*change->gone);
  } else {
    assign();
  }
  settle_ties();
  failing_.clear();
  // What was made now may fail now, too, when the triangulation has told its last change.
  if (events_.any() || kernel_->failure_is_due()) kernel_->settle_later(id_);
}

Attribute EmstCycles::attribute() const {
  Attribute result{Attribute::Shape::kTuples, {}};
  for (const auto& [edge, item] : lengths_.items()) {
    if (in_tree(item)) result.ids.insert(result.ids.end(), edge.begin(), edge.end());
  }
  return result;
}

// ---- checks

void EmstCycles::visit_proof(ProofVisitor& visitor) const {
  ProofGroup group;
  group.kind = "edge outside the tree";
  for (const auto& [edge, item] : lengths_.items()) {
    if (in_tree(item) || places_[item].empty()) continue;
    group.about = {edge[0], edge[1]};
    visitor.group(group);
    for (const Place place : places_[item]) {
      visitor.certificate(records_[place].certificate, "longer than an edge of its path");
    }
  }
}

std::vector<BoundCheck> EmstCycles::bounds(const BoundContext& context) const {
  const std::size_t n = context.objects();
  const std::size_t outside = n < 3 ? 0 : triangulation_.most_edges(n) - (n - 1);
  std::vector<BoundCheck> result{
      at_most("emst_cycles.certificates",
              "all edges outside the tree (2n - 5 in the plane), paths of n - 1 edges",
              counted(outside * (n - 1)), counted(context.ledger->max_live))};
  if (context.plain() && n > 1) result.push_back(spanning_tree_bound("emst_cycles", context));
  return result;
}

void EmstCycles::check_invariants(AuditReport& report) const {
  std::vector<Edge> edges;
  for (const auto& [edge, item] : lengths_.items()) edges.push_back(edge);
  report.check(edges == triangulation_.edges(),
               [] { return "it has missed a change of the edges"; });
  LinkCutForest forest = forest_;
  for (const auto& [edge, item] : lengths_.items()) {
    if (!forest.connected(edge[0], edge[1])) {
      report.check(false, [] { return "the ends of an edge are not connected"; });
      continue;
    }
    std::vector<Item> path = forest.path(edge[0], edge[1]);
    if (in_tree(item)) {
      report.check(path == std::vector<Item>{item}, [] { return "the forest lacks an edge"; });
      continue;
    }
    std::vector<Item> proved;
    for (const Place place : places_[item]) {
      const Record& record = records_[place];
      proved.push_back(record.inside);
      report.check(record.outside == item && in_tree(record.inside) &&
                       slots_.holds(record.certificate, lengths_.claim(record.inside, item), place),
                   [] { return "a certificate of something else"; });
      report.check(!slots_.is_tie(record.certificate) || lengths_.goes_first(record.inside, item),
                   [] { return "a tie in the wrong order"; });
    }
    std::sort(path.begin(), path.end());
    std::sort(proved.begin(), proved.end());
    report.check(path == proved, [] { return "a cycle is not proved"; });
  }
  report.check(slots_.line().live == records_.size() - free_.size(),
               [] { return "a record without an edge"; });
  report.check(!events_.any(), [] { return "a change of the tree was not reported"; });
}

void EmstCycles::audit(const Snapshot& snapshot, AuditReport& report) const {
  report.check(static_spanning_tree(snapshot) == attribute().ids,
               [] { return "another tree is the shortest"; });
}

std::size_t EmstCycles::bytes() const {
  std::size_t total = lengths_.bytes() + forest_.bytes() + in_tree_.capacity() / 8 +
                      records_.capacity() * sizeof(Record) + events_.bytes() +
                      places_.capacity() * sizeof(std::vector<Place>);
  for (const auto& places : places_) total += places.capacity() * sizeof(Place);
  return total;
}

}  // namespace kinex
