// SPDX-License-Identifier: GPL-3.0-or-later
// MaximumHeap: the object with the largest (or smallest) key, by a binary heap.
//
// Certificates. A KineticHeap (parts/kinetic_heap.h): one per place i > 0 of the heap's array, the
// object at the parent is at least as good as the one at i; degree D in t, that of the key.
//
// Quality, for n objects:
//   compactness     n - 1 certificates
//   locality        3 certificates an object; with squared distances as keys, the object from
//                   which they are measured is in all n - 1
//   responsiveness  at most 5 certificates, O(log n); an insertion or erasure sifts along one path,
//                   O(log n) certificates
// Events, for affine motions without flight-plan changes: at most the number of (ancestor,
// descendant) pairs, the sum of the depths, (k - 2) 2^k + 2 for n = 2^k - 1, which is reached: each
// event removes a pair whose descendant has the larger slope, and makes none. A flight-plan change,
// an insertion or an erasure makes at most as many such pairs as the objects that it changes or
// moves are in, and the bound grows by these: O(log n) for an object at the bottom. (For m updates
// the literature has O(m sqrt(m log m)).) For motions of higher degree no bound with known
// constants is proven but one event per crossing. The maximum changes at most lambda_D(n) - 1 times
// (lambda_D: see maximum_tournament.h).
//
// Ties. Where one of two objects with identically equal keys is an ancestor of the other, it has
// the smaller id; so the smallest is at the top.
//
// Source: Guibas, "Kinetic data structures: a state of the art report" (1998), section 5; events:
// Basch, Guibas, Ramkumar, "Reporting red-blue intersections between two sets of connected line
// segments" (1996); da Fonseca, de Figueiredo, "Kinetic heap-ordered trees" (2003).
#ifndef KINEX_STRUCTURES_MAXIMUM_MAXIMUM_HEAP_H
#define KINEX_STRUCTURES_MAXIMUM_MAXIMUM_HEAP_H

#include <span>
#include <string_view>
#include <vector>

#include "structures/maximum/maximum_structure.h"
#include "structures/parts/kinetic_heap.h"

namespace kinex {

class MaximumHeap final : public MaximumStructure {
 public:
  enum Kind : std::uint8_t {
    kSwap,     // parent and child change places: the old parent, the new one
    kTie,      // the same, because their keys have become identically equal
    kReplace,  // another maximum, by more than one swap: the old one, the new one
  };

  MaximumHeap(Kernel& kernel, StructureId id, const Key& key, const Scene& scene,
              Extremum extremum);

  std::vector<std::string_view> event_kinds() const override;
  void build(std::span<const ObjectId> objects) override;
  void rebuild() override;
  void certificate_failed(CertificateId failed) override;
  void insert(ObjectId object) override;
  void erase(ObjectId object) override;
  void motions_changed(std::span<const ObjectId> objects) override;
  void visit_proof(ProofVisitor& visitor) const override;
  std::vector<BoundCheck> bounds(const BoundContext& context) const override;
  void check_invariants(AuditReport& report) const override;
  std::size_t bytes() const override { return heap_.bytes(); }

  ObjectId winner() const override { return heap_.top(); }

 private:
  auto tied() {
    return [this](ObjectId old, ObjectId fresh) { kernel_->report(id_, kTie, {old, fresh}, false); };
  }

  KineticHeap<Contest> heap_;
};

}  // namespace kinex

#endif
