// SPDX-License-Identifier: GPL-3.0-or-later
// SortedList: moving objects in the order of a key.
//
// Certificates. A KineticList (parts/kinetic_list.h): one per pair of neighbours (a, b), key(a) <=
// key(b), of the key's degree D in t (D = d for coordinates and directions of motions of degree d,
// 2d for squared distances).
//
// Quality, for n objects:
//   compactness     n - 1 certificates
//   locality        2 certificates an object; with squared distances as keys, the object from
//                   which they are measured is in all n - 1
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
#include "structures/parts/kinetic_list.h"

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
  void visit_proof(ProofVisitor& visitor) const override;
  std::vector<BoundCheck> bounds(const BoundContext& context) const override;
  void check_invariants(AuditReport& report) const override;
  void audit(const Snapshot& snapshot, AuditReport& report) const override;
  std::size_t bytes() const override { return list_.bytes(); }

  StructureId id() const { return id_; }
  std::size_t size() const { return list_.size(); }
  // The number of objects of the scene, whether in the list or not.
  std::size_t objects() const { return list_.capacity(); }
  // Neighbours in the order, kNoObject at its ends. Requires that `object` is in the list. O(1).
  ObjectId first() const { return list_.first(); }
  ObjectId last() const { return list_.last(); }
  ObjectId next(ObjectId object) const { return list_.next(object); }
  ObjectId previous(ObjectId object) const { return list_.previous(object); }
  // The first or the last object; of several with identically equal keys the one with the smallest
  // id. kNoObject if there is none. O(1), except for such ties.
  ObjectId extreme(Extremum extremum) const {
    return extremum == Extremum::kMinimum ? list_.first() : list_.front_of_last();
  }
  const KeyOrder& order() const { return list_.claims(); }

 private:
  auto tied() {
    return [this](ObjectId a, ObjectId b) { kernel_->report(id_, kTie, {a, b}, true); };
  }

  Kernel* kernel_;
  StructureId id_;
  KineticList<KeyOrder> list_;
};

}  // namespace kinex

#endif
