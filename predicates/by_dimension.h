// SPDX-License-Identifier: GPL-3.0-or-later
// What formulas of one, two or three axes have in common: the sum of a term over the axes, and the
// choice of the formula for a scene's dimension.
#ifndef KINEX_PREDICATES_BY_DIMENSION_H
#define KINEX_PREDICATES_BY_DIMENSION_H

#include <memory>
#include <stdexcept>
#include <string>

#include "core/arithmetic/predicate_formula.h"

namespace kinex {

// term(0) + .. + term(Dimension - 1), of whatever type the terms have.
template <int Dimension, class Term>
auto sum_over_axes(const Term& term) {
  static_assert(Dimension >= 1 && Dimension <= 3);
  if constexpr (Dimension == 1) {
    return term(0);
  } else if constexpr (Dimension == 2) {
    return term(0) + term(1);
  } else {
    return term(0) + term(1) + term(2);
  }
}

// The predicate of Formula<dimension>, made by the class template Maker. Throws std::invalid_argument for another number of axes than
// 1 to 3: `what` are offered in 1 to 3 dimensions.
template <template <int> class Formula, template <class> class Maker = FormulaPredicate>
std::shared_ptr<const Predicate> make_by_dimension(int dimension, const std::string& what) {
  switch (dimension) {
    case 1:
      return std::make_shared<Maker<Formula<1>>>();
    case 2:
      return std::make_shared<Maker<Formula<2>>>();
    case 3:
      return std::make_shared<Maker<Formula<3>>>();
    default: throw std::invalid_argument(what + " are offered in 1 to 3 dimensions");
  }
}

}  // namespace kinex

#endif
