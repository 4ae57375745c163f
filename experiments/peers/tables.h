// SPDX-License-Identifier: GPL-3.0-or-later
// The tables of kinex_peers.
#ifndef KINEX_EXPERIMENTS_PEERS_TABLES_H
#define KINEX_EXPERIMENTS_PEERS_TABLES_H

#include <string>
#include <vector>

#include "experiments/lab/bench_options.h"
#include "experiments/lab/gnuplot.h"
#include "experiments/peers/judge.h"

namespace kinex::peers {

// answers.cpp: right answers, by family, by gap, and on reported failures
void answer_tables(const lab::BenchOptions& options, PeerQuestions& questions);
// distances.cpp: the errors of the distances on which all other answers are built
void distance_table(const lab::BenchOptions& options);
// costs.cpp: work and time of single queries
void cost_table(const lab::BenchOptions& options, PeerQuestions& questions);
// samples.cpp: fixed steps, and the number of steps that finds every overlap of a family
std::vector<lab::Figure> sample_tables(const lab::BenchOptions& options, PeerQuestions& questions);
// crossovers.cpp: time against separation, vertices and looks on the way
std::vector<lab::Figure> crossover_tables(const lab::BenchOptions& options,
                                          PeerQuestions& questions);

// ---- shared (curves.cpp)

struct PeerCurve {
  std::string name;
  std::vector<std::array<double, 2>> points;
};
// On logarithmic axes, y also on a linear one; curves without points are left out.
lab::Figure figure_of(const std::string& title, const std::string& caption,
                      const std::string& x_label, const std::string& y_label,
                      const std::vector<PeerCurve>& curves, bool log_y = true);

}  // namespace kinex::peers

#endif
