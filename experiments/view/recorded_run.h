// SPDX-License-Identifier: GPL-3.0-or-later
// RecordedRun: a run as data: every event with its certificate and instant, and every structure's
// attribute and proof after each event. Nothing is recomputed: all data come from the run.
#ifndef KINEX_EXPERIMENTS_VIEW_RECORDED_RUN_H
#define KINEX_EXPERIMENTS_VIEW_RECORDED_RUN_H

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/engine/event.h"
#include "core/numbers/instant_name.h"
#include "core/numbers/polynomial.h"
#include "core/numbers/rational.h"
#include "experiments/lab/scene_run.h"
#include "experiments/view/attribute_change.h"
#include "experiments/view/recorded_proof.h"
#include "experiments/view/stage_watch.h"
#include "structures/parts/query_trace.h"

namespace kinex::view {

struct RecordedInstant {
  InstantName name;              // in full detail (InstantDetail::kName)
  std::optional<Rational> near;  // a number near it, for drawing; nullopt: not finite
};

struct RecordedEvent {
  Event event;              // its `reason` is not set; see below
  std::string reason;       // of a rebuild; otherwise empty
  std::vector<ObjectId> gone,
      came;                 // Event::gone, Event::came of an external event without a certificate
  std::size_t instant = 0;  // index into RecordedRun::instants
  // The certificate's polynomial under the motions in force, primitive. If it is +1 or -1 times
  // that of the instant, `sign` is that factor and `polynomial` is zero; otherwise `sign` is 0.
  // Both are zero if there is no certificate.
  Polynomial polynomial;
  int sign = 0;
  std::optional<StagesUsed> stages;
};

// A query of the scene, answered by every structure that can show its work.
struct RecordedQuery {
  struct Answer {
    StructureId structure;
    std::vector<ObjectId> ids;  // ascending
    QueryTrace nodes;
    std::uint64_t looked_at = 0;  // QueryCounts::nodes, which counts more than those
  };
  BoxQuery query;
  std::vector<Answer> answers;
};

struct RecordedStructure {
  std::string label, name;
  std::string role;  // StructureInfo::role
  std::vector<std::vector<Rational>> directions;  // directions_of() the request
  std::vector<bool> members;  // by object, true for those that it is built from; empty: all
  ObjectId query = kNoObject;  // the object that it is about; none: it is about no single one
  Key key;
  bool has_key = false;
  std::vector<std::string> kinds;        // those that all structures have at the end
  std::vector<std::string> meanings;     // of the kinds, in words
  Attribute initial;                     // before the first recorded event
  std::vector<AttributeChange> changes;  // ascending in `event`
  // The number of events after which an inexact arithmetic had corrupted the structure: it has no
  // attribute from then on. nullopt: never.
  std::optional<std::uint64_t> corrupt_after;
  std::string corruption;
  RecordedProof proof;
};

struct RecordedRun {
  std::string arithmetic;
  bool exact = true;
  Rational start;            // of what is recorded
  std::uint64_t before = 0;  // events before it
  bool complete = true;      // recorded to the end of the scene
  std::string stopped;       // the reason why it is not complete
  std::vector<Event> all;    // every event from the start of the run on, recorded or not
  std::vector<RecordedEvent> events;
  std::vector<RecordedInstant> instants;
  std::vector<RecordedStructure> structures;
  std::vector<RecordedQuery> queries;   // ascending in time
  std::vector<std::string> predicates;  // by PredicateId
  std::vector<ClaimForm> forms;         // likewise; each lives as long as its predicate:
  std::vector<std::shared_ptr<const Predicate>> bound;
  std::size_t objects = 0;              // number of the scene's objects
  std::vector<RecordedThing> things;    // derived objects in the record; ids from `objects` on
  std::vector<RecordedClaim> claims;
  std::string digest;  // of `all`, as in an event log
};

// The attribute of a structure after event `event` (numbered from 1 in the whole run, at least
// run.before); nullopt where it is corrupt. Replays the changes.
std::optional<Attribute> attribute_after(const RecordedStructure& structure, std::uint64_t event);

// Index (from 1) of the first event whose structure, kind or ids differ between two runs of one
// scene; 0: the runs are equal, or one was stopped and is a prefix of the other.
std::uint64_t first_divergence(const RecordedRun& a, const RecordedRun& b);

}  // namespace kinex::view

#endif
