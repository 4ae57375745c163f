// SPDX-License-Identifier: GPL-3.0-or-later
// Question: does the kinetic hull scale to large n? (Guibas 1998, section 11: 50,000 points, about
//   400,000 events.) And to 1,000,000 points?
// Motion: uniform square, linear, one seed; until no event is left.
// Expected: about 8 events a point; the report does not say when its run ends.
// Cost: some minutes; --quick: 2,000 points.
#include <fmt/format.h>

#include <cmath>

#include "experiments/families/hull/experiments.h"
#include "experiments/lab/claim_check.h"

namespace kinex::families {

namespace {

constexpr int kClaimedPoints = 50000;
constexpr double kClaimedEvents = 400000;

}  // namespace

std::vector<lab::SeriesPoint> kds_large_runs_points(bool quick) {
  std::vector<lab::SeriesPoint> points;
  const auto add = [&](int n, bool forever) {
    lab::SeriesPoint point;
    point.key.structure = "convex_hull_2";
    point.key.workload = "uniform-square";
    point.key.parameters.n = n;
    point.key.forever = forever;
    point.min_seeds = point.max_seeds = 1;
    point.cost = n * 5e-5;
    points.push_back(std::move(point));
  };
  if (quick) {
    add(2000, false);
    add(2000, true);
  } else {
    add(kClaimedPoints, false);
    add(kClaimedPoints, true);
    add(1000000, false);
    add(1000000, true);
  }
  return points;
}

lab::PartReport kds_large_runs_report(const std::vector<lab::SeriesResult>& results,
                                 const std::string& command) {
  lab::PartReport report;
  std::string on_time;  // the events of the claimed points up to t = 1
  report.tables =
      "| n | until | certificate failures | failures a point | hull changes | certificates | "
      "set-up, "
      "CPU s | run, CPU s | failures/s | bytes |\n| ---: | --- | ---: | ---: | ---: | ---: | ---: "
      "| ---: | ---: | "
      "---: |\n";
  for (const lab::SeriesResult& result : results) {
    const lab::RunRecord& run = result.runs.front();
    const lab::RunKey& key = result.point.key;
    const double events = static_cast<double>(run.processed);
    report.tables += fmt::format(
        "| {} | {} | {} | {:.2f} | {} | {} | {:.1f} | {:.1f} | {:.0f} | {} |\n", key.parameters.n,
        key.forever ? "no event is left" : "t = 1", run.processed, events / key.parameters.n, run.external,
        run.max_live, run.seconds_setup, run.seconds, events / run.seconds, run.peak_bytes);
    if (key.parameters.n != kClaimedPoints) continue;
    if (!key.forever) {
      on_time = fmt::format(
          "{} certificate failures up to t = 1, {:.2f} times the report's number, and {} "
          "hull changes; ",
          run.processed, events / kClaimedEvents, run.external);
      continue;
    }
    lab::PaperClaim claim;
    claim.id = "section-11.50000";
    claim.place = "section 11";
    claim.kind = "run";
    claim.command = command;
    claim.statement = "The structure handles 50,000 points and about 400,000 events.";
    claim.expected = "about 400,000 events";
    claim.tolerance = "none: motion and end of the run are not stated";
    claim.observed = fmt::format("{}{} until none is left, {:.2f} times, and {} hull changes; {}",
                                 on_time, run.processed, events / kClaimedEvents, run.external,
                                 run.clean ? "audit and bounds hold" : run.trouble);
    // That it handles so many is seen; which run the report speaks of is not known.
    claim.verdict = run.clean ? lab::Verdict::kOpen : lab::Verdict::kRefuted;
    claim.assumptions = {"motion as in section 9, up to t = 1 and until no event is left",
                         "all failures of certificates are events"};
    claim.small_run = lab::small_run(key);
    report.claims.push_back(std::move(claim));
  }
  return report;
}

}  // namespace kinex::families
