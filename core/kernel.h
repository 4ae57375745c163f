// SPDX-License-Identifier: GPL-3.0-or-later
// Kernel: the services of a structure: signs, certificates, and the report of events.
#ifndef KINEX_CORE_KERNEL_H
#define KINEX_CORE_KERNEL_H

#include <array>
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/arithmetic.h"
#include "core/certificate.h"
#include "core/derived_objects.h"
#include "core/event.h"
#include "core/event_queue.h"
#include "core/ledger.h"
#include "core/stop.h"

namespace kinex {

// How far ahead failure times are searched for. Most certificates are retracted long before they
// would fail, so it can pay to prove only that they hold for a window of a few typical lifetimes,
// then for one four times as long, and so on (section 10 of Guibas's report):
//
//   created       kLater             kLater                        failure time, never, ..
//   |--- window ---|---- 4 windows ----|------- 16 windows -------|
//
// The events are the same.
enum class Scheduling : std::uint8_t {
  kEager,  // the failure time is found at once
  kLazy,
};

class Kernel {
 public:
  Kernel(std::unique_ptr<Arithmetic> arithmetic, std::size_t objects,
         Scheduling scheduling = Scheduling::kLazy);

  // ---- for structures ------------------------------------------------------------------------
  PredicateId bind(std::shared_ptr<const Predicate> predicate);

  // Sign on (now, now + eps); kZero only if identically zero there. An object may occur twice.
  Sign sign_after(PredicateId predicate, std::initializer_list<ObjectId> ids) {
    poll();
    return arithmetic_->sign_after(Query(predicate, ids));
  }

  struct Created {
    CertificateId id;
    Outlook outlook;
  };
  // A new certificate "predicate(ids) >= 0" of `structure`; `tag` is at the structure's disposal.
  // It is scheduled if it fails by the horizon; one that is negative right after now fails next.
  // Throws RepeatedObject if the query names an object other than a constant twice; then nothing
  // has changed (use a predicate of fewer arguments). O(log queue) plus one failure time.
  Created create(StructureId structure, const Query& query, std::uint32_t tag);
  // Withdraws a certificate. O(log queue).
  void retract(CertificateId id);
  // Replaces the claim of a certificate (same id; counted as one retracted and one created). Throws
  // as create does.
  Outlook replace(CertificateId id, const Query& query, std::uint32_t tag);

  // ---- derived objects (scenes of bodies); ids beyond those of the scene -----------------------
  // An object made by `construction` from `bases`, which must exist. `name` is for logs.
  ObjectId derive(std::string name, std::shared_ptr<const Construction> construction,
                  std::span<const ObjectId> bases);
  // Gives a derived object other bases; no live certificate may contain it.
  void rederive(ObjectId derived, std::string name, std::span<const ObjectId> bases);
  // An object of constant coordinates, one per axis.
  ObjectId constant(std::string name, std::vector<Rational> coordinates);
  // Gives a constant other coordinates; no live certificate may contain it.
  void redefine(ObjectId constant, std::string name, std::vector<Rational> coordinates);
  const DerivedObjects& derived() const { return derived_; }

  const Query& query(CertificateId id) const { return queue_.certificate(id).query; }
  std::uint32_t tag(CertificateId id) const { return queue_.certificate(id).tag; }
  // Prefetches the memory of a certificate that will be replaced or retracted soon.
  void prefetch(CertificateId id) const { queue_.prefetch(id); }
  // The tag of a certificate of `structure` that probably fails soon (EventQueue::upcoming); else
  // kNoTag.
  static constexpr std::uint32_t kNoTag = 0xffffffffu;
  std::uint32_t upcoming_tag(StructureId structure, std::size_t i) const {
    const CertificateId id = queue_.upcoming(i);
    if (id == kNoCertificate || queue_.certificate(id).structure != structure) return kNoTag;
    return queue_.certificate(id).tag;
  }
  void set_tag(CertificateId id, std::uint32_t tag) { queue_.certificate(id).tag = tag; }
  Outlook outlook(CertificateId id) const { return queue_.certificate(id).outlook; }

  // One event per failure that is handled; further events of the same failure (ties put in order)
  // are logged too. `external`: the attribute changed. At most kMaxArity ids.
  void report(StructureId structure, std::uint8_t kind, std::initializer_list<ObjectId> ids,
              bool external) {
    report(structure, kind, ids, external, {}, {});
  }
  // The same with the change of the attribute (Event::gone, came), if the ids do not determine it.
  void report(StructureId structure, std::uint8_t kind, std::initializer_list<ObjectId> ids,
              bool external, std::span<const ObjectId> gone, std::span<const ObjectId> came);
  // The common event "settled": changes at this instant that no other external event has reported.
  // Without such changes nothing is reported. See Structure::instant_over.
  void report_settled(StructureId structure, std::span<const ObjectId> gone,
                      std::span<const ObjectId> came);
  // True while more than one certificate of `structure` fails at this instant, or motions changed
  // at it: the instant may be degenerate.
  bool instant_is_shared(StructureId structure) const;
  // The structure was rebuilt from its static algorithm at this instant, for this reason. Logged as
  // the common event "rebuild", external if the attribute changed; the structure's watchers are
  // notified when its present call has returned.
  void count_rebuild(StructureId structure, const std::string& reason,
                     std::span<const ObjectId> gone = {}, std::span<const ObjectId> came = {});
  // An inexact arithmetic has led the structure into a state that exact answers cannot reach. The
  // structure's certificates are retracted; it is not called again. Throws std::logic_error in an
  // exact arithmetic, where this can only be a bug.
  void corrupt(StructureId structure, const std::string& what);
  bool is_exact() const { return arithmetic_->is_exact(); }
  // For long work of a structure without signs or certificates: throws Stopped if the run has to
  // stop (core/stop.h).
  void poll() {
    if (deadline_ != nullptr) deadline_->poll();
  }

  // ---- for the simulator ---------------------------------------------------------------------
  // The motion of an object of the scene from now on, and of those derived from it.
  void set_motion(ObjectId object, const Trajectory& trajectory,
                  const std::optional<Rational>& until);
  // It outlives the kernel.
  void set_deadline(Deadline* deadline) {
    deadline_ = deadline;
    arithmetic_->set_deadline(deadline);
  }
  // Before the first motion is set: objects will be derived.
  void keep_motions() { derived_.keep_motions(); }
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
  // ... and asks for its failure time again afterwards.
  void reschedule(CertificateId id) {
    queue_.remove(id);
    schedule(id);
  }
  // The number of live certificates of `structure` that `object` is in. O(1).
  std::uint32_t live_certificates(StructureId structure, ObjectId object) const {
    return live_per_object_[structure][object];
  }
  // All live certificates that `object`, which is no constant, is in. From the first call on an
  // index is kept.
  std::span<const CertificateId> certificates_of(ObjectId object);
  void set_instant_shared(StructureId structure, bool shared) { shared_[structure] = shared; }
  void clear_structure(StructureId structure);  // retracts all its certificates
  // Events are passed on to this function; see Simulator.
  void set_reporter(class EventReporter* reporter) { reporter_ = reporter; }
  const Event& last_event() const { return event_; }
  std::size_t bytes() const;

 private:
  // The window by the estimated lifetimes of a structure's certificates, and the next estimate.
  struct Window {
    double length;                // +infinity: unknown, no limit
    double rounder;               // added and subtracted, it leaves few bits of a number
    double since;                 // a double near the time of this estimate
    std::uint64_t retracted = 0;  // certificates retracted by then
    std::uint64_t next = 0;       // the number at which a new estimate is made
  };
  Outlook schedule(CertificateId id);
  Outlook enqueue(CertificateId id, Outlook outlook, const FailureTime& time);
  double limit_of(StructureId structure, int looks) const;
  void update_window(StructureId structure);
  // Before the certificate leaves: counts a failure time that was computed but not used.
  void count_unused(CertificateId id) {
    const Certificate& c = queue_.certificate(id);
    if (c.outlook == Outlook::kFails && queue_.queued(id)) ++ledgers_[c.structure]->failures_unused;
  }
  void make_room(ObjectId object);
  void count_created(StructureId structure, const Query& query);
  void count_retracted(StructureId structure, const Query& query);
  void count_replaced(StructureId structure, const Query& before, const Query& after);
  void count_external(StructureId structure);
  [[noreturn]] void refuse_repeated(StructureId structure, const Query& query) const;
  // Calls visit(object) for every object of the scene that the argument stands for: itself, or the
  // bases that it is derived from.
  template <class Visit>
  void each_base(ObjectId id, const Visit& visit) const {
    if (!derived_.is_derived(id)) return visit(id);
    for (const ObjectId base : derived_.object(id).bases) visit(base);
  }
  void note_live(StructureId structure, ObjectId object);
  // A count below the maximum cannot exceed it later without passing through here.
  void note_or_defer(StructureId structure, ObjectId object) {
    const StructureLedger& ledger = *ledgers_[structure];
    if (ledger.live <= ledger.max_live &&
        live_per_object_[structure][object] <= ledger.max_per_object) {
      return;
    }
    if (deferred_) {
      touched_.emplace_back(structure, object);
    } else {
      note_live(structure, object);
    }
  }
  void index_add(CertificateId id);
  void index_remove(CertificateId id);

  std::unique_ptr<Arithmetic> arithmetic_;
  Deadline* deadline_ = nullptr;
  EventQueue queue_;
  std::vector<std::unique_ptr<StructureLedger>> ledgers_;  // references stay valid
  // live_per_object_[structure][object]
  std::vector<std::vector<std::uint32_t>> live_per_object_;
  std::vector<std::uint8_t> shared_;
  Scheduling scheduling_;
  std::vector<Window> windows_;
  // index_[object]: its certificates in no particular, but reproducible, order;
  // index_position_[certificate][i]: the place of the certificate among those of its i-th object.
  std::vector<std::vector<CertificateId>> index_;
  std::vector<std::array<std::uint32_t, kMaxArity>> index_position_;
  bool indexed_ = false;
  std::size_t objects_;  // derived ones included
  DerivedObjects derived_;
  class EventReporter* reporter_ = nullptr;
  Event event_;
  // counts that have grown since begin_event or begin_change
  bool deferred_ = false;
  std::vector<std::pair<StructureId, ObjectId>> touched_;
  // the failure being handled
  CertificateId failing_ = kNoCertificate;
  StructureId failing_structure_ = 0;
  Query failing_query_;
  bool handling_ = false;
  bool event_external_ = false;
  std::uint64_t created_before_ = 0;
  std::uint64_t retracted_before_ = 0;
};

// Receives what structures report.
class EventReporter {
 public:
  virtual ~EventReporter() = default;
  virtual void reported(const Event& event) = 0;
  // The common events: `event` has all but its kind.
  virtual void settled(Event) {}
  virtual void rebuilt(Event) {}
};

}  // namespace kinex

#endif
