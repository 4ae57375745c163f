// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/proximity/closest_pair_discs.h"

#include <algorithm>
#include <string>
#include <utility>

#include "predicates/points/extent_predicates.h"
#include "structures/parts/tournament_proof.h"
#include "structures/proximity/meeting_bounds.h"
#include "structures/proximity/static_closest_discs_audit.h"

namespace kinex {

ClosestPairDiscs::ClosestPairDiscs(Kernel& kernel, StructureId id, const RegularGraph& graph)
    : kernel_(&kernel),
      id_(id),
      graph_(graph),
      seen_(graph_),
      edges_(kernel, id, "edges", DiscGaps(kernel, graph.dimension())),
      overlap_(kernel.bind(make_disc_overlap(graph.dimension()))),
      apart_(kernel.bind(make_disc_apart(graph.dimension()))),
      contact_(kernel, id, "contact"),
      events_(kernel, id, Attribute::Shape::kTuples) {}

// Empty if two discs meet, or if there are fewer than two.
std::span<const ObjectId> ClosestPairDiscs::closest() const {
  const Pair* front = edges_.front();
  if (front == nullptr || winner_meets_ || hidden_) return {};
  return *front;
}

// ---- changes

// A flip hides no disc, and none shows by it.
void ClosestPairDiscs::read_edges() {
  was_of_plane_ = was_of_plane_ && graph_.is_of_plane();
  hidden_ = graph_.hides();
  catch_up();
  edges_.apply(tied());
  changed();
}

void ClosestPairDiscs::catch_up() {
  seen_.look([this] { edges_.assign(graph_.edges()); },
             [this](const DelaunayEdge& edge, bool is_there) {
               if (is_there) {
                 edges_.come(edge);
               } else {
                 edges_.go(edge);
               }
             });
}

// A change of the closest pair is reported when the instant is over, for certificates of this structure
// may fail at the same instant.
void ClosestPairDiscs::changed() {
  watch_winner();
  if (!std::ranges::equal(closest(), events_.told().ids)) kernel_->settle_later(id_);
}

// The certificate of the winner's discs is about the present winner.
void ClosestPairDiscs::watch_winner() {
  const Pair* front = edges_.front();
  if (front == nullptr) {
    contact_.drop(winner_slot_);
    winner_ = {kNoObject, kNoObject};
    winner_meets_ = false;
  } else if (*front != winner_) {
    winner_ = *front;
    winner_meets_ = kernel_->sign_after(overlap_, {winner_[0], winner_[1]}) != Sign::kNegative;
    certify_winner();
  }
}

void ClosestPairDiscs::certify_winner() {
  contact_.set(winner_slot_, {winner_meets_ ? overlap_ : apart_, {winner_[0], winner_[1]}}, 0);
}

void ClosestPairDiscs::begin() {
  read_edges();
  events_.begin(closest());
}

void ClosestPairDiscs::rebuild() {
  was_of_plane_ = was_of_plane_ && graph_.is_of_plane();
  hidden_ = graph_.hides();
  seen_.forget();
  catch_up();
  edges_.rebuild(tied());
  contact_.drop(winner_slot_);
  winner_ = {kNoObject, kNoObject};
  watch_winner();
  events_.begin(closest());
}

// What was touched is looked at after an event that is not one of single edges, and all edges after one that
// contradicts those known.
void ClosestPairDiscs::watched_changed(const Event* event) {
  const auto change = graph_.told(event);
  const bool followed = change && (!change->gone || edges_.go(*change->gone)) &&
                        (!change->came || edges_.come(*change->came));
  if (!followed) {
    if (change) seen_.forget();  // a contradiction, of an inexact arithmetic
    return read_edges();
  }
  seen_.followed(*change);
  edges_.apply(tied());
  changed();
}

void ClosestPairDiscs::certificate_failed(CertificateId failed) {
  if (contact_.owns(failed)) {
    contact_.failed(failed);
    winner_meets_ = !winner_meets_;
    certify_winner();
    const bool over = instant_is_over();
    if (over && closest().empty() != events_.told().ids.empty()) return tell();
    kernel_->report(id_, kTouch, {winner_[0], winner_[1]}, false);
    if (!over) kernel_->settle_later(id_);
    return;
  }
  const auto [old, fresh] = edges_.failed(failed, tied());
  watch_winner();
  // What comes or goes has an event of its own.
  if (closest().empty() != events_.told().ids.empty()) kernel_->settle_later(id_);
  if (old == fresh) {
    events_.repaired(kCase, {old[0], old[1]}, closest(), graph_.id());
  } else {
    events_.repaired(kReplace, {old[0], old[1], fresh[0], fresh[1]}, closest(), graph_.id());
  }
}

void ClosestPairDiscs::motions_changed(std::span<const ObjectId> objects) {
  edges_.motions_changed(objects, tied());
  watch_winner();
  if (contact_.is_tie(winner_slot_) && !winner_meets_) {
    winner_meets_ = true;
    certify_winner();
  }
  changed();
}

void ClosestPairDiscs::tell() {
  const std::vector<ObjectId> before = events_.told().ids;
  const std::span<const ObjectId> now = closest();
  if (before.empty() == now.empty()) return events_.over(now);
  events_.begin(now);
  if (now.empty()) {
    kernel_->report(id_, kContact, {before[0], before[1]}, true, before, {});
  } else {
    kernel_->report(id_, kApart, {now[0], now[1]}, true, {}, now);
  }
}

// ---- for people and audits

void ClosestPairDiscs::visit_proof(ProofVisitor& visitor) const {
  visit_tournament(visitor, edges_, 0, "edges by the gap of their discs", [](const Pair& winner) {
    return std::vector<ObjectId>(winner.begin(), winner.end());
  });
  if (winner_slot_ == kNoCertificate) return;
  ProofGroup group;
  group.kind = "closest discs";
  group.about = {winner_[0], winner_[1]};
  group.text = winner_meets_ ? "they meet" : "they are apart";
  visitor.group(group);
  visitor.certificate(winner_slot_, winner_meets_ ? "meeting" : "apart");
}

std::vector<BoundCheck> ClosestPairDiscs::bounds(const BoundContext& context) const {
  const StructureLedger& ledger = *context.ledger;
  const Integer n = counted(context.objects()), all = kinex::pairs(n);
  const bool all_pairs = !was_of_plane_ || context.objects() < 3;
  const Integer edges = all_pairs ? all : Integer(3) * n - Integer(6);
  const Integer most = Integer(3) * (edges - Integer(1)) + Integer(1);
  std::vector<BoundCheck> result{
      at_most("closest_pair_discs.certificates",
              "three for each match of the edges, at most 3n - 6 in a plane, else all pairs; and one",
              std::max(Integer(0), most), counted(ledger.max_live)),
      at_most("closest_pair_discs.events",
              "the epochs of the nodes of the tournament, and the roots of the four polynomials of each "
              "match; two discs touch",
              edges_.most_failures_of_pairs(DiscGaps::most_failures(context.degree)) +
                  pair_sign_changes(context.pieces, 2 * context.degree),
              counted(ledger.failures))};
  if (context.plain() && all.sign() > 0) {
    const Integer envelope =
        davenport_schinzel_bound(DiscGaps::most_orders(context.degree), all) - Integer(1);
    result.push_back(at_most("closest_pair_discs.external",
                             "pieces of the lower envelope of the gaps of all pairs, and changes of the "
                             "pairs that meet",
                             envelope + meeting_bound("closest_pair_discs", 1, 2, context).bound,
                             counted(ledger.external)));
  }
  return result;
}

void ClosestPairDiscs::check_invariants(AuditReport& report) const {
  edges_.check(report, "edges");
  report.check(edges_.values() == graph_.edges(), [] { return "a change of the edges is missed"; });
  report.check(hidden_ == graph_.hides(), [] { return "a disc that hides or shows is missed"; });
  const Pair* front = edges_.front();
  report.check(front == nullptr ? winner_slot_ == kNoCertificate
                                : *front == winner_ && contact_.holds(winner_slot_,
                                                                      {winner_meets_ ? overlap_ : apart_,
                                                                       {winner_[0], winner_[1]}},
                                                                      0),
               [] { return "a wrong certificate of the winner's discs"; });
  report.check(winner_meets_ || !contact_.is_tie(winner_slot_),
               [] { return "an identical touch that is no meeting"; });
  report.check(std::ranges::equal(closest(), events_.told().ids),
               [] { return "a change of the closest pair was not reported"; });
}

void ClosestPairDiscs::audit(const Snapshot& snapshot, AuditReport& report) const {
  report.check(static_closest_discs(snapshot) == attribute().ids,
               [] { return "another pair of discs has the smallest gap"; });
}

}  // namespace kinex
