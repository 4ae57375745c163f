// SPDX-License-Identifier: GPL-3.0-or-later
// The tables of the trade as Markdown, for a page in a repository.
#ifndef KINEX_EXPERIMENTS_TRADE_MARKDOWN_H
#define KINEX_EXPERIMENTS_TRADE_MARKDOWN_H

#include <string>

#include "experiments/trade/runner.h"
#include "experiments/verify/html.h"

namespace kinex {

// A section a structure: scenes over arithmetics, once each for what came out, for errors of event
// times, and for time and memory; then the bits. All but times is the same on every machine; what
// depends on the machine is marked as such.
std::string trade_markdown(const TradeResult& result, const PageFacts& facts);

}  // namespace kinex

#endif
