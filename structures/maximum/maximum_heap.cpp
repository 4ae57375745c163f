// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/maximum/maximum_heap.h"

#include <algorithm>
#include <string>
#include <utility>

#include "structures/maximum/maximum_bounds.h"

namespace kinex {

MaximumHeap::MaximumHeap(Kernel& kernel, StructureId id, const Key& key, const Scene& scene,
                         Extremum extremum)
    : kernel_(&kernel),
      id_(id),
      contest_(extremum, kernel, key, scene),
      events_(kernel, id, kReplace),
      place_of_(scene.objects.size(), kNone) {}

std::string_view MaximumHeap::name() const {
  return contest_.extremum() == Extremum::kMaximum ? "maximum_heap" : "minimum_heap";
}

std::vector<std::string_view> MaximumHeap::event_kinds() const {
  return common_event_kinds({"swap", "tie", "replace"});
}

// ---- the static algorithm

void MaximumHeap::build(std::span<const ObjectId> objects) {
  construct(contest_.order().members(objects));
  events_.begin(top());
}

void MaximumHeap::rebuild() {
  for (std::size_t i = 1; i < heap_.size(); ++i) kernel_->retract(certificate_[i]);
  std::vector<ObjectId> members = heap_;
  std::sort(members.begin(), members.end());
  construct(std::move(members));
  events_.begin(top());
}

// The (ancestor, descendant) pairs with place i: its depth plus the places below it.
std::uint64_t MaximumHeap::relatives(Place i) const {
  std::uint64_t count = 0;
  for (Place up = i; up > 0; up = (up - 1) / 2) ++count;
  const std::uint64_t n = heap_.size();
  for (std::uint64_t first = 2 * std::uint64_t{i} + 1, width = 2; first < n; width *= 2) {
    count += std::min(width, n - first);
    first = 2 * first + 1;
  }
  return count;
}

void MaximumHeap::construct(std::vector<ObjectId> members) {
  heap_ = std::move(members);
  certificate_.assign(heap_.size(), kNoCertificate);
  ties_.clear();
  for (Place i = 0; i < heap_.size(); ++i) place_of_[heap_[i]] = i;
  std::vector<Place> moved;
  for (std::size_t i = heap_.size() / 2; i-- > 0;) sift_down(static_cast<Place>(i), moved);
  for (Place i = 1; i < heap_.size(); ++i) {
    set_certificate(i);
    for (Place up = i; up > 0; up = (up - 1) / 2) ++pairs_;
  }
  settle_ties();
}

// ---- certificates

void MaximumHeap::set_certificate(Place i) {
  const Query query = contest_.claim(heap_[(i - 1) / 2], heap_[i]);
  CertificateId& c = certificate_[i];
  Outlook outlook;
  if (c == kNoCertificate) {
    const Kernel::Created created = kernel_->create(id_, query, i);
    c = created.id;
    outlook = created.outlook;
  } else if (kernel_->query(c) == query) {
    return;
  } else {
    outlook = kernel_->replace(c, query, i);
  }
  if (outlook == Outlook::kIdenticallyZero) ties_.push_back(i);
}

// The object at `child` and its parent change places. The certificate between them comes first: the
// arithmetic reuses its polynomial.
void MaximumHeap::exchange(Place child) {
  const Place parent = (child - 1) / 2;
  const ObjectId up = heap_[child], down = heap_[parent];
  put(parent, up);
  put(child, down);
  set_certificate(child);
  if (parent > 0) set_certificate(parent);
  for (const Place base : {parent, child}) {
    for (Place i = 2 * base + 1; i <= 2 * base + 2 && i < heap_.size(); ++i) {
      if (i != child) set_certificate(i);
    }
  }
}

void MaximumHeap::certificate_failed(CertificateId failed) {
  const Place child = kernel_->tag(failed);
  const ObjectId up = heap_[child], down = heap_[(child - 1) / 2];
  exchange(child);
  settle_ties();
  events_.repaired(kSwap, down, up, top());
}

// Each exchange moves a smaller id up, so there are at most as many as pairs of an ancestor and a
// descendant.
void MaximumHeap::settle_ties() {
  while (!ties_.empty()) {
    const Place i = ties_.back();
    ties_.pop_back();
    if (i >= heap_.size() || certificate_[i] == kNoCertificate) continue;
    if (kernel_->outlook(certificate_[i]) != Outlook::kIdenticallyZero) continue;
    const ObjectId up = heap_[i], down = heap_[(i - 1) / 2];
    if (down < up) continue;
    exchange(i);
    kernel_->report(id_, kTie, {down, up}, false);
  }
}

void MaximumHeap::motions_changed(std::span<const ObjectId> objects) {
  for (const ObjectId object : objects) {
    if (place_of_[object] == kNone) {  // the reference of the distances
      for (const Place i : place_of_) pairs_ += i == kNone ? 0 : relatives(i);
    } else {
      pairs_ += relatives(place_of_[object]);
    }
    for (const CertificateId c : kernel_->certificates_of(object)) {
      if (kernel_->is_tie_of(id_, c)) ties_.push_back(kernel_->tag(c));
    }
  }
  settle_ties();
}

// ---- insertion and erasure

// Moves objects only; `moved` collects the places whose object has changed.
void MaximumHeap::sift_up(Place i, std::vector<Place>& moved) {
  const ObjectId object = heap_[i];
  while (i > 0 && contest_.beats(object, heap_[(i - 1) / 2])) {
    put(i, heap_[(i - 1) / 2]);
    moved.push_back(i);
    i = (i - 1) / 2;
  }
  put(i, object);
  moved.push_back(i);
}

void MaximumHeap::sift_down(Place i, std::vector<Place>& moved) {
  const ObjectId object = heap_[i];
  for (;;) {
    Place child = 2 * i + 1;
    if (child >= heap_.size()) break;
    if (child + 1 < heap_.size() && contest_.beats(heap_[child + 1], heap_[child])) ++child;
    if (!contest_.beats(heap_[child], object)) break;
    put(i, heap_[child]);
    moved.push_back(i);
    i = child;
  }
  put(i, object);
  moved.push_back(i);
}

void MaximumHeap::renew(const std::vector<Place>& moved) {
  std::vector<Place> places;
  for (const Place i : moved) {
    pairs_ += relatives(i);
    for (const Place j : {i, 2 * i + 1, 2 * i + 2}) {
      if (j > 0 && j < heap_.size()) places.push_back(j);
    }
  }
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
  for (const Place i : places) set_certificate(i);
  settle_ties();
}

void MaximumHeap::insert(ObjectId object) {
  heap_.push_back(object);
  certificate_.push_back(kNoCertificate);
  std::vector<Place> moved;
  sift_up(static_cast<Place>(heap_.size() - 1), moved);
  renew(moved);
  events_.begin(top());
}

// The last object moves to the free place and sifts.
void MaximumHeap::erase(ObjectId object) {
  contest_.order().check_erasure(object);
  const Place hole = place_of_[object];
  const ObjectId last = heap_.back();
  if (certificate_.back() != kNoCertificate) kernel_->retract(certificate_.back());
  heap_.pop_back();
  certificate_.pop_back();
  place_of_[object] = kNone;
  if (object == last) return events_.begin(top());
  put(hole, last);
  std::vector<Place> moved;
  sift_up(hole, moved);
  if (place_of_[last] == hole) sift_down(hole, moved);
  renew(moved);
  events_.begin(top());
}

// ---- attribute, bounds, invariants

Attribute MaximumHeap::attribute() const {
  Attribute result{Attribute::Shape::kObject, {}};
  if (!heap_.empty()) result.ids.push_back(heap_[0]);
  return result;
}

std::vector<BoundCheck> MaximumHeap::bounds(const BoundContext& context) const {
  std::vector<BoundCheck> result = maximum_bounds(name(), contest_.order(), context);
  const auto counted = [](std::uint64_t k) { return Integer(static_cast<std::int64_t>(k)); };
  if (contest_.order().reference() == kNoObject) {
    result.push_back(at_most(std::string(name()) + ".locality", "a parent and two children",
                             Integer(3), counted(context.ledger->max_per_object)));
  }
  if (contest_.order().degree(context.degree) <= 1) {
    result.push_back(at_most(std::string(name()) + ".events",
                             "affine motions: pairs of an ancestor and a descendant in the heap; "
                             "Basch, Guibas, Ramkumar 1996; and those that a change makes anew",
                             counted(pairs_), counted(context.ledger->failures)));
  } else {
    result.push_back(crossing_bound(name(), contest_.order(), context));
  }
  return result;
}

std::size_t MaximumHeap::bytes() const {
  return heap_.capacity() * sizeof(ObjectId) + certificate_.capacity() * sizeof(CertificateId) +
         (place_of_.capacity() + ties_.capacity()) * sizeof(Place);
}

}  // namespace kinex
