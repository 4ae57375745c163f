// SPDX-License-Identifier: GPL-3.0-or-later
// SeparationProof: how a structure for collisions proves that two bodies are apart. All else is the
// same in all of them: collision_pairs.h.
#ifndef KINEX_STRUCTURES_COLLISION_SEPARATION_PROOF_H
#define KINEX_STRUCTURES_COLLISION_SEPARATION_PROOF_H

#include <cstdint>
#include <optional>
#include <vector>

#include "core/arithmetic/touch.h"
#include "core/engine/audit.h"
#include "core/engine/bound.h"
#include "core/engine/proof.h"
#include "structures/collision/pair_table.h"

namespace kinex {

// The ranks of the kinds of events of every structure for collisions; those of its proof follow.
//   contact, graze, separation  the two bodies and the features that meet, as derived objects:
//                    "a.v3" is vertex 3 of body a, "a.e3" the edge from it to the next (counted
//                    from 0 in the scene's order). In an exact arithmetic they depend on the
//                    motion alone: two vertices if these meet, else a vertex and an edge
//   inside           the pair gets another overlap proof, with another edge ahead
//   volume           the pair gets another one-certificate proof by volumes, or loses it
//   grid             a body enters another cell
//   overlap          two bodies overlap without having come into contact: one of them is new (or
//                    an inexact arithmetic has missed the contact)
struct CollisionEvent {
  enum Kind : std::uint8_t {
    kContact,
    kGraze,
    kSeparation,
    kInside,
    kVolume,
    kGrid,
    kOverlap,
    kFirstOwn,  // the first kind of the proof
  };
};

class SeparationProof {
 public:
  using Edge = SumBoundary::Edge;
  using Roles = PairTable::Roles;
  // What a repair has come to: an event of the pair, of this kind, or a contact of the bodies, by
  // features near those that meet. Neither: it has been reported already.
  struct Repair {
    std::optional<std::uint8_t> event;
    std::optional<Features> contact;

    static Repair changed(std::uint8_t kind) { return {kind, {}}; }
    static Repair met(const Features& near) { return {{}, near}; }
  };

  virtual ~SeparationProof() = default;

  // Makes a proof for this pair right after now, in the table; false if the bodies are not disjoint
  // there. `left`: the edge of M, the Minkowski sum, across which they have just separated; nullptr:
  // the bodies may be anywhere.
  virtual bool start(PairId p, const Edge* left) = 0;
  // The certificate of this slot is negative right after now: repairs the proof.
  virtual Repair repair(PairId p, std::uint32_t slot) = 0;
  // The features by which the bodies touch right after now, or at now; nullopt: they do not touch.
  // Requires that the proof holds right after now.
  virtual std::optional<Features> touch(PairId p, When when) = 0;
  // The motion of one of the two bodies has changed.
  virtual void moved(PairId) {}

  // As PairTable::describe_volumes, for visit_proof.
  virtual Roles describe(PairId p, ProofGroup& group) const = 0;
  // The largest number of certificates of a pair between events.
  virtual std::uint32_t most_certificates() const = 0;
  // A failure has been handled, by this many signs of the predicates on poses. For proofs that bound
  // them (CollisionMethod::counts_signs).
  virtual void handled(std::uint64_t signs) { static_cast<void>(signs); }
  virtual void add_bounds(const BoundContext&, std::vector<BoundCheck>&) const {}
  virtual void audit(const Snapshot&, AuditReport&) const {}
  virtual std::size_t bytes() const = 0;
};

}  // namespace kinex

#endif
