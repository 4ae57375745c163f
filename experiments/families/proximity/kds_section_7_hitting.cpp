// SPDX-License-Identifier: GPL-3.0-or-later
// Question: how many points hit all pairs of discs that meet, so that each two that meet have one of the
//   points in common? (Guibas 1998, section 7: O(n^(5/3)) suffice, Omega(n^(4/3)) may be needed, and they
//   can be taken from maximal cells; how to find them while discs move is open.)
// Scenes: small-discs, as dense as there are many, so that the pairs that meet grow like n^2; random-discs,
//   where they grow like n. At rational times.
// Parameters: n from 12 to 96, 8 scenes of each at 5 times, in a quick run to 48 and 4 scenes. Times of one
//   scene depend on each other: the errors are those of the means of scenes.
// Method: exact. A largest set of discs with a common point has the centre of a disc or a crossing of two
//   circles in common. A greedy choice: next the set that hits most pairs that are not hit yet.
// Expected: nothing; a power of n is fitted. A greedy choice is at most a factor of 1 + log(pairs) above
//   the smallest one.
// Cost: seconds.
#include <fmt/format.h>

#include <algorithm>
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
#include "experiments/families/points/kds_claims.h"
#include "experiments/families/proximity/experiments.h"
#include "experiments/lab/claim_check.h"
#include "experiments/lab/scene_run.h"
#include "experiments/lab/statistics.h"
#include "experiments/lab/study_runs.h"
#include "experiments/lab/workload.h"
#include "experiments/lab/workload_parts.h"

namespace kinex::families {

namespace {

constexpr const char* kHitDiscs = "disc_pairs_all";
constexpr const char* kDense = "small-discs";
constexpr const char* kSparse = "random-discs";

struct Disc {
  Rational x, y, r;
};
using Pair = std::pair<std::size_t, std::size_t>;
using Members = std::vector<std::size_t>;  // discs, ascending

// The sign of p + q sqrt(root).
int sign_of(const Rational& p, const Rational& q, const Rational& root) {
  const int a = p.sign(), b = root.is_zero() ? 0 : q.sign();
  if (a == 0 || b == 0 || a == b) return a != 0 ? a : b;
  return a * (p * p - q * q * root).sign();
}

// A point: (x + u s, y + v s), s the root of a rational.
struct Place {
  Rational x, y, u, v, root;
};

Members discs_at(const std::vector<Disc>& discs, const Place& at) {
  Members inside;
  for (std::size_t k = 0; k < discs.size(); ++k) {
    const Rational x = at.x - discs[k].x, y = at.y - discs[k].y;
    const Rational plain = x * x + y * y + (at.u * at.u + at.v * at.v) * at.root -
                           discs[k].r * discs[k].r;
    if (sign_of(plain, Rational(2) * (x * at.u + y * at.v), at.root) <= 0) inside.push_back(k);
  }
  return inside;
}

// The crossings of two circles, if there are any.
void add_crossings(const Disc& a, const Disc& b, std::vector<Place>& places) {
  const Rational x = b.x - a.x, y = b.y - a.y, square = x * x + y * y;
  if (square.is_zero()) return;
  const Rational share = (a.r * a.r - b.r * b.r + square) / (Rational(2) * square);
  const Rational root = a.r * a.r / square - share * share;
  if (root.sign() < 0) return;
  for (const int side : {1, -1}) {
    places.push_back({a.x + share * x, a.y + share * y, Rational(-side) * y, Rational(side) * x, root});
  }
}

// The largest sets of two discs or more with a common point, in lexicographic order.
std::vector<Members> maximal_sets(const std::vector<Disc>& discs) {
  std::vector<Place> places;
  for (std::size_t i = 0; i < discs.size(); ++i) {
    places.push_back({discs[i].x, discs[i].y, 0, 0, 0});
    for (std::size_t j = i + 1; j < discs.size(); ++j) add_crossings(discs[i], discs[j], places);
  }
  std::vector<Members> sets;
  for (const Place& place : places) {
    Members inside = discs_at(discs, place);
    if (inside.size() >= 2) sets.push_back(std::move(inside));
  }
  std::sort(sets.begin(), sets.end());
  sets.erase(std::unique(sets.begin(), sets.end()), sets.end());
  std::vector<Members> largest;
  for (const Members& set : sets) {
    const bool inside_another = std::any_of(sets.begin(), sets.end(), [&set](const Members& other) {
      return other.size() > set.size() &&
             std::includes(other.begin(), other.end(), set.begin(), set.end());
    });
    if (!inside_another) largest.push_back(set);
  }
  return largest;
}

// The pairs that meet, ascending.
std::vector<Pair> pairs_of(const std::vector<Members>& sets) {
  std::vector<Pair> pairs;
  for (const Members& set : sets) {
    for (std::size_t i = 0; i < set.size(); ++i) {
      for (std::size_t j = i + 1; j < set.size(); ++j) pairs.emplace_back(set[i], set[j]);
    }
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

// How many of the sets a greedy choice takes until every pair is in one of them.
std::size_t greedy_points(const std::vector<Members>& sets, std::vector<Pair> left) {
  std::size_t points = 0;
  for (; !left.empty(); ++points) {
    const auto hits = [&left](const Members& set) {
      return std::count_if(left.begin(), left.end(), [&set](const Pair& pair) {
        return std::binary_search(set.begin(), set.end(), pair.first) &&
               std::binary_search(set.begin(), set.end(), pair.second);
      });
    };
    const auto best = std::max_element(sets.begin(), sets.end(), [&](const Members& a, const Members& b) {
      return hits(a) < hits(b);
    });
    std::erase_if(left, [&best](const Pair& pair) {
      return std::binary_search(best->begin(), best->end(), pair.first) &&
             std::binary_search(best->begin(), best->end(), pair.second);
    });
  }
  return points;
}

struct Hitting {
  lab::RunningMean pairs, sets, points;
  std::size_t different = 0;  // pairs that the structure has and the sets have not, or the reverse
};

Hitting hit_at(const char* workload, int n, std::uint64_t seed, int times,
               const std::function<bool()>& go_on, lab::StudyResult& study) {
  const Scene scene = lab::generate_scene(workload, {.n = n, .seed = seed}, kHitDiscs);
  SimulatorOptions options;
  options.audit = AuditLevel::kNone;
  const auto simulator = lab::make_simulator(scene, "exact", options);
  simulator->start();
  Hitting result;
  for (int i = 1; i <= times && go_on(); ++i) {
    const Rational t = scene.start + (*scene.end - scene.start) * lab::fraction(2 * i - 1, 2 * times + 1);
    simulator->run_until(t);
    const Snapshot now = simulator->snapshot(t);
    std::vector<Disc> discs;
    for (ObjectId id = 0; id < now.objects(); ++id) {
      discs.push_back({now.position(id, 0), now.position(id, 1), now.position(id, 2)});
    }
    const std::vector<Members> sets = maximal_sets(discs);
    const std::vector<Pair> pairs = pairs_of(sets);
    const std::vector<ObjectId> ids = simulator->structure(0).attribute().ids;
    std::vector<Pair> meeting;
    for (std::size_t k = 0; k + 1 < ids.size(); k += 2) meeting.emplace_back(ids[k], ids[k + 1]);
    std::vector<Pair> different;
    std::set_symmetric_difference(pairs.begin(), pairs.end(), meeting.begin(), meeting.end(),
                                  std::back_inserter(different));
    result.different += different.size();
    result.pairs.add(static_cast<double>(pairs.size()));
    result.sets.add(static_cast<double>(sets.size()));
    result.points.add(static_cast<double>(greedy_points(sets, pairs)));
  }
  lab::check_run(*simulator, scene.name, study);
  return result;
}

// Of the means of scenes.
Hitting hit(const char* workload, int n, int scenes, int times, const std::function<bool()>& go_on,
            lab::StudyResult& study) {
  Hitting result;
  for (int seed = 1; seed <= scenes && go_on(); ++seed) {
    const Hitting one = hit_at(workload, n, static_cast<std::uint64_t>(seed), times, go_on, study);
    result.pairs.add(one.pairs.mean());
    result.sets.add(one.sets.mean());
    result.points.add(one.points.mean());
    result.different += one.different;
  }
  return result;
}

// Columns of the study's table.
constexpr std::size_t kScenes = 0, kDiscs = 1, kSets = 5, kPoints = 6, kError = 7, kDifferent = 8;

// The least of the points over the maximal sets, of the sizes that have sets.
double least_share(const lab::StudyResult& result, std::string_view workload) {
  double least = 1;
  for (const std::vector<std::string>& row : result.table.rows) {
    const double sets = std::stod(row[kSets]);
    if (row[kScenes] == workload && sets > 0)
      least = std::min(least, std::stod(row[kPoints]) / sets);
  }
  return least;
}

std::vector<lab::FitPoint> points_of(const lab::StudyResult& result, std::string_view workload) {
  std::vector<lab::FitPoint> points;
  for (const std::vector<std::string>& row : result.table.rows) {
    if (row[kScenes] != workload) continue;
    points.push_back({std::stod(row[kDiscs]), std::stod(row[kPoints]), std::stod(row[kError])});
  }
  return points;
}

}  // namespace

lab::StudyResult study_hitting_sets(bool quick, const std::function<bool()>& go_on) {
  lab::StudyResult result;
  result.name = "section-7-hitting";
  result.table.title = "points that hit all pairs of discs that meet";
  result.table.header = {"scenes",       "discs",  "seeds",          "times",    "pairs",
                         "maximal sets", "points", "standard error", "different"};
  result.table.note =
      "means of the means of scenes over the times; a maximal set: discs with a common point, to "
      "which none can be added; "
      "different: pairs that meet in disc_pairs_all and are in no set, or the reverse";
  const int scenes = quick ? 4 : 8, times = 5;
  for (const char* const workload : {kDense, kSparse}) {
    for (const int n : {12, 17, 24, 34, 48, 68, 96}) {
      if (quick && n > 48) continue;
      if (!go_on()) return result;
      const Hitting found = hit(workload, n, scenes, times, go_on, result);
      result.table.rows.push_back(
          {workload, std::to_string(n), std::to_string(scenes), std::to_string(times),
           fmt::format("{:.1f}", found.pairs.mean()), fmt::format("{:.4f}", found.sets.mean()),
           fmt::format("{:.4f}", found.points.mean()),
           fmt::format("{:.4f}", found.points.standard_error()), std::to_string(found.different)});
    }
  }
  return result;
}

lab::PartReport kds_section_7_hitting_report(const lab::StudyResult& result,
                                             const std::string& command) {
  lab::PartReport report;
  std::size_t different = 0;
  for (const std::vector<std::string>& row : result.table.rows) different += std::stoul(row[kDifferent]);
  std::vector<lab::Curve> curves;
  for (const char* const workload : {kDense, kSparse}) {
    const std::vector<lab::FitPoint> points = points_of(result, workload);
    const auto fit = lab::fit_power(points);
    if (!fit) continue;
    const bool dense = std::string_view(workload) == kDense;
    lab::PaperClaim claim = open_question(
        dense ? "7.14.hitting" : "7.14.hitting-sparse",
        dense ? "How many points hit all pairs of n discs that meet, if the pairs grow like n^2? "
                "(The report: O(n^(5/3)) suffice, Omega(n^(4/3)) may be needed.)"
              : "How many points hit all pairs of n discs that meet, if the pairs grow like n?",
        lab::fit_text(*fit) + fmt::format("; {} pairs otherwise than in {}", different, kHitDiscs) +
            fmt::format(
                ". The points are {:.0f} % of the maximal sets at least: a set is spared if "
                "others have all its pairs. The exponent is of these scenes, and says little "
                "about the bounds of the worst case",
                std::floor(100 * least_share(result, workload))),
        {kHitDiscs, workload});
    claim.place = "section 7";
    claim.command = command;
    claim.assumptions = {
        "a greedy choice among the maximal sets of discs with a common point, which is at most 1 + "
        "log(pairs) "
        "times the smallest one",
        "crossings of circles are compared by square roots of our own, not by those of CGAL",
        "random scenes, which say nothing of the worst case"};
    claim.small_run = lab::small_run(std::move(claim.small_run));
    if (different > 0) claim.verdict = lab::Verdict::kRefuted;
    lab::refute_by_checks(result, claim);
    report.claims.push_back(std::move(claim));
    curves.push_back({workload, points, ""});
  }
  if (curves.empty()) return report;
  report.figures.push_back(
      growth_figure("Points that hit all pairs of discs that meet",
                    "A greedy choice at rational times; means of scenes with bars of two standard "
                    "errors, and the power of n that fits, "
                    "with its 95 % interval.",
                    "points", {1, 4.0 / 3, 5.0 / 3}, std::move(curves)));
  report.figure_names = {"section-7-hitting"};
  report.tables = lab::markdown(result.table);
  return report;
}

}  // namespace kinex::families
