// SPDX-License-Identifier: GPL-3.0-or-later
// The results for their page: what did not pass, the fits, the tables, and all cells with all their
// checks.
#ifndef KINEX_EXPERIMENTS_VERIFY_REPORT_H
#define KINEX_EXPERIMENTS_VERIFY_REPORT_H

#include "experiments/lab/report.h"
#include "experiments/verify/runner.h"

namespace kinex::verify {

// With the figures of verify_figures. `facts`: of the page.
lab::Report verify_report(const VerifyResult& result, const lab::PageFacts& facts);

}  // namespace kinex::verify

#endif
