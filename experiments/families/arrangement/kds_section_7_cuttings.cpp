// SPDX-License-Identifier: GPL-3.0-or-later
// Question: which number r of sample lines makes the proof of incidences by a cutting smallest? (Guibas
//   1998, section 7: O(n^(5/3)) certificates and nearly n^2 events; Theta(n^(4/3)) certificates would be
//   natural.)
// Scenes: n random chords of the unit square and n points in it, linear motion.
// Parameters: n from 27 to 125, to 64 in a quick run; r from n^(1/4) to n^(2/3); 4 scenes, 2 in a quick run.
// Expected: the changes of incidences_all, in every run; r^2 + n r + (n^2 / r) log n certificates in
//   order (structures/arrangement/incidences_cutting.h), which are fewest near r = n^(1/2). Powers are fitted.
// Cost: minutes; --quick: seconds.
#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/engine/simulator.h"
#include "experiments/families/arrangement/experiments.h"
#include "experiments/families/points/kds_claims.h"
#include "experiments/lab/claim_check.h"
#include "experiments/lab/scene_run.h"
#include "experiments/lab/statistics.h"
#include "experiments/lab/study_runs.h"
#include "experiments/lab/workload.h"
#include "structures/plan.h"

namespace kinex::families {

namespace {

constexpr const char* kChordsAndPoints = "random-lines-and-points";

struct SamplePower {
  const char* title;
  double power;  // r = n^power, rounded
};
constexpr SamplePower kSamplePowers[] = {
    {"n^(1/4)", 1.0 / 4}, {"n^(1/3)", 1.0 / 3}, {"n^(1/2)", 1.0 / 2}, {"n^(2/3)", 2.0 / 3}};

struct CuttingCounts {
  double certificates = 0;  // the most at one time, those of the sample included
  double events = 0;        // failures, those of the sample included
  double changes = 0;
};

CuttingCounts cutting_counts(Scene scene, const char* structure, int r, lab::StudyResult& study) {
  Request request{structure, structure, {}};
  if (r > 0) request.parameters = {{"r", Rational(r)}};
  scene.maintain = {std::move(request)};
  SimulatorOptions options;
  options.audit = AuditLevel::kNone;
  const auto simulator = lab::make_simulator(scene, "exact", options);
  simulator->start();
  simulator->run_until(std::nullopt);
  lab::check_run(*simulator, fmt::format("{}, {}", structure, scene.name), study);
  CuttingCounts counts;
  for (StructureId id = 0; id < simulator->structures(); ++id) {
    counts.certificates += static_cast<double>(simulator->ledger(id).max_live);
    counts.events += static_cast<double>(simulator->ledger(id).failures);
  }
  counts.changes = static_cast<double>(simulator->ledger(asked_structure(scene)).external);
  return counts;
}

// Columns of the study's table.
enum CuttingColumn : std::size_t {
  kCuttingPower,
  kCuttingN,
  kCuttingR,
  kCuttingSeeds,
  kCuttingCertificates,
  kCuttingCertificatesError,
  kCuttingEvents,
  kCuttingEventsError
};

std::vector<lab::FitPoint> cutting_points(const lab::StudyResult& result, std::string_view power,
                                          CuttingColumn counted) {
  std::vector<lab::FitPoint> points;
  for (const std::vector<std::string>& row : result.table.rows) {
    if (row[kCuttingPower] != power) continue;
    points.push_back(
        {std::stod(row[kCuttingN]), std::stod(row[counted]), std::stod(row[counted + 1])});
  }
  return points;
}

}  // namespace

lab::StudyResult study_sample_lines(bool quick, const std::function<bool()>& go_on) {
  lab::StudyResult result;
  result.name = "section-7-cuttings";
  result.table.title = "certificates and events of incidences_cutting";
  result.table.header = {
      "r =", "n", "r", "seeds", "certificates", "standard error", "events", "standard error"};
  result.table.note =
      "n lines and n points; r: sample lines. Means of the scenes: certificates are the most at "
      "one "
      "time, events are failures, those of the sample's arrangement and trapezoids included";
  const int seeds = quick ? 2 : 4;
  for (const int n : {27, 45, 64, 90, 125}) {
    if (quick && n > 64) continue;
    std::vector<lab::RunningMean> certificates(std::size(kSamplePowers)), events = certificates;
    for (int seed = 1; seed <= seeds; ++seed) {
      const lab::WorkloadParameters parameters{.n = 2 * n,
                                               .seed = static_cast<std::uint64_t>(seed)};
      const Scene scene = lab::generate_scene(kChordsAndPoints, parameters, "incidences_all");
      if (!go_on()) return result;
      const CuttingCounts all = cutting_counts(scene, "incidences_all", 0, result);
      for (std::size_t i = 0; i < std::size(kSamplePowers); ++i) {
        if (!go_on()) return result;
        const int r = static_cast<int>(std::lround(std::pow(n, kSamplePowers[i].power)));
        const CuttingCounts cutting = cutting_counts(scene, "incidences_cutting", r, result);
        certificates[i].add(cutting.certificates);
        events[i].add(cutting.events);
        if (cutting.changes == all.changes) continue;
        result.checks.push_back({fmt::format("7.12.cuttings.changes.{}.{}.{}", n, r, seed),
                                 "exactly", "", fmt::format("{:.0f}", all.changes),
                                 fmt::format("{:.0f}", cutting.changes),
                                 "the changes of incidences_all on the same scene",
                                 lab::Verdict::kRefuted, std::nullopt});
      }
    }
    for (std::size_t i = 0; i < std::size(kSamplePowers); ++i) {
      const int r = static_cast<int>(std::lround(std::pow(n, kSamplePowers[i].power)));
      result.table.rows.push_back({kSamplePowers[i].title, std::to_string(n), std::to_string(r),
                                   std::to_string(seeds),
                                   fmt::format("{:.1f}", certificates[i].mean()),
                                   fmt::format("{:.2f}", certificates[i].standard_error()),
                                   fmt::format("{:.1f}", events[i].mean()),
                                   fmt::format("{:.2f}", events[i].standard_error())});
    }
  }
  return result;
}

lab::PartReport kds_section_7_cuttings_report(const lab::StudyResult& result,
                                              const std::string& command) {
  lab::PartReport report;
  std::string certificates, events;
  std::vector<lab::Curve> curves;
  for (const SamplePower& sample : kSamplePowers) {
    const auto points = cutting_points(result, sample.title, kCuttingCertificates);
    const auto fit = lab::fit_power(points);
    const auto other = lab::fit_power(cutting_points(result, sample.title, kCuttingEvents));
    if (!fit || !other) continue;
    certificates += fmt::format("{}r = {}: {}", certificates.empty() ? "" : "; ", sample.title,
                                lab::fit_text(*fit));
    events += fmt::format("; events, r = {}: {}", sample.title, lab::fit_text(*other));
    curves.push_back({fmt::format("r = {}", sample.title), points, ""});
  }
  if (curves.empty()) return report;
  lab::PaperClaim claim = open_question("7.12.cuttings",
                                        "Sides of n lines and n points have a proof of O(n^(5/3)) "
                                        "certificates. How many has a cutting by r "
                                        "random sample lines, and how many events?",
                                        "certificates, " + certificates + events,
                                        {"incidences_cutting", kChordsAndPoints});
  claim.expected = "certificates: of the order of r^2 + n r + (n^2 / r) log n";
  lab::refute_by_checks(result, claim);
  claim.place = "section 7";
  claim.command = command;
  claim.assumptions = {
      "n: lines, and as many points", "random samples instead of the report's eps-nets",
      "random scenes, which say nothing of the worst case", "the powers without their logarithms"};
  claim.small_run = lab::small_run(std::move(claim.small_run));
  report.claims.push_back(std::move(claim));
  report.figures.push_back(
      growth_figure("Proofs of incidences by cuttings",
                    "Certificates, the most at one time; means of scenes with bars "
                    "of two standard errors, and the power of n that fits.",
                    "certificates", {1.5, 5.0 / 3, 2}, std::move(curves)));
  report.figure_names = {"section-7-cuttings"};
  report.tables = lab::markdown(result.table);
  return report;
}

}  // namespace kinex::families
