// SPDX-License-Identifier: GPL-3.0-or-later
// LengthPredicate: the predicate of a formula that compares two lengths, known as such
// (core/arithmetic/length_order.h). The formula also has
//   static constexpr LengthEnds kEnds;
#ifndef KINEX_PREDICATES_LENGTH_PREDICATE_H
#define KINEX_PREDICATES_LENGTH_PREDICATE_H

#include "core/arithmetic/length_order.h"
#include "core/arithmetic/predicate_formula.h"

namespace kinex {

template <class Formula>
class LengthPredicate final : public FormulaPredicate<Formula>, public LengthOrder {
 public:
  static_assert(Formula::kReference == Formula::kEnds.shorter_from);
  LengthEnds length_ends() const override { return Formula::kEnds; }
};

}  // namespace kinex

#endif
