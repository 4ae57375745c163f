// SPDX-License-Identifier: GPL-3.0-or-later
// Scheduler: the services of the simulator, beyond those of structures (core/engine/kernel.h):
// motions, the queue and its arithmetic, ledgers, the beginning and the end of events. Structures
// never see it.
#ifndef KINEX_CORE_ENGINE_SCHEDULER_H
#define KINEX_CORE_ENGINE_SCHEDULER_H

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>

#include "core/engine/event_reporter.h"
#include "core/engine/kernel.h"

namespace kinex {

class Scheduler final : public Kernel {
 public:
  Scheduler(std::unique_ptr<Arithmetic> arithmetic, std::size_t objects,
            Scheduling scheduling = Scheduling::kLazy)
      : Kernel(std::move(arithmetic), objects, scheduling) {}

  // Sets the motion of an object of the scene from now on, and the motions of the objects derived from it.
  void set_motion(ObjectId object, const Trajectory& trajectory,
                  const std::optional<Rational>& until);
  // It outlives the kernel.
  void set_deadline(Deadline* deadline) {
    deadline_ = deadline;
    arithmetic_->set_deadline(deadline);
  }
  // The first in the queue is the end of a window: looks further.
  void look_further();
  Arithmetic& arithmetic() { return *arithmetic_; }
  const Arithmetic& arithmetic() const { return *arithmetic_; }
  EventQueue& queue() { return queue_; }
  const EventQueue& queue() const { return queue_; }
  StructureId add_structure();
  std::size_t structures() const { return ledgers_.size(); }
  StructureLedger& ledger(StructureId id) { return *ledgers_[id]; }
  const StructureLedger& ledger(StructureId id) const { return *ledgers_[id]; }
  // Starts counting one failure; ends it (retracting `failed` if it is still there).
  void begin_event(StructureId structure, CertificateId failed);
  void end_event();
  // Brackets any other call of a structure. The largest numbers of live certificates are taken
  // between such calls, not while a structure is in the middle of one.
  void begin_change() { deferred_ = true; }
  void end_change();
  // Takes a certificate out of the queue before the motions of its objects change...
  void unschedule(CertificateId id) { queue_.remove(id); }
  // ... and queues it again afterwards, by its new failure time.
  void reschedule(CertificateId id) {
    queue_.remove(id);
    schedule(id, queue_.query(id));
  }
  // The number of live certificates of `structure` that `object` is in. O(1).
  std::uint32_t live_certificates(StructureId structure, ObjectId object) const {
    return live_per_object_[structure][object];
  }
  // Structure::instant_settled is due if the instant is shared, until it has been called; and again
  // when the structure is marked anew (set_instant_shared, Kernel::settle_later).
  void set_instant_shared(StructureId structure, bool shared) {
    shared_[structure] = shared ? kDue : kNot;
  }
  bool settling_is_due(StructureId structure) const { return shared_[structure] == kDue; }
  void set_settled(StructureId structure) { shared_[structure] = kSettled; }
  // A new instant begins.
  void count_instant() { ++instant_number_; }
  using Kernel::clear_structure;
  // Events are passed on to this function; see Simulator.
  void set_reporter(EventReporter* reporter) { reporter_ = reporter; }
  const Event& last_event() const { return event_; }
  std::size_t bytes() const;

 private:
  enum Shared : std::uint8_t { kNot, kDue, kSettled };  // the values of shared_
};

}  // namespace kinex

#endif
