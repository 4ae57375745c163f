// SPDX-License-Identifier: GPL-3.0-or-later
// The trade as one HTML page that needs nothing else.
#ifndef KINEX_EXPERIMENTS_TRADE_PAGE_H
#define KINEX_EXPERIMENTS_TRADE_PAGE_H

#include <string>

#include "experiments/trade/runner.h"
#include "experiments/verify/html.h"

namespace kinex {

// How often each arithmetic was right, what is wrong with an exact one, the figures, the bits, and
// a table for every scene. Where plots could not be drawn the page says why.
std::string trade_page(const TradeResult& result, const std::vector<Figure>& figures,
                       const Drawings& drawings, const PageFacts& facts);

}  // namespace kinex

#endif
