// SPDX-License-Identifier: GPL-3.0-or-later
// Contact at one instant, by CGAL's exact kernel.
#ifndef KINEX_TESTS_PREDICATES_CCD_CONTACT_WITNESS_H
#define KINEX_TESTS_PREDICATES_CCD_CONTACT_WITNESS_H

#include "tests/predicates/ccd/contact_support.h"

namespace kinex::test {

bool cgal_touches(ContactKind kind, const std::array<Point, 4>& points);

}  // namespace kinex::test

#endif
