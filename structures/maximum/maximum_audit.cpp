// SPDX-License-Identifier: GPL-3.0-or-later
// Audits of the structures for a maximum that look ahead, or read it off.
#include <string>

#include "structures/maximum/maximum_dual_hull.h"
#include "structures/maximum/maximum_envelope.h"
#include "structures/maximum/maximum_of_list.h"
#include "structures/maximum/maximum_structure.h"
#include "structures/parts/key_value.h"

namespace kinex {

void MaximumEnvelope::check_invariants(AuditReport& report) const {
  report.check(members_.empty() ? winners_.empty() : at_ < winners_.size(),
               [] { return std::string("there is no winner"); });
  for (std::size_t i = at_ + 1; i < winners_.size(); ++i) {
    report.check(winners_[i] != winners_[i - 1],
                 [] { return std::string("an object comes after itself"); });
  }
  report.check(to_come() == 0 ? certificate_ == kNoCertificate
                              : slots_.holds(certificate_,
                                             contest_.claim(winners_[at_], winners_[at_ + 1]), 0),
               [] { return std::string("a certificate of something else"); });
}

void MaximumEnvelope::audit(const Snapshot& snapshot, AuditReport& report) const {
  audit_extremum(contest_.order().key(), contest_.extremum(), scene_->objects.size(), attribute(),
                 snapshot, report);
}

// Objects that touch the winner without overtaking it have no certificate with it.
bool MaximumEnvelope::holds_at(const Snapshot& snapshot) const {
  AuditReport report;
  audit(snapshot, report);
  if (report.violations.empty()) return true;
  if (scene_->end && *scene_->end < snapshot.time()) return false;
  const Key& key = contest_.order().key();
  const auto keys = sorted_keys(key, snapshot, scene_->objects.size());
  const auto& best = contest_.extremum() == Extremum::kMaximum ? keys.back() : keys.front();
  return key_value(key, snapshot, winner()) != best.first;
}

void MaximumDualHull::check_invariants(AuditReport& report) const {
  const std::string complaint = hull_.complaint();
  report.check(complaint.empty(), [&] { return complaint; });
  report.check(winner_ == kNoObject ? hull_.empty() : hull_.contains(winner_),
               [] { return std::string("a winner that is not a member"); });
  report.check(next_ == kNoObject ? certificate_ == kNoCertificate
                                  : slots_.holds(certificate_, contest_.claim(winner_, next_), 0),
               [] { return std::string("a certificate of something else"); });
}

void MaximumDualHull::audit(const Snapshot& snapshot, AuditReport& report) const {
  audit_extremum(contest_.order().key(), contest_.extremum(), objects_, attribute(), snapshot,
                 report);
}

void MaximumOfList::check_invariants(AuditReport& report) const {
  report.check(winner() == extreme(),
               [] { return std::string("it has missed a change of its list"); });
}

void MaximumOfList::audit(const Snapshot& snapshot, AuditReport& report) const {
  audit_extremum(list_->order().key(), extremum_, list_->objects(), attribute(), snapshot, report);
}

}  // namespace kinex
