// SPDX-License-Identifier: GPL-3.0-or-later
// Touches: instants at which a certificate's value is zero and not negative right after. By the
// right-hand rule (arithmetic.h) they are not failures. For events at touches, such as two bodies
// that graze, a certificate can be made to fail there too:
//
//   value   \           /
//            \         /
//   0  -------'-._._.-'--------- t
//                ^ touch (double root): a failure only of a FailsAtTouch
#ifndef KINEX_CORE_ARITHMETIC_TOUCH_H
#define KINEX_CORE_ARITHMETIC_TOUCH_H

#include "core/arithmetic/query.h"
#include "core/numbers/sign.h"

namespace kinex {

// A second base class of a Predicate. In an exact arithmetic its certificates fail at their first
// root after now, of any multiplicity, or at now if they are negative right after it. The structure
// then checks the sign. In an inexact arithmetic they fail like all others. The predicate of the
// same name without this base has the same polynomial.
class FailsAtTouch {
 public:
  virtual ~FailsAtTouch() = default;
};

// The place at which a sign is requested.
enum class When : bool {
  kRightAfter,  // on (now, now + eps)
  kNow,         // at now itself
};

// A second base class of every exact Arithmetic: the sign at now itself, not right after it.
class SignNow {
 public:
  virtual ~SignNow() = default;
  virtual Sign sign_now(const Query& query) = 0;
};

}  // namespace kinex

#endif
