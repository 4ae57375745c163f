// SPDX-License-Identifier: GPL-3.0-or-later
// LineMaxima: the extreme objects of linear motions, each by a dual hull (direction_maxima.h).
//
// The position along u_i is a line slope t + height; the winner and the next one to win are
// neighbours on the upper hull of the dual points (maximum/line_hull.h). The only certificate of a
// direction compares these two; its tag is the direction.
#ifndef KINEX_STRUCTURES_EXTENT_LINE_MAXIMA_H
#define KINEX_STRUCTURES_EXTENT_LINE_MAXIMA_H

#include <deque>
#include <string>

#include "structures/extent/direction_maxima.h"
#include "structures/maximum/line_hull.h"
#include "structures/parts/key_order.h"
#include "structures/parts/slots.h"

namespace kinex {

class LineMaxima final : public DirectionMaxima {
 public:
  // Throws std::invalid_argument for motions that are not linear.
  LineMaxima(Kernel& kernel, StructureId structure, const Scene& scene,
             const std::vector<DirectionVector>& half);

  bool level(std::size_t i, ObjectId a, ObjectId b) const override;
  bool owns(CertificateId certificate) const override { return slots_.owns(certificate); }
  Duel failed(CertificateId certificate, const Tied& tied) override;
  int largest_motion_degree() const override { return 1; }
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

  struct Direction {
    Direction(Kernel& kernel, const Scene& scene, const Key& key, Extremum extremum)
        : contest(extremum, kernel, key, scene),
          order(kernel, contest, scene.dimension),
          hull(order, scene.objects.size()) {}
    Contest contest;
    LineOrder order;
    LineHull hull;
    ObjectId next = kNoObject;  // will overtake the winner; none at the last vertex
    CertificateId certificate = kNoCertificate;
  };

  // The winner of direction i, whose hull has changed: expects the next vertex.
  ObjectId look(std::size_t i);
  void expect(std::size_t i, ObjectId winner, ObjectId next);

  Kernel* kernel_;
  Slots slots_;
  std::deque<Direction> directions_;  // addresses are stable: each refers to itself
};

}  // namespace kinex

#endif
