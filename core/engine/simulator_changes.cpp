// SPDX-License-Identifier: GPL-3.0-or-later
// Flight plans: changes of motion, insertions and erasures at rational instants.
#include <algorithm>
#include <stdexcept>
#include <utility>

#include "core/engine/refused_change.h"
#include "core/engine/simulator.h"
#include "core/numbers/check.h"
#include "core/numbers/time_text.h"

namespace kinex {

// Of the axes that some structure reads.
int Simulator::degree_read(const Trajectory& trajectory) const {
  const bool weights = kernel_.arithmetic().needs().weights;
  return trajectory.degree_of_axes(0, weights ? scene_.axes() : scene_.axes_without_weights());
}

void Simulator::check_trajectory(const Trajectory& trajectory) const {
  if (trajectory.dimension() != scene_.axes()) {
    throw std::invalid_argument("a motion in " + std::to_string(trajectory.dimension()) +
                                " coordinates in a scene of " + std::to_string(scene_.axes()));
  }
  const int degree = degree_read(trajectory);
  for (const Entry& entry : entries_) {
    if (degree <= entry.structure->largest_motion_degree()) continue;
    throw std::invalid_argument(std::string(entry.structure->name()) +
                                " cannot maintain a motion of degree " + std::to_string(degree));
  }
}

void Simulator::check_given(const Trajectory& trajectory) const {
  check_trajectory(trajectory);
  for (const Entry& entry : entries_) {
    if (entry.structure->takes_other_plans()) continue;
    throw std::invalid_argument(
        std::string(entry.structure->name()) +
        " is laid out for the flight plans of the scene: put the motion there");
  }
}

void Simulator::put_in_force(ObjectId object, const Trajectory& trajectory,
                             const std::optional<Rational>& until) {
  kernel_.set_motion(object, trajectory, until);
  ++pieces_[object];
}

// Pieces that start or end within the scene's time become changes; those in force right after its
// start are put in force. A piece that ends with the scene or later has no end.
void Simulator::plan_changes() {
  for (ObjectId object = 0; object < scene_.objects.size(); ++object) {
    bool present = false;
    std::optional<Rational> ended;  // where the last piece ended
    for (const MotionPiece& piece : scene_.objects[object].motion.pieces) {
      const Rational from = piece.from && scene_.start < *piece.from ? *piece.from : scene_.start;
      if (piece.to && *piece.to <= from) continue;
      if (scene_.end && *scene_.end < from) break;
      const bool ends = piece.to && (!scene_.end || *piece.to < *scene_.end);
      const std::optional<Rational> until = ends ? piece.to : std::nullopt;
      if (present && ended && *ended < from) {
        changes_.push_back({*ended, Change::Kind::kErase, object, nullptr, {}, true, nullptr});
        present = false;
      }
      if (!present && from == scene_.start) {
        put_in_force(object, piece.trajectory, until);
        alive_[object] = true;
      } else {
        const auto kind = present ? Change::Kind::kUpdate : Change::Kind::kInsert;
        changes_.push_back({from, kind, object, &piece.trajectory, until, true, nullptr});
      }
      present = true;
      ended = until;
    }
    if (present && ended) {
      changes_.push_back({*ended, Change::Kind::kErase, object, nullptr, {}, true, nullptr});
    }
  }
  std::stable_sort(changes_.begin(), changes_.end(), [](const Change& a, const Change& b) {
    if (const auto order = a.t <=> b.t; order != 0) return order < 0;
    if (a.kind != b.kind) return a.kind < b.kind;
    return a.object < b.object;
  });
}

// ---- from outside

void Simulator::queue_change(Change change) {
  if (change.object >= alive_.size()) {
    throw std::invalid_argument("there is no object with number " + std::to_string(change.object));
  }
  if (change.t < reached_ || (scene_.end && *scene_.end < change.t)) {
    throw std::invalid_argument("no change can be made at " + time_text(change.t));
  }
  if (change.trajectory != nullptr) degree_ = std::max(degree_, degree_read(*change.trajectory));
  // It replaces the scene's own plan for the object.
  const auto open = changes_.begin() + static_cast<std::ptrdiff_t>(next_change_);
  changes_.erase(std::remove_if(open, changes_.end(),
                                [&](const Change& c) {
                                  return c.planned && c.object == change.object && c.t >= change.t;
                                }),
                 changes_.end());
  const auto place = std::upper_bound(changes_.begin() + static_cast<std::ptrdiff_t>(next_change_),
                                      changes_.end(), change, [](const Change& a, const Change& b) {
                                        if (const auto order = a.t <=> b.t; order != 0)
                                          return order < 0;
                                        if (a.kind != b.kind) return a.kind < b.kind;
                                        return a.object < b.object;
                                      });
  changes_.insert(place, std::move(change));
}

void Simulator::schedule_update(const Rational& t, ObjectId object, Trajectory trajectory) {
  check_given(trajectory);
  auto given = std::make_shared<const Trajectory>(std::move(trajectory));
  queue_change({t, Change::Kind::kUpdate, object, given.get(), {}, false, given});
}

void Simulator::schedule_insertion(const Rational& t, ObjectId object, Trajectory trajectory) {
  check_given(trajectory);
  auto given = std::make_shared<const Trajectory>(std::move(trajectory));
  queue_change({t, Change::Kind::kInsert, object, given.get(), {}, false, given});
}

void Simulator::schedule_erasure(const Rational& t, ObjectId object) {
  queue_change({t, Change::Kind::kErase, object, nullptr, {}, false, nullptr});
}

// ---- one instant

void Simulator::make_changes() {
  try {
    change_instant();
  } catch (const std::invalid_argument& error) {
    throw RefusedChange(reached_, error.what());
  }
}

void Simulator::change_instant() {
  const Rational t = *next_change();
  next_lo_ = t.lower_double();
  remember_between();
  at_failure_instant_ = false;
  begin_instant();
  kernel_.arithmetic().set_now(t);
  reached_ = Rational(t);
  now_hi_ = t.upper_double();

  std::vector<Change> updates, insertions;
  std::vector<ObjectId> erasures;
  for (; next_change_ < changes_.size() && changes_[next_change_].t == t; ++next_change_) {
    const Change& change = changes_[next_change_];
    const std::string& name = scene_.objects[change.object].id;
    const bool erased = std::binary_search(erasures.begin(), erasures.end(), change.object);
    switch (change.kind) {
      case Change::Kind::kUpdate:
        if (!alive_[change.object]) {
          throw std::invalid_argument("object " + name + " is not there to change its motion");
        }
        if (!updates.empty() && updates.back().object == change.object) updates.pop_back();
        updates.push_back(change);
        break;
      case Change::Kind::kErase:
        if (!alive_[change.object] || erased) {
          throw std::invalid_argument("object " + name + " is not there to be erased");
        }
        erasures.push_back(change.object);
        break;
      case Change::Kind::kInsert:
        if ((alive_[change.object] && !erased) ||
            (!insertions.empty() && insertions.back().object == change.object)) {
          throw std::invalid_argument("object " + name + " is there already");
        }
        insertions.push_back(change);
        break;
    }
  }
  const std::vector<ObjectId> gone = erasures;
  const auto leaves = [&](const Change& update) {
    if (std::binary_search(gone.begin(), gone.end(), update.object)) return true;
    const Trajectory& before = kernel_.derived().trajectory(update.object);
    if (update.trajectory->meets(before, t, scene_.has_bodies())) return false;
    erasures.push_back(update.object);  // it jumps
    insertions.push_back(update);
    return true;
  };
  updates.erase(std::remove_if(updates.begin(), updates.end(), leaves), updates.end());
  std::sort(erasures.begin(), erasures.end());
  std::sort(insertions.begin(), insertions.end(),
            [](const Change& a, const Change& b) { return a.object < b.object; });

  if (!updates.empty()) apply_updates(updates);
  if (fails_now()) mark_shared();
  repair();
  settle();
  // A failure at this instant may have named it by a polynomial in motions that end here.
  if (!erasures.empty() || !insertions.empty()) kernel_.arithmetic().set_now(t);
  apply_erasures(erasures);
  settle();
  apply_insertions(insertions);
  settle();
  end_instant();
  // Past changes are dropped.
  if (next_change_ >= 1024 && 2 * next_change_ >= changes_.size()) {
    changes_.erase(changes_.begin(), changes_.begin() + static_cast<std::ptrdiff_t>(next_change_));
    next_change_ = 0;
  }
}

void Simulator::apply_updates(const std::vector<Change>& updates) {
  std::vector<ObjectId> objects;
  std::vector<CertificateId> affected;
  for (const Change& update : updates) {
    objects.push_back(update.object);
    const auto certificates = kernel_.certificates_of(update.object);
    affected.insert(affected.end(), certificates.begin(), certificates.end());
    for (const ObjectId derived : kernel_.derived().all_dependents(update.object)) {
      const auto more = kernel_.certificates_of(derived);
      affected.insert(affected.end(), more.begin(), more.end());
    }
  }
  std::sort(affected.begin(), affected.end());
  affected.erase(std::unique(affected.begin(), affected.end()), affected.end());
  // All leave the queue first: no comparison may involve a time under a former motion.
  for (const CertificateId id : affected) kernel_.unschedule(id);
  for (const Change& update : updates) {
    put_in_force(update.object, *update.trajectory, update.until);
  }
  for (const CertificateId id : affected) kernel_.reschedule(id);
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    const StructureId id = static_cast<StructureId>(i);
    if (kernel_.ledger(id).corrupt) continue;
    const std::vector<ObjectId> own = entries_[i].those_of(objects);
    if (own.empty()) continue;
    kernel_.set_instant_shared(id, true);
    kernel_.ledger(id).motion_updates += own.size();
    for (const ObjectId object : own) report_change(id, CommonEvent::kMotion, object);
    call(id, [&](Structure& s) { s.motions_changed(own); });
  }
  tell_watchers();
}

void Simulator::apply_erasures(const std::vector<ObjectId>& objects) {
  dynamic_ = dynamic_ || !objects.empty();
  for (const ObjectId object : objects) {
    alive_[object] = false;
    for (std::size_t i = 0; i < entries_.size(); ++i) {
      const StructureId id = static_cast<StructureId>(i);
      if (kernel_.ledger(id).corrupt || !entries_[i].has(object)) continue;
      ++kernel_.ledger(id).erasures;
      report_change(id, CommonEvent::kErase, object);
      call(id, [object](Structure& s) { s.erase(object); });
      if (kernel_.live_certificates(id, object) != 0) {  // corrupt() throws in exact arithmetics
        kernel_.corrupt(id, "it kept a certificate of an erased object");
        abandon(id);
      }
      if (!entries_[i].watchers.empty()) notices_.push_back({id, false, {}});
    }
    tell_watchers();
    repair();
  }
}

void Simulator::apply_insertions(const std::vector<Change>& insertions) {
  dynamic_ = dynamic_ || !insertions.empty();
  for (const Change& change : insertions) {
    put_in_force(change.object, *change.trajectory, change.until);
    alive_[change.object] = true;
    for (std::size_t i = 0; i < entries_.size(); ++i) {
      const StructureId id = static_cast<StructureId>(i);
      if (kernel_.ledger(id).corrupt || !entries_[i].has(change.object)) continue;
      ++kernel_.ledger(id).insertions;
      report_change(id, CommonEvent::kInsert, change.object);
      call(id, [&](Structure& s) { s.insert(change.object); });
      if (!entries_[i].watchers.empty()) notices_.push_back({id, false, {}});
    }
    tell_watchers();
    repair();
  }
}

}  // namespace kinex
