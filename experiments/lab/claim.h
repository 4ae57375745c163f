// SPDX-License-Identifier: GPL-3.0-or-later
// PaperClaim: a statement of a paper, with expectation, observation and verdict.
#ifndef KINEX_EXPERIMENTS_LAB_CLAIM_H
#define KINEX_EXPERIMENTS_LAB_CLAIM_H

#include <string>
#include <vector>

#include "experiments/lab/checked_by.h"
#include "experiments/lab/verdict.h"

namespace kinex::lab {

struct PaperClaim {
  std::string id;         // "figure-3.brute-force"
  std::string place;      // in the paper
  std::string statement;  // in our words
  std::string kind;       // "finding", "growth", "expectation", "run", "question"
  std::string command;
  std::string expected;
  std::string tolerance;
  std::string observed;
  Verdict verdict = Verdict::kOpen;
  std::vector<std::string> assumptions;  // added to the paper's
  // Not empty for a statement that is known to be false: what refutes it. Such a claim is expected
  // to be refuted; any other verdict is a failure.
  std::string counterexample;
  // A small run about the claim, for a second program to check. Without a structure there is none,
  // and no_small_run is the reason.
  RunKey small_run;
  std::string no_small_run;
  CheckedBy checked_by;

  // True if the verdict is a surprise: a statement is refuted that has no known counterexample, or
  // one that has is confirmed, or agrees.
  bool is_surprising() const {
    if (counterexample.empty()) return verdict == Verdict::kRefuted;
    return verdict <= Verdict::kAgrees;
  }
};

}  // namespace kinex::lab

#endif
