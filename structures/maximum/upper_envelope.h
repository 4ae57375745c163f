// SPDX-License-Identifier: GPL-3.0-or-later
// UpperEnvelope: the winners of a contest from now on, one after another, computed in advance.
//
// Divide and conquer: the envelopes of the two halves are merged by a sweep over their breakpoints.
// Between two breakpoints one object of each half is on top, and the winner changes where these two
// cross. Several crossings of a pair are found one after another.
//
//   first half    |------ f ------|-------- g --------->     | breakpoint of a half
//   second half   |---- u ---|----------- v ------------>
//   sweep         |   x      |    |      x                   x crossing of the two on top
//   merged        |-u-|--- f -----|-- g -|----- v ------>    | change of the winner
//
// Cost: O(lambda_D(n) log n) failure times and comparisons of instants for keys of degree D;
// O(n log n) for lines.
//
// Valid while the motions in force are unchanged. Ties: of objects with identically equal keys the
// smallest id wins; at an instant, the winner is that right after it.
//
// Source: Guibas, "Kinetic data structures: a state of the art report" (1998), section 5; Sharir,
// Agarwal, "Davenport-Schinzel sequences and their geometric applications" (1995), chapter 6.
#ifndef KINEX_STRUCTURES_MAXIMUM_UPPER_ENVELOPE_H
#define KINEX_STRUCTURES_MAXIMUM_UPPER_ENVELOPE_H

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/arithmetic/foresight.h"
#include "structures/parts/key_order.h"

namespace kinex {

class UpperEnvelope {
 public:
  UpperEnvelope(const Contest& contest, Kernel& kernel)
      : contest_(&contest), foresight_(kernel.foresight()), exact_(kernel.is_exact()) {}

  // The winners from now on, one after another; empty if there are no members. Requires ascending
  // members.
  std::vector<ObjectId> compute(std::span<const ObjectId> members);

 private:
  using Moment = Foresight::Moment;
  struct Piece {
    ObjectId object;
    Moment end;  // kNever for the last one
  };
  using Pieces = std::vector<Piece>;
  struct Duel {
    ObjectId winner;
    Moment end;  // when the other one wins
  };

  Pieces envelope(std::span<const ObjectId> members);
  // Requires that all ids in a are smaller than those in b.
  Pieces merge(const Pieces& a, const Pieces& b);
  Duel duel(ObjectId a, ObjectId b, Moment from);

  const Contest* contest_;
  Foresight foresight_;
  bool exact_;
};

}  // namespace kinex

#endif
