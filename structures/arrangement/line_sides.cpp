// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/arrangement/line_sides.h"

#include <string>

#include "predicates/points/line_predicates.h"

namespace kinex {

LineSides::LineSides(Kernel& kernel, StructureId id)
    : kernel_(&kernel),
      above_(kernel.bind(make_line_side())),
      under_(kernel.bind(make_line_under())),
      slots_(kernel, id, "sides") {}

bool LineSides::add(const Pair& pair) {
  std::uint32_t place;
  if (free_.empty()) {
    place = static_cast<std::uint32_t>(sides_.size());
    sides_.emplace_back();
  } else {
    place = free_.back();
    free_.pop_back();
  }
  places_.emplace(pair, place);
  Side& side = sides_[place];
  side.pair = pair;
  side.above = kernel_->sign_after({above_, {pair.line, pair.point}}) == Sign::kPositive;
  slots_.set(side.certificate, query(side), place);
  return side.above;
}

bool LineSides::remove(const Pair& pair) {
  const auto there = places_.find(pair);
  Side& side = sides_[there->second];
  const bool was_above = side.above;
  slots_.drop(side.certificate);
  side = Side{};
  free_.push_back(there->second);
  places_.erase(there);
  return was_above;
}

void LineSides::clear() {
  for (const auto& [pair, place] : places_) slots_.drop(sides_[place].certificate);
  places_.clear();
  sides_.clear();
  free_.clear();
  ties_.clear();
}

void LineSides::turn(std::uint32_t place) {
  Side& side = sides_[place];
  side.above = !side.above;
  slots_.set(side.certificate, query(side), place);
}

LineSides::Change LineSides::failed(CertificateId c) {
  const std::uint32_t place = slots_.failed(c);
  turn(place);
  return {sides_[place].pair, sides_[place].above};
}

void LineSides::visit_proof(ProofVisitor& visitor) const {
  ProofGroup group;
  group.kind = "line and point";
  for (const auto& [pair, place] : places_) {
    const Side& side = sides_[place];
    group.about = {pair.line, pair.point};
    group.text = side.above ? "the point is above" : "the point is not above";
    visitor.group(group);
    visitor.certificate(side.certificate, side.above ? "above" : "below");
  }
}

void LineSides::check(AuditReport& report) const {
  for (const auto& [pair, place] : places_) {
    const Side& side = sides_[place];
    const auto name = [&pair = pair] {
      return " of line " + std::to_string(pair.line) + " and point " + std::to_string(pair.point);
    };
    report.check(side.pair == pair && slots_.holds(side.certificate, query(side), place),
                 [&] { return "a wrong certificate" + name(); });
    report.check(!side.above || !slots_.is_tie(side.certificate),
                 [&] { return "a point above a line that it is identically on:" + name(); });
  }
  report.check(places_.size() + free_.size() == sides_.size(),
               [] { return "a pair of a line and a point is lost"; });
  report.check(ties_.empty(), [] { return "points on lines were not settled"; });
}

std::size_t LineSides::bytes() const {
  return sides_.capacity() * sizeof(Side) + free_.capacity() * sizeof(std::uint32_t) +
         places_.size() * (sizeof(Pair) + 48) + ties_.bytes();
}

}  // namespace kinex
