// SPDX-License-Identifier: GPL-3.0-or-later
// Common parts of the claims of Guibas's report (1998), section 7: counts of runs against integers
// that are known for every size, and against powers.
//
// What a verdict means:
//   a count     confirmed if every run of every size counts exactly the integer, else refuted
//   a power     that of lab::judge_power: confirmed only if the whole confidence interval of the
//               exponent lies within the tolerance
//   a bound on all motions
//               never confirmed by runs: open, "consistent with", unless a run breaks it
#ifndef KINEX_EXPERIMENTS_FAMILIES_POINTS_KDS_CLAIMS_H
#define KINEX_EXPERIMENTS_FAMILIES_POINTS_KDS_CLAIMS_H

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/lab/curves.h"
#include "experiments/lab/fit.h"
#include "experiments/lab/part.h"

namespace kinex::families {

// The runs of a part, as they are chosen for a claim.
struct KdsRuns {
  std::string_view structure, workload;
};

// One run of a workload without random numbers.
lab::SeriesPoint kds_single(KdsRuns runs, int n, int m = 0, int dimension = 2);
// `seeds` runs of a workload with random numbers.
lab::SeriesPoint kds_random(KdsRuns runs, int n, int seeds, int dimension = 2);

// The results of these runs, in order; of another dimension none.
std::vector<const lab::SeriesResult*> results_of(const std::vector<lab::SeriesResult>& results,
                                                 KdsRuns runs, int dimension = 2);
// Means of a quantity (lab::quantity_of) over n.
std::vector<lab::FitPoint> means_of(const std::vector<lab::SeriesResult>& results, KdsRuns runs,
                                    const std::string& quantity, int dimension = 2);
// The ratio of two of the same runs, scene by scene: its means with their errors.
std::vector<lab::FitPoint> ratios_of(const std::vector<lab::SeriesResult>& results, KdsRuns runs,
                                     const std::string& over, const std::string& under,
                                     int dimension = 2);
// The ratio of the same quantity in the runs of two structures on the same scenes.
std::vector<lab::FitPoint> ratios_of(const std::vector<lab::SeriesResult>& results, KdsRuns over,
                                     KdsRuns under, const std::string& quantity);

// "every run counts `formula`": n and m to the integer. `counted`: in words.
struct KdsCount {
  std::string id, statement;
  KdsRuns runs;
  std::string quantity, counted, formula;
  double (*integer)(double n, double m);
};
lab::PaperClaim count_claim(const std::vector<lab::SeriesResult>& results, const KdsCount& count);

// "no run has more than `formula`", of a bound on all motions: open, "consistent with", or refuted.
lab::PaperClaim bound_claim(const std::vector<lab::SeriesResult>& results, const KdsCount& count);

enum class KdsPower {
  kTheta,        // of these very scenes: the exponent is as claimed
  kAtMost,       // of these very scenes: the exponent is at most as claimed
  kAtLeast,      // of these very scenes: a lower bound on the worst case
  kOnAllMotion,  // a bound on all motions, of which these scenes are a few
};
struct KdsGrowth {
  std::string id, statement;
  KdsRuns runs;         // of the small run
  std::string counted;  // in words
  double exponent;
  KdsPower kind = KdsPower::kTheta;
  double lower_order = 1;  // lab::ClaimedPower
};
// The orders that a term of lower order of such a law may have, but for this one. The report does not name them:
// the fraction of the points of a square that are near its boundary is n^(-1/2), in space n^(-1/3); n (n - 1)
// and a + b n have a term that is smaller by n.
std::vector<double> other_orders(double order);

lab::PaperClaim growth_claim(const std::vector<lab::FitPoint>& points, const KdsGrowth& growth);

// A question that the report leaves open, and what was observed: never confirmed.
lab::PaperClaim open_question(std::string id, std::string question, std::string observed,
                              KdsRuns runs);

// Whether all structures have as many changes on every scene: those of equal workload, size and seed.
struct KdsAgreement {
  std::size_t scenes = 0;  // that several structures have
  std::string difference;  // the first; empty: none
};
KdsAgreement agreement_of(const std::vector<lab::SeriesResult>& results,
                          const std::vector<std::string_view>& structures);

// What agreement_of() does not compare.
inline constexpr std::string_view kAgreementAssumption =
    "numbers of changes are compared here; that they are the same changes at the same instants is "
    "what "
    "`kinex diff --attributes` and the tests of the structures compare";

// "as many changes by each, on every scene": confirmed if several structures have a scene, and agree on all.
lab::PaperClaim agreement_claim(const std::vector<lab::SeriesResult>& results, std::string id,
                                std::string statement, KdsRuns small,
                                const std::vector<std::string_view>& structures);

// A picture of counts over n, each with the power that fits it.
lab::Figure growth_figure(std::string title, std::string caption, std::string y,
                          std::vector<double> slopes, std::vector<lab::Curve> curves);

// The table of all runs.
std::string runs_table(const std::vector<lab::SeriesResult>& results);
// Place and command of all claims; their small runs become those of the second program.
void finish_section_7(lab::PartReport& report, const std::vector<lab::SeriesResult>& results,
                      const std::string& command);

}  // namespace kinex::families

#endif
