// SPDX-License-Identifier: GPL-3.0-or-later
// Common parts of the paper separation-sensitive-1999. Bodies have radius 1, so D = 2.
#ifndef KINEX_EXPERIMENTS_FAMILIES_COLLISION_SEPARATION_PAPER_H
#define KINEX_EXPERIMENTS_FAMILIES_COLLISION_SEPARATION_PAPER_H

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/numbers/rational.h"
#include "experiments/lab/curves.h"
#include "experiments/lab/fit.h"
#include "experiments/lab/part.h"

namespace kinex::families {

// One run, or `scenes` of them. `separation`: nullopt: that of the workload.
lab::SeriesPoint separation_point(std::string structure, std::string workload, int n,
                                  std::optional<Rational> separation, int scenes = 1);
Rational inverse_power(int k);  // 2^-k

// Of points with a separation: mu (axes.h), and 4 / separation.
double mu_of(const lab::SeriesResult& result);
double nearness_of(const lab::SeriesResult& result);

// Mean events of a structure on a workload against x.
std::vector<lab::FitPoint> points_of(const std::vector<lab::SeriesResult>& results,
                                const std::string& structure, const std::string& workload,
                                const std::function<double(const lab::SeriesResult&)>& x);

// "events grow at most like NAME^exponent", judged by lab::judge_power with a tolerance of 0.1. This and
// log_claim are verdicts on the scenes alone, until finish().
lab::PaperClaim power_claim(std::string id, std::string statement,
                            const std::vector<lab::FitPoint>& points, const std::string& name,
                            double exponent);
// "COUNTS grow at most like log NAME", judged by lab::judge_law with a tolerance of 10 %: the table of
// the law against its neighbours goes to the report.
lab::PaperClaim log_claim(lab::PartReport& report, std::string id, std::string statement,
                          const std::string& counts, const std::vector<lab::FitPoint>& points,
                          const std::string& name);

// Events against the variable that the picture's x axis begins with. The legend has the power of it
// that fits, with its 95 % interval, unless the curve has a value of its own or is a bound.
lab::Figure curves_figure(std::string title, std::string caption, lab::CurvesPicture picture,
                          std::vector<lab::Curve> curves);

// Sets the claim's small run, which a second program checks: one of the results for this structure
// and workload, at a small size.
void set_small_run(lab::PaperClaim& claim, const std::vector<lab::SeriesResult>& results,
                   const std::string& structure, const std::string& workload);

// Adds the table of all runs, and the place and command of every claim. Claims of kind "growth" and
// "bound" are on all motions, or all polygons: they get the assumption `all`, and are open where their
// runs would confirm them. Refuted ones stay so.
void finish(lab::PartReport& report, const std::vector<lab::SeriesResult>& results,
            const std::string& command,
            const char* all = "runs cannot confirm a bound on all motions");

// The paper with all its parts.
lab::Paper separation_paper();
// separation_translation.cpp
std::vector<lab::SeriesPoint> separation_translation_points(bool quick);
lab::PartReport separation_translation_report(const std::vector<lab::SeriesResult>& results,
                                         const std::string& command);
// separation_rigid.cpp
std::vector<lab::SeriesPoint> separation_rigid_points(bool quick);
lab::PartReport separation_rigid_report(const std::vector<lab::SeriesResult>& results,
                                   const std::string& command);
std::vector<lab::SeriesPoint> separation_features_points(bool quick);
lab::PartReport separation_features_report(const std::vector<lab::SeriesResult>& results,
                                      const std::string& command);
// separation_far.cpp
std::vector<lab::SeriesPoint> separation_hysteresis_points(bool quick);
lab::PartReport separation_hysteresis_report(const std::vector<lab::SeriesResult>& results,
                                        const std::string& command);
std::vector<lab::SeriesPoint> separation_hierarchies_points(bool quick);
lab::PartReport separation_hierarchies_report(const lab::StudyResult& study,
                                              const std::string& command);

}  // namespace kinex::families

#endif
