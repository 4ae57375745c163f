// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/parts/pair_sides.h"

#include <utility>

namespace kinex {

PairSides::PairSides(Kernel& kernel, StructureId id, std::string part, std::string_view kind,
                     const Sides& sides)
    : kernel_(&kernel), kind_(kind), sides_(sides), slots_(kernel, id, std::move(part)) {}

bool PairSides::add(const Pair& pair) {
  std::uint32_t place;
  if (free_.empty()) {
    place = static_cast<std::uint32_t>(members_.size());
    members_.emplace_back();
  } else {
    place = free_.back();
    free_.pop_back();
  }
  places_.emplace(pair, place);
  Member& member = members_[place];
  member.pair = pair;
  const Sign sign = kernel_->sign_after({sides_.positive.predicate, {pair[0], pair[1]}});
  member.positive = sides_.tie ? sign != Sign::kNegative : sign == Sign::kPositive;
  slots_.set(member.certificate, query(member), place);
  return member.positive;
}

bool PairSides::remove(const Pair& pair) {
  const auto there = places_.find(pair);
  if (there == places_.end()) return false;
  Member& member = members_[there->second];
  const bool was_positive = member.positive;
  slots_.drop(member.certificate);
  member = Member{};
  free_.push_back(there->second);
  places_.erase(there);
  return was_positive;
}

void PairSides::clear() {
  for (const auto& [pair, place] : places_) slots_.drop(members_[place].certificate);
  places_.clear();
  members_.clear();
  free_.clear();
  ties_.clear();
}

void PairSides::turn(std::uint32_t place) {
  Member& member = members_[place];
  member.positive = !member.positive;
  slots_.set(member.certificate, query(member), place);
}

PairSides::Change PairSides::failed(CertificateId c) {
  const std::uint32_t place = slots_.failed(c);
  turn(place);
  return {members_[place].pair, members_[place].positive};
}

void PairSides::visit_proof(ProofVisitor& visitor) const {
  ProofGroup group;
  group.kind = kind_;
  for (const auto& [pair, place] : places_) {
    const Member& member = members_[place];
    group.about.assign(pair.begin(), pair.end());
    group.text = side(member).text;
    visitor.group(group);
    visitor.certificate(member.certificate, side(member).role);
  }
}

void PairSides::check(AuditReport& report) const {
  for (const auto& [pair, place] : places_) {
    const Member& member = members_[place];
    const auto name = [this, &pair = pair] {
      return " of the " + std::string(kind_) + " " + std::to_string(pair[0]) + ", " +
             std::to_string(pair[1]);
    };
    report.check(member.pair == pair && slots_.holds(member.certificate, query(member), place),
                 [&] { return "a wrong certificate" + name(); });
    report.check(member.positive == sides_.tie || !slots_.is_tie(member.certificate),
                 [&] { return "a tie on the wrong side" + name(); });
  }
  report.check(places_.size() + free_.size() == members_.size(),
               [&] { return "a lost " + std::string(kind_); });
  report.check(ties_.empty(), [] { return "ties of pairs were not settled"; });
}

std::size_t PairSides::bytes() const {
  return members_.capacity() * sizeof(Member) + free_.capacity() * sizeof(std::uint32_t) +
         places_.size() * (sizeof(Pair) + 48) + ties_.bytes();
}

}  // namespace kinex
