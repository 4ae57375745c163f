// SPDX-License-Identifier: GPL-3.0-or-later
// First contact by an independent formulation, in rationals and Sturm sequences: barycentric
// coordinates by Cramer's rule in a coordinate plane; all polynomials give candidates.
#ifndef KINEX_TESTS_PREDICATES_CCD_CONTACT_ORACLE_H
#define KINEX_TESTS_PREDICATES_CCD_CONTACT_ORACLE_H

#include <optional>

#include "core/numbers/rational_sturm.h"
#include "tests/predicates/ccd/contact_support.h"

namespace kinex::test {

// A root of a square-free polynomial: the only one in (lower, upper], or lower = upper.
struct OracleRoot {
  RationalPolynomial polynomial;
  Rational lower, upper;
};

std::optional<OracleRoot> oracle_first_contact(ContactKind kind, const Points& points);

}  // namespace kinex::test

#endif
