// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/proximity/bichromatic_pair_maximum_norm.h"

#include <algorithm>
#include <utility>

#include "structures/proximity/static_norm_audit.h"

namespace kinex {

BichromaticPairMaximumNorm::BichromaticPairMaximumNorm(Kernel& kernel, StructureId id,
                                                       const Scene& scene, TwoClasses classes)
    : FrontPair(kernel, id, "pairs", "pairs by their lengths in the maximum norm",
                MaximumNormLengths(kernel)),
      classes_(std::move(classes)),
      offers_(kernel, id, scene.objects.size(), ConeOffers::Cones::kOctants,
              KeptPoints::kOneOfEachColour, &classes_,
              [this](const ConeOffers::Offer& one, int change) { offer(one, change); }) {}

// The projections of octants are x and y: the axis is the number of the linear function.
void BichromaticPairMaximumNorm::offer(const ConeOffers::Offer& offer, int change) {
  const ObjectId from = offer.reversed ? offer.seen : offer.looker;
  const ObjectId to = offer.reversed ? offer.looker : offer.seen;
  counts_.count({from, to, static_cast<ObjectId>(offer.projection)}, change, pairs_);
}

// ---- calls

void BichromaticPairMaximumNorm::build(std::span<const ObjectId> objects) {
  offers_.build(objects);
  begin();
}

void BichromaticPairMaximumNorm::rebuild() {
  offers_.rebuild();
  FrontPair::rebuild();
}

void BichromaticPairMaximumNorm::insert(ObjectId object) {
  offers_.insert(object);
  begin();
}

void BichromaticPairMaximumNorm::erase(ObjectId object) {
  offers_.erase(object);
  begin();
}

void BichromaticPairMaximumNorm::certificate_failed(CertificateId failed) {
  if (const auto exchange = offers_.failed(failed)) {
    pairs_.apply(tied());
    repaired(kOrder, {exchange->before, exchange->after});
    offers_.settle(exchange->list, exchanged());
    pairs_.apply(tied());
    if (!is_told()) kernel_->settle_later(id_);
    return;
  }
  const Duel duel = pairs_.failed(failed, tied());
  if (!kernel_->instant_is_over(id_)) {
    renew({duel.after});
    kernel_->settle_later(id_);  // the change of the attribute may be more than this duel
  }
  replaced(duel);
}

// Lengths that were identically equal may be so no more, or have become it, and then another claim
// compares them.
void BichromaticPairMaximumNorm::motions_changed(std::span<const ObjectId> objects) {
  offers_.motions_changed(objects, exchanged());
  std::vector<Value> moved;
  const auto moves = [&](ObjectId id) { return std::ranges::binary_search(objects, id); };
  for (const Value& value : counts_.values()) {
    if (moves(value[0]) || moves(value[1])) moved.push_back(value);
  }
  renew(moved);
}

// They leave the tournament and come back, so that their matches are decided right after now. A winner
// that has taken the place of another one is level with that, but above it may meet a length that is
// identically equal to its own and shorter after the turn, since long: no certificate would fail at
// this instant.
void BichromaticPairMaximumNorm::renew(const std::vector<Value>& values) {
  for (const Value& value : values) pairs_.go(value);
  pairs_.apply(tied());
  for (const Value& value : values) pairs_.come(value);
  pairs_.apply(tied());
}

// ---- checks

void BichromaticPairMaximumNorm::visit_proof(ProofVisitor& visitor) const {
  offers_.visit_proof(visitor);
  FrontPair::visit_proof(visitor);
}

std::vector<BoundCheck> BichromaticPairMaximumNorm::bounds(const BoundContext& context) const {
  const StructureLedger& ledger = *context.ledger;
  const std::string own(name());
  const std::size_t n = context.objects();
  const Integer all = counted(classes_.size(0)) * counted(classes_.size(1));
  // A pair has four forms, and may have several of them while an instant is not over.
  const Integer lengths = std::min(
      Integer(4) * all,
      ConeOffers::most_offers(ConeOffers::Cones::kOctants, KeptPoints::kOneOfEachColour, context));
  std::vector<BoundCheck> result{
      at_most(own + ".certificates",
              "four lists, and a tournament of 12 n ceil(log2 n) offers, twice as many if points "
              "came or went, or four lengths for each pair of the two colours",
              ConeOffers::most_certificates(n) +
                  (lengths.sign() > 0 ? lengths - Integer(1) : Integer(0)),
              counted(ledger.max_live)),
      at_most(own + ".events",
              "each two points change their order in each list at every root, and where pieces "
              "meet; the epochs of the nodes of the tournament",
              Integer(4) * pair_sign_changes(context.pieces, context.degree) +
                  pairs_.most_failures(context.degree),
              counted(ledger.failures))};
  if (!context.plain() || all.sign() == 0) return result;
  result.push_back(ConeOffers::bound_on_exchanges(own, context));
  // A length is |dx| or |dy|: two are equal at roots of eight polynomials at most.
  result.push_back(at_most(
      own + ".external", "pieces of the lower envelope of the lengths of all pairs",
      davenport_schinzel_bound(8 * context.degree, all) - Integer(1), counted(ledger.external)));
  return result;
}

void BichromaticPairMaximumNorm::check_invariants(AuditReport& report) const {
  offers_.check(report);
  report.check(pairs_.values() == counts_.values(), [] { return "lengths that no tree offers"; });
  for (const Value& value : counts_.values()) {
    report.check(classes_.differ(value[0], value[1]), [] { return "two points of one colour"; });
  }
  FrontPair::check_invariants(report);
}

void BichromaticPairMaximumNorm::audit(const Snapshot& snapshot, AuditReport& report) const {
  offers_.audit(snapshot, report);
  const auto pair = static_nearest_maximum_norm(
      snapshot, [this](ObjectId a, ObjectId b) { return classes_.differ(a, b); });
  report.check(pair == attribute().ids, [] { return "another pair is the nearest"; });
}

std::size_t BichromaticPairMaximumNorm::bytes() const {
  return classes_.bytes() + offers_.bytes() + counts_.bytes() + FrontPair::bytes() +
         pairs_.claims().bytes();
}

}  // namespace kinex
