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
  void build(std::span<const ObjectId> objects, const Tied& tied) override;
  void rebuild(const Tied& tied) override;
  bool owns(CertificateId certificate) const override;
  Duel failed(CertificateId certificate, const Tied& tied) override;
  void insert(ObjectId object, const Tied& tied) override;
  void erase(ObjectId object, const Tied& tied) override;
  void motions_changed(std::span<const ObjectId> objects, const Tied& tied) override;
  int largest_motion_degree() const override { return std::numeric_limits<int>::max(); }
  Integer most_certificates(const BoundContext& context) const override;
  Integer most_per_object(const BoundContext& context) const override;
  Integer most_failures(const BoundContext& context) const override;
  void visit_proof(ProofVisitor& visitor) const override;
  void check(AuditReport& report) const override;
  std::size_t bytes() const override;

 private:
  // The tie report of the tournament of direction i.
  static auto in(std::size_t i, const Tied& tied) {
    return [i, &tied](ObjectId old, ObjectId fresh) { tied({i, old, fresh}); };
  }
  void read(std::size_t i) { winners_[i] = tournaments_[i].winner(); }

  Kernel* kernel_;
  StructureId structure_;
  std::vector<KineticTournament<Contest>> tournaments_;
};

}  // namespace kinex

#endif
