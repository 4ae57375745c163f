// SPDX-License-Identifier: GPL-3.0-or-later
// BoxOverlaps: which boxes meet, by the order of their ends along every axis. A part of box_pairs
// and disc_pairs_boxes: a box has half extents of its own, or those of the disc in it.
//
//   axis x    a-  b-  a+  c-  b+  c+        - a lower end, + an upper end
//                     \___/                 a+ and c- change places: the boxes a and c begin to
//   axis y    c-  a-  a+  b-  c+  b+        overlap along x; along y they do, so they meet
//
// Two boxes meet iff along every axis the lower end of each is in front of the upper end of the
// other. The place of every end is a number, so that is known in O(1). A failure changes two
// neighbours, so at most the one pair of their boxes.
//
// Certificates. One per two neighbours among the 2n ends along an axis, "this end is not beyond the
// next": 2n - 1 an axis, an object in at most 4 of them; degree d for motions and extents of degree
// d. The claim about the two ends of one box is that its extent is not negative.
//
// Cost: a failure renews 3 certificates in O(log n); an insertion or erasure makes O(log n)
// comparisons an axis and numbers the places anew, O(n). The pairs are enumerated by a sweep along
// the first axis: O(n) and the pairs whose intervals on it meet.
//
// Ties. Of ends that are equal identically the lower ones come first, so that boxes meet that touch
// identically; those of one kind are in the order of their ids.
#ifndef KINEX_STRUCTURES_PROXIMITY_BOX_OVERLAPS_H
#define KINEX_STRUCTURES_PROXIMITY_BOX_OVERLAPS_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/engine/kernel.h"
#include "core/engine/proof.h"
#include "structures/parts/kinetic_list.h"

namespace kinex {

// Claims about ends along one axis. Item 2a is the lower end of object a, item 2a + 1 its upper end.
class EndClaims {
 public:
  EndClaims(Kernel& kernel, const Scene& scene, int axis);

  static Item lower(ObjectId object) { return 2 * object; }
  static Item upper(ObjectId object) { return 2 * object + 1; }
  static ObjectId object_of(Item end) { return end / 2; }
  static bool is_upper(Item end) { return end % 2 != 0; }

  Query claim(Item a, Item b) const;
  bool goes_first(Item a, Item b) const {
    return is_upper(a) != is_upper(b) ? is_upper(b) : a < b;
  }

 private:
  PredicateId lower_ends_, upper_ends_, meeting_, apart_, width_, no_width_;
};

class BoxOverlaps {
 public:
  using Pair = std::array<ObjectId, 2>;  // the smaller id first

  BoxOverlaps(Kernel& kernel, StructureId id, const Scene& scene);

  // The boxes of these objects, in place of those that are there.
  template <class Change, class Tied>
  void build(std::span<const ObjectId> objects, const Change& change, const Tied& tied);
  // One box more or less. The caller asks for the pairs of an object before it is erased, or after it
  // was inserted.
  template <class Change, class Tied>
  void insert(ObjectId object, const Change& change, const Tied& tied);
  template <class Change, class Tied>
  void erase(ObjectId object, const Change& change, const Tied& tied);
  // True if the certificate belongs to a list of ends.
  bool owns(CertificateId c) const { return list_of(c) != nullptr; }
  // A certificate of a list has failed: two ends change places, those of the objects that are
  // returned. Calls change(a, b, meets) if their boxes begin or cease to meet.
  template <class Change>
  std::pair<ObjectId, ObjectId> failed(CertificateId c, const Change& change);
  // Puts ties in order: as failed(), then calls tied(a, b). To be called after failed().
  template <class Change, class Tied>
  void settle(const Change& change, const Tied& tied);
  template <class Change, class Tied>
  void motions_changed(std::span<const ObjectId> objects, const Change& change, const Tied& tied);

  // The boxes of a and b, which are there, meet. O(1).
  bool meet(ObjectId a, ObjectId b) const;
  bool has(ObjectId object) const { return object < there_.size() && there_[object]; }
  // Those that are there, ascending.
  std::vector<ObjectId> objects() const;
  std::size_t size() const { return size_; }
  // All pairs that meet, ascending.
  std::vector<Pair> pairs() const;
  // Those of one object.
  std::vector<ObjectId> partners(ObjectId object) const;

  int axes() const { return static_cast<int>(lists_.size()); }
  // Failures of the lists.
  std::uint64_t swaps() const;
  std::uint64_t max_live() const;  // the sum of the lists' largest numbers of certificates
  void visit_proof(ProofVisitor& visitor) const;
  void check(AuditReport& report) const;
  std::size_t bytes() const;

 private:
  using List = KineticList<EndClaims>;

  const List* list_of(CertificateId c) const;
  // Two ends along an axis change places.
  template <class Change>
  void exchange(std::size_t axis, Item before, Item after, const Change& change);
  void number(std::size_t axis);

  std::vector<List> lists_;                       // by axis
  std::vector<std::vector<std::uint32_t>> rank_;  // by axis and end: its place among the ends
  std::vector<bool> there_;                       // by object
  std::size_t size_ = 0;                          // their number
};

// ---- templates

template <class Change>
void BoxOverlaps::exchange(std::size_t axis, Item before, Item after, const Change& change) {
  const ObjectId a = EndClaims::object_of(before), b = EndClaims::object_of(after);
  const bool facing = a != b && EndClaims::is_upper(before) != EndClaims::is_upper(after);
  const bool met = facing && meet(a, b);
  std::swap(rank_[axis][before], rank_[axis][after]);
  if (facing && meet(a, b) != met) change(std::min(a, b), std::max(a, b), !met);
}

template <class Change, class Tied>
void BoxOverlaps::build(std::span<const ObjectId> objects, const Change& change, const Tied& tied) {
  std::vector<Item> ends;
  std::fill(there_.begin(), there_.end(), false);
  size_ = objects.size();
  for (const ObjectId object : objects) {
    there_[object] = true;
    ends.push_back(EndClaims::lower(object));
    ends.push_back(EndClaims::upper(object));
  }
  for (std::size_t axis = 0; axis < lists_.size(); ++axis) {
    const auto exchanged = [&](Item before, Item after) {
      exchange(axis, before, after, change);
      tied(EndClaims::object_of(before), EndClaims::object_of(after));
    };
    lists_[axis].build(ends, exchanged);
    number(axis);
  }
}

template <class Change, class Tied>
void BoxOverlaps::insert(ObjectId object, const Change& change, const Tied& tied) {
  there_[object] = true;
  ++size_;
  for (std::size_t axis = 0; axis < lists_.size(); ++axis) {
    const auto exchanged = [&](Item before, Item after) {
      exchange(axis, before, after, change);
      tied(EndClaims::object_of(before), EndClaims::object_of(after));
    };
    lists_[axis].insert(EndClaims::lower(object), exchanged);
    lists_[axis].insert(EndClaims::upper(object), exchanged);
    number(axis);
  }
}

template <class Change, class Tied>
void BoxOverlaps::erase(ObjectId object, const Change& change, const Tied& tied) {
  for (std::size_t axis = 0; axis < lists_.size(); ++axis) {
    const auto exchanged = [&](Item before, Item after) {
      exchange(axis, before, after, change);
      tied(EndClaims::object_of(before), EndClaims::object_of(after));
    };
    lists_[axis].erase(EndClaims::lower(object), exchanged);
    lists_[axis].erase(EndClaims::upper(object), exchanged);
    number(axis);
  }
  there_[object] = false;
  --size_;
}

template <class Change>
std::pair<ObjectId, ObjectId> BoxOverlaps::failed(CertificateId c, const Change& change) {
  const auto axis = static_cast<std::size_t>(list_of(c) - lists_.data());
  const auto [before, after] = lists_[axis].failed(c);
  exchange(axis, before, after, change);
  return {EndClaims::object_of(before), EndClaims::object_of(after)};
}

template <class Change, class Tied>
void BoxOverlaps::settle(const Change& change, const Tied& tied) {
  for (std::size_t axis = 0; axis < lists_.size(); ++axis) {
    lists_[axis].settle([&](Item before, Item after) {
      exchange(axis, before, after, change);
      tied(EndClaims::object_of(before), EndClaims::object_of(after));
    });
  }
}

template <class Change, class Tied>
void BoxOverlaps::motions_changed(std::span<const ObjectId> objects, const Change& change,
                                  const Tied& tied) {
  for (std::size_t axis = 0; axis < lists_.size(); ++axis) {
    lists_[axis].motions_changed(objects, [&](Item before, Item after) {
      exchange(axis, before, after, change);
      tied(EndClaims::object_of(before), EndClaims::object_of(after));
    });
  }
}

}  // namespace kinex

#endif
