// SPDX-License-Identifier: GPL-3.0-or-later
// DiameterAllPairs: the farthest pair of moving points, by a tournament of all pairs. The baseline
// for diameter_2: without a hull, in 1 to 3 axes.
//
// Certificates. "This pair is at least as far apart as that one": n(n-1)/2 - 1 of them for n
// points, degree 2d for motions of degree d.
//
// Quality: a point is in up to 2 (n - 1) log2 n certificates; a failure renews O(log n), an
// insertion or erasure O(n log n). External events: one for each instant that changes the pair, at
// most lambda_2d(n(n-1)/2) - 1 without flight-plan changes: n(n-1) - 2 for linear motion.
//
// Ties. Of pairs at identically equal distances the lexicographically smallest one.
//
// Source: Guibas, "Kinetic data structures: a state of the art report" (1998), sections 5 and 6.7.
#ifndef KINEX_STRUCTURES_EXTENT_DIAMETER_ALL_PAIRS_H
#define KINEX_STRUCTURES_EXTENT_DIAMETER_ALL_PAIRS_H

#include <span>
#include <string_view>
#include <vector>

#include "core/engine/structure.h"
#include "structures/parts/attribute_events.h"
#include "structures/parts/changing_extremum.h"
#include "structures/parts/pair_distances.h"

namespace kinex {

// The pair that is farther apart is in front.
class FarPairs {
 public:
  using Value = PairDistances::Value;
  FarPairs(Kernel& kernel, int dimension) : distances_(kernel, dimension) {}
  Query claim(const Value& front, const Value& back) const { return distances_.claim(back, front); }
  bool goes_first(const Value& a, const Value& b) const { return a < b; }

 private:
  PairDistances distances_;
};

class DiameterAllPairs final : public Structure {
  using Pair = FarPairs::Value;
  auto tied() {
    return [this](const Pair& a, const Pair& b) {
      kernel_->report(id_, kTie, {a[0], a[1], b[0], b[1]}, false);
    };
  }

 public:
  // kReplace: another winner of a duel: the old pair and the new one. kTie: the same, because the
  // distances have become identically equal.
  enum Kind : std::uint8_t { kReplace, kTie };

  DiameterAllPairs(Kernel& kernel, StructureId id, const Scene& scene)
      : kernel_(&kernel),
        id_(id),
        pairs_(kernel, id, "pairs", FarPairs(kernel, scene.dimension)),
        events_(kernel, id, Attribute::Shape::kTuples) {}

  std::string_view name() const override { return "diameter_all_pairs"; }
  std::vector<std::string_view> event_kinds() const override {
    return common_event_kinds({"replace", "tie"});
  }
  void build(std::span<const ObjectId> objects) override;
  void rebuild() override;
  void certificate_failed(CertificateId failed) override;
  void insert(ObjectId object) override;
  void erase(ObjectId object) override;
  void motions_changed(std::span<const ObjectId> objects) override {
    pairs_.motions_changed(objects, tied());
  }
  void instant_over() override { events_.over(farthest()); }
  Attribute attribute() const override { return {Attribute::Shape::kTuples, farthest()}; }
  Attribute told() const override { return events_.told(); }
  void visit_proof(ProofVisitor& visitor) const override;
  std::vector<BoundCheck> bounds(const BoundContext& context) const override;
  void check_invariants(AuditReport& report) const override;
  void audit(const Snapshot& snapshot, AuditReport& report) const override;
  std::size_t bytes() const override {
    return members_.capacity() * sizeof(ObjectId) + pairs_.bytes() + events_.bytes();
  }

 private:
  std::vector<ObjectId> farthest() const;
  void begin();

  Kernel* kernel_;
  StructureId id_;
  std::vector<ObjectId> members_;  // ascending
  ChangingExtremum<FarPairs> pairs_;
  AttributeEvents events_;
};

}  // namespace kinex

#endif
