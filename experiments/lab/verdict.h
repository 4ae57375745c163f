// SPDX-License-Identifier: GPL-3.0-or-later
// Verdict: what data say of a claim.
#ifndef KINEX_EXPERIMENTS_LAB_VERDICT_H
#define KINEX_EXPERIMENTS_LAB_VERDICT_H

#include <string_view>

namespace kinex::lab {

// From best to worst: the verdict of several is the largest.
enum class Verdict {
  kConfirmed,
  kAgrees,  // as --quick has it: a part of the data that the claim asks for would confirm it
  kOpen,    // agrees, but with too few data to exclude that it does not
  kGaveUp,  // a run stopped at a limit
  kRefuted,
};

std::string_view check_word(
    Verdict verdict);  // "PASS", "AGREES", "INCONCLUSIVE", "GAVE UP", "FAIL"
std::string_view claim_word(
    Verdict verdict);  // "confirmed", "agrees", "open", "gave up", "refuted"

// The verdict of a confidence interval on the claim "value within the tolerance" (at_most:
// "value or less"). Confirmed: all of the interval lies there. Refuted: none of it. Open: some of it. So
// a wider interval never confirms more. Never kAgrees or kGaveUp.
Verdict compare_with_claim(double lower, double upper, double value, double tolerance,
                           bool at_most);

}  // namespace kinex::lab

#endif
