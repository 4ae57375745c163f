// SPDX-License-Identifier: GPL-3.0-or-later
// Audits of the structures that maintain a maximum or minimum.
#include <string>

#include "structures/maximum/maximum_dual_hull.h"
#include "structures/maximum/maximum_envelope.h"
#include "structures/maximum/maximum_hanger.h"
#include "structures/maximum/maximum_heap.h"
#include "structures/maximum/maximum_of_list.h"
#include "structures/maximum/maximum_tournament.h"
#include "structures/parts/key_value.h"

namespace kinex {
namespace {

// The best (key, id): of equal keys the smallest id.
void audit_extremum(const Key& key, Extremum extremum, std::size_t objects,
                    const Attribute& attribute, const Snapshot& snapshot, AuditReport& report) {
  const bool maximum = extremum == Extremum::kMaximum;
  const auto keys = sorted_keys(key, snapshot, objects);
  Attribute expected{Attribute::Shape::kObject, {}};
  if (!keys.empty()) {
    std::size_t best = 0;
    if (maximum) {
      best = keys.size() - 1;
      while (best > 0 && keys[best - 1].first == keys[best].first) --best;
    }
    expected.ids.push_back(keys[best].second);
  }
  report.check(expected == attribute, [&] {
    const auto text = [](const Attribute& a) {
      return a.ids.empty() ? std::string("none") : std::to_string(a.ids[0]);
    };
    return "the " + std::string(maximum ? "maximum" : "minimum") + " is object " + text(expected) +
           ", not " + text(attribute);
  });
}

void check_told(const MaximumEvents& events, ObjectId winner, AuditReport& report) {
  report.check(events.winner() == winner,
               [] { return std::string("a change of the maximum was not reported"); });
}

}  // namespace

void MaximumTournament::check_invariants(AuditReport& report) const {
  check_told(events_, winner(), report);
  for (Node v = 1; v < leaves_; ++v) {
    const auto where = [&] { return " at node " + std::to_string(v); };
    const ObjectId a = winner_[2 * v], b = winner_[2 * v + 1];
    report.check(winner_[v] == a || winner_[v] == b,
                 [&] { return "a winner who did not play" + where(); });
    const CertificateId c = certificate_[v];
    report.check(c != kNoCertificate && kernel_->tag(c) == v &&
                     kernel_->query(c) == contest_.claim(winner_[v], loser(v)),
                 [&] { return "a certificate of something else" + where(); });
    report.check(c == kNoCertificate || kernel_->outlook(c) != Outlook::kIdenticallyZero ||
                     winner_[v] < loser(v),
                 [&] { return "a tie with the wrong winner" + where(); });
  }
  for (std::size_t v = leaves_; v < 2 * leaves_; ++v) {
    report.check(leaf_of_[winner_[v]] == v,
                 [&] { return "a lost object at leaf " + std::to_string(v); });
  }
}

void MaximumTournament::audit(const Snapshot& snapshot, AuditReport& report) const {
  audit_extremum(contest_.order().key(), contest_.extremum(), leaf_of_.size(), attribute(),
                 snapshot, report);
}

void MaximumHeap::check_invariants(AuditReport& report) const {
  check_told(events_, top(), report);
  for (Place i = 0; i < heap_.size(); ++i) {
    const auto where = [&] { return " at place " + std::to_string(i); };
    report.check(place_of_[heap_[i]] == i, [&] { return "a lost object" + where(); });
    if (i == 0) {
      report.check(certificate_[0] == kNoCertificate,
                   [] { return std::string("the top has a certificate"); });
      continue;
    }
    const ObjectId parent = heap_[(i - 1) / 2];
    const CertificateId c = certificate_[i];
    report.check(c != kNoCertificate && kernel_->tag(c) == i &&
                     kernel_->query(c) == contest_.claim(parent, heap_[i]),
                 [&] { return "a certificate of something else" + where(); });
    report.check(c == kNoCertificate || kernel_->outlook(c) != Outlook::kIdenticallyZero ||
                     parent < heap_[i],
                 [&] { return "a tie in the wrong order" + where(); });
  }
}

void MaximumHeap::audit(const Snapshot& snapshot, AuditReport& report) const {
  audit_extremum(contest_.order().key(), contest_.extremum(), place_of_.size(), attribute(),
                 snapshot, report);
}

void MaximumHanger::check_invariants(AuditReport& report) const {
  check_told(events_, best(), report);
  std::size_t found = 0;
  for (Place p = 0; p < nodes_.size(); ++p) {
    const Node& node = nodes_[p];
    if (node.object == kNoObject) continue;
    ++found;
    const auto where = [&] { return " at place " + std::to_string(p); };
    report.check(place_of_[node.object] == p, [&] { return "a lost object" + where(); });
    for (const Place child : node.child) {
      report.check(
          child == kNone || (nodes_[child].parent == p && nodes_[child].object != kNoObject),
          [&] { return "a broken link" + where(); });
    }
    const CertificateId c = node.certificate;
    if (node.parent == kNone) {
      report.check(p == root_ && c == kNoCertificate, [&] { return "a second root" + where(); });
      continue;
    }
    const ObjectId parent = nodes_[node.parent].object;
    report.check(c != kNoCertificate && kernel_->tag(c) == p &&
                     kernel_->query(c) == contest_.claim(parent, node.object),
                 [&] { return "a certificate of something else" + where(); });
    report.check(c == kNoCertificate || kernel_->outlook(c) != Outlook::kIdenticallyZero ||
                     parent < node.object,
                 [&] { return "a tie in the wrong order" + where(); });
  }
  report.check(found == size_, [] { return std::string("a wrong number of objects"); });
}

void MaximumHanger::audit(const Snapshot& snapshot, AuditReport& report) const {
  audit_extremum(contest_.order().key(), contest_.extremum(), place_of_.size(), attribute(),
                 snapshot, report);
}

void MaximumEnvelope::check_invariants(AuditReport& report) const {
  report.check(members_.empty() ? winners_.empty() : at_ < winners_.size(),
               [] { return std::string("there is no winner"); });
  for (std::size_t i = at_ + 1; i < winners_.size(); ++i) {
    report.check(winners_[i] != winners_[i - 1],
                 [] { return std::string("an object comes after itself"); });
  }
  report.check(
      (certificate_ != kNoCertificate) == (to_come() > 0) &&
          (certificate_ == kNoCertificate ||
           kernel_->query(certificate_) == contest_.claim(winners_[at_], winners_[at_ + 1])),
      [] { return std::string("a certificate of something else"); });
}

void MaximumEnvelope::audit(const Snapshot& snapshot, AuditReport& report) const {
  audit_extremum(contest_.order().key(), contest_.extremum(), objects_, attribute(), snapshot,
                 report);
}

// Objects that touch the winner without overtaking it have no certificate with it.
bool MaximumEnvelope::holds_at(const Snapshot& snapshot) const {
  AuditReport report;
  audit(snapshot, report);
  if (report.violations.empty()) return true;
  if (end_ && *end_ < snapshot.time()) return false;
  const Key& key = contest_.order().key();
  const auto keys = sorted_keys(key, snapshot, objects_);
  const auto& best = contest_.extremum() == Extremum::kMaximum ? keys.back() : keys.front();
  return key_value(key, snapshot, winner()) != best.first;
}

void MaximumDualHull::check_invariants(AuditReport& report) const {
  const std::string complaint = hull_.complaint();
  report.check(complaint.empty(), [&] { return complaint; });
  report.check(winner_ == kNoObject ? hull_.empty() : hull_.contains(winner_),
               [] { return std::string("a winner who is not there"); });
  report.check(
      (certificate_ != kNoCertificate) == (next_ != kNoObject) &&
          (next_ == kNoObject || kernel_->query(certificate_) == contest_.claim(winner_, next_)),
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
