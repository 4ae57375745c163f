// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/proximity/disc_pairs.h"
#include "structures/proximity/disc_pairs_grid.h"
#include "structures/proximity/static_meetings_audit.h"

namespace kinex {

void DiscPairsAll::audit(const Snapshot& snapshot, AuditReport& report) const {
  report.check(static_disc_pairs(snapshot) == attribute().ids,
               [] { return "other discs meet"; });
}

void DiscPairsBoxes::audit(const Snapshot& snapshot, AuditReport& report) const {
  report.check(static_disc_pairs(snapshot) == attribute().ids,
               [] { return "other discs meet"; });
}

void DiscPairsGrid::audit(const Snapshot& snapshot, AuditReport& report) const {
  grid_.audit(snapshot, report);
  report.check(static_disc_pairs(snapshot) == attribute().ids,
               [] { return "other discs meet"; });
}

}  // namespace kinex
