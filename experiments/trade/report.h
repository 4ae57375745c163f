// SPDX-License-Identifier: GPL-3.0-or-later
// The trade for its page: how often each arithmetic was right, faults of exact ones, the bits, and a
// table for every scene.
#ifndef KINEX_EXPERIMENTS_TRADE_REPORT_H
#define KINEX_EXPERIMENTS_TRADE_REPORT_H

#include "experiments/lab/report.h"
#include "experiments/trade/runner.h"

namespace kinex::trade {

// With the figures of trade_figures. `facts`: of the page.
lab::Report trade_report(const TradeResult& result, const lab::PageFacts& facts);

}  // namespace kinex::trade

#endif
