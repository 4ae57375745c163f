// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/extent/calipers_2.h"

#include <algorithm>
#include <array>
#include <string>

namespace kinex {

Calipers2::Calipers2(Kernel& kernel, StructureId id, int folds, const HullSource& hull,
                     StructureId hull_id)
    : kernel_(&kernel),
      id_(id),
      hull_id_(hull_id),
      calipers_(kernel, id, folds, hull, hull_id),
      events_(kernel, id, Attribute::Shape::kTuples, static_cast<std::uint8_t>(folds)) {}

// What is touched after each edge of the list: its head, and the contacts of the other folds.
std::vector<ObjectId> Calipers2::touched() const {
  const Calipers& calipers = calipers_.calipers();
  const HullRing& ring = calipers.ring();
  const auto folds = static_cast<std::size_t>(calipers.folds());
  std::vector<ObjectId> ids;
  if (ring.size() == 2) {
    const ObjectId a = ring.any(), b = ring.next(a);
    ids.assign(folds, std::min(a, b));
    std::fill(ids.begin() + static_cast<std::ptrdiff_t>(folds / 2), ids.end(), std::max(a, b));
  }
  if (!calipers.has_list()) return ids;
  std::vector<std::array<ObjectId, 4>> tuples;
  for (const ObjectId edge : ring.cycle()) {
    std::array<ObjectId, 4> tuple;
    tuple.fill(kNoObject);  // greater than all ids
    tuple[0] = ring.next(edge);
    for (std::size_t k = 1; k < folds; ++k) {
      tuple[k] = calipers.contact(edge, static_cast<int>(k));
    }
    std::sort(tuple.begin(), tuple.end());
    tuples.push_back(tuple);
  }
  std::sort(tuples.begin(), tuples.end());
  for (const auto& tuple : tuples)
    ids.insert(ids.end(), tuple.begin(), tuple.begin() + static_cast<std::ptrdiff_t>(folds));
  return ids;
}

Attribute Calipers2::attribute() const {
  return {Attribute::Shape::kTuples, touched(),
          static_cast<std::uint8_t>(calipers_.calipers().folds())};
}

bool Calipers2::is_settling() const {
  return calipers_.is_behind() || kernel_->instant_is_shared(id_) ||
         calipers_.hull().shares_instant();
}

// Readers have followed by the end of every instant; one that has not looks at all edges.
void Calipers2::trim() {
  const Calipers& calipers = calipers_.calipers();
  if (calipers.changes_held() > 256 + 8 * calipers.ring().size()) calipers_.forget_changes();
}

void Calipers2::begin() {
  trim();
  calipers_.build();
  events_.begin(touched());
}

void Calipers2::rebuild() {
  calipers_.rebuild();
  events_.begin(touched());
}

void Calipers2::certificate_failed(CertificateId failed) {
  trim();
  const auto [kind, edges, swapped] = calipers_.failed(failed);
  const auto [a, b, c, d] = edges;
  if (swapped && !calipers_.hull().is_settling()) {
    return events_.repaired(kind, {a, b, c, d}, touched(), hull_id_);
  }
  kernel_->report(id_, kind, {a, b, c, d}, false);
  kernel_->settle_later(id_);
}

void Calipers2::motions_changed(std::span<const ObjectId> objects) {
  calipers_.motions_changed(objects);
}

void Calipers2::watched_changed(const Event* event) {
  trim();
  const auto [kind, ids] = calipers_.watched_changed(event);
  if (kind == HullCalipers::kRenew) {
    kernel_->report(id_, kind, {}, false);
  } else {
    kernel_->report(id_, kind, {ids[0], ids[1], ids[2]}, false);
  }
  if (touched() != events_.told().ids) kernel_->settle_later(id_);
}

void Calipers2::instant_settled() {
  if (calipers_.settled()) kernel_->report(id_, HullCalipers::kRenew, {}, false);
}

std::vector<BoundCheck> Calipers2::bounds(const BoundContext& context) const {
  std::vector<BoundCheck> checks;
  calipers_.add_bounds("calipers_2", context, checks);
  checks.push_back(at_most("calipers_2.locality",
                           "a vertex is in two edges, an edge in two certificates", Integer(4),
                           counted(context.ledger->max_per_object)));
  return checks;
}

void Calipers2::check_invariants(AuditReport& report) const {
  calipers_.check(report);
  report.check(touched() == events_.told().ids, [] { return "a change was not reported"; });
}

}  // namespace kinex
