// SPDX-License-Identifier: GPL-3.0-or-later
// Simulator: runs structures over one scene, from instant to instant.
#ifndef KINEX_CORE_SIMULATOR_H
#define KINEX_CORE_SIMULATOR_H

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/audit.h"
#include "core/bound.h"
#include "core/kernel.h"
#include "core/scene.h"
#include "core/structure.h"

namespace kinex {

enum class AuditLevel {
  kNone,
  kEnd,     // one full audit at the end of the run
  kEvents,  // invariants and certificates after every instant, a full audit between every two instants
};

struct SimulatorOptions {
  AuditLevel audit = AuditLevel::kEnd;
  std::uint64_t max_events = 0;  // stop with kLimit after so many failures; 0: no limit
  double max_seconds = 0;        // likewise; 0: no limit
  // Called about every 4096 failures; return false to stop with kInterrupted.
  std::function<bool(const class Simulator&)> progress;
};

enum class RunStatus { kDone, kLimit, kInterrupted };

class Simulator final : private EventReporter {
 public:
  // Keeps a reference to the scene, which must outlive it.
  Simulator(const Scene& scene, std::unique_ptr<Arithmetic> arithmetic, SimulatorOptions options = {});
  ~Simulator() override;

  Kernel& kernel() { return kernel_; }
  const Kernel& kernel() const { return kernel_; }
  const Scene& scene() const { return scene_; }

  // Reserves the id that a structure is constructed with; then hand the structure over.
  StructureId reserve() { return kernel_.add_structure(); }
  // `watches`: ids of structures whose external events it is told of.
  void add(StructureId id, std::unique_ptr<Structure> structure, std::string label,
           std::vector<StructureId> watches = {});
  std::size_t structures() const { return entries_.size(); }
  Structure& structure(StructureId id) { return *entries_[id].structure; }
  const Structure& structure(StructureId id) const { return *entries_[id].structure; }
  const std::string& label(StructureId id) const { return entries_[id].label; }

  void set_sink(EventSink* sink) { sink_ = sink; }

  // Sets the motions in force right after the scene's start and builds every structure.
  void start();
  // Handles all flight-plan changes and failures at instants <= t (at all instants if nullopt); then
  // now = t. Can be called again with later times; t before now throws std::invalid_argument.
  RunStatus run_until(const std::optional<Rational>& t);
  // The full audit at a rational time right after now; adds to the ledgers. True if nothing is wrong.
  bool audit();

  // ---- changes from outside, at a rational instant t >= the time run so far ---------------------
  // A flight-plan change; the position must be continuous at t, or the object is erased and inserted.
  void schedule_update(const Rational& t, ObjectId object, Trajectory trajectory);
  // The object appears with this motion; it must not be alive then.
  void schedule_insertion(const Rational& t, ObjectId object, Trajectory trajectory);
  void schedule_erasure(const Rational& t, ObjectId object);

  // The exact time the run has reached (the last t of run_until, or the last flight-plan instant).
  const Rational& reached() const { return reached_; }
  bool alive(ObjectId object) const { return alive_[object]; }
  Snapshot snapshot(const Rational& t) const;
  const RunLedger& ledger() const { return ledger_; }
  // Hard bounds of one structure for what has been run.
  std::vector<BoundCheck> bounds(StructureId id) const;
  // Violations found so far, for people (at most kMaxMessages are kept).
  static constexpr std::size_t kMaxMessages = 100;
  const std::vector<std::string>& violations() const { return violations_; }
  double seconds_setup() const { return seconds_setup_; }
  double seconds_simulate() const { return seconds_simulate_; }
  double seconds_audit() const { return seconds_audit_; }

 private:
  struct Entry {
    std::unique_ptr<Structure> structure;
    std::string label;
    std::vector<StructureId> watchers;
  };
  struct Change {
    enum class Kind { kUpdate, kErase, kInsert };
    Rational t;
    Kind kind;
    ObjectId object;
    Trajectory trajectory;
    std::optional<Rational> until;
  };

  void reported(const Event& event) override;
  void plan_changes();
  void queue_change(Change change);
  void apply_changes(const Rational& t);
  void handle_failure();
  void settle_instant();
  void report_change(StructureId id, std::uint8_t kind, ObjectId object);
  void audit_between();
  void full_audit(const Rational& t);
  void after_corruption();
  void note_peak();

  const Scene& scene_;
  SimulatorOptions options_;
  Kernel kernel_;
  std::vector<Entry> entries_;
  EventSink* sink_ = nullptr;
  std::vector<Change> changes_;  // ascending in (t, kind, object) from next_change_ on
  std::size_t next_change_ = 0;
  std::vector<bool> alive_;
  std::vector<Trajectory> trajectory_;  // in force
  std::vector<int> pieces_;
  bool dynamic_ = false;
  bool started_ = false;
  Rational reached_;
  // the present instant
  bool at_failure_instant_ = false;  // now is the instant of a failure (not only a rational time)
  std::vector<std::uint64_t> failures_at_instant_;
  std::uint64_t repairs_at_instant_ = 0;
  bool motions_changed_at_instant_ = false;
  RunLedger ledger_;
  std::vector<std::string> violations_;
  double seconds_setup_ = 0, seconds_simulate_ = 0, seconds_audit_ = 0;
};

}  // namespace kinex

#endif
