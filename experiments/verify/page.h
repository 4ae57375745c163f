// SPDX-License-Identifier: GPL-3.0-or-later
// The results as one self-contained HTML page.
#ifndef KINEX_EXPERIMENTS_VERIFY_PAGE_H
#define KINEX_EXPERIMENTS_VERIFY_PAGE_H

#include <string>

#include "experiments/lab/html.h"
#include "experiments/verify/runner.h"

namespace kinex::verify {

// Verdicts, failures, fits, plots, and the table of all cells with all their checks. If plots could
// not be drawn the page gives the reason.
std::string verify_page(const VerifyResult& result, const std::vector<lab::Figure>& figures,
                        const lab::Drawings& drawings, const lab::PageFacts& facts);

}  // namespace kinex::verify

#endif
