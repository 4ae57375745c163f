// SPDX-License-Identifier: GPL-3.0-or-later
// KineticHeap: the item in front of all others, by a binary heap over any claims.
//
// Certificates. One per place i > 0 of the heap's array, whose tag is the place: the item at the
// parent (i - 1) / 2 is in front of the one at i.
//
//         g                g
//         * 1              * 1
//         p                c            p's certificate with c fails: the two change places, and
//     2 * ' * 3        2 * ' * 3        the five certificates at them are renewed
//      c     s          p     s
//  4 * ' * 5        4 * ' * 5
//
// Cost for n items: n - 1 certificates, 3 an item; a failure renews 5 at most; an insertion or
// erasure sifts along one path, O(log n) certificates.
// Bound on the failures: most_failures().
//
// Ties. Of items that are level identically the one that goes first is above the other, where one
// is above the other.
//
// Source: Guibas, "Kinetic data structures: a state of the art report" (1998), section 5; events:
// Basch, Guibas, Ramkumar, "Reporting red-blue intersections between two sets of connected line
// segments" (1996); da Fonseca, de Figueiredo, "Kinetic heap-ordered trees" (2003).
#ifndef KINEX_STRUCTURES_PARTS_KINETIC_HEAP_H
#define KINEX_STRUCTURES_PARTS_KINETIC_HEAP_H

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/engine/audit.h"
#include "structures/parts/claim.h"
#include "structures/parts/slots.h"
#include "structures/parts/ties.h"

namespace kinex {

template <Claims C>
class KineticHeap {
 public:
  // A parent and a child that have changed places: the old parent, the new one.
  struct Swap {
    Item before, after;
  };

  // `name`: of the ledger line. `items`: room is reserved for items below this number.
  KineticHeap(Kernel& kernel, StructureId structure, std::string name, C claims,
              std::size_t items = 0)
      : slots_(kernel, structure, std::move(name)),
        claims_(std::move(claims)),
        place_of_(items, kNone) {}

  const C& claims() const { return claims_; }
  const Slots& slots() const { return slots_; }
  std::size_t size() const { return heap_.size(); }
  // In front of all others; kNoItem if there is none.
  Item top() const { return heap_.empty() ? kNoItem : heap_[0]; }
  // In the order of their places.
  const std::vector<Item>& items() const { return heap_; }

  // Calls visit(place, item, certificate) from the top on, which has no certificate. The parent of
  // place i is (i - 1) / 2.
  template <class Visit>
  void each_place(const Visit& visit) const {
    for (Place i = 0; i < heap_.size(); ++i) visit(i, heap_[i], certificate_[i]);
  }

  // Replaces the heap by that of these items, right after now. O(n) comparisons.
  template <TieReport Tied>
  void build(std::vector<Item> items, const Tied& tied) {
    for (CertificateId& c : certificate_) slots_.drop(c);
    heap_ = std::move(items);
    certificate_.assign(heap_.size(), kNoCertificate);
    ties_.clear();
    std::fill(place_of_.begin(), place_of_.end(), kNone);
    for (Place i = 0; i < heap_.size(); ++i) put(i, heap_[i]);
    std::vector<Place> moved;
    for (std::size_t i = heap_.size() / 2; i-- > 0;) sift_down(static_cast<Place>(i), moved);
    for (Place i = 1; i < heap_.size(); ++i) {
      certify(i);
      for (Place up = i; up > 0; up = (up - 1) / 2) ++pairs_;
    }
    settle(tied);
  }

  // A certificate of this part has failed: the swap, and the ties that it makes.
  template <TieReport Tied>
  Swap failed(CertificateId failed, const Tied& tied) {
    const Place child = slots_.failed(failed);
    const Swap swap{heap_[(child - 1) / 2], heap_[child]};
    exchange(child);
    settle(tied);
    return swap;
  }

  template <TieReport Tied>
  void insert(Item item, const Tied& tied) {
    heap_.push_back(item);
    certificate_.push_back(kNoCertificate);
    std::vector<Place> moved;
    sift_up(static_cast<Place>(heap_.size() - 1), moved);
    renew(moved, tied);
  }
  // The last item moves to the free place and sifts.
  template <TieReport Tied>
  void erase(Item item, const Tied& tied) {
    const Place hole = place_of_[item];
    const Item last = heap_.back();
    slots_.drop(certificate_.back());
    heap_.pop_back();
    certificate_.pop_back();
    place_of_[item] = kNone;
    if (item == last) return;
    put(hole, last);
    std::vector<Place> moved;
    sift_up(hole, moved);
    if (place_of_[last] == hole) sift_down(hole, moved);
    renew(moved, tied);
  }

  // New motions of these objects, of which these items are made.
  template <TieReport Tied>
  void motions_changed(std::span<const ObjectId> objects, std::span<const Item> items,
                       const Tied& tied) {
    for (const Item item : items) pairs_ += relatives(place_of_[item]);
    ties_.note_of(slots_, objects);
    settle(tied);
  }
  bool has(Item item) const { return item < place_of_.size() && place_of_[item] != kNone; }

  // An upper bound on the failures so far, for claims that are affine in t: the number of pairs of
  // an ancestor and a descendant. Each event removes a pair whose descendant grows faster, and
  // makes none. A new motion, an insertion or an erasure adds at most the pairs of the items that
  // it changes or moves.
  std::uint64_t most_failures() const { return pairs_; }

  // Places, certificates and ties; `name` begins the messages.
  void check(AuditReport& report, const std::string& name) const {
    for (Place i = 0; i < heap_.size(); ++i) {
      const auto where = [&] { return " at place " + std::to_string(i) + " of " + name; };
      report.check(has(heap_[i]) && place_of_[heap_[i]] == i,
                   [&] { return "a lost item" + where(); });
      if (i == 0) {
        report.check(certificate_[0] == kNoCertificate,
                     [&] { return "the top has a certificate" + where(); });
        continue;
      }
      const Item parent = heap_[(i - 1) / 2];
      report.check(slots_.holds(certificate_[i], claims_.claim(parent, heap_[i]), i),
                   [&] { return "a certificate of something else" + where(); });
      report.check(!slots_.is_tie(certificate_[i]) || claims_.goes_first(parent, heap_[i]),
                   [&] { return "a tie in the wrong order" + where(); });
    }
  }
  std::size_t bytes() const {
    return heap_.capacity() * sizeof(Item) + certificate_.capacity() * sizeof(CertificateId) +
           place_of_.capacity() * sizeof(Place) + ties_.bytes();
  }

 private:
  using Place = std::uint32_t;
  static constexpr Place kNone = 0xffffffffu;

  // The (ancestor, descendant) pairs with place i: its depth plus the places below it.
  std::uint64_t relatives(Place i) const {
    std::uint64_t count = 0;
    for (Place up = i; up > 0; up = (up - 1) / 2) ++count;
    const std::uint64_t n = heap_.size();
    for (std::uint64_t first = 2 * std::uint64_t{i} + 1, width = 2; first < n; width *= 2) {
      count += std::min(width, n - first);
      first = 2 * first + 1;
    }
    return count;
  }
  void put(Place i, Item item) {
    if (place_of_.size() <= item) place_of_.resize(item + std::size_t{1}, kNone);
    heap_[i] = item;
    place_of_[item] = i;
  }
  bool beats(Item a, Item b) const { return in_front(slots_.kernel(), claims_, a, b); }

  void certify(Place i) {
    const Query query = claims_.claim(heap_[(i - 1) / 2], heap_[i]);
    CertificateId& slot = certificate_[i];
    if (slot != kNoCertificate && slots_.kernel().claims(slot, query)) return;
    ties_.set(slots_, slot, query, i);
  }
  // The item at `child` and its parent change places. The certificate between them comes first: the
  // arithmetic reuses its polynomial.
  void exchange(Place child) {
    const Place parent = (child - 1) / 2;
    const Item up = heap_[child], down = heap_[parent];
    put(parent, up);
    put(child, down);
    certify(child);
    if (parent > 0) certify(parent);
    for (const Place base : {parent, child}) {
      for (Place i = 2 * base + 1; i <= 2 * base + 2 && i < heap_.size(); ++i) {
        if (i != child) certify(i);
      }
    }
  }
  // Each exchange moves an item that goes first up, so there are at most as many as pairs of an
  // ancestor and a descendant.
  template <TieReport Tied>
  void settle(const Tied& tied) {
    ties_.settle([&](Place i) {
      if (i >= heap_.size() || !slots_.is_tie(certificate_[i])) return;
      const Item up = heap_[i], down = heap_[(i - 1) / 2];
      if (claims_.goes_first(down, up)) return;
      exchange(i);
      tied(down, up);
    });
  }

  // Moves items only; `moved` collects the places whose item has changed.
  void sift_up(Place i, std::vector<Place>& moved) {
    const Item item = heap_[i];
    while (i > 0 && beats(item, heap_[(i - 1) / 2])) {
      put(i, heap_[(i - 1) / 2]);
      moved.push_back(i);
      i = (i - 1) / 2;
    }
    put(i, item);
    moved.push_back(i);
  }
  void sift_down(Place i, std::vector<Place>& moved) {
    const Item item = heap_[i];
    for (;;) {
      Place child = 2 * i + 1;
      if (child >= heap_.size()) break;
      if (child + 1 < heap_.size() && beats(heap_[child + 1], heap_[child])) ++child;
      if (!beats(heap_[child], item)) break;
      put(i, heap_[child]);
      moved.push_back(i);
      i = child;
    }
    put(i, item);
    moved.push_back(i);
  }
  template <TieReport Tied>
  void renew(const std::vector<Place>& moved, const Tied& tied) {
    std::vector<Place> places;
    for (const Place i : moved) {
      pairs_ += relatives(i);
      for (const Place j : {i, 2 * i + 1, 2 * i + 2}) {
        if (j > 0 && j < heap_.size()) places.push_back(j);
      }
    }
    std::sort(places.begin(), places.end());
    places.erase(std::unique(places.begin(), places.end()), places.end());
    for (const Place i : places) certify(i);
    settle(tied);
  }

  Slots slots_;
  C claims_;
  Ties ties_;
  std::vector<Item> heap_;
  std::vector<CertificateId> certificate_;  // per place, of it and its parent; none for the root
  std::vector<Place> place_of_;             // per item
  std::uint64_t pairs_ = 0;  // of an ancestor and a descendant that may still fail, or have failed
};

}  // namespace kinex

#endif
