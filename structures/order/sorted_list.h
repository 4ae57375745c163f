// SPDX-License-Identifier: GPL-3.0-or-later
// SortedList: moving objects in the order of a key.
//
// Certificates. One per pair of neighbours (a, b): key(a) <= key(b), of the key's degree D in t
// (D = d for coordinates and directions of motions of degree d, 2d for squared distances).
//
//     z --1-- a --2-- b --3-- y      2 fails: a and b change places,
//     z --1'- b --2'- a --3'- y      three certificates are renewed
//
// Quality, for n objects:
//   compactness     n - 1 certificates
//   locality        2 certificates an object
//   responsiveness  3 certificates, O(log n); an insertion O(log n) signs and 2 certificates, an
//                   erasure 1 certificate
//   efficiency      every event is external; as a structure for the maximum alone it is not
//                   efficient: n(n-1)/2 events against n - 1
// Events: every pair changes places at most D times, so at most D n(n-1)/2, reached by n lines of
// which any two cross; with flight plans see pair_sign_changes in core/engine/bound.h.
//
// Ties. Objects with identically equal keys are in the order of their ids.
//
// Source: Guibas, "Kinetic data structures: a state of the art report" (1998), section 5.
#ifndef KINEX_STRUCTURES_ORDER_SORTED_LIST_H
#define KINEX_STRUCTURES_ORDER_SORTED_LIST_H

#include <span>
#include <string_view>
#include <vector>

#include "core/engine/kernel.h"
#include "core/engine/structure.h"
#include "core/motion/scene.h"
#include "structures/parts/key_order.h"
#include "structures/parts/order_tree.h"

namespace kinex {

class SortedList final : public Structure {
 public:
  enum Kind : std::uint8_t {
    kSwap,  // two neighbours change places: the one that came first, the other
    kTie,   // the same, because their keys have become identically equal
  };

  SortedList(Kernel& kernel, StructureId id, const Key& key, const Scene& scene);

  std::string_view name() const override { return "sorted_list"; }
  std::vector<std::string_view> event_kinds() const override;
  void build(std::span<const ObjectId> objects) override;
  void rebuild() override;
  void certificate_failed(CertificateId failed) override;
  void insert(ObjectId object) override;
  void erase(ObjectId object) override;
  void motions_changed(std::span<const ObjectId> objects) override;
  Attribute attribute() const override;
  std::vector<BoundCheck> bounds(const BoundContext& context) const override;
  void check_invariants(AuditReport& report) const override;
  void audit(const Snapshot& snapshot, AuditReport& report) const override;
  std::size_t bytes() const override;

  std::size_t size() const { return size_; }
  // The number of objects of the scene, whether in the list or not.
  std::size_t objects() const { return slot_of_.size(); }
  // Neighbours in the order, kNoObject at its ends. Requires that `object` is in the list. O(1).
  ObjectId first() const { return object_at(first_); }
  ObjectId last() const { return object_at(last_); }
  ObjectId next(ObjectId object) const { return object_at(slots_[slot_of_[object]].next); }
  ObjectId previous(ObjectId object) const { return object_at(slots_[slot_of_[object]].previous); }
  // The first or the last object; of several with identically equal keys the one with the smallest
  // id. kNoObject if there is none. O(1), except for such ties.
  ObjectId extreme(Extremum extremum) const;
  const KeyOrder& order() const { return order_; }

 private:
  using Place = OrderTree::Place;
  static constexpr Place kNone = OrderTree::kNone;
  // A place in the list and its object. A swap changes only the objects at two places.
  struct Slot {
    ObjectId object = kNoObject;
    Place next = kNone, previous = kNone;
    CertificateId certificate = kNoCertificate;  // of this place and the next
  };

  ObjectId object_at(Place s) const { return s == kNone ? kNoObject : slots_[s].object; }
  void construct(std::vector<ObjectId> members);
  void set_certificate(Place s);
  void drop_certificate(Place s);
  void exchange(Place s);
  void settle_ties();
  Place new_slot(ObjectId object);

  Kernel* kernel_;
  StructureId id_;
  KeyOrder order_;
  std::vector<Slot> slots_;
  std::vector<Place> slot_of_;  // per object
  std::vector<Place> free_;
  Place first_ = kNone, last_ = kNone;
  std::size_t size_ = 0;
  OrderTree tree_;  // built by the first insertion, kept from then on
  bool has_tree_ = false;
  std::vector<Place> ties_;  // certificates that are identically zero, not yet checked
};

}  // namespace kinex

#endif
