// SPDX-License-Identifier: GPL-3.0-or-later
// Common parts of separation-sensitive-1999. Bodies have radius 1, so D = 2.
#ifndef KINEX_EXPERIMENTS_FAMILIES_COLLISION_SEPARATION_PAPER_H
#define KINEX_EXPERIMENTS_FAMILIES_COLLISION_SEPARATION_PAPER_H

#include <functional>
#include <string>
#include <vector>

#include "core/numbers/rational.h"
#include "experiments/lab/fit.h"
#include "experiments/lab/part.h"

namespace kinex {

// One run, or `scenes` of them.
SeriesPoint separation_point(std::string structure, std::string workload, int n,
                             std::string separation, int scenes = 1);
std::string inverse_power(int k);  // "1/2^k", written out

// min(2 n, sqrt(2 / separation))
double mu_of(const SeriesResult& result);

// Mean events of a structure on a workload against x.
std::vector<FitPoint> points_of(const std::vector<SeriesResult>& results,
                                const std::string& structure, const std::string& workload,
                                const std::function<double(const SeriesResult&)>& x);

// "events grow at most like NAME^exponent": confirmed if the fitted exponent is at most
// `exponent` + 0.1 or the 95 % interval reaches down to it.
PaperClaim power_claim(std::string id, std::string statement, const std::vector<FitPoint>& points,
                       const std::string& name, double exponent);

struct NamedCurve {
  std::string name;
  std::vector<FitPoint> points;
};
// Logarithmic axes.
Figure curves_figure(std::string title, std::string caption, const std::string& x,
                     const std::vector<NamedCurve>& curves);

// The claim is about runs of this structure and workload: one of these, made small, is checked by a
// second program.
void set_small_run(PaperClaim& claim, const std::vector<SeriesResult>& results,
                   const std::string& structure, const std::string& workload);

// All runs in a table, and every claim's place and command.
void finish(PartReport& report, const std::vector<SeriesResult>& results,
            const std::string& command);

// The paper with all its parts.
Paper separation_paper();
// separation_translation.cpp
std::vector<SeriesPoint> separation_translation_points(bool quick);
PartReport separation_translation_report(const std::vector<SeriesResult>& results,
                                         const std::string& command);
// separation_rigid.cpp
std::vector<SeriesPoint> separation_rigid_points(bool quick);
PartReport separation_rigid_report(const std::vector<SeriesResult>& results,
                                   const std::string& command);
std::vector<SeriesPoint> separation_features_points(bool quick);
PartReport separation_features_report(const std::vector<SeriesResult>& results,
                                      const std::string& command);
// separation_far.cpp
std::vector<SeriesPoint> separation_hysteresis_points(bool quick);
PartReport separation_hysteresis_report(const std::vector<SeriesResult>& results,
                                        const std::string& command);
std::vector<SeriesPoint> separation_hierarchies_points(bool quick);
PartReport separation_hierarchies_study(const std::string& command,
                                        const std::function<bool()>& go_on);

}  // namespace kinex

#endif
