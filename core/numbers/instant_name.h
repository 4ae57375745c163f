// SPDX-License-Identifier: GPL-3.0-or-later
// InstantName: an instant as data, for logs, pages and comparisons. Text is made only where it is
// written: by to_text(), or by the writer of a log.
#ifndef KINEX_CORE_NUMBERS_INSTANT_NAME_H
#define KINEX_CORE_NUMBERS_INSTANT_NAME_H

#include <cstdint>
#include <string>
#include <vector>

#include "core/numbers/polynomial.h"
#include "core/numbers/rational.h"

namespace kinex {

// The detail in which an instant is named.
enum class InstantDetail : std::uint8_t {
  kNone,      // nothing
  kInterval,  // a closed interval with dyadic ends that contains it, and its decimal
  kName,      // its exact name: polynomial, root, isolating interval; and its decimal
};

// The name of one instant, in one detail. An inexact arithmetic fills in only the decimal.
struct InstantName {
  // Distinct for every instant (and detail) that an arithmetic names: text made from this name may
  // be reused while the number is the same. 0: nothing has been named.
  std::uint64_t number = 0;
  InstantDetail detail = InstantDetail::kNone;
  bool exact = false;
  Polynomial polynomial;  // primitive, positive leading coefficient, square-free (kName)
  int root = 0;           // index from 1 among its real roots, in ascending order (kName)
  Rational lower, upper;  // kName: isolating, equal for a rational instant; kInterval: contains it
  std::string decimal;    // for people

  bool is_rational() const { return detail == InstantDetail::kName && exact && lower == upper; }
};

// An InstantName as text: numbers as "p" or "p/q".
struct InstantText {
  bool exact = false;
  std::vector<std::string> polynomial;  // low degree first (exact only)
  int root = 0;                         // (exact only)
  std::string lower, upper;             // (exact only)
  std::string approximate;              // the decimal
};
InstantText to_text(const InstantName& name);

}  // namespace kinex

#endif
