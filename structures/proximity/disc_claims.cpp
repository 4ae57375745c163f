// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/proximity/disc_claims.h"

#include <string>

#include "predicates/points/extent_predicates.h"

namespace kinex {

DiscClaims::DiscClaims(Kernel& kernel, StructureId id, const Scene& scene)
    : kernel_(&kernel),
      overlap_(kernel.bind(make_disc_overlap(scene.dimension))),
      apart_(kernel.bind(make_disc_apart(scene.dimension))),
      slots_(kernel, id, "pairs") {}

bool DiscClaims::add(const Pair& pair) {
  std::uint32_t place;
  if (free_.empty()) {
    place = static_cast<std::uint32_t>(claims_.size());
    claims_.emplace_back();
  } else {
    place = free_.back();
    free_.pop_back();
  }
  places_.emplace(pair, place);
  Claim& claim = claims_[place];
  claim.pair = pair;
  claim.meets = kernel_->sign_after({overlap_, {pair[0], pair[1]}}) != Sign::kNegative;
  slots_.set(claim.certificate, query(claim), place);
  return claim.meets;
}

bool DiscClaims::remove(const Pair& pair) {
  const auto there = places_.find(pair);
  if (there == places_.end()) return false;
  Claim& claim = claims_[there->second];
  const bool met = claim.meets;
  slots_.drop(claim.certificate);
  claim = Claim{};
  free_.push_back(there->second);
  places_.erase(there);
  return met;
}

void DiscClaims::clear() {
  for (const auto& [pair, place] : places_) slots_.drop(claims_[place].certificate);
  places_.clear();
  claims_.clear();
  free_.clear();
  ties_.clear();
}

void DiscClaims::turn(std::uint32_t place) {
  Claim& claim = claims_[place];
  claim.meets = !claim.meets;
  slots_.set(claim.certificate, query(claim), place);
}

DiscClaims::Change DiscClaims::failed(CertificateId c) {
  const std::uint32_t place = slots_.failed(c);
  turn(place);
  return {claims_[place].pair, claims_[place].meets};
}

std::vector<ObjectId> DiscClaims::meeting() const {
  std::vector<ObjectId> ids;
  for (const auto& [pair, place] : places_) {
    if (claims_[place].meets) ids.insert(ids.end(), pair.begin(), pair.end());
  }
  return ids;
}

std::vector<DiscClaims::Pair> DiscClaims::pairs() const {
  std::vector<Pair> result;
  for (const auto& [pair, place] : places_) result.push_back(pair);
  return result;
}

void DiscClaims::visit_proof(ProofVisitor& visitor) const {
  ProofGroup group;
  group.kind = "pair of discs";
  for (const auto& [pair, place] : places_) {
    group.about.assign(pair.begin(), pair.end());
    group.text = claims_[place].meets ? "they meet" : "they are apart";
    visitor.group(group);
    visitor.certificate(claims_[place].certificate, claims_[place].meets ? "meeting" : "apart");
  }
}

void DiscClaims::check(AuditReport& report) const {
  for (const auto& [pair, place] : places_) {
    const Claim& claim = claims_[place];
    const auto name = [&pair = pair] {
      return " of discs " + std::to_string(pair[0]) + " and " + std::to_string(pair[1]);
    };
    report.check(claim.pair == pair && slots_.holds(claim.certificate, query(claim), place),
                 [&] { return "a wrong certificate" + name(); });
    report.check(claim.meets || !slots_.is_tie(claim.certificate),
                 [&] { return "an identical touch that is no meeting" + name(); });
  }
  report.check(places_.size() + free_.size() == claims_.size(),
               [] { return "a pair of discs is lost"; });
  report.check(ties_.empty(), [] { return "ties of discs were not settled"; });
}

std::size_t DiscClaims::bytes() const {
  return claims_.capacity() * sizeof(Claim) + free_.capacity() * sizeof(std::uint32_t) +
         places_.size() * (sizeof(Pair) + 48) + ties_.bytes();
}

}  // namespace kinex
