// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/arrangement/incidences_cutting.h"

#include <algorithm>
#include <string>
#include <utility>

#include "predicates/points/line_predicates.h"
#include "structures/arrangement/line_bounds.h"
#include "structures/parts/sort_unique.h"

namespace kinex {

IncidencesCutting::IncidencesCutting(Kernel& kernel, StructureId id, const Trapezoids2& trapezoids,
                                     std::span<const ObjectId> sample, const Scene& scene)
    : kernel_(&kernel),
      id_(id),
      trapezoids_(&trapezoids),
      side_(kernel.bind(make_line_side())),
      under_(kernel.bind(make_line_under())),
      order_(kernel.bind(make_line_order())),
      is_line_(lines_of(scene)),
      is_sample_(scene.objects.size()),
      ways_(kernel, id, cells_, scene.objects.size()),
      slots_(kernel, id, "places"),
      places_(scene.objects.size()),
      sides_(kernel, id),
      numbers_(is_line_),
      above_(numbers_.count() * scene.objects.size()),
      events_(kernel, id) {
  for (const ObjectId line : sample) is_sample_[line] = true;
  for (Place& place : places_) place.certificates.fill(kNoCertificate);
}

// ---- the place of a point

bool IncidencesCutting::is_higher(ObjectId l, ObjectId m, ObjectId p) const {
  const Sign sign = kernel_->sign_after({order_, {l, m, p}});
  return sign == Sign::kPositive || (sign == Sign::kZero && m < l);
}

// Behind their crossing the steeper line is the higher one.
bool IncidencesCutting::is_behind(const std::array<ObjectId, 2>& crossing, ObjectId p) const {
  const auto [l, m] = crossing;
  return is_higher(l, m, p) == (trapezoids_->lines().crossings().side(l, m) > 0);
}

Query IncidencesCutting::order_claim(const std::array<ObjectId, 2>& crossing, bool behind,
                                     ObjectId p) const {
  const auto [l, m] = crossing;
  const bool higher = behind == (trapezoids_->lines().crossings().side(l, m) > 0);
  return higher ? Query(order_, {l, m, p}) : Query(order_, {m, l, p});
}

std::vector<Query> IncidencesCutting::claims_of(ObjectId p, std::vector<Claim>& which) const {
  const CuttingCells::Trapezoid& t = cells_.trapezoid(places_[p].cell);
  std::vector<Query> claims;
  const auto add = [&](Claim claim, bool needed, const auto& query) {
    if (!needed) return;
    which.push_back(claim);
    claims.push_back(query());
  };
  add(kFloor, t.floor != kNoObject, [&] { return Query(side_, {t.floor, p}); });
  add(kCeiling, t.ceiling != kNoObject, [&] { return Query(under_, {t.ceiling, p}); });
  add(kLeft, t.left[0] != kNoObject, [&] { return order_claim(t.left, true, p); });
  add(kRight, t.right[0] != kNoObject, [&] { return order_claim(t.right, false, p); });
  return claims;
}

bool IncidencesCutting::locate(ObjectId p) {
  ObjectId floor = kNoObject, ceiling = kNoObject;
  for (const ObjectId l : samples_) {
    const bool is_below = kernel_->sign_after({side_, {l, p}}) == Sign::kPositive;
    ObjectId& best = is_below ? floor : ceiling;
    if (best == kNoObject || is_higher(best, l, p) == is_below) best = l;
  }
  const Cell cell = cells_.find([&](const CuttingCells::Trapezoid& t) {
    return t.floor == floor && t.ceiling == ceiling &&
           (t.left[0] == kNoObject || is_behind(t.left, p)) &&
           (t.right[0] == kNoObject || !is_behind(t.right, p));
  });
  places_[p].cell = cell;
  if (cell == CuttingCells::kNone) return false;
  std::vector<Claim> which;
  const std::vector<Query> claims = claims_of(p, which);
  for (std::size_t claim = 0, i = 0; claim < kClaims; ++claim) {
    CertificateId& slot = places_[p].certificates[claim];
    if (i < which.size() && which[i] == claim) {
      slots_.renew(slot, claims[i++], p);
    } else {
      slots_.drop(slot);
    }
  }
  return true;
}

void IncidencesCutting::leave(ObjectId p) {
  for (CertificateId& slot : places_[p].certificates) slots_.drop(slot);
  for (const ObjectId line : places_[p].watched) sides_.remove({line, p});
  places_[p].watched.clear();
  places_[p].cell = CuttingCells::kNone;
}

// ---- pairs

void IncidencesCutting::compare(ObjectId line, ObjectId p) {
  const bool is_above = kernel_->sign_after({side_, {line, p}}) == Sign::kPositive;
  if (above(line, p) == is_above) return;
  above(line, p) = is_above;
  events_.changed(line, p, is_above);
}

void IncidencesCutting::watch(ObjectId line, ObjectId p) {
  Place& place = places_[p];
  const bool meet = place.cell != CuttingCells::kNone && cells_.is_crossed(place.cell, line);
  const auto there = std::lower_bound(place.watched.begin(), place.watched.end(), line);
  const bool is_watched = there != place.watched.end() && *there == line;
  if (meet == is_watched) return;
  if (meet) {
    place.watched.insert(there, line);
    sides_.add({line, p});
  } else {
    place.watched.erase(there);
    sides_.remove({line, p});
  }
}

// ---- repair

void IncidencesCutting::lose(ObjectId object) { lost_.push_back(object); }

void IncidencesCutting::lose_all() {
  lost_.insert(lost_.end(), lines_.begin(), lines_.end());
  lost_.insert(lost_.end(), points_.begin(), points_.end());
}

bool IncidencesCutting::settle() {
  if (is_settled()) return true;
  if (cells_changed_) {
    std::vector<bool> is_gone;
    const bool renewed = cells_.renew(*trapezoids_, [&](Cell cell) {
      if (is_gone.size() <= cell) is_gone.resize(cell + 1);
      is_gone[cell] = true;
      for (const ObjectId line : Ids(cells_.lines(cell))) {
        ways_.leave_cells(line);
        lose(line);
      }
    });
    if (!renewed) return false;
    for (const ObjectId p : points_) {
      const Cell cell = places_[p].cell;
      if (cell >= is_gone.size() || !is_gone[cell]) continue;
      places_[p].cell = CuttingCells::kNone;
      lose(p);
    }
    cells_changed_ = false;
  }
  sort_unique(lost_);
  const Ids lost = std::exchange(lost_, {});
  const Ids slopes = trapezoids_->lines().slopes();
  for (const ObjectId object : lost) {
    const bool found = is_line_[object]
                           ? ways_.lead(object, slopes, trapezoids_->lines().crossings())
                           : locate(object);
    if (!found) lose(object);
  }
  sort_unique(suspects_);
  for (const ObjectId line : std::exchange(suspects_, {})) {
    for (const ObjectId p : points_) compare(line, p);
  }
  for (const ObjectId object : lost) {
    if (is_line_[object]) {
      for (const ObjectId p : points_) compare(object, p);
      for (const ObjectId p : points_) watch(object, p);
    } else {
      for (const Ids* const lines : {&lines_, &samples_}) {
        for (const ObjectId line : *lines) compare(line, object);
      }
      for (const ObjectId line : lines_) watch(line, object);
    }
  }
  return is_settled();
}

void IncidencesCutting::settle_all() {
  cells_changed_ = true;
  settle();
  events_.begin();
}

// ---- calls

void IncidencesCutting::build(std::span<const ObjectId> objects) {
  for (const ObjectId line : lines_) ways_.forget(line);
  for (const ObjectId p : points_) leave(p);
  lines_.clear();
  points_.clear();
  samples_.clear();
  for (const ObjectId object : objects) own(object).push_back(object);
  lost_.clear();
  suspects_.clear();
  lose_all();
  settle_all();
}

// Within an instant the trapezoids may not be those of the lines yet: the proof is built when the instant
// is settled, and the sides are as they were until then.
void IncidencesCutting::rebuild() {
  for (const ObjectId line : lines_) ways_.forget(line);
  for (const ObjectId p : points_) leave(p);
  lose_all();
  cells_changed_ = true;
  events_.begin();
  kernel_->settle_later(id_);
}

void IncidencesCutting::insert(ObjectId object) {
  Ids& same = own(object);
  same.insert(std::lower_bound(same.begin(), same.end(), object), object);
  if (is_line_[object] && is_sample_[object]) {
    for (const ObjectId p : points_) compare(object, p);
  } else {
    lose(object);
  }
  settle_all();
}

void IncidencesCutting::erase(ObjectId object) {
  Ids& same = own(object);
  same.erase(std::lower_bound(same.begin(), same.end(), object));
  std::erase(lost_, object);
  std::erase(suspects_, object);
  if (!is_line_[object]) {
    leave(object);
  } else if (!is_sample_[object]) {
    ways_.forget(object);
    for (const ObjectId p : points_) watch(object, p);
  }
  settle_all();
}

void IncidencesCutting::certificate_failed(CertificateId failed) {
  if (sides_.owns(failed)) {
    const auto [pair, is_above] = sides_.failed(failed);
    const auto [line, point] = pair;
    if (above(line, point) != is_above) {
      above(line, point) = is_above;
      events_.changed(line, point, is_above);
    }
    return events_.repaired(std::min(line, point), std::max(line, point));
  }
  ObjectId object;
  if (ways_.owns(failed)) {
    object = ways_.failed(failed);
  } else {
    object = slots_.failed(failed);
    for (CertificateId& slot : places_[object].certificates) {
      if (slot == failed) slots_.drop(slot);
    }
  }
  lose(object);
  kernel_->settle_later(id_);
  kernel_->report(id_, kMeetingCell, {object}, false);
}

void IncidencesCutting::motions_changed(std::span<const ObjectId> objects) {
  sides_.motions_changed(objects, [this](const LineSides::Pair& pair) {
    const auto [line, point] = pair;
    above(line, point) = false;
    events_.changed(line, point, false);
    events_.tied(std::min(line, point), std::max(line, point));
  });
  for (const ObjectId object : objects) {
    if (is_line_[object] && is_sample_[object]) {
      lose_all();
    } else {
      lose(object);
    }
  }
  kernel_->settle_later(id_);
}

// Of the two structures that are watched the arrangement names three lines, or two, and the trapezoids four.
void IncidencesCutting::watched_changed(const Event* event) {
  cells_changed_ = true;
  kernel_->settle_later(id_);
  if (event != nullptr && event->count == 3) {
    suspects_.insert(suspects_.end(), event->ids.begin(), event->ids.begin() + 3);
  }
  const bool parallel =
      event != nullptr && event->count == 2 && event->kind == LineArrangement2::kParallel;
  if (event == nullptr || event->count == 0 || (event->count == 2 && !parallel)) {
    lose_all();
    suspects_.insert(suspects_.end(), samples_.begin(), samples_.end());
  }
}

void IncidencesCutting::instant_over() {
  if (is_settled()) {
    tries_ = 0;
  } else if (kernel_->is_exact() || ++tries_ > kMostTries) {
    return kernel_->corrupt(id_, "lines and points that are in no trapezoid");
  }
  events_.over();
}

Attribute IncidencesCutting::attribute() const {
  std::vector<std::array<ObjectId, 2>> pairs;
  for (const Ids* const lines : {&lines_, &samples_}) {
    for (const ObjectId line : *lines) {
      for (const ObjectId p : points_) {
        if (above(line, p)) pairs.push_back({std::min(line, p), std::max(line, p)});
      }
    }
  }
  std::sort(pairs.begin(), pairs.end());
  Attribute result{Attribute::Shape::kTuples, {}};
  for (const auto& pair : pairs) result.ids.insert(result.ids.end(), pair.begin(), pair.end());
  return result;
}

// ---- checks

void IncidencesCutting::visit_proof(ProofVisitor& visitor) const {
  ways_.visit_proof(visitor);
  ProofGroup group;
  group.kind = "place of a point";
  for (const ObjectId p : points_) {
    group.about = {p};
    bool any = false;
    for (const CertificateId slot : places_[p].certificates) any = any || slot != kNoCertificate;
    if (!any) continue;
    visitor.group(group);
    constexpr std::array<std::string_view, kClaims> kRoles{"above", "below", "behind a crossing",
                                                           "before a crossing"};
    for (std::size_t claim = 0; claim < kClaims; ++claim) {
      const CertificateId slot = places_[p].certificates[claim];
      if (slot != kNoCertificate) visitor.certificate(slot, kRoles[claim]);
    }
  }
  sides_.visit_proof(visitor);
}

// A line crosses each of r sample lines and each of r (r - 1) walls once at most.
std::vector<BoundCheck> IncidencesCutting::bounds(const BoundContext& context) const {
  const LinesAndPoints both(context, is_line_);
  std::int64_t sample = 0;
  for (std::size_t i = 0; i < context.pieces.size(); ++i) {
    const std::size_t object = context.members.empty() ? i : context.members[i];
    if (is_sample_[object]) ++sample;
  }
  const Integer r(sample), lines = counted(both.lines.size()) - r,
                           points = counted(both.points.size());
  return {
      at_most("incidences_cutting.certificates",
              "3 for each step of a line through the trapezoids, 4 for each point, one for each "
              "line and point",
              lines * (Integer(3) * r * r + Integer(5)) + Integer(4) * points + lines * points,
              counted(context.ledger->max_live)),
      at_most("incidences_cutting.external",
              "a point changes sides only at a root of its pair, and where pieces meet",
              side_changes(both, 2 * context.degree), counted(context.ledger->external))};
}

void IncidencesCutting::check_invariants(AuditReport& report) const {
  sides_.check(report);
  report.check(is_settled(), [] { return "something was not settled"; });
  report.check(!events_.any(), [] { return "a change of the pairs was not reported"; });
  report.check(cells_.size() == trapezoids_->trapezoids(),
               [] { return "other cells than trapezoids"; });
  for (const ObjectId line : lines_) ways_.check(line, report);
  std::size_t pairs = 0, crossed = 0, cells = 0;
  for (const ObjectId line : lines_) cells += ways_.cells(line).size();
  cells_.each([&](Cell cell) { crossed += cells_.lines(cell).size(); });
  report.check(cells == crossed, [] { return "other lines in the cells than go through them"; });
  for (const ObjectId p : points_) {
    const auto where = [p] { return " of point " + std::to_string(p); };
    const Place& place = places_[p];
    report.check(place.cell != CuttingCells::kNone, [&] { return "a missing place" + where(); });
    if (place.cell == CuttingCells::kNone) continue;
    std::vector<Claim> which;
    const std::vector<Query> claims = claims_of(p, which);
    std::size_t i = 0;
    for (std::size_t claim = 0; claim < kClaims; ++claim) {
      const bool needed = i < which.size() && which[i] == claim;
      const CertificateId slot = place.certificates[claim];
      report.check(needed ? slots_.holds(slot, claims[i], p) : slot == kNoCertificate,
                   [&] { return "a wrong certificate of the place" + where(); });
      if (needed) ++i;
    }
    report.check(place.watched == cells_.lines(place.cell),
                 [&] { return "other lines are watched than cross the trapezoid" + where(); });
    pairs += place.watched.size();
    for (const ObjectId line : place.watched) {
      report.check(sides_.is_positive({line, p}) == above(line, p),
                   [&] { return "a side that is not that of its certificate" + where(); });
    }
  }
  report.check(pairs == sides_.size(), [] { return "another number of pairs than are watched"; });
}

std::size_t IncidencesCutting::bytes() const {
  std::size_t result = (is_line_.capacity() + is_sample_.capacity() + above_.capacity()) / 8 +
                       places_.capacity() * sizeof(Place) + cells_.bytes() + ways_.bytes() +
                       sides_.bytes() + events_.bytes();
  for (const Place& place : places_) result += place.watched.capacity() * sizeof(ObjectId);
  return result + (lines_.capacity() + points_.capacity() + samples_.capacity()) * sizeof(ObjectId);
}

}  // namespace kinex
