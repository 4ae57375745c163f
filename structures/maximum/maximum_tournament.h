// SPDX-License-Identifier: GPL-3.0-or-later
// MaximumTournament: the object with the largest (or smallest) key, by a tournament tree.
//
// Certificates. Those of a KineticTournament (parts/kinetic_tournament.h), one per inner node: the
// winner of one child is at least as good as the winner of the other. The degree in t is D, the
// degree of the key.
//
// Quality, for n objects:
//   compactness     n - 1 certificates
//   locality        at most ceil(log2 n) certificates per object, the depth of the tree; with
//                   squared distances as keys, the object from which they are measured is in all
//                   n - 1
//   responsiveness  O(log n) certificates, those on one path to the root; an insertion or erasure
//                   moves at most two objects, O(log n) certificates
//   efficiency      not strongly efficient: the maximum may change O(1) times while Theta(n) events
//                   are processed
// lambda_D(n) is the greatest length of a Davenport-Schinzel sequence of order D over n symbols; it
// is n for D = 1.
// Events, without flight-plan changes: at most the sum over inner nodes v of lambda_D(m_v) - 1,
// with m_v the number of leaves under v. For lines and n a power of two this is n log2 n - n + 1,
// and it is reached. The maximum changes at most lambda_D(n) - 1 times. (Several failures at one
// instant count one by one: the winners of a node still form a Davenport-Schinzel sequence of order
// D, since each is equal to the previous one at the instant and strictly better right after it;
// roots are counted with multiplicity.)
// A change of motion, an insertion or an erasure begins a new epoch of every node on the paths from
// its leaves to the root. Each epoch of a node v has at most lambda_D(m_v) - 1 events: the winner
// from before the change is the first of the sequence, since its key is no less than the others' at
// the instant. So an update adds one such term for every node on its paths to the bound, for lines
// about 2 n per path.
//
// Ties. Of objects with identically equal keys the smallest id wins.
//
// Source: Guibas, "Kinetic data structures: a state of the art report" (1998), section 5.
#ifndef KINEX_STRUCTURES_MAXIMUM_MAXIMUM_TOURNAMENT_H
#define KINEX_STRUCTURES_MAXIMUM_MAXIMUM_TOURNAMENT_H

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "structures/maximum/maximum_structure.h"
#include "structures/parts/kinetic_tournament.h"

namespace kinex {

class MaximumTournament final : public MaximumStructure {
 public:
  enum Kind : std::uint8_t {
    kReplace,  // another winner at a node, or another maximum: the old one, the new one
    kTie,      // at a node, because the two keys have become identically equal
  };

  MaximumTournament(Kernel& kernel, StructureId id, const Key& key, const Scene& scene,
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
  std::size_t bytes() const override { return tournament_.bytes(); }

  ObjectId winner() const override { return tournament_.winner(); }

 private:
  // Reports a tie that was resolved.
  auto tied() {
    return [this](ObjectId old, ObjectId fresh) { kernel_->report(id_, kTie, {old, fresh}, false); };
  }

  KineticTournament<Contest> tournament_;
};

}  // namespace kinex

#endif
