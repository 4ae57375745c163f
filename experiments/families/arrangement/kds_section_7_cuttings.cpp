// SPDX-License-Identifier: GPL-3.0-or-later
// Question: which number r of sample lines makes the proof of incidences by a cutting smallest? (Guibas
//   1998, section 7: O(n^(5/3)) certificates and nearly n^2 events; Theta(n^(4/3)) certificates would be
//   natural.)
// Scenes: n random chords of the unit square and n points in it, linear motion.
// Parameters: r = n^(1/4), n^(1/3), n^(1/2) and n^(2/3), each at sizes of its own where it is an integer: a
//   rounded r would be the same at several n, and the power that fits would be that of a fixed r. n from 8 to
//   256, to 64 in a quick run; 4 scenes, 2 in a quick run.
// Expected: the changes of incidences_all, in every run; r^2 + n r + (n^2 / r) log n certificates in
//   order (structures/arrangement/incidences_cutting.h), fewest near r = n^(1/2). Powers are fitted.
// Left out: larger n, of one scene each: cutting_study.cpp, a study of `kinex verify incidences`.
// Cost: two minutes; --quick: seconds.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/engine/simulator.h"
#include "experiments/families/arrangement/experiments.h"
#include "experiments/families/points/kds_claims.h"
#include "experiments/lab/claim_check.h"
#include "experiments/lab/growth_words.h"
#include "experiments/lab/scene_run.h"
#include "experiments/lab/statistics.h"
#include "experiments/lab/study_runs.h"
#include "experiments/lab/workload.h"
#include "structures/plan.h"

namespace kinex::families {

namespace {

constexpr const char* kChordsAndPoints = "random-lines-and-points";

constexpr int kLargestQuick = 64;

struct SamplePower {
  const char* title;
  double power;            // r = n^power, an integer at each of the sizes
  std::vector<int> sizes;  // n, ascending
};

const std::vector<SamplePower>& sample_powers() {
  static const std::vector<SamplePower> kPowers{
      {"n^(1/4)", 1.0 / 4, {16, 81, 256}},
      {"n^(1/3)", 1.0 / 3, {27, 64, 125, 216}},
      {"n^(1/2)", 1.0 / 2, {16, 25, 36, 49, 64, 81, 100, 121}},
      {"n^(2/3)", 2.0 / 3, {8, 27, 64, 125}}};
  return kPowers;
}

// The sizes of all powers, ascending.
std::set<int> all_sizes(bool quick) {
  std::set<int> sizes;
  for (const SamplePower& sample : sample_powers()) {
    for (const int n : sample.sizes) {
      if (!quick || n <= kLargestQuick) sizes.insert(n);
    }
  }
  return sizes;
}

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

// Of one power at one size.
struct CuttingMeans {
  const char* title;
  int r;
  lab::RunningMean certificates, events;
};

std::vector<CuttingMeans> means_at(int n) {
  std::vector<CuttingMeans> means;
  for (const SamplePower& sample : sample_powers()) {
    if (std::find(sample.sizes.begin(), sample.sizes.end(), n) == sample.sizes.end()) continue;
    means.push_back(
        {sample.title, static_cast<int>(std::lround(std::pow(n, sample.power))), {}, {}});
  }
  return means;
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

struct PowerFits {
  const char* title;
  std::optional<lab::Fit> certificates, events;
};

std::string power_text(const std::vector<lab::FitPoint>& points,
                       const std::optional<lab::Fit>& fit) {
  if (points.empty()) return "no run";
  return fmt::format("{} (sizes: {}, n from {:.0f} to {:.0f})",
                     fit ? lab::fit_text(*fit) : "too few sizes", points.size(), points.front().n,
                     points.back().n);
}

// How all powers grow, those together of which the intervals tell the same.
std::string growth_text(const std::vector<PowerFits>& fits, std::optional<lab::Fit> PowerFits::*fit,
                        double exponent, const char* law) {
  std::vector<std::pair<std::string, std::string>> groups;  // words, and the powers of r
  for (const PowerFits& one : fits) {
    std::string words = lab::growth_words(one.*fit, exponent, law);
    const auto group = std::find_if(groups.begin(), groups.end(),
                                    [&words](const auto& known) { return known.first == words; });
    if (group == groups.end()) {
      groups.emplace_back(std::move(words), one.title);
    } else {
      group->second += fmt::format(", {}", one.title);
    }
  }
  std::string text;
  for (const auto& [words, powers] : groups) {
    text += fmt::format("{}{} for r = {}", text.empty() ? "" : "; ", words, powers);
  }
  return text;
}

// Which power has the fewest certificates: for each two of them at the largest size that both have.
std::string fewest_text(const lab::StudyResult& result) {
  struct Entry {
    std::string_view power;
    lab::FitPoint certificates;
  };
  std::map<double, std::vector<Entry>> by_size;
  for (const SamplePower& sample : sample_powers()) {
    for (const lab::FitPoint& point : cutting_points(result, sample.title, kCuttingCertificates)) {
      by_size[point.n].push_back({sample.title, point});
    }
  }
  std::map<std::pair<std::string_view, std::string_view>, double> largest;  // of two powers
  for (const auto& [n, entries] : by_size) {
    for (std::size_t i = 0; i < entries.size(); ++i) {
      for (std::size_t j = i + 1; j < entries.size(); ++j) {
        largest[{entries[i].power, entries[j].power}] = n;
      }
    }
  }
  std::set<double> sizes;
  for (const auto& two : largest) sizes.insert(two.second);
  std::string text;
  for (const double n : sizes) {
    std::vector<Entry>& entries = by_size[n];
    std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
      return a.certificates.count < b.certificates.count;
    });
    const lab::FitPoint &best = entries[0].certificates, &next = entries[1].certificates;
    const bool is_apart = best.count + 2 * std::hypot(best.error, next.error) < next.count;
    text += fmt::format("{} of r = {} at n = {:.0f} ({:.0f}, of {} powers that have this size{})",
                        text.empty() ? "" : ",", entries[0].power, n, best.count, entries.size(),
                        is_apart ? "" : fmt::format("; not told from r = {}", entries[1].power));
  }
  return text.empty() ? text : ". The fewest certificates are those" + text;
}

}  // namespace

lab::StudyResult study_sample_lines(bool quick, const std::function<bool()>& go_on) {
  lab::StudyResult result;
  result.name = "section-7-cuttings";
  result.table.title = "certificates and events of incidences_cutting";
  result.table.header = {
      "r =", "n", "r", "seeds", "certificates", "standard error", "events", "standard error"};
  result.table.note =
      "n lines and n points; r: sample lines, at sizes of which the power is an integer. Means of "
      "the "
      "scenes: certificates are the most at one time, events are failures, those of the sample's "
      "arrangement and trapezoids included";
  const int seeds = quick ? 2 : 4;
  for (const int n : all_sizes(quick)) {
    std::vector<CuttingMeans> means = means_at(n);
    for (int seed = 1; seed <= seeds; ++seed) {
      const lab::WorkloadParameters parameters{.n = 2 * n,
                                               .seed = static_cast<std::uint64_t>(seed)};
      const Scene scene = lab::generate_scene(kChordsAndPoints, parameters, "incidences_all");
      if (!go_on()) return result;
      const CuttingCounts all = cutting_counts(scene, "incidences_all", 0, result);
      for (CuttingMeans& mean : means) {
        if (!go_on()) return result;
        const CuttingCounts cutting = cutting_counts(scene, "incidences_cutting", mean.r, result);
        mean.certificates.add(cutting.certificates);
        mean.events.add(cutting.events);
        if (cutting.changes == all.changes) continue;
        result.checks.push_back({fmt::format("7.12.cuttings.changes.{}.{}.{}", n, mean.r, seed),
                                 "exactly", "", fmt::format("{:.0f}", all.changes),
                                 fmt::format("{:.0f}", cutting.changes),
                                 "the changes of incidences_all on the same scene",
                                 lab::Verdict::kRefuted, std::nullopt});
      }
    }
    for (const CuttingMeans& mean : means) {
      result.table.rows.push_back({mean.title, std::to_string(n), std::to_string(mean.r),
                                   std::to_string(seeds),
                                   fmt::format("{:.1f}", mean.certificates.mean()),
                                   fmt::format("{:.2f}", mean.certificates.standard_error()),
                                   fmt::format("{:.1f}", mean.events.mean()),
                                   fmt::format("{:.2f}", mean.events.standard_error())});
    }
  }
  return result;
}

lab::PartReport kds_section_7_cuttings_report(const lab::StudyResult& result,
                                              const std::string& command) {
  lab::PartReport report;
  if (result.table.rows.empty()) return report;
  std::string certificates, events;
  std::vector<PowerFits> fits;
  std::vector<lab::Curve> curves;
  for (const SamplePower& sample : sample_powers()) {
    const auto points = cutting_points(result, sample.title, kCuttingCertificates);
    const auto others = cutting_points(result, sample.title, kCuttingEvents);
    fits.push_back({sample.title, lab::fit_power(points), lab::fit_power(others)});
    certificates += fmt::format("{}r = {}: {}", certificates.empty() ? "" : "; ", sample.title,
                                power_text(points, fits.back().certificates));
    events +=
        fmt::format("; events, r = {}: {}", sample.title, power_text(others, fits.back().events));
    if (!points.empty()) curves.push_back({fmt::format("r = {}", sample.title), points, ""});
  }
  lab::PaperClaim claim = open_question(
      "7.12.cuttings",
      "Sides of n lines and n points have a proof of O(n^(5/3)) certificates. How many has a "
      "cutting "
      "by r random sample lines, and how many events?",
      "certificates, " + certificates + events + fewest_text(result) + ". Certificates grow " +
          growth_text(fits, &PowerFits::certificates, 5.0 / 3, "n^(5/3)") + ". Events grow " +
          growth_text(fits, &PowerFits::events, 2, "n^2") +
          ". That is what the intervals of these sizes say of random scenes; of the worst case "
          "they "
          "say nothing",
      {"incidences_cutting", kChordsAndPoints});
  claim.expected =
      "certificates: of the order of r^2 + n r + (n^2 / r) log n; without the logarithm like "
      "n^(7/4), "
      "n^(5/3), n^(3/2) and n^(5/3) for r = n^(1/4), n^(1/3), n^(1/2) and n^(2/3)";
  lab::refute_by_checks(result, claim);
  claim.place = "section 7";
  claim.command = command;
  claim.assumptions = {
      "n: lines, and as many points",
      "each r at sizes of which the power is an integer: other powers have other sizes",
      "random samples instead of the report's eps-nets",
      "random scenes, which say nothing of the worst case",
      "the powers without their logarithms and terms of lower order, which move the exponents of "
      "such "
      "sizes"};
  claim.small_run = lab::small_run(std::move(claim.small_run));
  report.claims.push_back(std::move(claim));
  report.figures.push_back(
      growth_figure("Proofs of incidences by cuttings",
                    "Certificates, the most at one time; means of scenes with bars "
                    "of two standard errors, and the power of n that fits where there are three "
                    "sizes or more.",
                    "certificates", {1.5, 5.0 / 3, 2}, std::move(curves)));
  report.figure_names = {"section-7-cuttings"};
  report.tables = lab::markdown(result.table);
  return report;
}

}  // namespace kinex::families
