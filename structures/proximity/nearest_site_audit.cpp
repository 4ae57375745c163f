// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/engine/audit.h"
#include "structures/proximity/nearest_site.h"

namespace kinex {

void NearestSite::audit(const Snapshot& snapshot, AuditReport& report) const {
  ObjectId nearest = kNoObject;
  Rational best;
  for (ObjectId site = 0; site < snapshot.objects(); ++site) {
    if (site == query_ || !snapshot.alive(site) || !snapshot.alive(query_)) continue;
    Rational squared;
    for (int axis = 0; axis < triangulation_.dimension(); ++axis) {
      const Rational gap = snapshot.position(site, axis) - snapshot.position(query_, axis);
      squared += gap * gap;
    }
    if (nearest != kNoObject && best <= squared) continue;
    nearest = site;
    best = squared;
  }
  report.check(nearest == site_, [] { return "another site is nearest"; });
}

}  // namespace kinex
