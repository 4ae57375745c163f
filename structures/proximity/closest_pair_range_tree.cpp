// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/proximity/closest_pair_range_tree.h"

#include <algorithm>

#include "structures/proximity/static_closest_pair_audit.h"

namespace kinex {

ClosestPairRangeTree::ClosestPairRangeTree(Kernel& kernel, StructureId id, const Scene& scene,
                                           ConeOffers::Cones cones)
    : FrontPair(kernel, id, "pairs", "pairs by distance", PairDistances(kernel, 2)),
      cones_(cones),
      kept_(cones == ConeOffers::Cones::kOctants ? KeptPoints::kOne : KeptPoints::kTwo),
      offers_(kernel, id, scene.objects.size(), cones, kept_, nullptr,
              [this](const ConeOffers::Offer& offer, int change) {
                const auto [first, second] = std::minmax(offer.looker, offer.seen);
                counts_.count({first, second}, change, pairs_);
              }) {}

// ---- calls

void ClosestPairRangeTree::build(std::span<const ObjectId> objects) {
  offers_.build(objects);
  begin();
}

void ClosestPairRangeTree::rebuild() {
  offers_.rebuild();
  FrontPair::rebuild();
}

void ClosestPairRangeTree::insert(ObjectId object) {
  offers_.insert(object);
  begin();
}

void ClosestPairRangeTree::erase(ObjectId object) {
  offers_.erase(object);
  begin();
}

void ClosestPairRangeTree::certificate_failed(CertificateId failed) {
  if (const auto exchange = offers_.failed(failed)) {
    pairs_.apply(tied());
    repaired(kOrder, {exchange->before, exchange->after});
    offers_.settle(exchange->list, exchanged());
    pairs_.apply(tied());
    if (!is_told()) kernel_->settle_later(id_);
    return;
  }
  FrontPair::certificate_failed(failed);
}

void ClosestPairRangeTree::motions_changed(std::span<const ObjectId> objects) {
  offers_.motions_changed(objects, exchanged());
  FrontPair::motions_changed(objects);
  pairs_.apply(tied());
}

// ---- checks

void ClosestPairRangeTree::visit_proof(ProofVisitor& visitor) const {
  offers_.visit_proof(visitor);
  FrontPair::visit_proof(visitor);
}

std::vector<BoundCheck> ClosestPairRangeTree::bounds(const BoundContext& context) const {
  const StructureLedger& ledger = *context.ledger;
  const std::size_t n = context.objects();
  const Integer all = kinex::pairs(counted(n));
  const Integer offers = std::min(all, ConeOffers::most_offers(cones_, kept_, context));
  std::vector<BoundCheck> result{
      at_most(
          "closest_pair_range_tree.certificates",
          cones_ == ConeOffers::Cones::kOctants
              ? "four lists, and a tournament of 8 n ceil(log2 n) offers, twice as many if "
                "points came or went, or all pairs"
              : "four lists, and a tournament of 10 n ceil(log2 n) offers, twice as many if points "
                "came or went, or all pairs",
          ConeOffers::most_certificates(n) + (offers.sign() > 0 ? offers - Integer(1) : Integer(0)),
          counted(ledger.max_live)),
      at_most("closest_pair_range_tree.events",
              "each two points change their order in each list at every root, and where pieces "
              "meet; the epochs of the nodes of the tournament",
              Integer(4) * pair_sign_changes(context.pieces, context.degree) +
                  pairs_.most_failures(2 * context.degree),
              counted(ledger.failures))};
  if (!context.plain() || n < 2) return result;
  result.push_back(ConeOffers::bound_on_exchanges(name(), context));
  result.push_back(at_most("closest_pair_range_tree.external",
                           "pieces of the lower envelope of the distances of all pairs",
                           davenport_schinzel_bound(2 * context.degree, all) - Integer(1),
                           counted(ledger.external)));
  return result;
}

void ClosestPairRangeTree::check_invariants(AuditReport& report) const {
  offers_.check(report);
  report.check(pairs_.values() == counts_.values(), [] { return "pairs that no tree offers"; });
  FrontPair::check_invariants(report);
}

void ClosestPairRangeTree::audit(const Snapshot& snapshot, AuditReport& report) const {
  offers_.audit(snapshot, report);
  check_closest_pairs(
      snapshot, attribute().ids, [this](const Pair& pair) { return pairs_.has(pair); }, report);
}

std::size_t ClosestPairRangeTree::bytes() const {
  return offers_.bytes() + counts_.bytes() + FrontPair::bytes();
}

}  // namespace kinex
