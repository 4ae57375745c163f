// SPDX-License-Identifier: GPL-3.0-or-later
// The run: from instant to instant, up to a time or a limit. An instant: simulator_instant.cpp;
// flight plans: simulator_changes.cpp; audits: simulator_audit.cpp.
#include "core/engine/simulator.h"

#include <algorithm>
#include <limits>
#include <new>
#include <stdexcept>
#include <utility>

#include "core/numbers/check.h"
#include "core/numbers/time_text.h"

namespace kinex {
namespace {

constexpr std::uint64_t kLookEvery = 4096;

}  // namespace

Simulator::Simulator(const Scene& scene, std::unique_ptr<Arithmetic> arithmetic,
                     SimulatorOptions options)
    : scene_(scene),
      options_(std::move(options)),
      deadline_(std::make_unique<Deadline>(options_.max_seconds, options_.interrupt)),
      kernel_(std::move(arithmetic), scene.objects.size(), options_.scheduling),
      alive_(scene.objects.size(), false),
      pieces_(scene.objects.size(), 0),
      degree_(kernel_.arithmetic().needs().weights ? scene.degree()
                                                   : scene.degree_without_weights()),
      reached_(scene.start) {
  kernel_.set_deadline(deadline_.get());
  for (const SceneObject& object : scene.objects) {
    for (const MotionPiece& piece : object.motion.pieces) check_trajectory(piece.trajectory);
  }
  kernel_.set_reporter(this);
  plan_changes();
}

Simulator::~Simulator() = default;

std::vector<ObjectId> Simulator::Entry::those_of(const std::vector<ObjectId>& objects) const {
  if (members.empty()) return objects;
  std::vector<ObjectId> result;
  for (const ObjectId object : objects) {
    if (members[object]) result.push_back(object);
  }
  return result;
}

void Simulator::add(StructureId id, std::unique_ptr<Structure> structure, std::string label,
                    std::vector<StructureId> watches, std::vector<bool> members) {
  require(!started_, "structures are added before the start");
  if (entries_.size() <= id) entries_.resize(id + std::size_t{1});
  require(entries_[id].structure == nullptr, "two structures with one id");
  Entry& entry = entries_[id];
  entry.structure = std::move(structure);
  entry.label = std::move(label);
  require(members.empty() || members.size() == alive_.size(), "a subset of other objects");
  entry.members = std::move(members);
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

// ---- the run

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
      const std::vector<ObjectId> own = entries_[i].those_of(objects);
      call(static_cast<StructureId>(i), [&](Structure& s) { s.build(own); });
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
  std::optional<Rational> t = time_between();
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
  if (is_torn() || kernel_.ledger(id).corrupt) return {};
  BoundContext context;
  for (ObjectId object = 0; object < pieces_.size(); ++object) {
    if (!entries_[id].has(object)) continue;
    context.pieces.push_back(std::max(pieces_[object], 1));
    if (!entries_[id].members.empty()) context.members.push_back(object);
  }
  context.degree = degree_;
  context.dynamic = dynamic_;
  context.ledger = &kernel_.ledger(id);
  return entries_[id].structure->bounds(context);
}

}  // namespace kinex
