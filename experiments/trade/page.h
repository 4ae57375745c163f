// SPDX-License-Identifier: GPL-3.0-or-later
// The trade as one self-contained HTML page.
#ifndef KINEX_EXPERIMENTS_TRADE_PAGE_H
#define KINEX_EXPERIMENTS_TRADE_PAGE_H

#include <string>

#include "experiments/lab/html.h"
#include "experiments/trade/runner.h"

namespace kinex::trade {

// How often each arithmetic was right, faults of exact ones, the figures, the bits, and a table for
// every scene. If plots could not be drawn the page gives the reason.
std::string trade_page(const TradeResult& result, const std::vector<lab::Figure>& figures,
                       const lab::Drawings& drawings, const lab::PageFacts& facts);

}  // namespace kinex::trade

#endif
