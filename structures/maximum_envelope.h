// SPDX-License-Identifier: GPL-3.0-or-later
// MaximumEnvelope: the object with the largest (or smallest) key, read off the upper envelope of
// the keys, which is computed ahead.
//
// Certificates. One: the present winner is at least as good as the next one of the envelope; degree
// D in t, that of the key. The envelope itself is the rest of the proof, and needs no certificates
// as long as the motions in force are what they were when it was computed. None when the last
// winner has come.
//
// Quality, for n objects: compactness 1 certificate, locality 1, responsiveness 1 certificate, and
// every event is external: lambda_D(n) - 1 of them at most. What that costs: the envelope takes
// O(n) space (lambda_D(n)) and O(lambda_D(n) log n) failure times and comparisons of instants to
// compute, and every flight-plan change, insertion and erasure computes it anew. It is the offline
// solution that kinetic structures are measured against: no better when nothing changes, and
// hopeless when much does.
//
// Motions on intervals (flight plans, objects that come and go). The envelope is that of the
// motions in force, as if each went on for ever; it is right until the first of them ends, and is
// then computed anew from the ones that follow. The pieces that a scene plans for later are not
// looked at, though the envelope of all of them, lambda_{D+2}(pieces) winners, could be computed at
// the start: no structure is told of a flight plan before it comes into force, so that a run is the
// same whether a change stands in the scene or comes from outside while it runs, and a change from
// outside takes the place of what was planned. The events are those of that one envelope all the
// same: with m pieces at most lambda_{D+2}(m) - 1; only the cost is m envelopes instead of one.
//
// Ties. Of objects whose keys are equal for ever the smallest id wins. Where several overtake the
// winner at one instant only the one that is best right after it is ever the winner.
//
// Source: Guibas, "Kinetic data structures: a state of the art report" (1998), section 5.
#ifndef KINEX_STRUCTURES_MAXIMUM_ENVELOPE_H
#define KINEX_STRUCTURES_MAXIMUM_ENVELOPE_H

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/kernel.h"
#include "core/scene.h"
#include "core/structure.h"
#include "structures/key_order.h"

namespace kinex {

class MaximumEnvelope final : public Structure {
 public:
  enum Kind : std::uint8_t {
    kReplace,  // another winner: the old one, the new one
    kTie,      // the same, because their keys have become equal for ever
  };

  MaximumEnvelope(Kernel& kernel, StructureId id, const Key& key, const Scene& scene,
                  Extremum extremum);

  std::string_view name() const override;
  std::vector<std::string_view> event_kinds() const override;
  void build(std::span<const ObjectId> objects) override;
  void rebuild() override { renew(); }
  void certificate_failed(CertificateId failed) override;
  void insert(ObjectId object) override;
  void erase(ObjectId object) override;
  void motions_changed(std::span<const ObjectId> objects) override;
  Attribute attribute() const override;
  std::vector<BoundCheck> bounds(const BoundContext& context) const override;
  void check_invariants(AuditReport& report) const override;
  void audit(const Snapshot& snapshot, AuditReport& report) const override;
  bool holds_at(const Snapshot& snapshot) const override;
  std::size_t bytes() const override;

  // kNoObject if there is none.
  ObjectId winner() const { return winners_.empty() ? kNoObject : winners_[at_]; }
  // How many winners are still to come under the motions in force.
  std::size_t to_come() const { return winners_.empty() ? 0 : winners_.size() - 1 - at_; }

 private:
  void renew();
  void set_certificate();

  Kernel* kernel_;
  StructureId id_;
  Contest contest_;
  std::size_t objects_;            // in the scene
  std::optional<Rational> end_;    // for audits: so far goes the envelope
  std::vector<ObjectId> members_;  // ascending
  std::vector<ObjectId> winners_;  // from some instant on
  std::size_t at_ = 0;             // the present one
  CertificateId certificate_ = kNoCertificate;
};

}  // namespace kinex

#endif
