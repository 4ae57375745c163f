// SPDX-License-Identifier: GPL-3.0-or-later
// An instant of a run: failures are handled, structures are called, and their reports go to the
// sink and to watchers, until nothing fails; or all of it is withdrawn.
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "core/engine/repeated_object.h"
#include "core/engine/simulator.h"
#include "core/numbers/check.h"

namespace kinex {
namespace {

// Claims of a predicate of three axes or more, weights included, that alternates in all its arguments,
// on one set of points: one polynomial, up to its sign. A flip of three cells into two fails three such
// certificates at once, on the hull some that fail at touches and some that do not, and so does a point
// of the plane that hides. (In the plane without weights such certificates fail together only where points
// coincide.)
bool claim_as_one(const Arithmetic& arithmetic, const Query& a, const Query& b) {
  if (!arithmetic.have_same_value(a.predicate, b.predicate) || a.arity < 4) return false;
  const Predicate& predicate = arithmetic.predicate(a.predicate);
  return predicate.dimension() >= 3 && predicate.alternating() == predicate.arity() &&
         sorted_ids(a) == sorted_ids(b);
}

// See simulator.h for the guard.
constexpr std::uint64_t kGuardFree = 1000;
constexpr int kMostRounds = 64;
// Of the run's length; a structure that cycles moves on by an ulp each time.
constexpr int kGuardWindow = -40, kLongestGuardWindow = -8, kGuardUlps = 27;

}  // namespace

// ---- what structures report

void Simulator::reported(const Event& event) {
  Entry& entry = entries_[event.structure];
  require(event.kind < entry.kind_counts.size(), "an event of an unknown kind");
  ++*entry.kind_counts[event.kind];
  ++kernel_.ledger(event.structure).records;
  events_at_instant_.push_back({event.structure, event.kind, event.external});
  if (sink_ != nullptr && !sink_timed_) {
    sink_->event(event, kernel_.arithmetic());
  } else if (sink_ != nullptr) {
    clock_.report([&] { sink_->event(event, kernel_.arithmetic()); });
  }
  // Watchers are notified of rebuilds by rebuilt().
  if (!event.external || entry.watchers.empty() || !event.reason.empty()) return;
  notices_.push_back({event.structure, true, event});
  notices_.back().event.gone = notices_.back().event.came = {};
}

void Simulator::report_common(Event event, CommonEvent kind) {
  const int first = entries_[event.structure].first_common;
  event.kind = static_cast<std::uint8_t>(first + static_cast<int>(kind));
  reported(event);
}

void Simulator::settled(Event event) { report_common(event, CommonEvent::kSettled); }

void Simulator::rebuilt(Event event) {
  report_common(event, CommonEvent::kRebuild);
  changed_within(event.structure);
}

void Simulator::changed_within(StructureId id) {
  if (!entries_[id].watchers.empty()) notices_.push_back({id, false, {}});
}

void Simulator::report_change(StructureId id, CommonEvent kind, ObjectId object) {
  Event event;
  event.structure = id;
  event.count = 1;
  event.ids[0] = object;
  report_common(event, kind);
}

// Notices may lead to further notices. Watchers have larger ids, so this terminates.
void Simulator::tell_watchers() {
  for (std::size_t i = 0; i < notices_.size(); ++i) {
    const Notice notice = notices_[i];
    for (const StructureId w : entries_[notice.structure].watchers) {
      call(w, [&](Structure& s) { s.watched_changed(notice.has_event ? &notice.event : nullptr); });
    }
  }
  notices_.clear();
}

// ---- calls to structures

// The same, with names.
RepeatedObject Simulator::with_names(const RepeatedObject& error) const {
  const Query& query = error.query();
  std::vector<std::string> objects;
  for (std::size_t i = 0; i < query.arity; ++i) objects.push_back(object_name(query.ids[i]));
  return RepeatedObject(error.structure(), query, entries_[error.structure()].label,
                        kernel_.arithmetic().predicate(query.predicate).name(), objects);
}

// In an inexact arithmetic a broken invariant is corruption, not a bug.
template <class Call>
void Simulator::guarded(StructureId id, const Call& function) {
  try {
    function(*entries_[id].structure);
  } catch (const std::invalid_argument&) {
    throw;
  } catch (const RepeatedObject& error) {
    if (kernel_.is_exact()) throw with_names(error);
    kernel_.corrupt(id, with_names(error).what());
  } catch (const std::logic_error& error) {
    if (kernel_.is_exact()) throw;
    kernel_.corrupt(id, error.what());
  }
}

void Simulator::call(StructureId id, const std::function<void(Structure&)>& function) {
  if (kernel_.ledger(id).corrupt) return;
  clock_.charge(id);
  kernel_.begin_change();
  guarded(id, function);
  kernel_.end_change();
  if (kernel_.ledger(id).corrupt) abandon(id);
}

// A corrupt structure has no certificates, and its watchers cannot continue either.
void Simulator::abandon(StructureId id) {
  if (entries_[id].abandoned) return;
  entries_[id].abandoned = true;
  kernel_.clear_structure(id);
  for (const StructureId w : entries_[id].watchers) {
    kernel_.corrupt(w, "the structure that it watches is corrupt");
    abandon(w);
  }
}

// Ends a stretch of work of the structures.
void Simulator::end_charge() {
  clock_.charge(RunClock::kNoStructure);
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    const StructureId id = static_cast<StructureId>(i);
    kernel_.ledger(id).seconds = clock_.structure_seconds(id);
  }
}

// ---- instants

// True if the first failure is at the present instant (or, inexact arithmetics, before it).
bool Simulator::fails_now() {
  EventQueue& queue = kernel_.queue();
  for (;;) {
    if (queue.empty() || queue.top_lo() > now_hi_) return false;
    if (!queue.top_is_later()) break;
    kernel_.look_further();
  }
  const CertificateId first = queue.top();
  FailureTime time = queue.time(first);
  order_to_now_ = kernel_.arithmetic().compare_with_now(kernel_.query(first), time);
  queue.set_time(first, time);
  return order_to_now_ <= 0;
}

void Simulator::handle_failure() {
  EventQueue& queue = kernel_.queue();
  const CertificateId failed = queue.top();
  const StructureId id = queue.certificate(failed).structure;
  if (rounds_ >= kMostRounds && !kernel_.is_exact()) return guard_fired(id);
  if (++repairs_[id] > kGuardFree) {
    const std::uint64_t c = kernel_.ledger(id).max_live;
    const std::uint64_t most =
        kernel_.is_exact() ? 64 * c + c * c : 8 * c + entries_[id].structure->most_repairs(c);
    if (repairs_[id] > kGuardFree + most) return guard_fired(id);
  }
  FailureTime time = queue.pop();
  if (order_to_now_ < 0) {
    kernel_.arithmetic().release(time);
  } else {
    now_hi_ = time.hi;
    kernel_.arithmetic().advance(kernel_.query(failed), time);
  }
  if (++failures_at_instant_[id] == 1) {
    before_instant_[id] = {kernel_.ledger(id).failures, kernel_.ledger(id).internal};
    touched_.push_back(id);
  } else {
    kernel_.set_instant_shared(id, true);
  }
  ++ledger_.events;
  clock_.charge(id);
  kernel_.begin_event(id, failed);
  guarded(id, [failed](Structure& s) { s.certificate_failed(failed); });
  kernel_.end_event();
  if (kernel_.ledger(id).corrupt) abandon(id);
  if (!notices_.empty()) tell_watchers();
}

void Simulator::guard_fired(StructureId id) {
  if (!kernel_.is_exact()) {
    kernel_.corrupt(id, "no end of repairs at one instant");
    return abandon(id);
  }
  if (guard_fired_[id] != 0) {
    throw std::logic_error("structure \"" + entries_[id].label +
                           "\" cannot be repaired: its certificates fail again after a rebuild");
  }
  guard_fired_[id] = 1;
  repairs_[id] = 0;
  call(id, [this, id](Structure& s) {
    const Attribute before = s.told();
    s.rebuild();
    if (kernel_.ledger(id).corrupt) return;
    const AttributeDifference change = difference_between(before, s.attribute());
    kernel_.count_rebuild(id, "guard", change.gone, change.came);
  });
  tell_watchers();
}

void Simulator::repair() {
  while (fails_now()) handle_failure();
}

// Marks the structures of which two or more certificates fail at the instant of the first failure.
// Those that claim one thing about one set of points count once.
void Simulator::mark_shared() {
  EventQueue& queue = kernel_.queue();
  if (!queue.first_instant_is_shared()) return;
  first_instant_.clear();
  queue.collect_first_instant(first_instant_);
  std::vector<CertificateId> first_of(entries_.size(), kNoCertificate);
  for (const CertificateId c : first_instant_) {
    const StructureId id = queue.certificate(c).structure;
    CertificateId& first = first_of[id];
    if (first == kNoCertificate) {
      first = c;
    } else if (!claim_as_one(kernel_.arithmetic(), queue.query(first), queue.query(c))) {
      kernel_.set_instant_shared(id, true);
    }
  }
}

// Requires the first failure to be after now.
void Simulator::failure_instant() {
  remember_between();
  at_failure_instant_ = true;
  begin_instant();
  mark_shared();
  order_to_now_ = 0;
  handle_failure();
  repair();
  settle();
  end_instant();
}

// Structures whose instant was shared check what no single failure can break, until nothing fails.
void Simulator::settle() {
  for (;; ++rounds_) {
    bool looked = false;
    for (std::size_t i = 0; i < entries_.size(); ++i) {
      const StructureId id = static_cast<StructureId>(i);
      if (!kernel_.instant_is_shared(id)) continue;
      looked = true;
      kernel_.set_instant_shared(id, true);
    }
    if (!looked) break;
    while (settle_once()) tell_watchers();
    if (fails_now()) {
      repair();
    } else if (tell_what_changed()) {
      break;
    } else {
      repair();  // certificates that watchers have made may fail at once
    }
  }
  rounds_ = 0;
}

// One call of each structure that is due; what it tells its watchers may make them due. True if there
// was one.
bool Simulator::settle_once() {
  bool looked = false;
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    const StructureId id = static_cast<StructureId>(i);
    if (!kernel_.settling_is_due(id)) continue;
    looked = true;
    call(id, [](Structure& s) { s.instant_settled(); });
    kernel_.set_settled(id);
  }
  return looked;
}

// Final reports on the instant by the structures that shared it. True if no watcher has work left.
// A watcher, which has a larger id, hears of what its structure reports before it reports itself.
bool Simulator::tell_what_changed() {
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    const StructureId id = static_cast<StructureId>(i);
    if (!kernel_.instant_is_shared(id)) continue;
    call(id, [](Structure& s) { s.instant_over(); });
    kernel_.set_instant_shared(id, false);
    if (notices_.empty()) continue;
    tell_watchers();
    return false;
  }
  return true;
}

void Simulator::begin_instant() {
  in_instant_ = true;
  if (!at_failure_instant_) reached_before_instant_ = Rational(reached_);
  events_at_instant_.clear();
  ++ledger_.instants;
  kernel_.count_instant();
}

// Subtracts the events and failures of the present instant from the counts; the cost of its work
// stays counted.
void Simulator::abandon_instant() {
  is_broken_ = true;
  if (in_instant_) {
    for (const ReportedEvent& event : events_at_instant_) {
      StructureLedger& ledger = kernel_.ledger(event.structure);
      const Entry& entry = entries_[event.structure];
      --*entry.kind_counts[event.kind];
      --ledger.records;
      const int common = event.kind - entry.first_common;
      if (common == static_cast<int>(CommonEvent::kMotion)) --ledger.motion_updates;
      if (common == static_cast<int>(CommonEvent::kInsert)) --ledger.insertions;
      if (common == static_cast<int>(CommonEvent::kErase)) --ledger.erasures;
      if (!event.external) continue;
      --ledger.external;
      --ledger.processed;
    }
    for (const StructureId id : touched_) {
      StructureLedger& ledger = kernel_.ledger(id);
      ledger.processed -= ledger.internal - before_instant_[id].internal;
      ledger.internal = before_instant_[id].internal;
      ledger.failures = before_instant_[id].failures;
      ledger_.events -= failures_at_instant_[id];
    }
    if (ledger_.instants > 0) --ledger_.instants;  // the start is not counted
    if (!at_failure_instant_) reached_ = std::move(reached_before_instant_);
    if (sink_ != nullptr) sink_->instant_abandoned();
  }
  // Nothing happens between the last instant and the present one.
  if (!started_) return;
  std::optional<Rational> t = std::move(between_);
  const Rational* const change = next_change();
  const bool plain = settled_hi_ < next_lo_ &&
                     (change == nullptr || settled_hi_ < change->lower_double()) &&
                     (!scene_.end || settled_hi_ <= scene_.end->lower_double());
  if (plain) {
    t = Rational::from_double(settled_hi_);
  } else if (!in_instant_ && !out_of_memory_) {
    try {
      t = time_between();
    } catch (const Stopped&) {
      return;
    }
    // The last instant is the end of the scene: no time is left between them.
    if (!t && kernel_.is_exact() && change == nullptr) t = scene_.end;
  }
  if (t && !(*t < reached_)) reached_ = *std::move(t);
}

// If the enclosures of the last instant and of the next one overlap, finds a time between them
// while the arithmetic still stands at the last one: abandon_instant() may need it.
void Simulator::remember_between() {
  between_.reset();
  if (!(settled_hi_ < next_lo_)) between_ = time_between();
}

void Simulator::end_instant() {
  for (const StructureId id : touched_) {
    StructureLedger& ledger = kernel_.ledger(id);
    const std::uint64_t failures = failures_at_instant_[id];
    if (failures >= 2) ++ledger.simultaneous_groups;
    ledger.largest_group = std::max(ledger.largest_group, failures);
    failures_at_instant_[id] = 0;
    guard_fired_[id] = 0;
    if (kernel_.is_exact()) repairs_[id] = 0;
  }
  touched_.clear();
  if (!kernel_.is_exact()) {
    const double now = kernel_.arithmetic().now_approximate();
    if (!(now <= guard_window_end_)) {
      std::fill(repairs_.begin(), repairs_.end(), 0);
      const long ulps = kGuardUlps - std::min(kernel_.arithmetic().precision(), 1000L);
      const int window = std::clamp(static_cast<int>(ulps), kGuardWindow, kLongestGuardWindow);
      guard_window_end_ = now + std::ldexp(std::max(std::fabs(now), span_), window);
    }
  }
  in_instant_ = false;
  settled_hi_ = now_hi_;
  const EventQueue& queue = kernel_.queue();
  next_lo_ = queue.empty() ? std::numeric_limits<double>::infinity() : queue.top_lo();
  if (sink_ != nullptr) sink_->instant_ended();
  if (options_.audit == AuditLevel::kEvents) run_audit(true);
}

}  // namespace kinex
