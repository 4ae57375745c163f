// SPDX-License-Identifier: GPL-3.0-or-later
// The run: instants, failures, watchers, limits. Flight plans: simulator_changes.cpp; audits:
// simulator_audit.cpp.
#include "core/simulator.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "core/check.h"

namespace kinex {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::uint64_t kLookEvery = 4096;
// See simulator.h for the guard.
constexpr std::uint64_t kGuardFree = 1000;
// Of the run's length; a structure that goes round in circles moves on by an ulp each time.
constexpr int kGuardWindow = -40, kLongestGuardWindow = -8, kGuardUlps = 27;

double seconds_between(Clock::time_point from, Clock::time_point to) {
  return std::chrono::duration<double>(to - from).count();
}

}  // namespace

Simulator::Simulator(const Scene& scene, std::unique_ptr<Arithmetic> arithmetic,
                     SimulatorOptions options)
    : scene_(scene),
      options_(std::move(options)),
      kernel_(std::move(arithmetic), scene.objects.size(), options_.scheduling),
      alive_(scene.objects.size(), false),
      trajectory_(scene.objects.size()),
      pieces_(scene.objects.size(), 0),
      degree_(scene.degree()),
      reached_(scene.start) {
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
  if (sink_ != nullptr) sink_->event(event, kernel_.arithmetic());
  if (event.external && !entry.watchers.empty()) notices_.push_back({event.structure, true, event});
}

void Simulator::rebuilt(StructureId id, std::string_view reason) {
  report_change(id, CommonEvent::kRebuild, kNoObject, reason);
  if (!entries_[id].watchers.empty()) notices_.push_back({id, false, {}});
}

void Simulator::report_change(StructureId id, CommonEvent kind, ObjectId object,
                              std::string_view reason) {
  Event event;
  event.reason = reason;
  event.structure = id;
  event.kind = static_cast<std::uint8_t>(entries_[id].first_common + static_cast<int>(kind));
  if (object != kNoObject) {
    event.count = 1;
    event.ids[0] = object;
  }
  reported(event);
}

// Notices may lead to further notices: those who watch have larger ids, so this ends.
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

// In an inexact arithmetic a broken invariant is corruption, not a bug.
template <class Call>
void Simulator::guarded(StructureId id, const Call& function) {
  try {
    function(*entries_[id].structure);
  } catch (const std::invalid_argument&) {
    throw;
  } catch (const std::logic_error& error) {
    if (kernel_.is_exact()) throw;
    kernel_.corrupt(id, error.what());
  }
}

void Simulator::call(StructureId id, const std::function<void(Structure&)>& function) {
  if (kernel_.ledger(id).corrupt) return;
  charge(id);
  kernel_.begin_change();
  guarded(id, function);
  kernel_.end_change();
  if (kernel_.ledger(id).corrupt) abandon(id);
}

// A corrupt structure has no certificates, and those who watch it cannot go on either.
void Simulator::abandon(StructureId id) {
  if (entries_[id].abandoned) return;
  entries_[id].abandoned = true;
  kernel_.clear_structure(id);
  for (const StructureId w : entries_[id].watchers) {
    kernel_.corrupt(w, "the structure that it watches is corrupt");
    abandon(w);
  }
}

// Time is charged to the structure that was called last; with one structure no clock is read.
void Simulator::charge(StructureId id) {
  if (id == charged_) return;
  const auto now = Clock::now();
  if (charged_ != kNoStructure) {
    kernel_.ledger(charged_).seconds += seconds_between(charged_since_, now);
  }
  charged_ = id;
  charged_since_ = now;
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
    touched_.push_back(id);
  } else {
    kernel_.set_instant_shared(id, true);
  }
  ++ledger_.events;
  charge(id);
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
    s.rebuild();
    kernel_.count_rebuild(id, "guard");
  });
  tell_watchers();
}

void Simulator::repair() {
  while (fails_now()) handle_failure();
}

// Tells structures of which two or more certificates fail at the instant of the first failure.
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

// Requires that the first failure comes after now.
void Simulator::failure_instant() {
  at_failure_instant_ = true;
  ++ledger_.instants;
  mark_shared();
  order_to_now_ = 0;
  handle_failure();
  repair();
  settle();
  end_instant();
}

// Structures whose instant was shared look at what single failures cannot break, until nothing
// fails.
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
    if (!fails_now()) break;
    repair();
  }
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    kernel_.set_instant_shared(static_cast<StructureId>(i), false);
  }
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
  if (options_.audit == AuditLevel::kEvents) run_audit(true);
}

// ---- the run

void Simulator::start() {
  require(!started_, "a run is started once");
  require(entries_.size() == kernel_.structures(), "a reserved structure was not handed over");
  for (const Entry& e : entries_) require(e.structure != nullptr, "a structure is missing");
  const auto begin = Clock::now();
  started_ = true;
  failures_at_instant_.assign(entries_.size(), 0);
  repairs_.assign(entries_.size(), 0);
  guard_fired_.assign(entries_.size(), 0);
  kernel_.arithmetic().set_now(scene_.start);
  now_hi_ = scene_.start.upper_double();
  span_ = scene_.end ? (*scene_.end - scene_.start).to_double() : 1.0;
  std::vector<ObjectId> objects;
  for (ObjectId object = 0; object < alive_.size(); ++object) {
    if (alive_[object]) objects.push_back(object);
  }
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    call(static_cast<StructureId>(i), [&](Structure& s) { s.build(objects); });
  }
  notices_.clear();  // those who watch were built later
  repair();
  settle();
  note_peak();
  charge(kNoStructure);
  seconds_setup_ += seconds_between(begin, Clock::now());
  end_instant();
}

// Handles all failures before `stop` (at it too, if inclusive; all if there is none) until a limit
// is reached.
void Simulator::run_failures(const Rational* stop, bool inclusive) {
  EventQueue& queue = kernel_.queue();
  const double lo = stop != nullptr ? stop->lower_double() : 0;
  const double hi = stop != nullptr ? stop->upper_double() : 0;
  while (!queue.empty()) {
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

RunStatus Simulator::run_until(const std::optional<Rational>& t) {
  require(started_, "a run has to be started");
  const std::optional<Rational> target = t ? t : scene_.end;
  if (target && *target < reached_) {
    throw std::invalid_argument("the run has reached " + reached_.to_string() +
                                " and cannot go back to " + target->to_string());
  }
  if (target && scene_.end && *scene_.end < *target) {
    throw std::invalid_argument("the scene ends at " + scene_.end->to_string() + ", before " +
                                target->to_string());
  }
  run_since_ = Clock::now();
  const double audit_before = seconds_audit_;
  status_ = RunStatus::kDone;
  next_look_ = ledger_.events + ledger_.instants + 2 * kLookEvery;
  for (;;) {
    const Rational* change = next_change();
    if (change != nullptr && target && *target < *change) change = nullptr;
    const Rational* stop = change != nullptr ? change : target ? &*target : nullptr;
    run_failures(stop, change == nullptr);
    if (status_ != RunStatus::kDone || change == nullptr || stop_early()) break;
    change_instant();
  }
  if (status_ != RunStatus::kDone) {
    stop_between();
  } else if (target) {
    kernel_.arithmetic().set_now(*target);
    reached_ = *target;
    now_hi_ = target->upper_double();
    at_failure_instant_ = false;
  } else if (at_failure_instant_) {
    stop_between();
  }
  note_peak();
  charge(kNoStructure);
  const bool ended = !scene_.end || *scene_.end == reached_;
  if (status_ == RunStatus::kDone && ended && options_.audit != AuditLevel::kNone) run_audit(false);
  seconds_simulate_ += seconds_between(run_since_, Clock::now()) - (seconds_audit_ - audit_before);
  return status_;
}

// Looks at the limits. Progress and the clock only after kLookEvery instants or failures.
bool Simulator::stop_early() {
  if (status_ != RunStatus::kDone) return true;
  if (options_.max_events != 0 && ledger_.events >= options_.max_events) {
    status_ = RunStatus::kLimit;
    return true;
  }
  const std::uint64_t work = ledger_.events + ledger_.instants;
  if (work < next_look_) return false;
  next_look_ = work + 2 * kLookEvery;
  // Counting all bytes takes as long as there are objects: at times that grow with the work done.
  if (work >= next_peak_) {
    next_peak_ = work + work / 16;
    note_peak();
  }
  if (options_.max_seconds > 0 &&
      seconds_simulate_ + seconds_between(run_since_, Clock::now()) > options_.max_seconds) {
    status_ = RunStatus::kLimit;
  } else if (options_.progress && !options_.progress(*this)) {
    status_ = RunStatus::kInterrupted;
  }
  return status_ != RunStatus::kDone;
}

// now := a rational time before the next instant, so that the run can be taken up again.
void Simulator::stop_between() {
  std::optional<Rational> t = rational_after_now();
  if (!t && !kernel_.is_exact()) t = Rational::from_double(kernel_.arithmetic().now_approximate());
  if (!t || *t < reached_) return;
  kernel_.arithmetic().set_now(*t);
  reached_ = *t;
  now_hi_ = t->upper_double();
  at_failure_instant_ = false;
}

void Simulator::note_peak() {
  std::uint64_t bytes = kernel_.bytes() + kernel_.arithmetic().bytes();
  for (const Entry& entry : entries_) bytes += entry.structure->bytes();
  ledger_.peak_bytes = std::max(ledger_.peak_bytes, bytes);
  ledger_.max_queue = kernel_.queue().max_size();
}

std::vector<BoundCheck> Simulator::bounds(StructureId id) const {
  BoundContext context;
  context.pieces = pieces_;
  for (int& p : context.pieces) p = std::max(p, 1);
  context.degree = degree_;
  context.dynamic = dynamic_;
  context.ledger = &kernel_.ledger(id);
  return entries_[id].structure->bounds(context);
}

}  // namespace kinex
