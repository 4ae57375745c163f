// SPDX-License-Identifier: GPL-3.0-or-later
// ConvexHull2Delaunay: the convex hull of moving points, read off their Delaunay triangulation.
//
// Certificates. None of its own: it watches the triangulation (delaunay_2), whose outer boundary is
// the hull, and reads it when a point enters or leaves that boundary.
//
// Quality: that of the triangulation, whose whole cost is paid for its boundary: certificates of
// degree 4d against 2d, Theta(n^(3/2)) flips for random motion against O(n) failures. The report
// compares the two.
//
// Ties: strict vertices only (the triangulation has points on hull edges too); of identically equal
// points the smallest id.
//
// Source: Guibas, "Kinetic data structures: a state of the art report" (1998), section 11.
#ifndef KINEX_STRUCTURES_HULL_CONVEX_HULL_2_DELAUNAY_H
#define KINEX_STRUCTURES_HULL_CONVEX_HULL_2_DELAUNAY_H

#include <span>
#include <string_view>
#include <vector>

#include "core/engine/kernel.h"
#include "core/engine/structure.h"
#include "structures/hull/hull_events.h"
#include "structures/triangulation/delaunay_2.h"

namespace kinex {

class ConvexHull2Delaunay final : public Structure, public HullSource {
 public:
  // `triangulation` outlives this structure and is watched by it.
  ConvexHull2Delaunay(Kernel& kernel, StructureId id, const Scene& scene,
                      const Delaunay2& triangulation);

  std::string_view name() const override { return "convex_hull_2_delaunay"; }
  std::vector<std::string_view> event_kinds() const override { return HullEvents::kinds({}); }
  void build(std::span<const ObjectId> objects) override;
  void rebuild() override { events_.begin(cycle()); }
  // Never called: it has no certificates.
  void certificate_failed(CertificateId) override {}
  // Insertion and erasure of points happen in the triangulation.
  void insert(ObjectId) override { events_.begin(cycle()); }
  void erase(ObjectId) override { events_.begin(cycle()); }
  void instant_settled() override { look(); }
  void watched_changed(const Event* event) override;
  // As last read: an inexact arithmetic might read another one now.
  const HullRing& ring() const override { return events_.ring(); }
  StructureId id() const override { return id_; }
  bool is_settling() const override { return kernel_->instant_is_shared(triangulation_->id()); }
  Attribute attribute() const override { return {Attribute::Shape::kCycle, events_.cycle()}; }
  std::vector<BoundCheck> bounds(const BoundContext& context) const override;
  void check_invariants(AuditReport& report) const override;
  void audit(const Snapshot& snapshot, AuditReport& report) const override;
  std::size_t bytes() const override { return sizeof *this + events_.bytes(); }

 private:
  std::vector<ObjectId> cycle() const;
  void look();

  Kernel* kernel_;
  StructureId id_;
  PredicateId orientation_;
  std::size_t objects_;
  const Delaunay2* triangulation_;
  HullEvents events_;
};

}  // namespace kinex

#endif
