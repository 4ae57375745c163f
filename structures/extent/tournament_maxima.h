// SPDX-License-Identifier: GPL-3.0-or-later
// TournamentMaxima: the extreme objects of motions of any degree, each by a tournament
// (direction_maxima.h). Each direction is a part of the structure (Kernel::add_part), and part i is
// direction i: the structure adds no part before.
#ifndef KINEX_STRUCTURES_EXTENT_TOURNAMENT_MAXIMA_H
#define KINEX_STRUCTURES_EXTENT_TOURNAMENT_MAXIMA_H

#include <limits>

#include "structures/extent/direction_maxima.h"
#include "structures/parts/key_order.h"
#include "structures/parts/kinetic_tournament.h"

namespace kinex {

class TournamentMaxima final : public DirectionMaxima {
 public:
  TournamentMaxima(Kernel& kernel, StructureId structure, const Scene& scene,
                   const std::vector<DirectionVector>& half);

  bool level(std::size_t i, ObjectId a, ObjectId b) const override;
  bool owns(CertificateId certificate) const override;
  Duel failed(CertificateId certificate, const Tied& tied) override;
  int largest_motion_degree() const override { return std::numeric_limits<int>::max(); }
  Integer most_certificates(const BoundContext& context) const override;
  Integer most_per_object(const BoundContext& context) const override;
  Integer most_failures(const BoundContext& context) const override;
  void visit_proof(ProofVisitor& visitor) const override;
  void check(AuditReport& report) const override;
  std::size_t bytes() const override;

 private:
  ObjectId built(std::size_t i, std::span<const ObjectId> objects, const Tied& tied) override;
  ObjectId rebuilt(std::size_t i, const Tied& tied) override;
  ObjectId inserted(std::size_t i, ObjectId object, const Tied& tied) override;
  ObjectId erased(std::size_t i, ObjectId object, const Tied& tied) override;
  ObjectId moved(std::size_t i, std::span<const ObjectId> objects, const Tied& tied) override;

  // The tie report of the tournament of direction i.
  static auto in(std::size_t i, const Tied& tied) {
    return [i, &tied](ObjectId old, ObjectId fresh) { tied({i, old, fresh}); };
  }

  Kernel* kernel_;
  StructureId structure_;
  std::vector<KineticTournament<Contest>> tournaments_;
};

}  // namespace kinex

#endif
