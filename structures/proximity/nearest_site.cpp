// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/proximity/nearest_site.h"

#include <algorithm>
#include <array>

#include "predicates/predicates.h"
#include "structures/parts/extremum_bounds.h"

namespace kinex {

NearestSite::NearestSite(Kernel& kernel, StructureId id, DelaunayGraph triangulation,
                         ObjectId query)
    : kernel_(&kernel),
      id_(id),
      triangulation_(triangulation),
      query_(query),
      distance_(kernel.bind(make_squared_distance_order(triangulation.dimension()))),
      slots_(kernel, id, "neighbours"),
      events_(kernel, id, kReplace) {}

bool NearestSite::in_front(ObjectId a, ObjectId b) const {
  const Sign sign = kernel_->sign_after(claim(a, b));
  return sign == Sign::kPositive || (sign == Sign::kZero && a < b);
}

// Goes from a site to neighbours that are nearer. In an exact arithmetic it cannot visit one twice.
void NearestSite::walk(ObjectId from) {
  site_ = triangulation_.representative(from);
  for (std::size_t steps = 0; steps <= triangulation_.objects(); ++steps) {
    const ObjectId here = site_;
    for (const ObjectId other : triangulation_.neighbours(here)) {
      if (in_front(other, site_)) site_ = other;
    }
    if (site_ == here) return;
  }
  kernel_->corrupt(id_, "no end of a walk to ever nearer sites");
}

// Certificates for all neighbours of the site, and no others: keeps those that are there.
void NearestSite::prove() {
  const std::vector<ObjectId> wanted =
      site_ == kNoObject ? std::vector<ObjectId>{} : triangulation_.neighbours(site_);
  for (auto place = rivals_.begin(); place != rivals_.end();) {
    const bool stays = std::binary_search(wanted.begin(), wanted.end(), place->first) &&
                       slots_.holds(place->second, claim(site_, place->first), place->first);
    if (!stays) slots_.drop(place->second);
    place = stays ? std::next(place) : rivals_.erase(place);
  }
  for (const ObjectId other : wanted) {
    const auto [place, fresh] = rivals_.try_emplace(other, kNoCertificate);
    if (fresh) ties_.set(slots_, place->second, claim(site_, other), other);
  }
}

// Of sites that are level the smallest is the nearest.
void NearestSite::settle_ties() {
  ties_.settle([this](ObjectId other) {
    const auto place = rivals_.find(other);
    if (place == rivals_.end() || !slots_.is_tie(place->second) || site_ < other) return;
    const ObjectId before = site_;
    site_ = other;
    prove();
    kernel_->report(id_, kTie, {before, other}, false);
    kernel_->settle_later(id_);
  });
}

// ---- calls

// From the site that was the nearest, if it is still there; else from any.
void NearestSite::begin() {
  const auto is_there = [this](ObjectId object) {
    return object != kNoObject && triangulation_.representative(object) != kNoObject;
  };
  ObjectId from = site_;
  if (!is_there(from)) from = 0;
  while (from < triangulation_.objects() && !is_there(from)) ++from;
  site_ = kNoObject;
  if (asked_ && from < triangulation_.objects()) walk(from);
  prove();
  ties_.clear();  // the walk has put them in order
  events_.begin(site_);
}

void NearestSite::build(std::span<const ObjectId> objects) {
  asked_ = std::binary_search(objects.begin(), objects.end(), query_);
  begin();
}

void NearestSite::rebuild() {
  for (auto& [other, certificate] : rivals_) slots_.drop(certificate);
  rivals_.clear();
  begin();
}

void NearestSite::insert(ObjectId object) {
  if (object == query_) asked_ = true;
  begin();
}

void NearestSite::erase(ObjectId object) {
  if (object == query_) asked_ = false;
  begin();
}

void NearestSite::certificate_failed(CertificateId failed) {
  const ObjectId before = site_;
  site_ = slots_.failed(failed);
  prove();
  const ObjectId after = site_;
  settle_ties();
  events_.repaired(kReplace, {before, after}, site_, triangulation_.id());
}

void NearestSite::motions_changed(std::span<const ObjectId> objects) {
  ties_.note_of(slots_, objects);
  settle_ties();
}

// A change of the nearest site is reported when the instant is over, for certificates of this
// structure may fail at the same instant.
void NearestSite::follow(const std::optional<DelaunayEdgeChange>& change) {
  if (site_ == kNoObject) return;
  if (change) {
    const auto touches = [this](const std::optional<DelaunayEdge>& edge) {
      return edge && ((*edge)[0] == site_ || (*edge)[1] == site_);
    };
    if (!touches(change->gone) && !touches(change->came)) return;
  }
  const ObjectId vertex = triangulation_.representative(site_);
  if (vertex == kNoObject) return begin();  // it has been erased
  site_ = vertex;
  prove();
  settle_ties();
  if (site_ != events_.object() || kernel_->failure_is_due()) kernel_->settle_later(id_);
}

Attribute NearestSite::attribute() const {
  Attribute result{Attribute::Shape::kObject, {}};
  if (site_ != kNoObject) result.ids.push_back(site_);
  return result;
}

// ---- checks

void NearestSite::visit_proof(ProofVisitor& visitor) const {
  ProofGroup group;
  group.kind = "neighbour of the nearest site";
  for (const auto& [other, certificate] : rivals_) {
    group.about = {site_, other};
    visitor.group(group);
    visitor.certificate(certificate, "farther");
  }
}

std::vector<BoundCheck> NearestSite::bounds(const BoundContext& context) const {
  const StructureLedger& ledger = *context.ledger;
  std::vector<int> pieces = context.pieces;
  int common = 1;
  if (const std::size_t place = context.place(query_); place < pieces.size()) {
    common = pieces[place];
    pieces.erase(pieces.begin() + static_cast<std::ptrdiff_t>(place));
  }
  const std::size_t n = pieces.size();
  return {
      at_most("nearest_site.certificates", "one for each neighbour of the nearest site",
              counted(n == 0 ? 0 : n - 1), counted(ledger.max_live)),
      at_most("nearest_site.external", "pieces of the lower envelope of the distances of all sites",
              extremum_changes(context, pieces, common, 2 * context.degree),
              counted(ledger.external))};
}

void NearestSite::check_invariants(AuditReport& report) const {
  std::vector<ObjectId> rivals;
  for (const auto& [other, certificate] : rivals_) {
    rivals.push_back(other);
    report.check(slots_.holds(certificate, claim(site_, other), other),
                 [] { return "a certificate of something else"; });
    report.check(!slots_.is_tie(certificate) || site_ < other,
                 [] { return "a tie in the wrong order"; });
  }
  const bool there = site_ != kNoObject;
  report.check(rivals == (there ? triangulation_.neighbours(site_) : std::vector<ObjectId>{}),
               [] { return "other neighbours than in the triangulation"; });
  report.check(!there || triangulation_.representative(site_) == site_,
               [] { return "the nearest site is no vertex"; });
  report.check(site_ == events_.object(), [] { return "a change was not reported"; });
}

}  // namespace kinex
