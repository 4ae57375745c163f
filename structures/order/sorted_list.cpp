// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/order/sorted_list.h"

#include <algorithm>
#include <utility>

namespace kinex {

SortedList::SortedList(Kernel& kernel, StructureId id, const Key& key, const Scene& scene)
    : kernel_(&kernel),
      id_(id),
      order_(kernel, key, scene),
      slot_of_(scene.objects.size(), kNone) {}

std::vector<std::string_view> SortedList::event_kinds() const {
  return common_event_kinds({"swap", "tie"});
}

// ---- the static algorithm

void SortedList::build(std::span<const ObjectId> objects) { construct(order_.members(objects)); }

void SortedList::rebuild() {
  std::vector<ObjectId> members;
  for (Place s = first_; s != kNone; s = slots_[s].next) {
    members.push_back(slots_[s].object);
    drop_certificate(s);
  }
  std::sort(members.begin(), members.end());
  construct(std::move(members));
}

// Merge sort ends even if the signs are no order (inexact arithmetics).
void SortedList::construct(std::vector<ObjectId> members) {
  std::vector<ObjectId> scratch(members.size());
  for (std::size_t width = 1; width < members.size(); width *= 2) {
    for (std::size_t begin = 0; begin < members.size(); begin += 2 * width) {
      const std::size_t middle = std::min(begin + width, members.size());
      const std::size_t end = std::min(begin + 2 * width, members.size());
      std::size_t a = begin, b = middle;
      for (std::size_t out = begin; out < end; ++out) {
        const bool take_b = b < end && (a == middle || order_.before(members[b], members[a]));
        scratch[out] = members[take_b ? b++ : a++];
      }
    }
    members.swap(scratch);
  }
  slots_.clear();
  free_.clear();
  tree_.clear();
  has_tree_ = false;
  std::fill(slot_of_.begin(), slot_of_.end(), kNone);
  size_ = members.size();
  for (const ObjectId object : members) {
    const Place s = new_slot(object);
    slots_[s].previous = s == 0 ? kNone : s - 1;
    slots_[s].next = s + 1 < size_ ? s + 1 : kNone;
  }
  first_ = size_ == 0 ? kNone : 0;
  last_ = size_ == 0 ? kNone : static_cast<Place>(size_ - 1);
  for (Place s = 0; s + 1 < size_; ++s) set_certificate(s);
  settle_ties();
}

SortedList::Place SortedList::new_slot(ObjectId object) {
  Place s;
  if (free_.empty()) {
    s = static_cast<Place>(slots_.size());
    slots_.emplace_back();
  } else {
    s = free_.back();
    free_.pop_back();
    slots_[s] = Slot{};
  }
  slots_[s].object = object;
  slot_of_[object] = s;
  return s;
}

// ---- certificates

void SortedList::set_certificate(Place s) {
  Slot& slot = slots_[s];
  const Query query = order_.query(slot.object, slots_[slot.next].object);
  Outlook outlook;
  if (slot.certificate == kNoCertificate) {
    const Kernel::Created created = kernel_->create(id_, query, s);
    slot.certificate = created.id;
    outlook = created.outlook;
  } else {
    outlook = kernel_->replace(slot.certificate, query, s);
  }
  if (outlook == Outlook::kIdenticallyZero) ties_.push_back(s);
}

void SortedList::drop_certificate(Place s) {
  Slot& slot = slots_[s];
  if (slot.certificate == kNoCertificate) return;
  kernel_->retract(slot.certificate);
  slot.certificate = kNoCertificate;
}

// The objects at s and at the place behind it change places. The certificate between them comes
// first: the arithmetic reuses its polynomial.
void SortedList::exchange(Place s) {
  Slot& a = slots_[s];
  Slot& b = slots_[a.next];
  if (a.previous != kNone) kernel_->prefetch(slots_[a.previous].certificate);
  if (b.next != kNone) kernel_->prefetch(b.certificate);
  std::swap(a.object, b.object);
  slot_of_[a.object] = s;
  slot_of_[b.object] = a.next;
  set_certificate(s);
  if (a.previous != kNone) set_certificate(a.previous);
  if (b.next != kNone) set_certificate(a.next);
}

void SortedList::certificate_failed(CertificateId failed) {
  const Place s = kernel_->tag(failed);
  exchange(s);
  kernel_->report(id_, kSwap, {object_at(slots_[s].next), object_at(s)}, true);
  if (!ties_.empty()) settle_ties();
}

// Every exchange orders two ids, and only neighbours are exchanged: at most n(n-1)/2 exchanges.
void SortedList::settle_ties() {
  while (!ties_.empty()) {
    const Place s = ties_.back();
    ties_.pop_back();
    const Slot& slot = slots_[s];
    if (slot.certificate == kNoCertificate || slot.next == kNone) continue;
    if (kernel_->outlook(slot.certificate) != Outlook::kIdenticallyZero) continue;
    const ObjectId a = slot.object, b = object_at(slot.next);
    if (a < b) continue;
    exchange(s);
    kernel_->report(id_, kTie, {a, b}, true);
  }
}

// ---- changes

void SortedList::insert(ObjectId object) {
  if (!has_tree_) {
    std::vector<Place> places;
    for (Place s = first_; s != kNone; s = slots_[s].next) places.push_back(s);
    tree_.build(places);
    has_tree_ = true;
  }
  Place previous = kNone;
  for (Place s = tree_.root(); s != kNone;) {
    if (order_.before(slots_[s].object, object)) {
      previous = s;
      s = tree_.right(s);
    } else {
      s = tree_.left(s);
    }
  }
  const Place s = new_slot(object);
  tree_.insert_after(previous, s);
  const Place next = previous == kNone ? first_ : slots_[previous].next;
  slots_[s].previous = previous;
  slots_[s].next = next;
  (previous == kNone ? first_ : slots_[previous].next) = s;
  (next == kNone ? last_ : slots_[next].previous) = s;
  ++size_;
  if (previous != kNone) set_certificate(previous);
  if (next != kNone) set_certificate(s);
  settle_ties();
}

void SortedList::erase(ObjectId object) {
  order_.check_erasure(object);
  const Place s = slot_of_[object];
  const Place previous = slots_[s].previous, next = slots_[s].next;
  drop_certificate(s);
  if (previous != kNone && next == kNone) drop_certificate(previous);
  (previous == kNone ? first_ : slots_[previous].next) = next;
  (next == kNone ? last_ : slots_[next].previous) = previous;
  if (has_tree_) tree_.erase(s);
  slots_[s] = Slot{};
  slot_of_[object] = kNone;
  free_.push_back(s);
  --size_;
  if (previous != kNone && next != kNone) set_certificate(previous);
  settle_ties();
}

// New motions may make neighbours identically equal; all other changes show as failures.
void SortedList::motions_changed(std::span<const ObjectId> objects) {
  for (const ObjectId object : objects) {
    for (const CertificateId c : kernel_->certificates_of(object)) {
      if (kernel_->is_tie_of(id_, c)) ties_.push_back(kernel_->tag(c));
    }
  }
  settle_ties();
}

// ---- attribute, bounds, invariants

ObjectId SortedList::extreme(Extremum extremum) const {
  if (extremum == Extremum::kMinimum) return first();
  Place s = last_;
  while (s != kNone && slots_[s].previous != kNone) {
    const Place before = slots_[s].previous;
    if (kernel_->outlook(slots_[before].certificate) != Outlook::kIdenticallyZero) break;
    s = before;
  }
  return object_at(s);
}

Attribute SortedList::attribute() const {
  Attribute result{Attribute::Shape::kSequence, {}};
  result.ids.reserve(size_);
  for (Place s = first_; s != kNone; s = slots_[s].next) result.ids.push_back(slots_[s].object);
  return result;
}

std::vector<BoundCheck> SortedList::bounds(const BoundContext& context) const {
  const std::vector<int> pieces = order_.member_pieces(context);
  const Integer n(static_cast<std::int64_t>(pieces.size()));
  const auto counted = [](std::uint64_t k) { return Integer(static_cast<std::int64_t>(k)); };
  std::vector<BoundCheck> result;
  result.push_back(at_most(
      "sorted_list.swaps",
      "every pair changes places at each sign change of its key difference at most",
      pair_sign_changes(pieces, order_.degree(context.degree), order_.reference_pieces(context)),
      counted(context.ledger->processed)));
  result.push_back(at_most("sorted_list.certificates", "one certificate per pair of neighbours",
                           n.is_zero() ? Integer(0) : n - Integer(1),
                           counted(context.ledger->max_live)));
  if (order_.reference() == kNoObject) {
    result.push_back(at_most("sorted_list.locality", "an object has two neighbours", Integer(2),
                             counted(context.ledger->max_per_object)));
  }
  return result;
}

std::size_t SortedList::bytes() const {
  return slots_.capacity() * sizeof(Slot) + tree_.bytes() +
         (slot_of_.capacity() + free_.capacity() + ties_.capacity()) * sizeof(Place);
}

}  // namespace kinex
