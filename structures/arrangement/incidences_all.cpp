// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/arrangement/incidences_all.h"

#include <algorithm>
#include <array>

#include "structures/arrangement/line_bounds.h"

namespace kinex {

IncidencesAll::IncidencesAll(Kernel& kernel, StructureId id, const Scene& scene)
    : is_line_(lines_of(scene)), sides_(kernel, id), events_(kernel, id) {}

void IncidencesAll::build(std::span<const ObjectId> objects) {
  lines_.clear();
  points_.clear();
  sides_.clear();
  for (const ObjectId object : objects) insert(object);
}

void IncidencesAll::rebuild() {
  std::vector<ObjectId> objects = lines_;
  objects.insert(objects.end(), points_.begin(), points_.end());
  std::sort(objects.begin(), objects.end());
  build(objects);
}

void IncidencesAll::certificate_failed(CertificateId failed) {
  const auto [pair, above] = sides_.failed(failed);
  const auto [line, point] = pair;
  events_.changed(line, point, above);
  events_.repaired(std::min(line, point), std::max(line, point));
}

void IncidencesAll::insert(ObjectId object) {
  for (const ObjectId other : others(object)) sides_.add(pair(object, other));
  std::vector<ObjectId>& same = own(object);
  same.insert(std::lower_bound(same.begin(), same.end(), object), object);
  events_.begin();
}

void IncidencesAll::erase(ObjectId object) {
  for (const ObjectId other : others(object)) sides_.remove(pair(object, other));
  std::vector<ObjectId>& same = own(object);
  same.erase(std::lower_bound(same.begin(), same.end(), object));
  events_.begin();
}

void IncidencesAll::motions_changed(std::span<const ObjectId> objects) {
  sides_.motions_changed(objects, [this](const LineSides::Pair& pair) {
    const auto [line, point] = pair;
    events_.changed(line, point, false);
    events_.tied(std::min(line, point), std::max(line, point));
  });
}

Attribute IncidencesAll::attribute() const {
  std::vector<std::array<ObjectId, 2>> pairs;
  sides_.each([&pairs](const LineSides::Pair& pair, bool above) {
    if (above) pairs.push_back({std::min(pair[0], pair[1]), std::max(pair[0], pair[1])});
  });
  std::sort(pairs.begin(), pairs.end());
  Attribute result{Attribute::Shape::kTuples, {}};
  for (const auto& pair : pairs) result.ids.insert(result.ids.end(), pair.begin(), pair.end());
  return result;
}

std::vector<BoundCheck> IncidencesAll::bounds(const BoundContext& context) const {
  const LinesAndPoints both(context, is_line_);
  return {at_most("incidences_all.certificates", "one for each line and point",
                  counted(both.lines.size()) * counted(both.points.size()),
                  counted(context.ledger->max_live)),
          at_most("incidences_all.events",
                  "a point changes sides only at a root of its pair, and where pieces meet",
                  side_changes(both, 2 * context.degree), counted(context.ledger->failures)),
          at_most("incidences_all.external",
                  "a point changes sides only at a root of its pair, and where pieces meet",
                  side_changes(both, 2 * context.degree), counted(context.ledger->external))};
}

void IncidencesAll::check_invariants(AuditReport& report) const {
  sides_.check(report);
  report.check(sides_.size() == lines_.size() * points_.size(),
               [] { return "another number of pairs than of lines times points"; });
  report.check(!events_.any(), [] { return "a change of the pairs was not reported"; });
}

std::size_t IncidencesAll::bytes() const {
  return is_line_.capacity() / 8 + (lines_.capacity() + points_.capacity()) * sizeof(ObjectId) +
         sides_.bytes() + events_.bytes();
}

}  // namespace kinex
