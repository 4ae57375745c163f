// SPDX-License-Identifier: GPL-3.0-or-later
// Question: are structures for closest pairs and spanning trees compact, local and responsive? In how
//   many certificates is one object, and how many does one event make? (Guibas 1998, section 7, calls its
//   structures by cones and range trees all three, doubts that a local one exists for balls of unequal
//   radii, and names a large ball with many small ones near its boundary.)
// Scenes: hub_scenes.h, a point with a ring of others about it, and a large disc with small ones on its
//   rim; random motion.
// Parameters: n from 32 to 512, in a quick run to 128; of random motion 4 scenes of each size, to 128.
// Expected: on the hub only range trees are local, which offer few pairs. Our other structures keep a pair
//   for each point that chooses another one, the report's one for each cone and point that is chosen.
// Cost: half a minute; --quick: seconds.
#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/engine/simulator.h"
#include "experiments/families/points/kds_claims.h"
#include "experiments/families/proximity/experiments.h"
#include "experiments/families/proximity/hub_scenes.h"
#include "experiments/lab/claim_check.h"
#include "experiments/lab/growth_words.h"
#include "experiments/lab/scene_run.h"
#include "experiments/lab/statistics.h"
#include "experiments/lab/study_runs.h"
#include "experiments/lab/workload.h"
#include "structures/plan.h"

namespace kinex::families {

namespace {

constexpr const char* kHub = "hub";

struct Subject {
  const char* title;
  const char* structure;
  const char* random;  // a workload
  int cones;           // a parameter; 0: none
  int largest;         // n on the hub
};
constexpr Subject kSubjects[] = {
    {"closest_pair_cones", "closest_pair_cones", "uniform-square", 0, 512},
    {"closest_pair_local", "closest_pair_local", "uniform-square", 0, 512},
    {"closest_pair_range_tree", "closest_pair_range_tree", "uniform-square", 0, 512},
    {"closest_pair_range_tree, quadrants", "closest_pair_range_tree", "uniform-square", 4, 512},
    {"closest_pair_delaunay", "closest_pair_delaunay", "uniform-square", 0, 512},
    {"mst_maximum_norm_list", "mst_maximum_norm_list", "uniform-square", 0, 512},
    {"mst_maximum_norm_cycles", "mst_maximum_norm_cycles", "uniform-square", 0, 256},
    {"mst_polygon_list", "mst_polygon_list", "uniform-square", 0, 512},
    {"mst_polygon_cycles", "mst_polygon_cycles", "uniform-square", 0, 256},
    {"closest_pair_discs", "closest_pair_discs", "apart-discs", 0, 512}};

Scene hub_scene(const Subject& subject, int n) {
  const bool discs = std::string_view(subject.structure) == "closest_pair_discs";
  return discs ? hub_of_discs(n) : hub_of_points(n);
}

struct Counts {
  double certificates = 0, of_one = 0;         // the most, of all structures of the run
  double events = 0, made = 0,
         most_made = 0;  // failures, certificates made after the start, and the most by one repair
};

Counts counts_of(Scene scene, const Subject& subject, lab::StudyResult& study) {
  Request request{subject.structure, subject.structure, {}};
  if (subject.cones > 0) request.parameters = {{"cones", Rational(subject.cones)}};
  scene.maintain = {std::move(request)};
  SimulatorOptions options;
  options.audit = AuditLevel::kNone;
  const auto simulator = lab::make_simulator(scene, "exact", options);
  simulator->start();
  Counts counts;
  // What is made when an instant is settled counts, too.
  for (StructureId id = 0; id < simulator->structures(); ++id) {
    counts.made -= static_cast<double>(simulator->ledger(id).certificates_created);
  }
  simulator->run_until(std::nullopt);
  lab::check_run(*simulator, fmt::format("{}, {}", subject.structure, scene.name), study);
  for (StructureId id = 0; id < simulator->structures(); ++id) {
    const StructureLedger& ledger = simulator->ledger(id);
    counts.certificates += static_cast<double>(ledger.max_live);
    counts.of_one += static_cast<double>(ledger.max_per_object);
    counts.events += static_cast<double>(ledger.created_per_event.events);
    counts.made += static_cast<double>(ledger.certificates_created);
    counts.most_made =
        std::max(counts.most_made, static_cast<double>(ledger.created_per_event.max));
  }
  return counts;
}

// Columns of the study's table.
enum LocalityColumn : std::size_t {
  kLocalityStructure,
  kLocalityScenes,
  kLocalityN,
  kLocalitySeeds,
  kLocalityCertificates,
  kLocalityOfOne,
  kLocalityError,
  kLocalityEvents,
  kLocalityMade,
  kLocalityMost
};

void add_row(lab::StudyResult& result, const Subject& subject, std::string_view scenes, int n,
             const std::vector<Counts>& runs) {
  lab::RunningMean certificates, of_one, events, most;
  double made = 0, all = 0;
  for (const Counts& run : runs) {
    certificates.add(run.certificates);
    of_one.add(run.of_one);
    events.add(run.events);
    most.add(run.most_made);
    made += run.made;
    all += run.events;
  }
  result.table.rows.push_back(
      {subject.title, std::string(scenes), std::to_string(n), std::to_string(runs.size()),
       fmt::format("{:.1f}", certificates.mean()), fmt::format("{:.2f}", of_one.mean()),
       fmt::format("{:.3f}", of_one.standard_error()), fmt::format("{:.1f}", events.mean()),
       all > 0 ? fmt::format("{:.2f}", made / all) : "-", fmt::format("{:.1f}", most.mean())});
}

// The title of a structure, over n.
std::vector<lab::FitPoint> locality_points(const lab::StudyResult& result, std::string_view title,
                                           std::string_view scenes, LocalityColumn column) {
  std::vector<lab::FitPoint> points;
  for (const std::vector<std::string>& row : result.table.rows) {
    if (row[kLocalityStructure] != title || row[kLocalityScenes] != scenes) continue;
    points.push_back({std::stod(row[kLocalityN]), std::stod(row[column]),
                      column == kLocalityOfOne ? std::stod(row[kLocalityError]) : 0});
  }
  return points;
}

std::string list_text(const std::vector<lab::FitPoint>& points) {
  std::string text;
  for (const lab::FitPoint& point : points) {
    text += fmt::format("{}{:.0f} at n = {:.0f}", text.empty() ? "" : ", ", point.count, point.n);
  }
  return text;
}

// A claim that one of the structures is not local.
struct NotLocal {
  const char* id;
  const char* title;
  const char* statement;
};
constexpr NotLocal kNotLocal[] = {
    {"7.5.local-cones", "closest_pair_cones",
     "closest_pair_cones, our closest pair by cones and sorted lists, is not local: a point that "
     "is "
     "next for many others is in a pair with each (ours; the report's is local)."},
    {"7.5.local-octants", "closest_pair_local",
     "closest_pair_local, our closest pair by cones without lists, is not local (ours; the "
     "report's, "
     "by lists, is)."},
    {"7.8.local", "mst_maximum_norm_list",
     "mst_maximum_norm_list, our tree in a polyhedral metric by the order of the pairs of octants, "
     "is "
     "not local (ours; the report's is)."},
    {"7.8.polygon-local", "mst_polygon_list",
     "mst_polygon_list, our approximate Euclidean tree by the order of the pairs of cones, is not "
     "local (ours; the report's is)."}};

lab::PaperClaim not_local(const lab::StudyResult& result, const NotLocal& what) {
  const std::vector<lab::FitPoint> hub = locality_points(result, what.title, kHub, kLocalityOfOne);
  const std::vector<lab::FitPoint> random =
      locality_points(result, what.title, "uniform-square", kLocalityOfOne);
  lab::PaperClaim claim =
      growth_claim(hub, {what.id,
                         what.statement,
                         {what.title, "uniform-square"},
                         "the certificates of one point, on a hub with a ring of others,",
                         0.5,
                         KdsPower::kAtLeast});
  claim.observed += "; " + list_text(hub) + "; of random motion " + list_text(random);
  if (const auto fit = lab::fit_power(random)) claim.observed += ", " + lab::fit_text(*fit);
  claim.assumptions = {
      "the structure is ours: the report's is not described in full, and nothing here is about it",
      "local: polylogarithmic, so that a power of n refutes it"};
  return claim;
}

lab::PaperClaim range_trees(const lab::StudyResult& result) {
  std::string observed, growth;
  for (const char* const title :
       {"closest_pair_range_tree", "closest_pair_range_tree, quadrants"}) {
    const std::vector<lab::FitPoint> hub = locality_points(result, title, kHub, kLocalityOfOne);
    observed += fmt::format("{}{}: {}", observed.empty() ? "" : "; ", title, list_text(hub));
    const auto fit = lab::fit_power(hub);
    if (fit) observed += ", " + lab::fit_text(*fit);
    growth += fmt::format("{} they grow {}", growth.empty() ? "by octants" : ", by four cones",
                          lab::growth_words(fit, 1, "n"));
  }
  lab::PaperClaim claim = open_question(
      "7.5.local-range-tree",
      "The report's closest pair by cones and range trees is local. In how many certificates is "
      "one "
      "point in ours, by octants and by four cones of 90 degrees, on a hub with a ring of others?",
      observed +
          ". A node of a range tree offers a fixed number of pairs, whichever points are next for "
          "others. "
          "The certificates of the hub: " +
          growth,
      {"closest_pair_range_tree", "uniform-square"});
  claim.expected = "certificates: polylogarithmic, if the structure is local";
  claim.assumptions = {"the structure is ours; runs cannot confirm a bound on all motions"};
  return claim;
}

// The most certificates that one failure makes on the hub, of several structures: at each size, the most of
// all sizes, and whether that is ever more than n.
std::string made_text(const lab::StudyResult& result, const std::vector<const char*>& titles) {
  std::string all, most, above;
  for (const char* const title : titles) {
    const std::vector<lab::FitPoint> points = locality_points(result, title, kHub, kLocalityMost);
    if (points.empty()) continue;
    const auto largest = std::max_element(
        points.begin(), points.end(),
        [](const lab::FitPoint& a, const lab::FitPoint& b) { return a.count < b.count; });
    all += fmt::format("{}{}: {}", all.empty() ? "" : "; ", title, list_text(points));
    most += fmt::format("{}{:.0f} by {}", most.empty() ? "" : ", ", largest->count, title);
    const bool is_above = std::any_of(points.begin(), points.end(), [](const lab::FitPoint& point) {
      return point.count > point.n;
    });
    if (is_above) above += fmt::format("{}{}", above.empty() ? "" : " and by ", title);
  }
  if (most.empty()) return "no run";
  return all + ". At all sizes one failure makes at most " + most + ". " +
         (above.empty() ? "No failure makes more than n"
                        : "More than n are made by " + above + ", at no size by the others") +
         "; one scene of each size does not tell a constant from a polylogarithm";
}

}  // namespace

lab::StudyResult study_locality(bool quick, const std::function<bool()>& go_on) {
  lab::StudyResult result;
  result.name = "section-7-locality";
  result.table.title = "certificates of one object, and of one event";
  result.table.header = {
      "structure",     "scenes",         "n",        "seeds",         "certificates",
      "of one object", "standard error", "failures", "made for each", "at most by one repair"};
  result.table.note =
      "hub: a point with a ring of others about it, or a large disc with small ones on its rim. "
      "Certificates, of all objects and of one, are the most at one time, those of structures that "
      "are read included; means of the scenes. Made by one: certificates that the failure of one "
      "makes, the mean and the most";
  for (const Subject& subject : kSubjects) {
    for (const int n : {32, 64, 128, 256, 512}) {
      if (n > (quick ? 128 : subject.largest)) continue;
      if (!go_on()) return result;
      add_row(result, subject, kHub, n, {counts_of(hub_scene(subject, n), subject, result)});
    }
    for (const int n : {16, 32, 64, 128}) {
      if (n > (quick ? 32 : subject.largest)) continue;
      std::vector<Counts> runs;
      for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        if (!go_on()) return result;
        runs.push_back(counts_of(
            lab::generate_scene(subject.random, {.n = n, .seed = seed}, subject.structure), subject,
            result));
      }
      add_row(result, subject, subject.random, n, runs);
    }
  }
  return result;
}

lab::PartReport kds_section_7_locality_report(const lab::StudyResult& result,
                                              const std::string& command) {
  lab::PartReport report;
  if (result.table.rows.empty()) return report;
  for (const NotLocal& what : kNotLocal) report.claims.push_back(not_local(result, what));
  report.claims.push_back(range_trees(result));
  report.claims.push_back(
      growth_claim(locality_points(result, "closest_pair_discs", kHub, kLocalityOfOne),
                   {"7.6.balls-local",
                    "A large ball with many small ones near its boundary suggests that sublinear "
                    "locality may not "
                    "be possible for balls of unequal radii. The structure by edges of the regular "
                    "triangulation "
                    "is not local.",
                    {"closest_pair_discs", "apart-discs"},
                    "the certificates of the large disc, with n - 1 small ones on its rim,",
                    1}));
  report.claims.back().assumptions = {"that no other structure is local is not shown"};
  for (const bool trees : {false, true}) {
    report.claims.push_back(open_question(
        trees ? "7.8.responsive" : "7.5.responsive",
        trees
            ? "The report's trees in a polyhedral metric are responsive. How many certificates "
              "does "
              "one failure make at most, in ours, on a hub with a ring of others?"
            : "The report's structures for the closest pair are responsive. How many certificates "
              "does one failure make at most, in ours, on a hub with a ring of others?",
        trees ? made_text(result, {"mst_polygon_list", "mst_polygon_cycles",
                                   "mst_maximum_norm_list", "mst_maximum_norm_cycles"}) +
                    ". By cycles a change of the tree may renew all cycles, which is not responsive"
              : made_text(result,
                          {"closest_pair_cones", "closest_pair_local", "closest_pair_range_tree"}),
        {trees ? "mst_polygon_list" : "closest_pair_cones", "uniform-square"}));
    report.claims.back().expected = "certificates: polylogarithmic, if the structure is responsive";
    report.claims.back().assumptions = {
        "certificates that a structure makes when the instant of a failure is settled, in one that "
        "it "
        "reads or of its own, are not counted"};
  }
  for (lab::PaperClaim& claim : report.claims) {
    lab::refute_by_checks(result, claim);
    claim.place = "section 7";
    claim.command = command;
    claim.small_run = lab::small_run(std::move(claim.small_run));
  }
  std::vector<lab::Curve> curves;
  for (const char* const title :
       {"closest_pair_cones", "closest_pair_range_tree", "closest_pair_range_tree, quadrants",
        "closest_pair_discs", "mst_polygon_list", "mst_polygon_cycles"}) {
    curves.push_back({title, locality_points(result, title, kHub, kLocalityOfOne), ""});
  }
  report.figures.push_back(
      growth_figure("Certificates of one object, on a hub with a ring of others",
                    "The most at one time, and the power of n that fits, with its 95 % interval.",
                    "certificates of one object", {0.5, 1}, std::move(curves)));
  report.figure_names = {"section-7-locality"};
  report.tables = lab::markdown(result.table);
  return report;
}

}  // namespace kinex::families
