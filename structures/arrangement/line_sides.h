// SPDX-License-Identifier: GPL-3.0-or-later
// LineSides: pairs of a line and a point, each with a certificate that the point is above the line
// or below it. A part of the structures incidences_..; the owner says which pairs there are.
//
// Certificates. One a pair, line_side or line_under: degree 2d for motions of degree d. A failure
// is a change of the pair, and renews its certificate.
//
// Ties. A point that is identically on a line is below it.
#ifndef KINEX_STRUCTURES_ARRANGEMENT_LINE_SIDES_H
#define KINEX_STRUCTURES_ARRANGEMENT_LINE_SIDES_H

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

class LineSides {
 public:
  struct Pair {  // a line and a point
    ObjectId line = kNoObject, point = kNoObject;
    friend auto operator<=>(const Pair&, const Pair&) = default;
  };

  LineSides(Kernel& kernel, StructureId id);

  // Adds a pair that is not there. True if the point is above the line right after now.
  bool add(const Pair& pair);
  // Removes a pair that is there. True if the point was above the line.
  bool remove(const Pair& pair);
  void clear();
  bool owns(CertificateId c) const { return slots_.owns(c); }
  // The certificate of a pair has failed: that pair, and the side of its point from now on.
  struct Change {
    Pair pair;
    bool above;
  };
  Change failed(CertificateId c);
  // New motions of these objects. Calls changed(pair) for each pair whose point is identically on
  // the line from now on and was above.
  template <class Changed>
  void motions_changed(std::span<const ObjectId> objects, const Changed& changed) {
    ties_.note_of(slots_, objects);
    ties_.settle([&](std::uint32_t place) {
      Side& side = sides_[place];
      if (!side.above || !slots_.is_tie(side.certificate)) return;
      turn(place);
      changed(side.pair);
    });
  }

  std::size_t size() const { return places_.size(); }
  // Requires that the pair is there.
  bool above(const Pair& pair) const { return sides_[places_.at(pair)].above; }
  // Calls visit(pair, above) for all pairs, ascending.
  template <class Visit>
  void each(const Visit& visit) const {
    for (const auto& [pair, place] : places_) visit(pair, sides_[place].above);
  }
  void visit_proof(ProofVisitor& visitor) const;
  void check(AuditReport& report) const;
  std::size_t bytes() const;

 private:
  struct Side {
    Pair pair;
    bool above = false;
    CertificateId certificate = kNoCertificate;
  };
  Query query(const Side& side) const {
    return {side.above ? above_ : under_, {side.pair.line, side.pair.point}};
  }
  void turn(std::uint32_t place);

  Kernel* kernel_;
  PredicateId above_, under_;
  Slots slots_;
  Ties ties_;
  std::vector<Side> sides_;
  std::vector<std::uint32_t> free_;
  std::map<Pair, std::uint32_t> places_;
};

}  // namespace kinex

#endif
