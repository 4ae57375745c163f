// SPDX-License-Identifier: GPL-3.0-or-later
// ConvexHull2BruteForce: the convex hull of moving points by comparing every point with every hull
// edge: the baseline of the report.
//
// Certificates, for motions of degree d, with a hull of h vertices:
//   turn    at each hull vertex the hull turns left                 orientation_2,    degree 2d
//   inside  each other point is to the left of each hull edge       orientation_2,    degree 2d
//   between a point that is identically on a hull edge is between   coordinate_order, degree d
//           its ends (two certificates)
//
// Quality, for n points: (n - h) h + h certificates, and two more for a point and each hull edge that
// it is identically on. Every failure is a change of the hull (ratio 1), except where hull vertices
// meet and part again (below). After each failure the static algorithm finds the hull and everything is
// scheduled anew. New motion of a hull vertex reschedules the certificates of all other points, that of
// another point only its own. Events: at most 2d C(n,3), unless three points are identically on one
// line: these change places where no triple turns.
//
// Turns fail at touches, too (core/arithmetic/touch.h): hull vertices that meet and part again can
// leave every turn to the left, and a hull that winds around twice. Such a failure may change
// nothing.
//
// Ties: strict vertices only; of identically equal points the smallest id.
//
// Source: Guibas, "Kinetic data structures: a state of the art report" (1998), section 11.
#ifndef KINEX_STRUCTURES_HULL_CONVEX_HULL_2_BRUTE_FORCE_H
#define KINEX_STRUCTURES_HULL_CONVEX_HULL_2_BRUTE_FORCE_H

#include <span>
#include <string_view>
#include <vector>

#include "core/engine/kernel.h"
#include "core/engine/structure.h"
#include "core/motion/scene.h"
#include "predicates/predicates.h"
#include "structures/hull/convex_hull_2_signs.h"
#include "structures/hull/hull_source.h"
#include "structures/parts/repeat_guard.h"
#include "structures/parts/ties.h"

namespace kinex {

class ConvexHull2BruteForce final : public HullSource {
 public:
  enum Kind : std::uint8_t {
    kTurn = HullEvents::kKinds,  // a hull vertex and its neighbours: before, vertex, after
    kInside,                     // a hull edge and a point
    kBetween,                    // two points on one line
  };

  ConvexHull2BruteForce(Kernel& kernel, StructureId id, const Scene&)
      : HullSource(kernel, id),
        signs_(kernel),
        touch_turn_(kernel.bind(make_orientation_2_touch())),
        slots_(kernel, id, "claims") {}

  std::string_view name() const override { return "convex_hull_2_brute_force"; }
  std::vector<std::string_view> event_kinds() const override;
  void build(std::span<const ObjectId> objects) override;
  void rebuild() override { events_.begin(find_hull()); }
  void certificate_failed(CertificateId failed) override;
  void insert(ObjectId object) override;
  void erase(ObjectId object) override;
  void motions_changed(std::span<const ObjectId> objects) override;
  void instant_settled() override;
  void visit_proof(ProofVisitor& visitor) const override;
  std::vector<BoundCheck> bounds(const BoundContext& context) const override;
  std::uint64_t most_repairs(std::uint64_t) const override { return 0; }
  void check_invariants(AuditReport& report) const override;
  // A hull that winds around twice turns left everywhere, too: after the scene's end it may do so.
  bool holds_at(const Snapshot& snapshot) const override;
  std::size_t bytes() const override;

 private:
  Outlook claim(const Query& query, Kind kind);
  void claim_inside(ObjectId u, ObjectId v, ObjectId point);
  const std::vector<ObjectId>& find_hull();

  HullSigns signs_;
  PredicateId touch_turn_;
  Slots slots_;                    // tag: the kind
  std::vector<ObjectId> members_;  // ascending
  std::vector<ObjectId> cycle_;
  std::vector<CertificateId> certificates_;
  RepeatGuard repeats_;
  bool look_again_ = false;  // motions have changed: ties may have come or gone
};

}  // namespace kinex

#endif
