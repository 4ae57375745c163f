// SPDX-License-Identifier: GPL-3.0-or-later
// Questions: how often does the closest pair change, what do the structures for it cost, and what do
//   swaps of points cost that are far apart? Is there a good structure for two colours, or for balls of
//   different radii? (Guibas 1998, section 7.)
// Scenes: random motion; pass-along-row, colours-along-row and gaps-along-row, where all pairs are the
//   closest in turn; exchange-in-all-orders, where every pair exchanges its order far apart.
// Expected: nm - 1 and n^2 - 1 changes; 4 C(n,2) swaps of the structure that sorts; equal changes in
//   all structures; of random motion n^2 swaps with sorted lists, n^(3/2) events without them.
// Cost: about 3 minutes; --quick: seconds.
#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "experiments/families/points/kds_claims.h"
#include "experiments/families/proximity/experiments.h"
#include "experiments/lab/growth_words.h"

namespace kinex::families {

namespace {

constexpr const char* kPairUniform = "uniform-square";
constexpr const char* kPairRow = "pass-along-row";
constexpr const char* kColourRow = "colours-along-row";
constexpr const char* kGapRow = "gaps-along-row";
constexpr const char* kApartDiscs = "apart-discs";
constexpr const char* kFarExchanges = "exchange-in-all-orders";

struct PairMethod {
  const char* structure;
  const char* title;
  int largest, largest_quick;  // n, of random motion
  double milliseconds;         // a run with n = 100
  double growth;               // of that, as a power of n
};
constexpr PairMethod kPairMethods[] = {
    {"closest_pair_cones", "four sorted lists, octants", 400, 200, 10, 2},
    {"closest_pair_local", "octants without lists", 1600, 200, 30, 1.5},
    {"closest_pair_range_tree", "four sorted lists, range trees", 200, 50, 200, 2},
    {"closest_pair_bins", "a grid", 1600, 200, 30, 1.5},
    {"closest_pair_delaunay", "Delaunay edges", 1600, 200, 20, 1.5},
    {"closest_pair_all", "all pairs", 100, 50, 100, 2}};
constexpr PairMethod kOctantMethods[] = {{"octants_listed", "octants, four sorted lists", 800, 200, 30, 2},
                               {"octants_local", "octants without lists", 1600, 200, 20, 1.5}};
constexpr int kPairSizes[] = {25, 35, 50, 70, 100, 140, 200, 400, 800, 1600};

void add_random_pairs(std::vector<lab::SeriesPoint>& points, const PairMethod& method, bool quick) {
  for (const int n : kPairSizes) {
    if (n > (quick ? method.largest_quick : method.largest)) continue;
    points.push_back(kds_random({method.structure, kPairUniform}, n, 8));
    points.back().cost = 8e-3 * method.milliseconds * std::pow(n / 100.0, method.growth);
  }
}

std::string ratio_text(const std::vector<lab::FitPoint>& ratios) {
  std::string text;
  for (const lab::FitPoint& point : ratios) {
    text += fmt::format("{}{:.1f} at n = {:.0f}", text.empty() ? "" : ", ", point.count, point.n);
  }
  return text;
}

lab::PaperClaim claim_on_agreement(const std::vector<lab::SeriesResult>& results) {
  std::vector<std::string_view> structures;
  for (const PairMethod& method : kPairMethods) structures.push_back(method.structure);
  const KdsAgreement agreement = agreement_of(results, structures);
  lab::PaperClaim claim;
  claim.id = "7.4.same-changes";
  claim.kind = "finding";
  claim.statement =
      "A tournament over the Delaunay edges maintains the closest pair, and so do cones and sorted "
      "lists.";
  claim.expected = "as many changes as the tournament of all pairs, and the others, on every scene";
  claim.tolerance = "none";
  claim.assumptions = {std::string(kAgreementAssumption)};
  claim.small_run.structure = "closest_pair_delaunay";
  claim.small_run.workload = kPairRow;
  const bool enough = agreement.scenes > 0;
  claim.observed = !agreement.difference.empty()
                       ? agreement.difference
                       : fmt::format("as many on all {} scenes that several have", agreement.scenes);
  claim.verdict = !agreement.difference.empty() ? lab::Verdict::kRefuted
                  : enough                      ? lab::Verdict::kConfirmed
                                                : lab::Verdict::kOpen;
  return claim;
}

// Closest pairs of one colour.
void add_pair_claims(const std::vector<lab::SeriesResult>& results, lab::PartReport& report) {
  report.claims.push_back(count_claim(
      results, {"7.3.lower",
                "The closest pair changes Omega(n^2) times on linear motions (not in the report).",
                {"closest_pair_local", kPairRow},
                "external",
                "changes",
                "nm - 1",
                [](double n, double m) { return n * m - 1; }}));
  report.claims.push_back(growth_claim(
      means_of(results, {"closest_pair_local", kPairRow}, "external"),
      {"7.3.upper", "The closest pair changes a nearly quadratic number of times at most.",
       {"closest_pair_local", kPairRow}, "changes", 2, KdsPower::kOnAllMotion}));
  report.claims.back().observed +=
      "; the bound n(n - 1) - 2 on linear motions is a check of every run";
  report.claims.push_back(claim_on_agreement(results));
  report.claims.push_back(count_claim(
      results, {"7.5.swaps",
                "Sorted projections along a constant number of directions have Omega(n^2) swaps on "
                "linear motions.",
                {"octants_listed", kFarExchanges},
                "processed",
                "swaps in four lists",
                "2n(n - 1)",
                [](double n, double) { return 2 * n * (n - 1); }}));
  report.claims.back().assumptions = {
      "the upper half, O(n^2), is not a matter of runs: two points of linear motion exchange their "
      "order along a direction at most once, in four lists all of them 2n(n - 1) times; this bound "
      "is "
      "checked in every run"};
  report.claims.push_back(bound_claim(
      results, {"7.5.compact", "The structure by cones is compact.",
                {"closest_pair_cones", kPairUniform}, "max_live", "certificates", "8n - 5",
                [](double n, double) { return 8 * n - 5; }}));
}

// The report's partition into bins, where all pairs exchange their order far apart.
lab::PaperClaim grid_at_worst(const std::vector<lab::SeriesResult>& results) {
  const KdsRuns grid{"closest_pair_bins", kFarExchanges};
  std::string observed = "events";
  const std::vector<lab::FitPoint> events = means_of(results, grid, "processed");
  for (const lab::FitPoint& point : events) {
    observed += fmt::format("{}{:.0f} at n = {:.0f}", &point == &events.front() ? " " : ", ",
                            point.count, point.n);
  }
  if (const auto fit = lab::fit_power(events)) observed += "; " + lab::fit_text(*fit);
  const std::vector<lab::FitPoint> certificates = means_of(results, grid, "max_live");
  if (const auto fit = lab::fit_power(certificates)) {
    observed += "; certificates: " + lab::fit_text(*fit);
  }
  observed += ". Lists have 2n(n - 1) swaps there; the grid has";
  for (const lab::FitPoint& point : events) {
    observed += fmt::format("{}{:.2f}", &point == &events.front() ? " " : ", ",
                            point.count / (2 * point.n * (point.n - 1)));
  }
  observed += " times as many events";
  return open_question("7.7.bins",
                       "Bins avoid exchanges of points that are far apart, but at some point the "
                       "cost of moving points from bin to bin becomes significant. How many "
                       "events has a grid on exchange-in-all-orders, where lists do worst?",
                       std::move(observed), grid);
}

// Whether the exponent between neighbouring sizes rises from each size to the next.
bool exponents_rise(const std::vector<lab::FitPoint>& points) {
  double last = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double exponent =
        std::log(points[i].count / points[i - 1].count) / std::log(points[i].n / points[i - 1].n);
    if (i > 1 && exponent <= last) return false;
    last = exponent;
  }
  return points.size() > 2;
}

// Octants without lists, where all pairs exchange their order far apart.
lab::PaperClaim local_at_worst(const std::vector<lab::SeriesResult>& results) {
  const KdsRuns local{"octants_local", kFarExchanges}, listed{"octants_listed", kFarExchanges};
  const std::vector<lab::FitPoint> failures = means_of(results, local, "processed");
  std::string observed;
  for (const lab::FitPoint& point : failures) {
    observed +=
        fmt::format("{}n = {:.0f}: {:.0f} failures for {:.0f} swaps", observed.empty() ? "" : "; ",
                    point.n, point.count, 2 * point.n * (point.n - 1));
  }
  if (const auto fit = lab::fit_power(failures)) observed += "; " + lab::fit_text(*fit);
  const std::vector<lab::FitPoint> shares = ratios_of(results, local, listed, "processed");
  if (failures.size() > 2 && !shares.empty()) {
    observed += fmt::format(
        ". There are {:.2f} times as many failures as swaps at n = {:.0f}, and {:.2f} times at n = "
        "{:.0f}; {}. ",
        shares.front().count, shares.front().n, shares.back().count, shares.back().n,
        lab::local_exponents(failures));
    observed +=
        exponents_rise(failures)
            ? "It rises at every size, so that no run here shows a growth slower than that of "
              "the swaps, n^2"
            : "It does not rise at every size";
    observed += ". Other motions may have more";
  }
  return open_question(
      "7.7.worst",
      "What is the worst number of events of a structure for the closest pair without "
      "sorted lists? On exchange-in-all-orders, where lists do worst:",
      std::move(observed), local);
}

// What sorting costs.
void add_sorting_claims(const std::vector<lab::SeriesResult>& results, lab::PartReport& report) {
  const KdsRuns listed{"octants_listed", kPairUniform}, local{"octants_local", kPairUniform};
  const std::vector<lab::FitPoint> ratios = ratios_of(results, listed, local, "processed");
  lab::PaperClaim far = growth_claim(
      ratios, {"7.7.far-apart",
               "Structures that sort process swaps of points that are far apart, which change "
               "nothing: their part grows with n.",
               listed, "swaps in the lists, for each failure without lists,", 0.1, KdsPower::kAtLeast});
  far.observed += "; " + ratio_text(ratios);
  far.assumptions = {"random motion in the unit square",
                     "the structure without lists, octants_local, is ours; it has the same attribute"};
  report.claims.push_back(std::move(far));
  report.claims.push_back(
      growth_claim(means_of(results, {"closest_pair_bins", kPairUniform}, "processed"),
                   {"7.7.grid",
                    "A grid avoids these swaps for points that are spread evenly: Theta(n^(3/2)) events "
                    "of random motion (not in the report).",
                    {"closest_pair_bins", kPairUniform}, "events", 1.5}));
  report.claims.push_back(local_at_worst(results));
  report.claims.push_back(grid_at_worst(results));
}

void add_colour_claims(const std::vector<lab::SeriesResult>& results, lab::PartReport& report) {
  const KdsRuns row{"bichromatic_pair_delaunay", kColourRow};
  report.claims.push_back(count_claim(
      results,
      {"7.6.lower",
       "The closest pair of two colours changes Omega(n^2) times on linear motions (not in the "
       "report).",
       row, "external", "changes", "n^2 - 1", [](double n, double) { return n * n - 1; }}));
  const std::vector<lab::FitPoint> ratios = ratios_of(results, row, "processed", "external");
  std::string observed = "by Delaunay edges, events for each change of the pair: " + ratio_text(ratios);
  if (const auto fit = lab::fit_power(ratios)) observed += "; " + lab::fit_text(*fit);
  const std::vector<lab::FitPoint> random =
      ratios_of(results, {"bichromatic_pair_delaunay", kPairUniform}, "processed", "external");
  observed += "; on random motion " + ratio_text(random);
  if (const auto fit = lab::fit_power(random)) observed += "; " + lab::fit_text(*fit);
  observed += ". On the row, where the pair changes n^2 - 1 times, " +
              lab::local_exponents(ratios) +
              "; on random motion, where it changes seldom, the events for a change grow " +
              lab::careful_growth_words(lab::fit_power(random), 0.5, "n^(1/2)");
  report.claims.push_back(open_question(
      "7.6.efficient",
      "Is there a responsive, compact, local and efficient structure for the closest pair of two "
      "colours? The one by Delaunay edges is not efficient, if events for a change grow with n:",
      observed, row));
}

// Discs of different radii, by their gap.
void add_disc_claims(const std::vector<lab::SeriesResult>& results, lab::PartReport& report) {
  const KdsRuns row{"closest_pair_discs", kGapRow}, apart{"closest_pair_discs", kApartDiscs};
  report.claims.push_back(count_claim(
      results, {"7.6.balls-lower",
                "The two balls of different radii with the smallest gap change Omega(n^2) times on linear "
                "motions.",
                row, "external", "changes", "nm - 1", [](double n, double m) { return n * m - 1; }}));
  const std::vector<lab::FitPoint> ratios = ratios_of(results, row, "processed", "external");
  std::string observed = "events for each change of the pair: " + ratio_text(ratios);
  if (const auto fit = lab::fit_power(ratios)) observed += "; " + lab::fit_text(*fit);
  const std::vector<lab::FitPoint> random = ratios_of(results, apart, "processed", "external");
  observed += "; on random motion " + ratio_text(random);
  if (const auto fit = lab::fit_power(random)) observed += "; " + lab::fit_text(*fit);
  const std::vector<lab::FitPoint> local = means_of(results, apart, "max_per_object");
  if (const auto fit = lab::fit_power(local)) {
    observed += "; the most certificates of one disc there: " + lab::fit_text(*fit);
  }
  observed += ". On the row " + lab::local_exponents(ratios) +
              "; on random motion the events for a change grow " +
              lab::careful_growth_words(lab::fit_power(random), 0.5, "n^(1/2)") +
              ". Radii are small there: 7.6.balls-local has the other case";
  report.claims.push_back(open_question(
      "7.6.balls-efficient",
      "Is there a responsive, compact, local and efficient structure for the closest pair of balls of "
      "different radii? The one by edges of the regular triangulation:",
      observed, row));
}

void add_exchange_figure(const std::vector<lab::SeriesResult>& results, lab::PartReport& report) {
  std::vector<lab::Curve> curves;
  curves.push_back({"swaps of four sorted lists",
                    means_of(results, {"octants_listed", kFarExchanges}, "processed"), ""});
  curves.push_back({"failures of octants without lists",
                    means_of(results, {"octants_local", kFarExchanges}, "processed"), ""});
  curves.push_back({"events of a grid",
                    means_of(results, {"closest_pair_bins", kFarExchanges}, "processed"), ""});
  report.figures.push_back(growth_figure("Points that all exchange their order far apart",
                                         "Events of one run of exchange-in-all-orders, which are "
                                         "exact, and the power of n that fits all "
                                         "sizes, with its 95 % interval.",
                                         "events", {1.5, 2}, std::move(curves)));
  report.figure_names.push_back("section-7-exchanges");
}

void add_ratio_figure(const std::vector<lab::SeriesResult>& results, lab::PartReport& report) {
  const auto ratios = [&results](const char* structure, const char* workload) {
    return ratios_of(results, {structure, workload}, "processed", "external");
  };
  std::vector<lab::Curve> curves;
  curves.push_back(
      {"two colours, colours-along-row", ratios("bichromatic_pair_delaunay", kColourRow), ""});
  curves.push_back(
      {"two colours, random motion", ratios("bichromatic_pair_delaunay", kPairUniform), ""});
  curves.push_back({"discs, gaps-along-row", ratios("closest_pair_discs", kGapRow), ""});
  curves.push_back({"discs, random motion", ratios("closest_pair_discs", kApartDiscs), ""});
  report.figures.push_back(growth_figure("Events for each change of a closest pair",
                                         "Of two colours, by Delaunay edges, and of discs, by "
                                         "edges of the regular triangulation; along a "
                                         "row exact counts, of random motion means with bars of "
                                         "two standard errors; the power of n that "
                                         "fits all sizes, with its 95 % interval.",
                                         "events for a change", {0.5}, std::move(curves)));
  report.figure_names.push_back("section-7-pair-ratios");
}

}  // namespace

std::vector<lab::SeriesPoint> kds_section_7_pairs_points(bool quick) {
  std::vector<lab::SeriesPoint> points;
  for (const PairMethod& method : kOctantMethods) {
    add_random_pairs(points, method, quick);
    for (const int n : {8, 16, 32, 64, 128}) {
      if (quick && n > 64) continue;
      points.push_back(kds_single({method.structure, kFarExchanges}, n));
    }
  }
  for (const int n : {8, 16, 32, 64, 128}) {
    if (quick && n > 32) continue;
    points.push_back(kds_single({"closest_pair_bins", kFarExchanges}, n));
    points.back().cost = n * n / 10000.0;
  }
  for (const PairMethod& method : kPairMethods) {
    add_random_pairs(points, method, quick);
    points.push_back(kds_single({method.structure, kPairRow}, 6, 6));
  }
  for (const int n : {8, 12, 16, 24, 32}) {
    if (quick && n > 16) continue;
    points.push_back(kds_single({"closest_pair_local", kPairRow}, n, n));
  }
  add_random_pairs(points, {"bichromatic_pair_delaunay", "", 800, 100, 20, 1.5}, quick);
  for (const int n : {4, 6, 8, 12, 16, 24, 32}) {
    if (quick && n > 16) continue;
    points.push_back(kds_single({"bichromatic_pair_delaunay", kColourRow}, n));
  }
  for (const int n : {4, 6, 8, 12, 16, 24}) {
    if (quick && n > 12) continue;
    points.push_back(kds_single({"closest_pair_discs", kGapRow}, n, n));
  }
  for (const int n : {25, 35, 50, 70, 100, 200, 400}) {
    if (quick && n > 70) continue;
    points.push_back(kds_random({"closest_pair_discs", kApartDiscs}, n, 8));
  }
  return points;
}

lab::PartReport kds_section_7_pairs_report(const std::vector<lab::SeriesResult>& results,
                                           const std::string& command) {
  lab::PartReport report;
  add_pair_claims(results, report);
  add_colour_claims(results, report);
  add_disc_claims(results, report);
  add_sorting_claims(results, report);
  std::vector<lab::Curve> curves;
  for (const PairMethod& method : kPairMethods) {
    curves.push_back({method.title, means_of(results, {method.structure, kPairUniform}, "processed"), ""});
  }
  curves.push_back({"changes of the closest pair",
                    means_of(results, {"closest_pair_delaunay", kPairUniform}, "external"), ""});
  report.figures.push_back(growth_figure(
      "The closest pair of points in random motion",
      "Events of a run, the structure that is read included; means with bars of two standard errors; the "
      "power of n that fits all sizes, with its 95 % interval.",
      "events", {1, 1.5, 2}, std::move(curves)));
  report.figure_names = {"section-7-pairs"};
  add_exchange_figure(results, report);
  add_ratio_figure(results, report);
  finish_section_7(report, results, command);
  return report;
}

}  // namespace kinex::families
