// SPDX-License-Identifier: GPL-3.0-or-later
// The run: instants, failures, watchers, limits. Flight plans: simulator_changes.cpp; audits:
// simulator_audit.cpp.
#include "core/simulator.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>
#include <stdexcept>
#include <utility>

#include "core/check.h"
#include "core/repeated_object.h"
#include "core/time_text.h"

namespace kinex {
namespace {

constexpr std::uint64_t kLookEvery = 4096;
// See simulator.h for the guard.
constexpr std::uint64_t kGuardFree = 1000;
// Of the run's length; a structure that cycles moves on by an ulp each time.
constexpr int kGuardWindow = -40, kLongestGuardWindow = -8, kGuardUlps = 27;

}  // namespace

Simulator::Simulator(const Scene& scene, std::unique_ptr<Arithmetic> arithmetic,
                     SimulatorOptions options)
    : scene_(scene),
      options_(std::move(options)),
      deadline_(std::make_unique<Deadline>(options_.max_seconds, options_.interrupt)),
      kernel_(std::move(arithmetic), scene.objects.size(), options_.scheduling),
      alive_(scene.objects.size(), false),
      trajectory_(scene.objects.size()),
      pieces_(scene.objects.size(), 0),
      degree_(scene.degree()),
      reached_(scene.start) {
  kernel_.set_deadline(deadline_.get());
  if (scene.has_bodies()) kernel_.keep_motions();
  for (const SceneObject& object : scene.objects) {
    for (const MotionPiece& piece : object.motion.pieces) check_trajectory(piece.trajectory);
  }
  kernel_.set_reporter(this);
  plan_changes();
}

Simulator::~Simulator() = default;

void Simulator::add(StructureId id, std::unique_ptr<Structure> structure, std::string label,
                    std::vector<StructureId> watches) {
  require(!started_, "structures are added before the start");
  if (entries_.size() <= id) entries_.resize(id + std::size_t{1});
  require(entries_[id].structure == nullptr, "two structures with one id");
  Entry& entry = entries_[id];
  entry.structure = std::move(structure);
  entry.label = std::move(label);
  const std::vector<std::string_view> kinds = event_kinds(id);
  entry.first_common = static_cast<std::uint8_t>(kinds.size() - kCommonEvents);
  for (const std::string_view kind : kinds) {
    entry.kind_counts.push_back(&kernel_.ledger(id).by_kind[std::string(kind)]);
  }
  for (const StructureId w : watches) {
    require(w < id && w < entries_.size() && entries_[w].structure != nullptr,
            "a structure watches one that was added before");
    entries_[w].watchers.push_back(id);
  }
}

std::vector<std::string_view> Simulator::event_kinds(StructureId id) const {
  std::vector<std::string_view> kinds = entries_[id].structure->event_kinds();
  const std::vector<std::string_view> common = common_event_kinds({});
  const bool complete = kinds.size() >= common.size() &&
                        std::equal(common.begin(), common.end(), kinds.end() - kCommonEvents);
  return complete ? kinds : common_event_kinds(std::move(kinds));
}

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
  if (entries_[event.structure].watchers.empty()) return;
  notices_.push_back({event.structure, false, {}});
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
void Simulator::mark_shared() {
  EventQueue& queue = kernel_.queue();
  if (!queue.first_instant_is_shared()) return;
  first_instant_.clear();
  queue.collect_first_instant(first_instant_);
  std::vector<std::uint8_t> seen(entries_.size(), 0);
  for (const CertificateId c : first_instant_) {
    const StructureId id = queue.certificate(c).structure;
    if (seen[id] != 0) kernel_.set_instant_shared(id, true);
    seen[id] = 1;
  }
}

// Requires the first failure to be after now.
void Simulator::failure_instant() {
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
  for (;;) {
    bool looked = false;
    for (std::size_t i = 0; i < entries_.size(); ++i) {
      const StructureId id = static_cast<StructureId>(i);
      if (!kernel_.instant_is_shared(id)) continue;
      looked = true;
      call(id, [](Structure& s) { s.instant_settled(); });
    }
    if (!looked) return;
    tell_watchers();
    if (fails_now()) {
      repair();
    } else if (tell_what_changed()) {
      break;
    }
  }
}

// Final reports on the instant by the structures that shared it. True if no watcher has work left.
bool Simulator::tell_what_changed() {
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    const StructureId id = static_cast<StructureId>(i);
    if (!kernel_.instant_is_shared(id)) continue;
    call(id, [](Structure& s) { s.instant_over(); });
    kernel_.set_instant_shared(id, false);
  }
  if (notices_.empty()) return true;
  tell_watchers();
  return false;
}

void Simulator::begin_instant() {
  in_instant_ = true;
  if (!at_failure_instant_) reached_before_instant_ = Rational(reached_);
  events_at_instant_.clear();
  ++ledger_.instants;
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
    --ledger_.instants;
    if (!at_failure_instant_) reached_ = std::move(reached_before_instant_);
    if (sink_ != nullptr) sink_->instant_abandoned();
  }
  // Nothing happens between the last instant and the present one.
  if (!started_ || !(settled_hi_ < next_lo_)) return;
  std::optional<Rational> t = Rational::from_double(settled_hi_);
  if (!t || *t < reached_ || (scene_.end && *scene_.end < *t)) return;
  if (next_change() != nullptr && *next_change() <= *t) return;
  reached_ = *std::move(t);
}

// Does the work; false, with the status, if it is stopped or memory is exhausted.
template <class Work>
bool Simulator::unless_stopped(const Work& work) {
  try {
    work();
    return true;
  } catch (const Stopped&) {
    status_ = deadline_->interrupted() ? RunStatus::kInterrupted : RunStatus::kLimit;
  } catch (const std::bad_alloc&) {
    status_ = RunStatus::kLimit;
    out_of_memory_ = true;
  }
  deadline_->pause();
  abandon_instant();
  return false;
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

// ---- the run

bool Simulator::start() {
  require(!started_, "a run is started once");
  require(entries_.size() == kernel_.structures(), "a reserved structure was not handed over");
  for (const Entry& e : entries_) require(e.structure != nullptr, "a structure is missing");
  std::optional<RunClock::Scope> setup(std::in_place, clock_, RunPhase::kSetup);
  started_ = true;
  failures_at_instant_.assign(entries_.size(), 0);
  before_instant_.assign(entries_.size(), {});
  repairs_.assign(entries_.size(), 0);
  guard_fired_.assign(entries_.size(), 0);
  now_hi_ = scene_.start.upper_double();
  next_lo_ = -std::numeric_limits<double>::infinity();
  span_ = scene_.end ? (*scene_.end - scene_.start).to_double() : 1.0;
  const bool built = unless_stopped([&] {
    begin_instant();
    --ledger_.instants;  // the start is not one
    kernel_.arithmetic().set_now(scene_.start);
    std::vector<ObjectId> objects;
    for (ObjectId object = 0; object < alive_.size(); ++object) {
      if (alive_[object]) objects.push_back(object);
    }
    for (std::size_t i = 0; i < entries_.size(); ++i) {
      call(static_cast<StructureId>(i), [&](Structure& s) { s.build(objects); });
    }
    notices_.clear();  // watchers were built later
    repair();
    settle();
  });
  if (built) note_peak();
  end_charge();
  setup.reset();
  const bool ready = built && unless_stopped([&] { end_instant(); });
  deadline_->pause();
  return ready;
}

// Handles all failures before `stop` (inclusive: at it too; null: all) until a limit is reached.
void Simulator::run_failures(const Rational* stop, bool inclusive) {
  EventQueue& queue = kernel_.queue();
  const double lo = stop != nullptr ? stop->lower_double() : 0;
  const double hi = stop != nullptr ? stop->upper_double() : 0;
  while (!queue.empty()) {
    next_lo_ = queue.top_lo();
    if (stop != nullptr && !(queue.top_hi() < lo)) {
      if (queue.top_lo() > hi) return;
      if (queue.top_is_later()) {
        kernel_.look_further();
        continue;
      }
      const CertificateId first = queue.top();
      FailureTime time = queue.time(first);
      const int order = kernel_.arithmetic().compare(kernel_.query(first), time, *stop);
      queue.set_time(first, time);
      if (order > 0 || (order == 0 && !inclusive)) return;
    }
    if (queue.top_is_later()) {
      kernel_.look_further();
      continue;
    }
    if (stop_early()) return;
    failure_instant();
  }
}

void Simulator::run_to(const std::optional<Rational>& target) {
  for (;;) {
    const Rational* change = next_change();
    if (change != nullptr && target && *target < *change) change = nullptr;
    const Rational* stop = change != nullptr ? change : target ? &*target : nullptr;
    run_failures(stop, change == nullptr);
    if (status_ != RunStatus::kDone || change == nullptr || stop_early()) break;
    if (options_.stop_before && !(*change < *options_.stop_before)) {
      status_ = RunStatus::kInterrupted;
      break;
    }
    make_changes();
  }
  if (status_ != RunStatus::kDone) {
    stop_between();
  } else if (target) {
    kernel_.arithmetic().set_now(*target);
    reached_ = Rational(*target);
    now_hi_ = target->upper_double();
    at_failure_instant_ = false;
  } else if (at_failure_instant_) {
    stop_between();
  }
}

RunStatus Simulator::run_until(const std::optional<Rational>& t) {
  require(started_, "a run has to be started");
  const std::optional<Rational> target = t ? t : scene_.end;
  if (target && *target < reached_) {
    throw std::invalid_argument("the run has reached " + time_text(reached_) +
                                " and cannot go back to " + time_text(*target));
  }
  if (target && scene_.end && *scene_.end < *target) {
    throw std::invalid_argument("the scene ends at " + time_text(*scene_.end) + ", before " +
                                time_text(*target));
  }
  if (is_broken_) return status_;
  const RunClock::Scope simulate(clock_, RunPhase::kSimulate);
  deadline_->resume();
  status_ = RunStatus::kDone;
  next_look_ = ledger_.events + ledger_.instants + 2 * kLookEvery;
  const bool finished = unless_stopped([&] { run_to(target); });
  end_charge();
  if (finished) {
    note_peak();
    const bool ended = !scene_.end || *scene_.end == reached_;
    if (status_ == RunStatus::kDone && ended && options_.audit != AuditLevel::kNone) {
      unless_stopped([&] { run_audit(false); });
    }
  }
  deadline_->pause();
  return status_;
}

// Checks the limits. Progress only after kLookEvery instants or failures.
bool Simulator::stop_early() {
  if (status_ != RunStatus::kDone) return true;
  if (options_.max_events != 0 && ledger_.events >= options_.max_events) {
    status_ = RunStatus::kLimit;
    return true;
  }
  if (deadline_->due()) {
    status_ = deadline_->interrupted() ? RunStatus::kInterrupted : RunStatus::kLimit;
    return true;
  }
  const std::uint64_t work = ledger_.events + ledger_.instants;
  if (work < next_look_) return false;
  next_look_ = work + 2 * kLookEvery;
  // Counting all bytes is linear in the objects: done at intervals that grow with the work done.
  if (work >= next_peak_) {
    next_peak_ = work + work / 16;
    note_peak();
  }
  if (options_.progress && !options_.progress(*this)) {
    status_ = RunStatus::kInterrupted;
  }
  return status_ != RunStatus::kDone;
}

// now := a rational time before the next instant, so that the run can be continued.
void Simulator::stop_between() {
  std::optional<Rational> t = rational_after_now();
  if (!t && !kernel_.is_exact()) t = Rational::from_double(kernel_.arithmetic().now_approximate());
  if (!t || *t < reached_) return;
  kernel_.arithmetic().set_now(*t);
  now_hi_ = t->upper_double();
  reached_ = *std::move(t);
  at_failure_instant_ = false;
}

void Simulator::note_peak() {
  std::uint64_t bytes = kernel_.bytes() + kernel_.arithmetic().bytes();
  for (const Entry& entry : entries_) bytes += entry.structure->bytes();
  ledger_.peak_bytes = std::max(ledger_.peak_bytes, bytes);
  ledger_.max_queue = kernel_.queue().max_size();
}

std::vector<BoundCheck> Simulator::bounds(StructureId id) const {
  if (is_torn()) return {};
  BoundContext context;
  context.pieces = pieces_;
  for (int& p : context.pieces) p = std::max(p, 1);
  context.degree = degree_;
  context.dynamic = dynamic_;
  context.ledger = &kernel_.ledger(id);
  return entries_[id].structure->bounds(context);
}

}  // namespace kinex
