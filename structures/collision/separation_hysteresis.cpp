// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/collision/separation_hysteresis.h"

namespace kinex {

bool SeparationHysteresis::put_wedge(PairId p) {
  const std::span<const Query> queries = search_.place(wedges_[p], bodies(p));
  if (!queries.empty()) pairs_.set(p, slots_, queries);
  return !queries.empty();
}

bool SeparationHysteresis::start(PairId p, const Edge* left) {
  if (wedges_.size() <= p) wedges_.resize(p + std::size_t{1});
  return put_wedge(p) || near_.start(p, left);
}

SeparationProof::Repair SeparationHysteresis::repair(PairId p, std::uint32_t slot) {
  if (!has_wedge(p)) {
    if (!near_.is_contact_slot(p, slot) && put_wedge(p)) return Repair::changed(kWedge);
    return near_.repair(p, slot);
  }
  search_.measure(wedges_[p], bodies(p));
  if (start(p, nullptr)) return Repair::changed(kWedge);
  // A wedge proves a positive distance: reached only in an inexact arithmetic.
  pairs_.kernel().corrupt(pairs_.id(), "the bodies meet although a wedge was between them");
  return {};
}

void SeparationHysteresis::add_bounds(const BoundContext&, std::vector<BoundCheck>& checks) const {
  const auto most = search_.most_thousandths();
  if (!most) return;
  checks.push_back(at_most("separation_hysteresis.displacement",
                           "the separation at which a wedge was made over the displacement that it "
                           "withstood: at most 1 / "
                           "0.23 (thousandths)",
                           Integer(WedgeSearch::kMostThousandths), Integer(*most)));
}

std::size_t SeparationHysteresis::bytes() const {
  return near_.bytes() + search_.bytes() + wedges_.capacity() * sizeof(WedgeSearch::Wedge);
}

}  // namespace kinex
