// SPDX-License-Identifier: GPL-3.0-or-later
// The tables of the trade as Markdown, for a page in a repository.
#ifndef KINEX_EXPERIMENTS_TRADE_MARKDOWN_H
#define KINEX_EXPERIMENTS_TRADE_MARKDOWN_H

#include <string>

#include "experiments/lab/html.h"
#include "experiments/trade/runner.h"

namespace kinex::trade {

// A section for each structure: scenes over arithmetics, in one table each for standings, errors of
// event times, and time and memory; then the bits. Everything but times is the same on every
// machine; what depends on the machine is marked.
std::string trade_markdown(const TradeResult& result, const lab::PageFacts& facts);

}  // namespace kinex::trade

#endif
