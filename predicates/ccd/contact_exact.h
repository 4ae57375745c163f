// SPDX-License-Identifier: GPL-3.0-or-later
// The second stage of continuous contact: roots of integer polynomials. Identities: continuous_contact.h.
#ifndef KINEX_PREDICATES_CCD_CONTACT_EXACT_H
#define KINEX_PREDICATES_CCD_CONTACT_EXACT_H

#include <optional>

#include "predicates/ccd/continuous_contact.h"

namespace kinex {

// The first contact in [0, 1], whatever the input; nullopt if there is none.
std::optional<ContactTime> first_contact_exactly(const ContactQuery& query, RootCounters& counters);

// The root of the cubic between two dyadic ends, where it has opposite signs and no other root.
ContactTime contact_between(const ContactQuery& query, double lower, double upper);

}  // namespace kinex

#endif
