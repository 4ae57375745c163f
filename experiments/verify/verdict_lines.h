// SPDX-License-Identifier: GPL-3.0-or-later
// The verdict of all experiments, as the page begins with it and the command ends with it.
#ifndef KINEX_EXPERIMENTS_VERIFY_VERDICT_LINES_H
#define KINEX_EXPERIMENTS_VERIFY_VERDICT_LINES_H

#include <array>
#include <cstddef>
#include <string>

#include "experiments/verify/runner.h"

namespace kinex::verify {

// Cells, fits and studies, by lab::Verdict.
std::array<std::size_t, 4> verdict_counts(const VerifyResult& result);

// "716 of 716 hold; 0 fail; 5 min"; "12 of 15 hold; 1 fails; 2 inconclusive; 40 s".
std::string verdict_line(const VerifyResult& result, double seconds);
// What was done: "702 cells and 14 fits: 4312 checks, 9123 runs, 1234567 certificate failures".
std::string work_line(const VerifyResult& result);

}  // namespace kinex::verify

#endif
