// SPDX-License-Identifier: GPL-3.0-or-later
// KineticList: items in order, from the front one to the last, over any claims.
//
// Certificates. One per pair of neighbours, whose tag is the place of the first: it is in front of
// the next one.
//
//     z --1-- a --2-- b --3-- y      2 fails: a and b change places,
//     z --1'- b --2'- a --3'- y      three certificates are renewed
//
// Cost for n items: n - 1 certificates, 2 an item; a failure renews 3 certificates in O(log n) for
// the queue; an insertion O(log n) comparisons and 2 certificates; an erasure 1 certificate.
//
// Ties. Items that are level identically are in the order of goes_first.
//
// Source: Guibas, "Kinetic data structures: a state of the art report" (1998), section 5.
#ifndef KINEX_STRUCTURES_PARTS_KINETIC_LIST_H
#define KINEX_STRUCTURES_PARTS_KINETIC_LIST_H

#include <algorithm>
#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/engine/audit.h"
#include "structures/parts/claim.h"
#include "structures/parts/merge_sort.h"
#include "structures/parts/order_tree.h"
#include "structures/parts/slots.h"
#include "structures/parts/ties.h"

namespace kinex {

template <Claims C>
class KineticList {
 public:
  // Two neighbours that have changed places: the one that was in front, and the one that is now.
  struct Swap {
    Item before, after;
  };

  // `name`: of the ledger line. `items`: room is reserved for items below this number.
  KineticList(Kernel& kernel, StructureId structure, std::string name, C claims,
              std::size_t items = 0)
      : slots_(kernel, structure, std::move(name)),
        claims_(std::move(claims)),
        place_of_(items, kNone) {}

  const C& claims() const { return claims_; }
  C& claims() { return claims_; }
  const Slots& slots() const { return slots_; }
  std::size_t size() const { return size_; }
  // Room is reserved for items below this number.
  std::size_t capacity() const { return place_of_.size(); }
  // kNoItem if there is none. next and previous require an item that is in the list. O(1).
  Item first() const { return item_at(first_); }
  Item last() const { return item_at(last_); }
  Item next(Item item) const { return item_at(places_[place_of_[item]].next); }
  Item previous(Item item) const { return item_at(places_[place_of_[item]].previous); }
  // The front one of those that are level with the last one identically. O(their number).
  Item front_of_last() const {
    Place s = last_;
    while (s != kNone && places_[s].previous != kNone) {
      const Place before = places_[s].previous;
      if (!slots_.is_tie(places_[before].certificate)) break;
      s = before;
    }
    return item_at(s);
  }
  // In order. O(n).
  std::vector<Item> items() const {
    std::vector<Item> result;
    result.reserve(size_);
    for (Place s = first_; s != kNone; s = places_[s].next) result.push_back(places_[s].item);
    return result;
  }

  // Calls visit(item, next item, certificate) for all neighbours, in order.
  template <class Visit>
  void each_link(const Visit& visit) const {
    for (Place s = first_; s != kNone && places_[s].next != kNone; s = places_[s].next) {
      visit(places_[s].item, item_at(places_[s].next), places_[s].certificate);
    }
  }

  // Removes all items. O(n).
  void clear() {
    for (Place s = first_; s != kNone; s = places_[s].next) slots_.drop(places_[s].certificate);
    places_.clear();
    free_.clear();
    ties_.clear();
    tree_.clear();
    has_tree_ = false;
    std::fill(place_of_.begin(), place_of_.end(), kNone);
    size_ = 0;
    first_ = last_ = kNone;
  }
  // Replaces the list by that of these items, right after now. O(n log n) comparisons.
  template <TieReport Tied>
  void build(std::vector<Item> items, const Tied& tied) {
    clear();
    merge_sort(items, [this](Item a, Item b) { return before(a, b); });
    build_in_order(items);
    settle(tied);
  }
  // The same for items that are in order, ties included. O(n), no comparisons.
  void build_in_order(const std::vector<Item>& items) {
    clear();
    size_ = items.size();
    for (const Item item : items) {
      const Place s = new_place(item);
      places_[s].previous = s == 0 ? kNone : s - 1;
      places_[s].next = s + 1 < size_ ? s + 1 : kNone;
    }
    first_ = size_ == 0 ? kNone : 0;
    last_ = size_ == 0 ? kNone : static_cast<Place>(size_ - 1);
    for (Place s = 0; s + 1 < size_; ++s) certify(s);
  }

  // A certificate of this part has failed. Call settle() when the swap has been reported.
  Swap failed(CertificateId failed) {
    const Place s = slots_.failed(failed);
    exchange(s);
    return {item_at(places_[s].next), item_at(s)};
  }
  // Puts ties in order. Every exchange orders two items, and only neighbours are exchanged: at most
  // n(n-1)/2 exchanges.
  template <TieReport Tied>
  void settle(const Tied& tied) {
    ties_.settle([&](Place s) {
      const Node& node = places_[s];
      if (node.next == kNone || !slots_.is_tie(node.certificate)) return;
      const Item a = node.item, b = item_at(node.next);
      if (claims_.goes_first(a, b)) return;
      exchange(s);
      tied(a, b);
    });
  }

  template <TieReport Tied>
  void insert(Item item, const Tied& tied) {
    if (!has_tree_) {
      std::vector<Place> places;
      for (Place s = first_; s != kNone; s = places_[s].next) places.push_back(s);
      tree_.build(places);
      has_tree_ = true;
    }
    Place previous = kNone;
    for (Place s = tree_.root(); s != kNone;) {
      if (before(places_[s].item, item)) {
        previous = s;
        s = tree_.right(s);
      } else {
        s = tree_.left(s);
      }
    }
    const Place s = new_place(item);
    tree_.insert_after(previous, s);
    const Place next = previous == kNone ? first_ : places_[previous].next;
    places_[s].previous = previous;
    places_[s].next = next;
    (previous == kNone ? first_ : places_[previous].next) = s;
    (next == kNone ? last_ : places_[next].previous) = s;
    ++size_;
    if (previous != kNone) certify(previous);
    if (next != kNone) certify(s);
    settle(tied);
  }

  template <TieReport Tied>
  void erase(Item item, const Tied& tied) {
    const Place s = place_of_[item];
    const Place previous = places_[s].previous, next = places_[s].next;
    slots_.drop(places_[s].certificate);
    if (previous != kNone && next == kNone) slots_.drop(places_[previous].certificate);
    (previous == kNone ? first_ : places_[previous].next) = next;
    (next == kNone ? last_ : places_[next].previous) = previous;
    if (has_tree_) tree_.erase(s);
    places_[s] = Node{};
    place_of_[item] = kNone;
    free_.push_back(s);
    --size_;
    if (previous != kNone && next != kNone) certify(previous);
    settle(tied);
  }

  // New motions of these objects may make neighbours level identically; all other changes show as
  // failures.
  template <TieReport Tied>
  void motions_changed(std::span<const ObjectId> objects, const Tied& tied) {
    ties_.note_of(slots_, objects);
    settle(tied);
  }

  // The claims about these items may be others now: renews their certificates with both neighbours.
  template <TieReport Tied>
  void renew(std::span<const Item> items, const Tied& tied) {
    for (const Item item : items) {
      if (item >= place_of_.size() || place_of_[item] == kNone) continue;
      const Place s = place_of_[item];
      if (places_[s].previous != kNone) certify(places_[s].previous);
      if (places_[s].next != kNone) certify(s);
    }
    settle(tied);
  }

  // Links, certificates and ties; `name` begins the messages.
  void check(AuditReport& report, const std::string& name) const {
    std::size_t count = 0;
    Place previous = kNone;
    std::vector<Place> places;
    for (Place s = first_; s != kNone && count <= places_.size(); s = places_[s].next, ++count) {
      const Node& node = places_[s];
      const auto where = [&] { return " at item " + std::to_string(node.item) + " of " + name; };
      places.push_back(s);
      report.check(node.previous == previous, [&] { return "a broken link" + where(); });
      report.check(node.item < place_of_.size() && place_of_[node.item] == s,
                   [&] { return "a lost item" + where(); });
      const bool has_next = node.next != kNone;
      report.check(has_next == (node.certificate != kNoCertificate),
                   [&] { return "a certificate too many or too few" + where(); });
      if (has_next && node.certificate != kNoCertificate) {
        const Item after = item_at(node.next);
        report.check(slots_.holds(node.certificate, claims_.claim(node.item, after), s),
                     [&] { return "a certificate of something else" + where(); });
        report.check(!slots_.is_tie(node.certificate) || claims_.goes_first(node.item, after),
                     [&] { return "a tie in the wrong order" + where(); });
      }
      previous = s;
    }
    report.check(previous == last_, [&] { return "the last place is another in " + name; });
    report.check(count == size_, [&] { return "another length of " + name; });
    report.check(ties_.empty(), [&] { return "ties were not settled in " + name; });
    if (has_tree_) {
      report.check(tree_.consistent() && tree_.in_order() == places,
                   [&] { return "the tree of " + name + " has another order"; });
    }
  }
  std::size_t bytes() const {
    return places_.capacity() * sizeof(Node) + tree_.bytes() + ties_.bytes() +
           (place_of_.capacity() + free_.capacity()) * sizeof(Place);
  }

 private:
  using Place = OrderTree::Place;
  static constexpr Place kNone = OrderTree::kNone;
  // A place in the list and its item. A swap changes only the items at two places.
  struct Node {
    Item item = kNoItem;
    Place next = kNone, previous = kNone;
    CertificateId certificate = kNoCertificate;  // of this place and the next
  };

  Item item_at(Place s) const { return s == kNone ? kNoItem : places_[s].item; }
  bool before(Item a, Item b) const { return in_front(slots_.kernel(), claims_, a, b); }
  void certify(Place s) {
    Node& node = places_[s];
    ties_.set(slots_, node.certificate, claims_.claim(node.item, places_[node.next].item), s);
  }
  // The items at s and at the place behind it change places. The certificate between them comes
  // first: the arithmetic reuses its polynomial.
  void exchange(Place s) {
    Node& a = places_[s];
    Node& b = places_[a.next];
    if (a.previous != kNone) slots_.kernel().prefetch(places_[a.previous].certificate);
    if (b.next != kNone) slots_.kernel().prefetch(b.certificate);
    std::swap(a.item, b.item);
    place_of_[a.item] = s;
    place_of_[b.item] = a.next;
    renewed_.size = 0;
    renew_later(s);
    if (a.previous != kNone) renew_later(a.previous);
    if (b.next != kNone) renew_later(a.next);
    ties_.set(slots_, renewed_);
  }
  void renew_later(Place s) {
    const Node& node = places_[s];
    const std::size_t i = renewed_.size++;
    renewed_.ids[i] = node.certificate;
    renewed_.queries[i] = claims_.claim(node.item, places_[node.next].item);
    renewed_.tags[i] = s;
  }
  Place new_place(Item item) {
    Place s;
    if (free_.empty()) {
      s = static_cast<Place>(places_.size());
      places_.emplace_back();
    } else {
      s = free_.back();
      free_.pop_back();
      places_[s] = Node{};
    }
    if (place_of_.size() <= item) place_of_.resize(item + std::size_t{1}, kNone);
    places_[s].item = item;
    place_of_[item] = s;
    return s;
  }

  Slots slots_;
  C claims_;
  Ties ties_;
  Kernel::Group renewed_;  // of exchange(): kept, since a new one would be filled with zeros
  std::vector<Node> places_;
  std::vector<Place> place_of_;  // per item
  std::vector<Place> free_;
  Place first_ = kNone, last_ = kNone;
  std::size_t size_ = 0;
  OrderTree tree_;  // built by the first insertion, kept from then on
  bool has_tree_ = false;
};

}  // namespace kinex

#endif
