// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/extent/directions_2.h"

#include <algorithm>

namespace kinex {

Directions2::Directions2(Kernel& kernel, StructureId id, const Scene& scene, int k,
                         MaximaChoice choice)
    : HullSource(kernel, id),
      name_(choice == MaximaChoice::kByDegree ? "directions_2" : "directions_2_tournament"),
      k_(k),
      maxima_(make_direction_maxima(kernel, id, scene, unit_directions_2(k), choice)),
      between_(maxima_->size(), 0),
      stale_(maxima_->size(), 1) {}

// ---- the polygon

// All objects that are level with the extreme one of direction i lie on one line across it. Beside
// i the extreme objects of the neighbours, if they are level too, are the ends of these.
bool Directions2::is_between(std::size_t i) const {
  const std::size_t all = maxima_->size();
  const ObjectId before = maxima_->winner((i + all - 1) % all), here = maxima_->winner(i),
                 after = maxima_->winner((i + 1) % all);
  if (here == before || here == after) return false;
  return maxima_->level(i, here, before) && maxima_->level(i, here, after);
}

// The extreme object of direction i has changed, and maybe which ones are between others.
void Directions2::look_around(std::size_t i) {
  const std::size_t all = maxima_->size();
  for (const std::size_t j : {(i + all - 1) % all, i, (i + 1) % all}) stale_[j] = 1;
}

void Directions2::look_everywhere() { std::fill(stale_.begin(), stale_.end(), 1); }

std::vector<ObjectId> Directions2::cycle() {
  for (std::size_t i = 0; i < stale_.size(); ++i) {
    if (stale_[i] != 0) between_[i] = is_between(i) ? 1 : 0;
    stale_[i] = 0;
  }
  return polygon();
}

std::vector<ObjectId> Directions2::polygon() const {
  std::vector<ObjectId> result;
  for (std::size_t i = 0; i < between_.size(); ++i) {
    const ObjectId here = maxima_->winner(i);
    if (here == kNoObject || between_[i] != 0) continue;
    if (result.empty() || result.back() != here) result.push_back(here);
  }
  if (result.size() > 1 && result.back() == result.front()) result.pop_back();
  start_at_smallest(result);
  return result;
}

void Directions2::begin() {
  look_everywhere();
  events_.begin(cycle());
}

void Directions2::settle() { events_.settle(cycle()); }

// ---- events

void Directions2::build(std::span<const ObjectId> objects) {
  maxima_->build(objects, tied());
  begin();
}

void Directions2::rebuild() {
  maxima_->rebuild(tied());
  begin();
}

void Directions2::certificate_failed(CertificateId failed) {
  const auto [direction, before, after] = maxima_->failed(failed, tied());
  kernel_->report(id_, kReplace, {before, after}, false);
  look_around(direction);
  if (kernel_->instant_is_shared(id_) || kernel_->failure_is_due()) {
    kernel_->settle_later(id_);
  } else {
    settle();
  }
}

void Directions2::insert(ObjectId object) {
  maxima_->insert(object, tied());
  begin();
}

void Directions2::erase(ObjectId object) {
  maxima_->erase(object, tied());
  begin();
}

void Directions2::motions_changed(std::span<const ObjectId> objects) {
  maxima_->motions_changed(objects, tied());
  look_everywhere();
}

// ---- bounds, invariants

std::vector<BoundCheck> Directions2::bounds(const BoundContext& context) const {
  const StructureLedger& ledger = *context.ledger;
  const std::string name(name_);
  std::vector<BoundCheck> result{
      at_most(name + ".certificates", "one a direction, or a tournament of n objects a direction",
              maxima_->most_certificates(context), counted(ledger.max_live)),
      at_most(name + ".locality", "one a direction, or one a level of each tournament",
              maxima_->most_per_object(context), counted(ledger.max_per_object)),
      at_most(name + ".events", "pieces of the upper envelopes along the directions",
              maxima_->most_failures(context), counted(ledger.failures))};
  if (context.plain()) {
    const auto ties = ledger.by_kind.find("tie");
    const std::uint64_t tied = ties == ledger.by_kind.end() ? 0 : ties->second;
    result.push_back(at_most(name + ".external",
                             "another extreme object moves at most four points, and one turn",
                             Integer(5) * counted(ledger.failures + tied),
                             counted(ledger.external)));
  }
  return result;
}

void Directions2::check_invariants(AuditReport& report) const {
  maxima_->check(report);
  for (std::size_t i = 0; i < between_.size(); ++i) {
    report.check(stale_[i] == 0 && (between_[i] != 0) == is_between(i), [i] {
      return "a point of an edge is out of date in direction " + std::to_string(i);
    });
  }
  report.check(events_.cycle() == polygon(), [] { return "the polygon was not reported"; });
}

}  // namespace kinex
