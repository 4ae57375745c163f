// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/lab/verdict.h"

#include <limits>

namespace kinex::lab {

std::string_view check_word(Verdict verdict) {
  switch (verdict) {
    case Verdict::kConfirmed:
      return "PASS";
    case Verdict::kAgrees:
      return "AGREES";
    case Verdict::kOpen:
      return "INCONCLUSIVE";
    case Verdict::kGaveUp:
      return "GAVE UP";
    case Verdict::kRefuted:
      return "FAIL";
  }
  return "";
}

std::string_view claim_word(Verdict verdict) {
  switch (verdict) {
    case Verdict::kConfirmed:
      return "confirmed";
    case Verdict::kAgrees:
      return "agrees";
    case Verdict::kOpen:
      return "open";
    case Verdict::kGaveUp:
      return "gave up";
    case Verdict::kRefuted:
      return "refuted";
  }
  return "";
}

Verdict compare_with_claim(double lower, double upper, double value, double tolerance,
                           bool at_most) {
  const double least = at_most ? -std::numeric_limits<double>::infinity() : value - tolerance;
  const double most = value + tolerance;
  if (lower >= least && upper <= most) return Verdict::kConfirmed;
  if (upper < least || lower > most) return Verdict::kRefuted;
  return Verdict::kOpen;  // not a number, too
}

}  // namespace kinex::lab
