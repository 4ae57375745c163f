// SPDX-License-Identifier: GPL-3.0-or-later
// RecordedRun: a run as data: every event with its certificate and instant, and the attribute of
// every structure and its proof after each of them. Nothing is recomputed: all data come from the
// run.
#ifndef KINEX_EXPERIMENTS_VIEW_RECORDED_RUN_H
#define KINEX_EXPERIMENTS_VIEW_RECORDED_RUN_H

#include <cstdint>
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

namespace kinex::view {

struct RecordedInstant {
  InstantName name;              // in every detail
  std::optional<Rational> near;  // a number near it, for drawing; nullopt: not finite
};

struct RecordedEvent {
  Event event;              // without its reason
  std::string reason;       // of a rebuild
  std::size_t instant = 0;  // index into RecordedRun::instants
  // The certificate's polynomial under the motions in force, primitive; zero if it is `sign` times
  // that of the instant, or if there is no certificate.
  Polynomial polynomial;
  int sign = 0;
  std::optional<StagesUsed> stages;
};

struct RecordedStructure {
  std::string label, name;
  Key key;
  bool has_key = false;
  std::vector<std::string> kinds;
  Attribute initial;                     // before the first recorded event
  std::vector<AttributeChange> changes;  // ascending in `event`
  // Corrupt in an inexact arithmetic after this many events: no attribute from then on.
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
  std::string stopped;       // the reason if it is not complete
  std::vector<Event> all;    // every event from the start of the run on, recorded or not
  std::vector<RecordedEvent> events;
  std::vector<RecordedInstant> instants;
  std::vector<RecordedStructure> structures;
  std::vector<std::string> predicates;  // by PredicateId
  std::vector<ClaimForm> forms;         // likewise
  // Derived objects that the record names; their ids are counted on from those of the scene.
  std::size_t objects = 0;  // of the scene
  std::vector<RecordedThing> things;
  std::vector<RecordedClaim> claims;
  std::string digest;  // of `all`, as an event log has it
};

// The attribute of a structure after event `event` (numbered from 1 in the whole run, at least
// run.before); nullopt where it is corrupt. Replays the changes.
std::optional<Attribute> attribute_after(const RecordedStructure& structure, std::uint64_t event);

// Index (from 1) of the first event in which two runs of one scene differ, in structure, kind or
// ids; 0: they are equal, or one was stopped and is a prefix of the other.
std::uint64_t first_divergence(const RecordedRun& a, const RecordedRun& b);

}  // namespace kinex::view

#endif
