// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/families/family.h"

namespace kinex::families {

const std::vector<Family>& families() {
  static const std::vector<Family> kFamilies{
      {"few_objects", "0 to 3 points or bodies that come and go", few_objects},
      {"meeting_pieces", "flight plans whose pieces meet where events are", meeting_pieces},
      {"every_arithmetic", "every structure under every arithmetic", every_arithmetic},
      {"extreme_bodies", "bodies with numbers of 1e+-300 and beyond in every field",
       extreme_bodies},
      {"named_twice", "certificates that name an object twice", named_twice},
  };
  return kFamilies;
}

}  // namespace kinex::families
