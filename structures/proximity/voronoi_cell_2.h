// SPDX-License-Identifier: GPL-3.0-or-later
// VoronoiCell2: the neighbours of one site in the Voronoi diagram of moving points in the plane, in
// the order of the edges around its cell.
//
// Certificates. None of its own: it watches the Delaunay triangulation (delaunay_2) and reads the
// star of the site when a flip touches it.
//
//            r1____r2
//            / \  / \         The edges of the cell of s are parts of the bisectors of s and its
//          r6---s----r3       Delaunay neighbours, in the same cyclic order: r1 r6 r5 r4 r3 r2,
//            \ / \  /         counter-clockwise. An unbounded cell has no edge between two of them.
//            r5----r4
//
// Quality: that of the triangulation, whose whole cost is paid for one star. A flip is looked at in
// O(1), and reads O(degree of s) if it touches s. External events: a neighbour leaves or enters, or
// the order of those that stay is another. The cell changes only where s is on a circle with three
// others, or on a line with two.
//
// Attribute: a cycle, counter-clockwise from the smallest id. Empty while the site is absent, or
// alone.
//
// Ties. Those of delaunay_2: of four sites that are identically on an empty circle two that are
// opposite are neighbours, by an edge of length zero, if one of them is the smallest. Sites that are
// identically equal have one cell in common, whose neighbours are no equals of theirs.
//
// Source: Guibas, "Kinetic data structures: a state of the art report" (1998), section 7.
#ifndef KINEX_STRUCTURES_PROXIMITY_VORONOI_CELL_2_H
#define KINEX_STRUCTURES_PROXIMITY_VORONOI_CELL_2_H

#include <span>
#include <string_view>
#include <vector>

#include "core/engine/kernel.h"
#include "core/engine/structure.h"
#include "structures/hull/hull_events.h"
#include "structures/triangulation/delaunay_2.h"

namespace kinex {

class VoronoiCell2 final : public Structure {
 public:
  // `triangulation` outlives this structure and is watched by it.
  VoronoiCell2(Kernel& kernel, StructureId id, const Delaunay2& triangulation, ObjectId site);

  std::string_view name() const override { return "voronoi_cell_2"; }
  // Those of a cycle (HullEvents): "leave", "enter", "turn".
  std::vector<std::string_view> event_kinds() const override { return HullEvents::kinds({}); }
  void build(std::span<const ObjectId>) override { events_.begin(cycle()); }
  void rebuild() override { events_.begin(cycle()); }
  // Never called: it has no certificates.
  void certificate_failed(CertificateId) override {}
  // Points come and go in the triangulation.
  void insert(ObjectId) override { events_.begin(cycle()); }
  void erase(ObjectId) override { events_.begin(cycle()); }
  void instant_settled() override { look(); }
  void watched_changed(const Event* event) override;
  Attribute attribute() const override { return {Attribute::Shape::kCycle, events_.cycle()}; }
  std::vector<BoundCheck> bounds(const BoundContext& context) const override;
  void check_invariants(AuditReport& report) const override;
  void audit(const Snapshot& snapshot, AuditReport& report) const override;
  std::size_t bytes() const override { return sizeof *this + events_.bytes(); }

 private:
  std::vector<ObjectId> cycle() const;
  bool touches(const Event& event) const;
  void look();

  Kernel* kernel_;
  StructureId id_;
  const Delaunay2* triangulation_;
  ObjectId site_;
  HullEvents events_;
};

}  // namespace kinex

#endif
