// SPDX-License-Identifier: GPL-3.0-or-later
// The plots of the trade: the plane of speed and accuracy of every structure, and the bits that
// instants need over n.
#ifndef KINEX_EXPERIMENTS_TRADE_PLOTS_H
#define KINEX_EXPERIMENTS_TRADE_PLOTS_H

#include <vector>

#include "experiments/lab/gnuplot.h"
#include "experiments/trade/runner.h"

namespace kinex::trade {

std::vector<lab::Figure> trade_figures(const TradeResult& result);

}  // namespace kinex::trade

#endif
