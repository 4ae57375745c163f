// SPDX-License-Identifier: GPL-3.0-or-later
// The floating-point filter of continuous contact: doubles with proven error bounds. It may
// abstain; it is never wrong.
#ifndef KINEX_PREDICATES_CCD_CONTACT_FILTER_H
#define KINEX_PREDICATES_CCD_CONTACT_FILTER_H

#include "predicates/ccd/continuous_contact.h"

namespace kinex {

struct ContactVerdict {  // the answer of the filter
  enum class Kind : std::uint8_t {
    kNone,    // no contact in [0, 1]
    kFirst,   // the first contact is in (lower, upper), at the only root of the cubic there, and
              // the cubic has opposite signs at both ends
    kUnknown  // ask the exact stage
  };
  Kind kind = Kind::kUnknown;
  double lower = 0, upper = 1;  // dyadic; for kFirst
  int cuts = 0;                 // how often an interval was cut
};

//   (1) a verdict other than kUnknown agrees with first_contact_exactly. No allocation; bounded cuts.
ContactVerdict filter_contact(const ContactQuery& query);

}  // namespace kinex

#endif
