// SPDX-License-Identifier: GPL-3.0-or-later
// The tables of `kinex trade` (speed against accuracy) as Markdown, for a page in a repository.
#ifndef KINEX_EXPERIMENTS_TRADE_MARKDOWN_H
#define KINEX_EXPERIMENTS_TRADE_MARKDOWN_H

#include <string>

#include "experiments/lab/report.h"
#include "experiments/trade/runner.h"

namespace kinex::trade {

// A table of standings, a section for each structure, and the growth of the bits needed. A section
// has a table of the bits that its scenes need, then tables with a row per scene and a column per
// arithmetic: the outcome, the first event that differs, the largest error of an event time, time
// and memory. Everything but the times is the same on every machine; they are marked.
std::string trade_markdown(const TradeResult& result, const lab::PageFacts& facts);

}  // namespace kinex::trade

#endif
