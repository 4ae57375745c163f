// SPDX-License-Identifier: GPL-3.0-or-later
// PairSides: pairs of two objects, each with a certificate that it is on one of two sides, the positive
// one or the negative one. The owner says which pairs there are, and what the sides mean: discs that
// meet or are apart, a point above a line or below it.
//
// Certificates. One a pair, of two opposite predicates. A failure is a change of the pair, and renews
// its certificate.
//
// Ties. Pairs whose predicate is identically zero are all on one side, as the owner says.
#ifndef KINEX_STRUCTURES_PARTS_PAIR_SIDES_H
#define KINEX_STRUCTURES_PARTS_PAIR_SIDES_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/engine/audit.h"
#include "core/engine/kernel.h"
#include "core/engine/proof.h"
#include "structures/parts/slots.h"
#include "structures/parts/ties.h"

namespace kinex {

class PairSides {
 public:
  using Pair = std::array<ObjectId, 2>;  // as the owner orders the two
  // What a failure has changed.
  struct Change {
    Pair pair;
    bool positive;  // its side from now on
  };

  // Adds a pair that is not there. True if it is on the positive side right after now.
  bool add(const Pair& pair);
  // Removes a pair. True if it was there, on the positive side.
  bool remove(const Pair& pair);
  void clear();
  bool owns(CertificateId c) const { return slots_.owns(c); }
  // The certificate of a pair has failed: the pair, which is on the other side from now on.
  Change failed(CertificateId c);
  // New motions of these objects. Calls changed(pair) for each pair that is a tie from now on and was
  // not on the side of ties.
  template <class Changed>
  void motions_changed(std::span<const ObjectId> objects, const Changed& changed) {
    ties_.note_of(slots_, objects);
    ties_.settle([&](std::uint32_t place) {
      Member& member = members_[place];
      if (member.positive == sides_.tie || !slots_.is_tie(member.certificate)) return;
      turn(place);
      changed(member.pair);
    });
  }

  bool has(const Pair& pair) const { return places_.contains(pair); }
  std::size_t size() const { return places_.size(); }
  // Requires that the pair is there.
  bool is_positive(const Pair& pair) const { return members_[places_.at(pair)].positive; }
  // Calls visit(pair, positive) for all pairs, ascending.
  template <class Visit>
  void each(const Visit& visit) const {
    for (const auto& [pair, place] : places_) visit(pair, members_[place].positive);
  }
  void visit_proof(ProofVisitor& visitor) const;
  void check(AuditReport& report) const;
  std::size_t bytes() const;

 protected:
  // One of the two sides of a pair.
  struct Side {
    PredicateId predicate;  // >= 0 on this side
    std::string_view text;  // about a pair on it, for viewers
    std::string_view role;  // of its certificate
  };
  // Both, and what a tie is.
  struct Sides {
    Side positive, negative;
    bool tie;  // the side of ties is the positive one
  };

  // `part`: the name of the certificates in the ledger. `kind`: what a pair is, in words.
  PairSides(Kernel& kernel, StructureId id, std::string part, std::string_view kind,
            const Sides& sides);

 private:
  struct Member {
    Pair pair{kNoObject, kNoObject};
    bool positive = false;
    CertificateId certificate = kNoCertificate;
  };
  const Side& side(const Member& member) const {
    return member.positive ? sides_.positive : sides_.negative;
  }
  Query query(const Member& member) const {
    return {side(member).predicate, {member.pair[0], member.pair[1]}};
  }
  void turn(std::uint32_t place);

  Kernel* kernel_;
  std::string_view kind_;
  Sides sides_;
  Slots slots_;
  Ties ties_;
  std::vector<Member> members_;
  std::vector<std::uint32_t> free_;
  std::map<Pair, std::uint32_t> places_;
};

}  // namespace kinex

#endif
