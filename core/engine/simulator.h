// SPDX-License-Identifier: GPL-3.0-or-later
// Simulator: runs structures over one scene, from instant to instant.
//
// An instant is the failure time of a certificate or the rational time of a flight-plan change.
// State is always read from the right: at an instant, failures are handled until every certificate
// is non-negative right after it. At an instant of flight-plan changes the order is:
//
//   motions -> failures -> erasures -> failures -> insertions -> failures
//
// First of all the certificates of all objects with new motions are scheduled anew, each once. An
// update that moves an object to another position is an erasure and an insertion.
//
// Guard against endless repairs: a structure may make 1000 + 64 c + c^2 repairs at one instant,
// where c is the largest number of certificates that it has had. No correct structure needs more:
//   sorted list       n keys have n - 1 certificates; each pair swaps at most once: C(n,2) <= c^2
//   Delaunay flips    never restore an edge: C(n,2) <= c^2
//   tournament, heap  winners only get better: at most c repairs per certificate
// In an exact arithmetic the structure is rebuilt when the guard fires; if it fires again at the
// same instant, std::logic_error is thrown.
// In an inexact arithmetic the limit is 1000 + 8 c + Structure::most_repairs(c), and the structure
// is corrupt when the guard fires; so is one that fails again after 64 rounds in which shared
// failures of one instant are settled, each of which may read a whole structure. Repairs at different
// instants are counted together if these lie in one short window of time. Relative to the length of
// the run (or to now, if that is larger) a window is 2^27 ulps of the arithmetic, but at least 2^-40
// and at most 2^-8.
#ifndef KINEX_CORE_ENGINE_SIMULATOR_H
#define KINEX_CORE_ENGINE_SIMULATOR_H

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/engine/audit.h"
#include "core/engine/bound.h"
#include "core/engine/repeated_object.h"
#include "core/engine/run_clock.h"
#include "core/engine/scheduler.h"
#include "core/engine/structure.h"
#include "core/motion/scene.h"
#include "core/numbers/stop.h"

namespace kinex {

enum class AuditLevel {  // how often a run is audited
  kNone,
  kEnd,     // one full audit at the end of the run
  kEvents,  // invariants and certificates after every instant, a full audit between every two
            // instants
};

struct SimulatorOptions {  // limits of a run, its audits and its scheduling
  AuditLevel audit = AuditLevel::kEnd;
  Scheduling scheduling = Scheduling::kLazy;
  std::uint64_t max_events = 0;  // stop with kLimit after this many failures; 0: no limit
  // Likewise for wall time in seconds: from the simulator's construction to the end of start(), and
  // within run_until(), audits included; 0: no limit.
  double max_seconds = 0;
  // Stop with kInterrupted before the first change of the scene at this time or later.
  std::optional<Rational> stop_before = std::nullopt;
  // Stops the run with kInterrupted when it is true. It must outlive the simulator. See stop.h.
  const std::atomic<bool>* interrupt = nullptr;
  // Called about every 4096 failures; return false to stop with kInterrupted.
  std::function<bool(const class Simulator&)> progress;
};

enum class RunStatus { kDone, kLimit, kInterrupted };  // how a run ended

class Simulator final : private EventReporter {
 public:
  // Keeps a reference to the scene, which must outlive it.
  Simulator(const Scene& scene, std::unique_ptr<Arithmetic> arithmetic,
            SimulatorOptions options = {});
  ~Simulator() override;

  // The kernel that structures are constructed with.
  Kernel& kernel() { return kernel_; }
  const Kernel& kernel() const { return kernel_; }
  const Arithmetic& arithmetic() const { return kernel_.arithmetic(); }
  const EventQueue& queue() const { return kernel_.queue(); }
  const StructureLedger& ledger(StructureId id) const { return kernel_.ledger(id); }
  // Bytes of certificates and their bookkeeping, without those of the arithmetic and the
  // structures.
  std::size_t bytes() const { return kernel_.bytes(); }
  std::uint32_t live_certificates(StructureId id, ObjectId object) const {
    return kernel_.live_certificates(id, object);
  }
  const Scene& scene() const { return scene_; }

  // Reserves the id that a structure is constructed with; add() then takes the structure.
  StructureId reserve() { return kernel_.add_structure(); }
  // Hands over the structure for a reserved id. `label`: its name in summaries and logs. `watches`:
  // ids of structures whose changes are reported to it (Structure::watched_changed); they must be
  // smaller than `id` and have been added. `members`: by object, true for those that the structure
  // is built from; it sees no other, nor their changes. Empty: all objects.
  void add(StructureId id, std::unique_ptr<Structure> structure, std::string label,
           std::vector<StructureId> watches = {}, std::vector<bool> members = {});
  std::size_t structures() const { return entries_.size(); }
  Structure& structure(StructureId id) { return *entries_[id].structure; }
  const SimulatorOptions& options() const { return options_; }
  const Structure& structure(StructureId id) const { return *entries_[id].structure; }
  // The name of an object of the scene or of a derived one.
  const std::string& object_name(ObjectId id) const {
    return id < scene_.objects.size() ? scene_.objects[id].id : kernel_.derived().object(id).name;
  }
  const std::string& label(StructureId id) const { return entries_[id].label; }
  // The names of all event kinds, indexed by Event::kind, the common ones last.
  std::vector<std::string_view> event_kinds(StructureId id) const;

  // The receiver of all events; nullptr: none. `timed`: the time of its calls is charged to
  // RunPhase::kReport. Measuring costs more than a sink that only fills a buffer: such a sink
  // should not be timed, and should charge the work on the full buffer itself.
  void set_sink(EventSink* sink, bool timed = true) {
    sink_ = sink;
    sink_timed_ = timed;
  }

  // Sets the motions in force right after the scene's start and builds every structure, in the
  // order of ids. False if it was stopped: run_until() then returns why, and no attribute is known.
  // Call it once, after every reserved id has its structure.
  bool start();
  // Handles all flight-plan changes and failures at instants <= t; then now = t. nullopt: up to the
  // scene's end, or all of them if it has none (now is then a rational time after the last). Can be
  // called again with later times. Returns kDone if it got there.
  //   audits      by AuditLevel; the final one at the scene's end, or, in a scene without an end,
  //               at the end of every call
  //   early stop  (kLimit, kInterrupted) is between two instants; the run can be continued
  //   abandoned   is an instant (or audit) that takes too long or runs out of memory: its events
  //               and failures are taken back, and the run is_broken()
  // Throws std::invalid_argument if t is before reached() or after the scene's end, and
  // RefusedChange (a std::invalid_argument) for a change that cannot be made.
  RunStatus run_until(const std::optional<Rational>& t);
  // The full audit at a rational time right after now; adds to the ledgers and to violations().
  // True: no violation.
  bool audit();

  // ---- changes from outside, at a rational instant t >= the time run so far ---------------------
  // From t on these changes replace the scene's own flight plans for the object. The functions
  // throw std::invalid_argument if t has passed or is after the scene's end, or if a structure is laid out
  // for the scene's own flight plans (Structure::takes_other_plans). A change that turns
  // out to be impossible (the insertion of an object that is alive) makes run_until() throw.

  // A flight-plan change; if the position is not continuous at t, an erasure and an insertion.
  void schedule_update(const Rational& t, ObjectId object, Trajectory trajectory);
  // The object appears with this motion; it must not be alive then.
  void schedule_insertion(const Rational& t, ObjectId object, Trajectory trajectory);
  void schedule_erasure(const Rational& t, ObjectId object);

  // The exact time the run has reached (the last t of run_until, or, inside it, the last
  // flight-plan instant).
  const Rational& reached() const { return reached_; }
  // The run was stopped within an instant or audit. What it has reported holds; it cannot continue.
  bool is_broken() const { return is_broken_; }
  // It was stopped within an instant: the attributes are not those of any time.
  bool is_torn() const { return is_broken_ && in_instant_; }
  // Memory was exhausted (kLimit).
  bool out_of_memory() const { return out_of_memory_; }
  // The clock of max_seconds: it runs from the construction to the end of start(), and within
  // run_until().
  Deadline& deadline() { return *deadline_; }
  bool alive(ObjectId object) const { return alive_[object]; }
  Snapshot snapshot(const Rational& t) const;
  const RunLedger& ledger() const { return ledger_; }
  // The hard bounds of one structure, checked for the run so far; none if it is corrupt or
  // the run is_torn().
  std::vector<BoundCheck> bounds(StructureId id) const;
  // Messages about the violations found so far (at most kMaxMessages are kept).
  static constexpr std::size_t kMaxMessages = 100;
  const std::vector<std::string>& violations() const { return violations_; }
  // CPU time of the thread and wall time, by phase: run_clock.h. The event sink's time is in
  // kReport, not in kSimulate. Charge work that belongs to the run but is done outside of it by
  // RunClock::Scope scope(simulator.clock(), RunPhase::kReport).
  Seconds seconds(RunPhase phase) const { return clock_.seconds(phase); }
  RunClock& clock() { return clock_; }
  // CPU seconds of each phase.
  double seconds_setup() const { return seconds(RunPhase::kSetup).cpu; }
  double seconds_simulate() const { return seconds(RunPhase::kSimulate).cpu; }
  double seconds_report() const { return seconds(RunPhase::kReport).cpu; }
  double seconds_audit() const { return seconds(RunPhase::kAudit).cpu; }

 private:
  struct Entry {
    std::unique_ptr<Structure> structure;
    std::string label;
    std::vector<StructureId> watchers;
    std::vector<bool> members;  // by object; empty: all
    std::vector<std::uint64_t*> kind_counts;  // by rank, into the ledger's by_kind
    std::uint8_t first_common = 0;            // rank of CommonEvent::kMotion
    bool abandoned = false;                   // corrupt, and abandon() has been called
    // At the last audit of AuditLevel::kEvents. `anew`: insertions, erasures, rebuilds.
    std::optional<Attribute> audited;
    std::uint64_t external_then = 0, anew_then = 0;

    bool has(ObjectId object) const { return members.empty() || members[object]; }
    std::vector<ObjectId> those_of(const std::vector<ObjectId>& objects) const;
  };
  struct Change {
    enum class Kind { kUpdate, kErase, kInsert };
    Rational t;
    Kind kind;
    ObjectId object;
    const Trajectory* trajectory;  // in the scene, or given from outside; none for kErase
    std::optional<Rational> until;
    bool planned;                             // by the scene
    std::shared_ptr<const Trajectory> given;  // from outside: keeps it while it is needed
  };
  struct Notice {
    StructureId structure;
    bool has_event;
    Event event;
  };
  // What the present instant has added to the counts.
  struct InstantCounts {
    std::uint64_t failures = 0, internal = 0;  // of a structure, before
  };
  struct ReportedEvent {
    StructureId structure;
    std::uint8_t kind;
    bool external;
  };
  // simulator.cpp, simulator_instant.cpp
  void reported(const Event& event) override;
  void settled(Event event) override;
  void rebuilt(Event event) override;
  void changed_within(StructureId id) override;
  void report_common(Event event, CommonEvent kind);
  void report_change(StructureId id, CommonEvent kind, ObjectId object);
  RepeatedObject with_names(const RepeatedObject& error) const;
  template <class Call>
  void guarded(StructureId id, const Call& function);
  void call(StructureId id, const std::function<void(Structure&)>& function);
  void abandon(StructureId id);
  void tell_watchers();
  void end_charge();
  bool fails_now();
  void mark_shared();
  void failure_instant();
  void handle_failure();
  void guard_fired(StructureId id);
  void repair();
  void settle();
  bool settle_once();
  bool tell_what_changed();
  void begin_instant();
  void end_instant();
  template <class Work>
  bool unless_stopped(const Work& work);
  void abandon_instant();
  void remember_between();
  void run_to(const std::optional<Rational>& target);
  void run_failures(const Rational* stop, bool inclusive);
  bool stop_early();
  void stop_between();
  void note_peak();
  // simulator_changes.cpp
  void plan_changes();
  int degree_read(const Trajectory& trajectory) const;
  void check_trajectory(const Trajectory& trajectory) const;
  // The same of a motion from outside.
  void check_given(const Trajectory& trajectory) const;
  void queue_change(Change change);
  const Rational* next_change() const {
    return next_change_ < changes_.size() ? &changes_[next_change_].t : nullptr;
  }
  void make_changes();
  void change_instant();
  void put_in_force(ObjectId object, const Trajectory& trajectory,
                    const std::optional<Rational>& until);
  void apply_updates(const std::vector<Change>& updates);
  void apply_erasures(const std::vector<ObjectId>& objects);
  void apply_insertions(const std::vector<Change>& insertions);
  // simulator_audit.cpp
  void violation(StructureId id, const std::string& what);
  void audit_certificates();
  bool certificates_hold(const Snapshot& positions) const;
  std::optional<Rational> rational_after_now();
  std::optional<Rational> time_between();
  std::optional<Rational> audit_time();
  bool run_audit(bool certificates);
  void audit_reports(StructureId id, AuditReport& report);

  const Scene& scene_;
  SimulatorOptions options_;
  std::unique_ptr<Deadline> deadline_;
  Scheduler kernel_;
  std::vector<Entry> entries_;
  EventSink* sink_ = nullptr;
  bool sink_timed_ = true;
  std::vector<Change> changes_;  // ascending in (t, kind, object) from next_change_ on
  std::size_t next_change_ = 0;
  std::vector<bool> alive_;
  std::vector<int> pieces_;
  int degree_ = 0;  // of all motions, without weights that no structure reads
  bool dynamic_ = false;
  bool started_ = false;
  Rational reached_;
  // the present instant
  bool at_failure_instant_ = false;  // now is the instant of a failure (not only a rational time)
  double now_hi_ = 0;                // now <= now_hi_
  int order_to_now_ = 0;             // of the first failure, from the last fails_now()
  std::vector<std::uint64_t> failures_at_instant_;
  std::vector<InstantCounts> before_instant_;    // of structures with failures at it
  std::vector<ReportedEvent> events_at_instant_;
  Rational reached_before_instant_;
  std::optional<Rational> between_;  // see remember_between()
  bool in_instant_ = false;
  bool is_broken_ = false;
  bool out_of_memory_ = false;
  double settled_hi_ = 0;  // the last finished instant is <= settled_hi_
  double next_lo_ = 0;     // the instant after it, a failure or a present change, is >= next_lo_
  std::vector<std::uint64_t> repairs_;  // since the guard was last reset
  std::vector<std::uint8_t> guard_fired_;
  int rounds_ = 0;  // in which the present instant has been settled; outside of settle() 0
  std::vector<StructureId> touched_;  // structures with failures at the instant
  double guard_window_end_ = 0;       // inexact arithmetics
  double span_ = 1;                   // length of the scene in time, for that window
  std::vector<CertificateId> first_instant_;
  std::vector<Notice> notices_;
  RunLedger ledger_;
  std::vector<std::string> violations_;
  RunClock clock_;
  std::uint64_t next_look_ = 0;  // amount of work at which progress is reported next
  std::uint64_t next_peak_ = 0;  // ... at which the bytes in use are counted next
  RunStatus status_ = RunStatus::kDone;
};

}  // namespace kinex

#endif
