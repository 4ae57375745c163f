// SPDX-License-Identifier: GPL-3.0-or-later
// DiscClaims: pairs of discs, each with a certificate that it meets, or that it is apart. A part of
// the structures disc_pairs_..; the owner says which pairs there are.
//
// Certificates. One a pair, +-disc_overlap: degree 2d for motions and radii of degree d. A failure
// is a change of the pair, and renews its certificate.
//
// Ties. A pair that touches identically meets.
#ifndef KINEX_STRUCTURES_PROXIMITY_DISC_CLAIMS_H
#define KINEX_STRUCTURES_PROXIMITY_DISC_CLAIMS_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "core/engine/audit.h"
#include "core/engine/kernel.h"
#include "core/engine/proof.h"
#include "structures/parts/slots.h"
#include "structures/parts/ties.h"

namespace kinex {

class DiscClaims {
 public:
  using Pair = std::array<ObjectId, 2>;  // the smaller id first

  DiscClaims(Kernel& kernel, StructureId id, const Scene& scene);

  // A pair more, right after now, which is not there. True if it meets.
  bool add(const Pair& pair);
  // A pair less. True if it met.
  bool remove(const Pair& pair);
  void clear();
  bool owns(CertificateId c) const { return slots_.owns(c); }
  // The certificate of a pair has failed: the pair, which is the other way round from now on.
  struct Change {
    Pair pair;
    bool meets;
  };
  Change failed(CertificateId c);
  // New motions of these objects. Calls changed(pair) for each that touches identically from now on
  // and did not meet.
  template <class Changed>
  void motions_changed(std::span<const ObjectId> objects, const Changed& changed) {
    ties_.note_of(slots_, objects);
    ties_.settle([&](std::uint32_t place) {
      Claim& claim = claims_[place];
      if (claim.meets || !slots_.is_tie(claim.certificate)) return;
      turn(place);
      changed(claim.pair);
    });
  }

  bool has(const Pair& pair) const { return places_.contains(pair); }
  std::size_t size() const { return places_.size(); }
  // Those that meet, ascending, flattened.
  std::vector<ObjectId> meeting() const;
  // All pairs, ascending.
  std::vector<Pair> pairs() const;
  void visit_proof(ProofVisitor& visitor) const;
  void check(AuditReport& report) const;
  std::size_t bytes() const;

 private:
  struct Claim {
    Pair pair{kNoObject, kNoObject};
    bool meets = false;
    CertificateId certificate = kNoCertificate;
  };
  Query query(const Claim& claim) const {
    return {claim.meets ? overlap_ : apart_, {claim.pair[0], claim.pair[1]}};
  }
  void turn(std::uint32_t place);

  Kernel* kernel_;
  PredicateId overlap_, apart_;
  Slots slots_;
  Ties ties_;
  std::vector<Claim> claims_;
  std::vector<std::uint32_t> free_;
  std::map<Pair, std::uint32_t> places_;
};

}  // namespace kinex

#endif
