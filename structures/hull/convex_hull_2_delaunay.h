// SPDX-License-Identifier: GPL-3.0-or-later
// ConvexHull2Delaunay: the convex hull of moving points, read off their Delaunay triangulation.
//
// Certificates. None of its own: it watches the triangulation (delaunay_2), whose outer boundary is
// the hull, and reads it when a point enters or leaves that boundary.
//
// Quality: that of the triangulation, which is maintained as a whole for its boundary alone. Its
// certificates have degree 4d instead of 2d, and random motion makes Theta(n^(3/2)) flips instead of
// O(n) failures.
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
#include "structures/hull/hull_source.h"
#include "structures/triangulation/delaunay_2.h"

namespace kinex {

class ConvexHull2Delaunay final : public HullSource {
 public:
  // `triangulation` outlives this structure and is watched by it.
  ConvexHull2Delaunay(Kernel& kernel, StructureId id, const Delaunay2& triangulation);

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
  bool is_settling() const override { return kernel_->instant_is_shared(triangulation_->id()); }
  std::vector<BoundCheck> bounds(const BoundContext& context) const override;
  void check_invariants(AuditReport& report) const override;
  std::size_t bytes() const override { return sizeof *this + events_.bytes(); }

 private:
  std::vector<ObjectId> cycle() const;
  void look();

  PredicateId orientation_;
  const Delaunay2* triangulation_;
};

}  // namespace kinex

#endif
