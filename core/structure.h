// SPDX-License-Identifier: GPL-3.0-or-later
// Structure: a kinetic data structure. Pure combinatorics: it asks a Kernel for signs and
// certificates and never sees a coordinate, a polynomial or a time.
#ifndef KINEX_CORE_STRUCTURE_H
#define KINEX_CORE_STRUCTURE_H

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/audit.h"
#include "core/bound.h"
#include "core/certificate.h"
#include "core/event.h"

namespace kinex {

// The value of a configuration function.
struct Attribute {
  enum class Shape {
    kSequence,  // ids in order
    kObject,    // one id (none if there is no object)
    kEdges,     // id pairs, flattened; smaller id first in a pair, pairs sorted
    kCycle,     // ids counter-clockwise, starting at the smallest id
  };
  Shape shape = Shape::kSequence;
  std::vector<ObjectId> ids;
  friend bool operator==(const Attribute&, const Attribute&) = default;
};

// Events that every structure has: they come last in its event_kinds(), in this order. The first
// three name the object and are never external. "settled" and "rebuild" name no object, carry the
// difference that they make to the attribute (Event::gone, Event::came), and are external, and
// counted as processed, if there is one. A "settled" without a difference is not reported.
//
// Replaying a structure's external events, its insertions and its erasures gives its attribute
// right after every instant. (An insertion or erasure changes the attribute as the object's coming
// or going does right after the instant.)
enum class CommonEvent : std::uint8_t { kMotion, kInsert, kErase, kSettled, kRebuild };
inline constexpr std::size_t kCommonEvents = 5;
// `own` followed by "motion", "insert", "erase", "settled", "rebuild".
std::vector<std::string_view> common_event_kinds(std::vector<std::string_view> own);

// What leads from one attribute to another, as Event::gone and Event::came give it.
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
  // Throws the proof away (its certificates are retracted) and builds it anew right after now. The
  // caller reports the difference to told(); nothing is left to be told.
  virtual void rebuild() = 0;
  // `failed` is negative right after now and out of the queue, but still readable. The structure
  // repairs its state, reports one event (Kernel::report), and may retract or replace `failed`; if
  // it does neither, the kernel retracts it on return.
  virtual void certificate_failed(CertificateId failed) = 0;
  virtual void insert(ObjectId object) = 0;
  virtual void erase(ObjectId object) = 0;
  // The motions of these objects have changed at now (positions did not jump); all their
  // certificates have been rescheduled, those that are negative right after now fail next.
  virtual void motions_changed(std::span<const ObjectId>) {}
  // All certificates are non-negative right after now, after an instant at which two or more failed
  // or motions changed. A place to check what single failures cannot break.
  virtual void instant_settled() {}
  // After instant_settled, when nothing is left to be repaired at the instant (and once more after
  // its erasures, and after its insertions): the place to report what has changed at the instant
  // and has not been told yet (Kernel::report_settled). Nothing else may change.
  virtual void instant_over() {}
  // A structure it watches changed its attribute (`event` is external), or gained or lost an object
  // or was rebuilt (nullptr). Called when the watched structure has done its work; at the start and
  // when objects come or go, the watched structure is built, told or repaired before those that
  // watch it.
  virtual void watched_changed(const Event* event) { (void)event; }

  // The largest degree of motion that it can maintain.
  virtual int largest_motion_degree() const { return std::numeric_limits<int>::max(); }

  virtual Attribute attribute() const = 0;
  // The attribute as external events have told it so far. In the midst of an instant this is not
  // attribute() for a structure that reports changes when the instant is over.
  virtual Attribute told() const { return attribute(); }
  virtual std::vector<BoundCheck> bounds(const BoundContext& context) const = 0;
  // In an inexact arithmetic: how many repairs at one instant, beyond 1000 + 8 c for c
  // certificates, it may make before it is taken to be going round in circles. By default as many
  // as in an exact one, c^2; a structure that needs far fewer even at degenerate instants says so.
  virtual std::uint64_t most_repairs(std::uint64_t certificates) const {
    return certificates * certificates;
  }
  // Cheap and combinatorial: links, counts, order of its own state.
  virtual void check_invariants(AuditReport& report) const = 0;
  // Compares the attribute with an independent static computation on exact positions at a rational
  // time at which all its certificates hold.
  virtual void audit(const Snapshot& snapshot, AuditReport& report) const = 0;
  // For audits: false if its proof, certificates aside, leaves doubts at these positions: where two
  // objects only touch, or after the scene's end, up to which a proof may have been made. Another
  // time is looked for then. For a proof that rests on more than certificates.
  virtual bool holds_at(const Snapshot& snapshot) const {
    static_cast<void>(snapshot);
    return true;
  }
  // Bytes of its own state, certificates not counted.
  virtual std::size_t bytes() const = 0;
};

}  // namespace kinex

#endif
