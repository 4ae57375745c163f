// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/proximity/cone_neighbours.h"

#include <algorithm>
#include <span>
#include <string>
#include <utility>

#include "structures/proximity/static_cones_audit.h"

namespace kinex {
namespace {

constexpr std::size_t kFewChanges = 16;

ConeNeighbours::Pair ascending(ObjectId a, ObjectId b) {
  return {std::min(a, b), std::max(a, b)};
}

Attribute as_attribute(const std::vector<ConeNeighbours::Pair>& pairs) {
  Attribute result{Attribute::Shape::kTuples, {}};
  for (const auto& [a, b] : pairs) {
    result.ids.push_back(a);
    result.ids.push_back(b);
  }
  return result;
}

}  // namespace

ConeNeighbours::ConeNeighbours(Kernel& kernel, StructureId id, const ConeFrame& frame,
                               std::size_t objects, const ConeWoods::Before& before)
    : kernel_(&kernel),
      id_(id),
      woods_(frame, objects, before,
             [this](std::size_t cone, ObjectId p, ObjectId old) { note(cone, p, old); }) {}

// ---- the attribute

template <class Next>
std::vector<ConeNeighbours::Pair> ConeNeighbours::pairs_by(const Next& next) const {
  std::vector<Pair> result;
  for (std::size_t cone = 0; cone < frame().cones(); ++cone) {
    if (!frame().counts(cone)) continue;
    for (ObjectId p = 0; p < woods_.objects(); ++p) {
      const ObjectId q = next(cone, p);
      if (q != kNoObject) result.push_back(ascending(p, q));
    }
  }
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

std::vector<ConeNeighbours::Pair> ConeNeighbours::pairs() const {
  return pairs_by([this](std::size_t cone, ObjectId p) { return next(cone, p); });
}

Attribute ConeNeighbours::attribute() const { return as_attribute(pairs()); }

Attribute ConeNeighbours::told() const {
  std::vector<Change> changes = changes_;
  sort_out(changes);
  return as_attribute(
      pairs_by([&](std::size_t cone, ObjectId p) { return next_before(changes, cone, p); }));
}

bool ConeNeighbours::has(const Pair& pair) const {
  for (std::size_t cone = 0; cone < frame().cones(); ++cone) {
    if (!frame().counts(cone)) continue;
    if (next(cone, pair[0]) == pair[1] || next(cone, pair[1]) == pair[0]) return true;
  }
  return false;
}

// Where they are many: few are looked through.
void ConeNeighbours::note_old_pairs() {
  old_pairs_.clear();
  if (changes_.size() <= kFewChanges) return;
  for (const Change& c : changes_) {
    if (frame().counts(c.cone) && c.old != kNoObject) {
      old_pairs_.push_back(ascending(c.point, c.old));
    }
  }
  std::sort(old_pairs_.begin(), old_pairs_.end());
}

// As has(), before these changes, whose old pairs are noted: a pointer that is among them was the old one, any
// other one is as it is now.
bool ConeNeighbours::had(std::span<const Change> changes, const Pair& pair) const {
  if (changes.size() > kFewChanges) {
    if (std::binary_search(old_pairs_.begin(), old_pairs_.end(), pair)) return true;
  } else {
    for (const Change& c : changes) {
      if (!frame().counts(c.cone) || c.old == kNoObject) continue;
      if (ascending(c.point, c.old) == pair) return true;
    }
  }
  for (std::size_t cone = 0; cone < frame().cones(); ++cone) {
    if (!frame().counts(cone)) continue;
    for (std::size_t i = 0; i < 2; ++i) {
      const ObjectId from = pair[i], to = pair[1 - i];
      if (next(cone, from) == to && next_before(changes, cone, from) == to) return true;
    }
  }
  return false;
}

// ---- changes

void ConeNeighbours::note(std::size_t cone, ObjectId p, ObjectId old) {
  changes_.push_back({p, static_cast<std::uint32_t>(cone), old});
  pointer_changed(cone, p);
  const ObjectId fresh = next(cone, p);
  woods_.prefetch(old);
  woods_.prefetch(fresh);
  for (ConeWatcher* const watcher : watchers_) watcher->pointer_changed(p, old, fresh);
}

void ConeNeighbours::sort_out(std::vector<Change>& changes) {
  const auto key = [](const Change& c) { return std::pair(c.point, c.cone); };
  const auto before = [&](const Change& a, const Change& b) { return key(a) < key(b); };
  if (changes.size() <= kFewChanges) {  // of a failure: std::stable_sort would ask for memory
    for (std::size_t i = 1; i < changes.size(); ++i) {
      const Change one = changes[i];
      std::size_t at = i;
      for (; at > 0 && before(one, changes[at - 1]); --at) changes[at] = changes[at - 1];
      changes[at] = one;
    }
  } else {
    std::stable_sort(changes.begin(), changes.end(), before);
  }
  const auto end = std::unique(changes.begin(), changes.end(),
                               [&](const Change& a, const Change& b) { return key(a) == key(b); });
  changes.erase(end, changes.end());
}

ObjectId ConeNeighbours::next_before(std::span<const Change> changes, std::size_t cone,
                                     ObjectId p) const {
  const std::pair wanted(p, static_cast<std::uint32_t>(cone));
  const auto found = std::lower_bound(
      changes.begin(), changes.end(), wanted,
      [](const Change& c, const auto& key) { return std::pair(c.point, c.cone) < key; });
  const bool is_there = found != changes.end() && std::pair(found->point, found->cone) == wanted;
  return is_there ? found->old : next(cone, p);
}

void ConeNeighbours::repaired() {
  if (changes_.empty()) return;
  if (kernel_->instant_is_over(id_)) {
    tell();
  } else {
    kernel_->settle_later(id_);
  }
}

// Sets the mark of the first event that names a pair.
void ConeNeighbours::mark_first(std::vector<Named>& named, bool Telling::*mark) {
  std::sort(named.begin(), named.end());
  for (std::size_t i = 0; i < named.size(); ++i) {
    if (i == 0 || named[i].pair != named[i - 1].pair) telling_[named[i].place].*mark = true;
  }
}

// Into telling_. A pair that left or joined belongs to the first event that names it as the old or the new
// one.
void ConeNeighbours::find_changes() {
  sort_out(changes_);
  note_old_pairs();
  telling_.clear();
  gone_.clear();
  came_.clear();
  for (const auto& [p, cone, old] : changes_) {
    const ObjectId fresh = next(cone, p);
    if (old == fresh) continue;
    if (frame().counts(cone)) {
      const Pair before = ascending(p, old), after = ascending(p, fresh);
      if (old != kNoObject && !has(before)) gone_.push_back({before, telling_.size()});
      if (fresh != kNoObject && !had(changes_, after)) came_.push_back({after, telling_.size()});
    }
    telling_.push_back({p, old == kNoObject ? p : old, fresh == kNoObject ? p : fresh});
  }
  changes_.clear();
  mark_first(gone_, &Telling::goes);
  mark_first(came_, &Telling::comes);
}

void ConeNeighbours::notify(const Telling& one) const {
  for (ConeWatcher* const watcher : watchers_) {
    if (one.goes) watcher->pair_changed(ascending(one.point, one.old), false);
    if (one.comes) watcher->pair_changed(ascending(one.point, one.fresh), true);
  }
}

void ConeNeighbours::follow_point() {
  find_changes();
  for (const Telling& one : telling_) notify(one);
}

void ConeNeighbours::tell() {
  find_changes();
  for (const Telling& one : telling_) {
    const Pair before = ascending(one.point, one.old), after = ascending(one.point, one.fresh);
    notify(one);
    kernel_->report(id_, kPoint, {one.point, one.old, one.fresh}, one.goes || one.comes,
                    std::span(before).first(one.goes ? 2 : 0),
                    std::span(after).first(one.comes ? 2 : 0));
  }
}

// ---- checks

namespace {

// Of one pointer, of n points that move linearly.
Integer most_changes_of_one(std::size_t n) {
  return davenport_schinzel_bound(3, counted(n)) - Integer(1);
}

}  // namespace

bool ConeNeighbours::has_segments(const BoundContext& context) {
  return context.plain() && context.degree <= 1 && context.objects() > 0;
}

Integer ConeNeighbours::most_pointer_changes(const BoundContext& context) const {
  const std::size_t n = context.objects();
  return counted(frame().cones() * n) * most_changes_of_one(n);
}

void ConeNeighbours::add_bounds(const BoundContext& context,
                                std::vector<BoundCheck>& result) const {
  if (!has_segments(context)) return;
  const StructureLedger& ledger = *context.ledger;
  const std::size_t n = context.objects();
  const auto points = ledger.by_kind.find("point");
  result.push_back(at_most(std::string(name()) + ".point",
                           "pieces of the lower envelope of n - 1 segments, for each pointer",
                           most_pointer_changes(context),
                           counted(points == ledger.by_kind.end() ? 0 : points->second)));
  result.push_back(
      at_most(std::string(name()) + ".external", "the same for the pointers into cones that count",
              counted(frame().counted() * n) * most_changes_of_one(n), counted(ledger.external)));
}

void ConeNeighbours::check_woods(AuditReport& report) const {
  woods_.check(report);
  report.check(changes_.empty(), [] { return "a change was not reported"; });
}

void ConeNeighbours::audit(const Snapshot& snapshot, AuditReport& report) const {
  const auto right = static_cones(snapshot, frame().corners);
  for (ObjectId p = 0; p < snapshot.objects(); ++p) {
    for (std::size_t cone = 0; cone < frame().cones(); ++cone) {
      report.check(right[p][cone] == next(cone, p), [&] {
        return "another point is next in cone " + std::to_string(cone) + " of point " +
               std::to_string(p);
      });
    }
  }
}

}  // namespace kinex
