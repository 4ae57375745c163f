// SPDX-License-Identifier: GPL-3.0-or-later
// Structure: the interface of a kinetic data structure. It is purely combinatorial: it gets signs
// and certificates from a Kernel and never sees a coordinate, a polynomial or a time.
#ifndef KINEX_CORE_ENGINE_STRUCTURE_H
#define KINEX_CORE_ENGINE_STRUCTURE_H

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/engine/audit.h"
#include "core/engine/bound.h"
#include "core/engine/certificate.h"
#include "core/engine/event.h"
#include "core/engine/proof.h"

namespace kinex {

// The value of a configuration function: discrete, and constant between two events. The shapes are
// few and generic, so that logs, summaries and viewers handle a shape and know no structure.
//
//   a tree             is a set of edges, kTuples: it is unrooted, and a root or an order of
//                      children would be no part of the attribute
//   faces              of a triangulation are a set of tuples, too; faces of different sizes have
//                      no shape, since no structure maintains them
//   a length, an area  is no attribute, since it changes at all times; its value at a time follows
//                      from the ids and the exact positions then
struct Attribute {
  enum class Shape {
    kSequence,  // ids in order
    kObject,    // one id (none if there is no object)
    kTuples,    // a set of tuples of `width` ids, flattened: edges, triangles, tetrahedra; ids
                // ascend in a tuple, tuples ascend
    kCycle,     // ids counter-clockwise, starting at the smallest id
    kOrders,    // n + 1 rows of n ids: an order of all n, then for each, ascending, the id itself
                // and an order of the others
  };
  Shape shape = Shape::kSequence;
  std::vector<ObjectId> ids;
  std::uint8_t width = 2;  // kTuples
  friend bool operator==(const Attribute&, const Attribute&) = default;
};

// kOrders: the number n of ids in a row. O(log n).
std::size_t width_of_orders(const Attribute& attribute);

// Events that every structure has: they come last in its event_kinds(), in this order.
//   motion, insert, erase  name the object and are never external
//   settled, rebuild       name no object and carry the change of the attribute (Event::gone,
//                          Event::came); external, and counted as processed, if there is a change.
//                          A "settled" without a change is not reported.
//
// Replaying a structure's external events, insertions and erasures gives its attribute right after
// every instant. (An insertion or erasure changes the attribute as the object's appearance or
// disappearance does right after the instant.)
enum class CommonEvent : std::uint8_t { kMotion, kInsert, kErase, kSettled, kRebuild };
inline constexpr std::size_t kCommonEvents = 5;  // the number of them
// `own` followed by "motion", "insert", "erase", "settled", "rebuild".
std::vector<std::string_view> common_event_kinds(std::vector<std::string_view> own);

// The change from one attribute to another, in the form of Event::gone and Event::came.
struct AttributeDifference {
  std::vector<ObjectId> gone, came;
};
AttributeDifference difference_between(const Attribute& before, const Attribute& after);

class Structure {
 public:
  virtual ~Structure() = default;

  // The registered name ("delaunay_2").
  virtual std::string_view name() const = 0;
  // Names of its events, by rank; Event::kind indexes this list. Ends with the common ones: return
  // common_event_kinds({"swap"}).
  virtual std::vector<std::string_view> event_kinds() const = 0;

  // Builds the proof for these objects (ascending ids), right after now.
  virtual void build(std::span<const ObjectId> objects) = 0;
  // Discards the proof (its certificates are retracted) and builds it anew right after now. The
  // caller reports the change of the attribute since told(); nothing is then left to be reported.
  virtual void rebuild() = 0;
  // `failed` is negative right after now and out of the queue, but still readable. The structure
  // repairs its state, reports one event (Kernel::report), and may retract or replace `failed`; if
  // it does neither, the kernel retracts it on return.
  virtual void certificate_failed(CertificateId failed) = 0;
  virtual void insert(ObjectId object) = 0;
  virtual void erase(ObjectId object) = 0;
  // The motions of these objects, ascending, have changed at now (positions did not jump). All their
  // certificates have been rescheduled; those that are negative right after now fail next.
  virtual void motions_changed(std::span<const ObjectId>) {}
  // All certificates are non-negative right after now, after an instant at which two or more failed
  // or motions changed. The place to check what no single failure can break.
  virtual void instant_settled() {}
  // After instant_settled, when nothing is left to be repaired at the instant (and again after its
  // erasures, and after its insertions): the place to report changes at the instant that have not
  // been reported yet (Kernel::report_settled). Nothing else may change.
  virtual void instant_over() {}
  // A watched structure changed its attribute (`event` is external), or gained or lost an object, was
  // rebuilt or changed within (nullptr; Kernel::report_changed_within). Called when the watched structure has done its work. At the start, and
  // when objects appear or disappear, a watched structure is built, notified or repaired before its
  // watchers.
  virtual void watched_changed(const Event* event) { (void)event; }

  // The largest degree of motion that it can maintain.
  virtual int largest_motion_degree() const { return std::numeric_limits<int>::max(); }
  // False: the structure is laid out for the flight plans of the scene, and no motion that is not in them can be
  // given to an object during the run (Simulator::schedule_update, schedule_insertion).
  virtual bool takes_other_plans() const { return true; }

  virtual Attribute attribute() const = 0;
  // The attribute as reported by external events so far. Within an instant it differs from
  // attribute() for a structure that reports changes when the instant is over.
  virtual Attribute told() const { return attribute(); }
  // Shows the proof: every live certificate once, in groups. Called between two calls of the
  // structure. Default: it has no certificates of its own.
  virtual void visit_proof(ProofVisitor& visitor) const { static_cast<void>(visitor); }
  virtual std::vector<BoundCheck> bounds(const BoundContext& context) const = 0;
  // Inexact arithmetics: the number of repairs at one instant, beyond 1000 + 8 c for c
  // certificates, after which the structure is considered to be cycling. Default: c^2, as in an
  // exact arithmetic; a structure that needs far fewer even at degenerate instants returns less.
  virtual std::uint64_t most_repairs(std::uint64_t certificates) const {
    return certificates * certificates;
  }
  // Cheap and combinatorial: links, counts, order of its own state.
  virtual void check_invariants(AuditReport& report) const = 0;
  // Compares the attribute with an independent static computation on exact positions at a rational
  // time at which all its certificates hold.
  virtual void audit(const Snapshot& snapshot, AuditReport& report) const = 0;
  // For audits, if the proof rests on more than certificates: false if that part is not certain at
  // these positions (two objects only touch, or the time is after the scene's end, up to which a
  // proof may have been made). Another time is then tried.
  virtual bool holds_at(const Snapshot& snapshot) const {
    static_cast<void>(snapshot);
    return true;
  }
  // Bytes of its own state, certificates not counted.
  virtual std::size_t bytes() const = 0;
};

}  // namespace kinex

#endif
