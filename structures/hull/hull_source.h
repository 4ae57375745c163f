// SPDX-License-Identifier: GPL-3.0-or-later
// HullSource: the common base class of structures that maintain a convex hull, or a polygon in its
// place, for others to read: the ring, the external events, the audit.
//
// Readers are notified of every change (Structure::watched_changed); while they are, the ring may
// already contain changes of the same instant that have not been reported to them.
#ifndef KINEX_STRUCTURES_HULL_HULL_SOURCE_H
#define KINEX_STRUCTURES_HULL_HULL_SOURCE_H

#include "core/engine/kernel.h"
#include "core/engine/structure.h"
#include "structures/hull/hull_events.h"
#include "structures/hull/hull_ring.h"

namespace kinex {

class HullSource : public Structure {
 public:
  StructureId id() const { return id_; }
  // As last reported: an inexact arithmetic might read another one now.
  const HullRing& ring() const { return events_.ring(); }
  // 0: the ring is the convex hull of all points. k > 0: it is that of the points which are extreme
  // in the 4k directions of unit_directions.h. Then a vertex may come or go far from the edge that it
  // divides, and what readers find has a proven error (structures/extent/README.md).
  virtual int fineness() const { return 0; }
  // What the hull is read from may still change at this instant.
  virtual bool is_settling() const { return false; }
  // The hull may change again at this instant. A reader whose certificate fails then requests
  // that both be settled, the source first (Kernel::settle_later).
  bool shares_instant() const { return kernel_->instant_is_shared(id_) || is_settling(); }

  Attribute told() const override { return {Attribute::Shape::kCycle, events_.cycle()}; }
  Attribute attribute() const override { return told(); }
  // Compares the attribute with CGAL's convex_hull_2 on exact positions. At the time of the snapshot
  // three vertices may be on one line, or two equal, without an event (they touch and turn back):
  // there the cycle may hold more points than the witness, on its edges.
  void audit(const Snapshot& snapshot, AuditReport& report) const override;

 protected:
  HullSource(Kernel& kernel, StructureId id) : kernel_(&kernel), id_(id), events_(kernel, id) {}

  Kernel* kernel_;
  StructureId id_;
  HullEvents events_;
};

}  // namespace kinex

#endif
