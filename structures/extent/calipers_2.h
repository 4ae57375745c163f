// SPDX-License-Identifier: GPL-3.0-or-later
// Calipers2: what rotating calipers touch on their way around a convex hull: all antipodal pairs,
// or all sets of four vertices that two pairs of calipers at right angles touch at once.
//
// Certificates. It watches a hull (HullSource). Calipers (calipers.h) keep the directions of the
// hull's edges in order, modulo half a turn (folds = 2) or a quarter (folds = 4). Degree 2d for
// motions of degree d: an orientation, slope_order_2 or edge_dot_2.
//
//   between two neighbours of the list the calipers touch the same vertices; when they pass the
//   direction of an edge, its tail is replaced by its head:
//
//        list      .. d      e      f      g ..       a swap of e and f changes what is touched
//        touched      |  T1  |  T2  |  T3  |          between them, T2, and nothing else
//
// Quality, for h hull vertices: at most h certificates, 4 of one vertex; a failure renews 3, and is
// an external event of its own. A vertex that comes or goes renews 3. O(h log h) time to report a
// change. It is local, compact and responsive, and efficient: every event changes the attribute.
// O(n^(2 + eps)) events for algebraic motion; at most 6d (C(n,4) + C(n,3)) antiparallel and as many
// perpendicular ones, of the antiparallel ones 6d C(n,4) outside instants at which all points are
// on one line. External events: one for each instant that changes the attribute.
//
// Readers. Structures over one hull that search what calipers find share one of these: the plan
// makes it if a scene maintains two or more of them. A reader watches the hull and the calipers,
// and follows Calipers::changes_since: whatever changes is reported to it by one of the two before
// the instant is over.
//
// Ties. Directions that are identically equal modulo the fold are in the order of their tails.
//
// Attribute. The tuples of `folds` vertices that are touched at once: ids ascend in a tuple (a
// vertex may be touched twice by calipers of 4 folds), tuples ascend; h of them, no two alike. For
// a segment a, b: one tuple, of both ends in equal parts. With fewer vertices: none. The hull and
// the attribute determine the list and all contacts.
//
// Source: Guibas, "Kinetic data structures: a state of the art report" (1998), section 6.7;
// Agarwal, Guibas, Hershberger, Veach, "Maintaining the extent of a moving point set" (2001).
#ifndef KINEX_STRUCTURES_EXTENT_CALIPERS_2_H
#define KINEX_STRUCTURES_EXTENT_CALIPERS_2_H

#include <cstddef>
#include <initializer_list>
#include <span>
#include <string_view>
#include <vector>

#include "core/engine/structure.h"
#include "structures/extent/hull_calipers.h"
#include "structures/parts/attribute_events.h"

namespace kinex {

class Calipers2 final : public Structure {
 public:
  // HullCalipers::Kind. kAntiparallel, kPerpendicular: two edges, each by its ends. kSplit, kMerge:
  // a vertex that came or went between two others. kRenew: the list was built anew.
  using Kind = HullCalipers::Kind;

  // `hull` outlives this structure and is watched by it; it is the structure `hull_id`.
  Calipers2(Kernel& kernel, StructureId id, int folds, const HullSource& hull, StructureId hull_id);

  std::string_view name() const override { return "calipers_2"; }
  std::vector<std::string_view> event_kinds() const override {
    return common_event_kinds({"antiparallel", "perpendicular", "split", "merge", "renew"});
  }
  void build(std::span<const ObjectId>) override { begin(); }
  void rebuild() override;
  void certificate_failed(CertificateId failed) override;
  // Vertices come and go in the hull.
  void insert(ObjectId) override { begin(); }
  void erase(ObjectId) override { begin(); }
  void motions_changed(std::span<const ObjectId> objects) override;
  void instant_settled() override;
  void instant_over() override { events_.over(touched()); }
  void watched_changed(const Event* event) override;
  Attribute attribute() const override;
  Attribute told() const override { return events_.told(); }
  void visit_proof(ProofVisitor& visitor) const override { calipers_.visit_proof(visitor); }
  std::vector<BoundCheck> bounds(const BoundContext& context) const override;
  void check_invariants(AuditReport& report) const override;
  void audit(const Snapshot& snapshot, AuditReport& report) const override;
  std::size_t bytes() const override { return calipers_.bytes() + events_.bytes(); }

  StructureId id() const { return id_; }
  const Calipers& calipers() const { return calipers_.calipers(); }
  // The list may still change at this instant.
  bool is_settling() const;

 private:
  void begin();
  void trim();
  std::vector<ObjectId> touched() const;
  void audit_touched(const Snapshot& snapshot, AuditReport& report) const;  // calipers_2_audit.cpp

  Kernel* kernel_;
  StructureId id_, hull_id_;
  HullCalipers calipers_;
  AttributeEvents events_;
};

}  // namespace kinex

#endif
