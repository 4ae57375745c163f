// SPDX-License-Identifier: GPL-3.0-or-later
// Kernel: the services of a structure: signs, certificates, and the report of events.
#ifndef KINEX_CORE_ENGINE_KERNEL_H
#define KINEX_CORE_ENGINE_KERNEL_H

#include <array>
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/arithmetic/arithmetic.h"
#include "core/arithmetic/foresight.h"
#include "core/arithmetic/touch.h"
#include "core/engine/certificate.h"
#include "core/engine/event.h"
#include "core/engine/event_queue.h"
#include "core/engine/event_reporter.h"
#include "core/engine/ledger.h"
#include "core/motion/derived_objects.h"
#include "core/numbers/coarse_time.h"
#include "core/numbers/instant_name.h"
#include "core/numbers/stop.h"

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
  Kernel(const Kernel&) = delete;
  Kernel& operator=(const Kernel&) = delete;

  PredicateId bind(std::shared_ptr<const Predicate> predicate);

  // Sign on (now, now + eps); kZero only if identically zero there. An object may occur twice.
  Sign sign_after(PredicateId predicate, std::initializer_list<ObjectId> ids) {
    poll();
    return arithmetic_->sign_after(Query(predicate, ids));
  }

  Sign sign_after(const Query& query) {
    poll();
    return arithmetic_->sign_after(query);
  }
  // Copies of motions, and many signs by them: as in Arithmetic.
  void fill(PredicateId predicate, std::span<const ObjectId> objects,
            CoordinateTable& table) const {
    arithmetic_->fill(predicate, objects, table);
  }
  void signs_after(PredicateId predicate, const CoordinateTable& table, std::size_t place,
                   std::span<const ObjectId> first, ObjectId second, Sign* signs) {
    poll();
    arithmetic_->signs_after(predicate, table, place, first, second, signs);
  }
  OutOfInterval out_of_interval(PredicateId predicate, const CoordinateTable& table,
                                std::size_t place, std::span<const ObjectId> first, ObjectId low,
                                ObjectId high) {
    poll();
    return arithmetic_->out_of_interval(predicate, table, place, first, low, high);
  }
  // The sign right after now, or at now itself. Only exact arithmetics have the sign at now; in
  // others kNow is the sign right after now.
  bool tells_sign_now() const { return sign_now_ != nullptr; }
  Sign sign(const Query& query, When when) {
    if (when == When::kNow && sign_now_ != nullptr) return sign_now_->sign_now(query);
    return sign_after(query);
  }
  // Certificates of the query's predicate fail at touches, too (core/arithmetic/touch.h).
  bool fails_at_touch(const Query& query) const {
    return arithmetic_->fails_at_touch(query.predicate);
  }
  // The number of signs of this predicate computed so far, for all callers together.
  std::uint64_t signs_asked(PredicateId predicate) const {
    std::uint64_t sum = 0;
    for (const std::uint64_t n : arithmetic_->counters().by_predicate[predicate].signs) sum += n;
    return sum;
  }
  // Queries at future instants, under the motions in force. No other query while the object lives.
  Foresight foresight() { return Foresight(*arithmetic_); }

  // A part of a structure has tags of its own, and a line in the structure's ledger that it keeps
  // itself. The reference stays valid. Throws std::invalid_argument for more than 255 parts.
  struct NewPart {
    PartId id;
    PartLedger& line;
  };
  NewPart add_part(StructureId structure, std::string name);

  struct Created {  // the result of create()
    CertificateId id;
    Outlook outlook;
  };
  // A new certificate "predicate(ids) >= 0" of `structure`; `tag` is at the disposal of its part.
  // It is scheduled if it fails by the horizon; one that is negative right after now fails next.
  // Throws RepeatedObject if the query names an object other than a constant twice; then nothing
  // has changed (use a predicate of fewer arguments). O(log queue) plus one failure time.
  Created create(StructureId structure, const Query& query, std::uint32_t tag, PartId part = 0);
  // Withdraws a certificate. O(log queue).
  void retract(CertificateId id);
  // Replaces the claim of a certificate (same id; counted as one retracted and one created). Throws
  // as create does.
  Outlook replace(CertificateId id, const Query& query, std::uint32_t tag);

  // Certificates of one structure that are replaced together.
  struct Group {
    static constexpr std::size_t kMost = Arithmetic::kMostInGroup;
    std::size_t size = 0;
    std::array<CertificateId, kMost> ids;
    std::array<Query, kMost> queries;
    std::array<std::uint32_t, kMost> tags;
    std::array<Outlook, kMost> outlooks;  // of those that have been replaced
  };
  // The same as replace() for one after the other, in less time: the arithmetic sees all of them at
  // once. Requires at least one certificate.
  void replace(Group& group);

  // ---- derived objects; ids beyond those of the scene ------------------------------------------
  // An object made by `construction` from `bases`, which must exist and may be derived, too. `name`
  // is for logs. Its kind must be among the needs that the arithmetic was made for (NumberNeeds):
  // throws std::logic_error if it has more axes than any of them.
  ObjectId derive(std::string name, std::shared_ptr<const Construction> construction,
                  std::span<const ObjectId> bases);
  // Gives a derived object other bases; no live certificate may contain it, or one derived from it.
  void rederive(ObjectId derived, std::string name, std::span<const ObjectId> bases);
  // An object of constant coordinates, one per axis.
  ObjectId constant(std::string name, std::vector<Rational> coordinates);
  // A constant that is only a name, for events.
  ObjectId named(std::string name) { return constant(std::move(name), {Rational()}); }
  // An object that stands for a feature of a polygon in events and is in no certificate.
  ObjectId feature(std::string name, const PolygonFeature& feature);
  // Gives a constant other coordinates; no live certificate may contain it, or one derived from it.
  void redefine(ObjectId constant, std::string name, std::vector<Rational> coordinates);
  const DerivedObjects& derived() const { return derived_; }
  // The degree in t of the motion in force, on the axes [first, last): 0 if they do not change.
  int motion_degree(ObjectId object, int first, int last) const {
    return derived_.trajectory(object).degree_of_axes(first, last);
  }

  Query query(CertificateId id) const { return queue_.query(id); }
  // query(id) == query, for less than a copy.
  bool claims(CertificateId id, const Query& query) const { return queue_.claims(id, query); }
  std::uint32_t tag(CertificateId id) const { return queue_.certificate(id).tag; }
  StructureId structure_of(CertificateId id) const { return queue_.certificate(id).structure; }
  PartId part(CertificateId id) const { return queue_.certificate(id).part; }
  // Prefetches the memory of a certificate that will be replaced or retracted soon.
  void prefetch(CertificateId id) const { queue_.prefetch(id); }
  // The same for what its replacement touches beside it. In small runs all of it is near anyway.
  void prefetch_neighbours(CertificateId id) const {
    if (objects_ >= kManyObjects) queue_.prefetch_neighbours(id);
  }
  // Prefetches what is kept for objects whose certificates of `structure` will be made or withdrawn
  // soon. Objects of few scenes are near anyway: nothing is done for them.
  void prefetch(StructureId structure, std::span<const ObjectId> objects) const {
    if (objects_ < kManyObjects) return;
    arithmetic_->prefetch(objects);
    const std::uint32_t* const live = live_per_object_[structure].data();
    for (const ObjectId object : objects) __builtin_prefetch(live + object, 1);
  }
  // A certificate that probably fails soon (EventQueue::upcoming), if it is one of `structure`; else
  // kNoCertificate.
  CertificateId upcoming(StructureId structure, std::size_t i) const {
    const CertificateId id = queue_.upcoming(i);
    if (id == kNoCertificate || queue_.certificate(id).structure != structure) {
      return kNoCertificate;
    }
    return id;
  }
  void set_tag(CertificateId id, std::uint32_t tag) { queue_.certificate(id).tag = tag; }
  // All live certificates, of any structure, with `object` as an argument. Requires that it is no
  // constant. The first call builds an index, which is kept up to date from then on.
  std::span<const CertificateId> certificates_of(ObjectId object);
  Outlook outlook(CertificateId id) const { return queue_.certificate(id).outlook; }

  // One event per failure that is handled; further events of the same failure (ties resolved) are
  // logged too. `external`: the attribute changed. At most kMaxArity ids.
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
  // The structure has changed, but not its attribute: its watchers, which may read more of it than
  // that, are notified as of a rebuild when its present call has returned.
  void report_changed_within(StructureId structure);
  // True while more than one certificate of `structure` fails at this instant, or motions changed
  // at it, or the structure called settle_later: the instant may be degenerate.
  bool instant_is_shared(StructureId structure) const;
  // Requests Structure::instant_settled and instant_over at this instant, as if it were shared.
  void settle_later(StructureId structure) { shared_[structure] = 1; }
  // A certificate, of whatever structure, is negative right after now: more is to be repaired at
  // this instant. (Those of one instant fail by structure, in the order of their ids.)
  bool failure_is_due() const {
    return !queue_.empty() && queue_.certificate(queue_.top()).outlook == Outlook::kFailsNow;
  }
  // For a structure that has repaired a failure: no other certificate of `structure` fails at this
  // instant, and none is due, so that what holds now holds right after it. If false the instant may
  // go on: Structure::instant_over follows where it is shared, or after settle_later.
  bool instant_is_over(StructureId structure) const {
    return !instant_is_shared(structure) && !failure_is_due();
  }
  // Counts certificates that may be zero at now (Arithmetic::possible_zeros).
  std::uint64_t possible_zeros() const { return arithmetic_->possible_zeros(); }
  // The number of the present instant in the run, from 1.
  std::uint64_t instant_number() const { return instant_number_; }
  // A time near now that is the same in every exact arithmetic (Arithmetic::now_rounded), for
  // choices that any time near now would serve.
  CoarseTime coarse_now() { return CoarseTime(arithmetic_->now_rounded()); }
  // The present instant, for reports and messages (time_text). Valid until now moves.
  const InstantName& now() { return arithmetic_->name_now(InstantDetail::kName); }
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
  // stop (core/numbers/stop.h).
  void poll() {
    if (deadline_ != nullptr) deadline_->poll();
  }

 protected:
  static constexpr std::size_t kManyObjects = 8192;  // their motions exceed the nearest caches
  // Further examinations of a certificate beyond its first window; the last one has no end.
  static constexpr int kMostLooks = 6;

  // Runs own a Scheduler (core/engine/scheduler.h), which is one of these.
  Kernel(std::unique_ptr<Arithmetic> arithmetic, std::size_t objects, Scheduling scheduling);
  ~Kernel() = default;

  // The window by the estimated lifetimes of a structure's certificates, and the next estimate.
  struct Window {
    double length;                // +infinity: unknown, no limit
    double rounder;               // added and subtracted, it leaves few bits of a number
    double since;                 // a double near the time of this estimate
    std::uint64_t retracted = 0;  // certificates retracted by then
    std::uint64_t next = 0;       // the number at which a new estimate is made
  };
  Outlook schedule(CertificateId id, const Query& query);
  // The certificate claims something else from now on, and is to be scheduled. Throws as create does.
  void check_replacement(CertificateId id, const Query& query) const;
  void exchange(CertificateId id, const Query& query, std::uint32_t tag);
  void clear_structure(StructureId structure);  // retracts all its certificates
  Outlook enqueue(CertificateId id, Outlook outlook, const FailureTime& time);
  double limit_of(StructureId structure, int looks) const;
  void update_window(StructureId structure);
  // Before the certificate leaves: counts a failure time that was computed but not used.
  void count_unused(CertificateId id) {
    const Certificate& c = queue_.certificate(id);
    if (c.outlook == Outlook::kFails && queue_.queued(id)) ++ledgers_[c.structure]->failures_unused;
  }
  ObjectId add_constant(std::string name, std::vector<Rational> coordinates,
                        const std::optional<PolygonFeature>& feature);
  void make_room(ObjectId object);
  // The arithmetic gets the motion of a derived object, or of all those that depend on one.
  void hold(const DerivedObjects::Object& object, ObjectId id);
  void renew_dependents(ObjectId object);
  void count_created(StructureId structure, const Query& query);
  void count_retracted(const Certificate& certificate);
  void count_replaced(const Certificate& before, const Query& after);
  bool count_together(const Group& group);
  template <std::size_t kArguments>
  bool count_together(const Group& group, StructureId structure);
  void count_external(StructureId structure);
  [[noreturn]] void refuse_repeated(StructureId structure, const Query& query) const;
  // Calls visit(object) once for every object of the scene that the arguments stand for: the
  // arguments themselves, or the objects that they are derived from.
  template <class Visit>
  void each_object(const Query& query, const Visit& visit) {
    if (derived_.size() == 0) {
      for (std::size_t i = 0; i < query.arity; ++i) visit(query.ids[i]);
    } else {
      for (const ObjectId object : objects_of(query)) visit(object);
    }
  }
  // Likewise, ascending; valid until the next call, or until an object is derived.
  std::span<const ObjectId> objects_of(const Query& query);
  void note_live(StructureId structure, ObjectId object);
  // A count below the maximum cannot exceed it later without passing through here. For every object
  // whose count has grown, if it or that of the structure is beyond its maximum.
  void note_or_defer(StructureId structure, ObjectId object) {
    if (deferred_) {
      touched_.emplace_back(structure, object);
    } else {
      note_live(structure, object);
    }
  }
  void index_add(CertificateId id);
  void make_room_in_index(std::size_t arity);
  std::uint32_t& place_in_index(CertificateId id, std::size_t i) {
    return index_places_[id * index_arity_ + i];
  }
  void index_remove(CertificateId id);

  std::unique_ptr<Arithmetic> arithmetic_;
  SignNow* sign_now_;  // the arithmetic, if it can tell
  Deadline* deadline_ = nullptr;
  EventQueue queue_;
  std::vector<std::unique_ptr<StructureLedger>> ledgers_;  // references stay valid
  // live_per_object_[structure][object]
  std::vector<std::vector<std::uint32_t>> live_per_object_;
  std::vector<std::uint8_t> shared_;
  Scheduling scheduling_;
  std::vector<Window> windows_;
  // index_[object]: its certificates in no particular, but reproducible, order;
  // place_in_index(certificate, i): the place of the certificate among those of its i-th object.
  std::vector<std::vector<CertificateId>> index_;
  std::vector<std::uint32_t> index_places_;
  std::size_t index_arity_ = 0;  // places reserved for each certificate
  bool indexed_ = false;
  std::size_t objects_;  // derived ones included
  DerivedObjects derived_;
  std::vector<ObjectId> objects_of_query_;
  Arithmetic::GroupAnswers answers_;  // of replace(): kept, since a new one would be filled with zeros
  EventReporter* reporter_ = nullptr;
  std::uint64_t instant_number_ = 0;
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

}  // namespace kinex

#endif
