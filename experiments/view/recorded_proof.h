// SPDX-License-Identifier: GPL-3.0-or-later
// RecordedProof: the proof of a structure over a run as data: the live certificates and their
// groups after every event. The features of polygons behind the lines and points of a certificate
// are determined exactly, once, when the certificate is first seen.
#ifndef KINEX_EXPERIMENTS_VIEW_RECORDED_PROOF_H
#define KINEX_EXPERIMENTS_VIEW_RECORDED_PROOF_H

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/arithmetic/arithmetic.h"
#include "core/engine/proof.h"
#include "core/motion/scene.h"
#include "core/numbers/rational.h"
#include "experiments/view/frame_feature.h"

namespace kinex::view {

// A derived object of the run as first seen. An object that was redefined as another constant has
// another entry.
struct RecordedThing {
  std::string name;
  std::vector<Rational> coordinates;      // of a constant
  std::optional<PolygonFeature> feature;  // that it stands for
};

// A predicate and its arguments: objects of the scene, or beyond those places in
// RecordedRun::things.
struct RecordedClaim {
  PredicateId predicate = 0;
  std::vector<ObjectId> arguments;
  // By argument: the feature of a line or point on its polygon. Other arguments have none.
  std::vector<FrameFeature> features;
  friend bool operator==(const RecordedClaim&, const RecordedClaim&) = default;
};

// A certificate from when it comes to when it goes.
struct RecordedCertificate {
  std::uint32_t group = 0;  // number of the group
  std::uint32_t slot = 0;   // its place among the certificates of the group
  std::string_view role;
  std::uint32_t claim = 0;  // place in RecordedRun::claims
  // The run's knowledge of its failure at the last event at which it was live.
  Outlook outlook = Outlook::kNever;
  double time = 0;  // kFails: near the failure; kLater: it does not fail before
};

// The state of a group from one event on. Objects are numbered as those of claims.
struct RecordedGroup {
  std::uint32_t group = 0;
  ProofGroup state;
};

// The changes at an event: indices into RecordedProof::certificates (gone, came) and
// RecordedProof::groups (new states), and numbers of groups that ended.
struct ProofChange {
  std::uint64_t event = 0;
  std::vector<std::uint32_t> gone, came, states, ended;
  bool empty() const { return gone.empty() && came.empty() && states.empty() && ended.empty(); }
};

struct RecordedProof {
  std::vector<RecordedCertificate> certificates;  // in the order in which they came
  std::vector<RecordedGroup> groups;
  std::vector<ProofChange>
      changes;  // ascending in `event`; the first is what the record begins with
  std::optional<StructureId> reads;  // a structure whose proof this one relies on
  // The proof was too large to be followed beyond this event.
  std::optional<std::uint64_t> ends;
};

// The certificates of one group after event `event`, by slot, and its state; nullopt: there is no
// such group then. Replays the changes.
struct GroupProof {
  std::vector<std::uint32_t> claims;  // places in RecordedRun::claims
  ProofGroup state;
};
std::optional<GroupProof> group_after(const RecordedProof& proof, std::span<const ObjectId> about,
                                      std::uint64_t event);
// The places of all certificates that are live after event `event`, ascending.
std::vector<std::uint32_t> certificates_after(const RecordedProof& proof, std::uint64_t event);

}  // namespace kinex::view

#endif
