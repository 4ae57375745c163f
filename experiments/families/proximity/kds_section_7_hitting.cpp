// SPDX-License-Identifier: GPL-3.0-or-later
// Question: how many points hit all pairs of discs that meet, so that each two that meet have one of the
//   points in common? (Guibas 1998, section 7: O(n^(5/3)) suffice, Omega(n^(4/3)) may be needed, and they
//   can be taken from maximal cells; how to find them while discs move is open.)
// Scenes: small-discs, as dense as there are many, so that the pairs that meet grow like n^2: as they are,
//   with fewer pairs than discs, and with radii 3 and 6 times as large, where a disc meets several others;
//   random-discs, where the pairs grow like n. At rational times.
// Parameters: n from 12 to 96, of the largest radii to 68; 8 scenes of each at 5 times; in a quick run 4
//   scenes, n to 48, of the larger radii to 34. Times of one scene depend on each other: the errors are those
//   of the means of scenes.
// Method: exact. A largest set of discs with a common point has the centre of a disc or a crossing of two
//   circles in common. A greedy choice: next the set that hits most pairs that are not hit yet.
// Expected: nothing; a power of n is fitted, and one of the number of pairs. A greedy choice is at most a
//   factor of 1 + log(pairs) above the smallest one.
// Cost: about a minute; --quick: seconds.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/engine/simulator.h"
#include "experiments/families/points/kds_claims.h"
#include "experiments/families/proximity/experiments.h"
#include "experiments/lab/claim_check.h"
#include "experiments/lab/growth_words.h"
#include "experiments/lab/scene_run.h"
#include "experiments/lab/statistics.h"
#include "experiments/lab/study_runs.h"
#include "experiments/lab/workload.h"
#include "experiments/lab/workload_parts.h"

namespace kinex::families {

namespace {

constexpr const char* kHitDiscs = "disc_pairs_all";

struct HitScenes {
  const char* id;
  const char* title;  // in the table
  const char* workload;
  int factor;                  // of its radii
  bool is_dense;               // the pairs grow like n^2, else like n
  int largest, largest_quick;  // n
};
constexpr HitScenes kHitScenes[] = {
    {"7.14.hitting", "small-discs", "small-discs", 1, true, 96, 48},
    {"7.14.hitting-radii-3", "small-discs, radii x 3", "small-discs", 3, true, 96, 34},
    {"7.14.hitting-radii-6", "small-discs, radii x 6", "small-discs", 6, true, 68, 34},
    {"7.14.hitting-sparse", "random-discs", "random-discs", 1, false, 96, 48}};

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
  const Rational aside = (at.u * at.u + at.v * at.v) * at.root;
  for (std::size_t k = 0; k < discs.size(); ++k) {
    const Rational x = at.x - discs[k].x, y = at.y - discs[k].y;
    const Rational plain = x * x + y * y + aside - discs[k].r * discs[k].r;
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

// How many of the sets a greedy choice takes until each of the pairs, which are those of the sets, is in one
// of them. `discs`: their number.
std::size_t greedy_points(const std::vector<Members>& sets, const std::vector<Pair>& pairs,
                          std::size_t discs) {
  std::vector<bool> is_hit(discs * discs, false);
  const auto not_hit = [&is_hit, discs](const Members& set) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < set.size(); ++i) {
      for (std::size_t j = i + 1; j < set.size(); ++j) {
        if (!is_hit[set[i] * discs + set[j]]) ++count;
      }
    }
    return count;
  };
  std::size_t points = 0, left = pairs.size();
  while (left > 0) {
    std::size_t best = 0, most = 0;  // the first of those that hit most
    for (std::size_t k = 0; k < sets.size(); ++k) {
      const std::size_t count = not_hit(sets[k]);
      if (count <= most) continue;
      most = count;
      best = k;
    }
    for (std::size_t i = 0; i < sets[best].size(); ++i) {
      for (std::size_t j = i + 1; j < sets[best].size(); ++j) {
        is_hit[sets[best][i] * discs + sets[best][j]] = true;
      }
    }
    left -= most;
    ++points;
  }
  return points;
}

// All radii, at all times.
void enlarge(Scene& scene, int factor) {
  if (factor == 1) return;
  const auto radius = static_cast<std::size_t>(scene.dimension);  // its axis
  for (SceneObject& object : scene.objects) {
    for (MotionPiece& piece : object.motion.pieces) {
      for (Rational& coefficient : piece.trajectory.coordinates[radius]) {
        coefficient *= Rational(factor);
      }
    }
  }
  scene.name += fmt::format(", radii x {}", factor);
}

struct Hitting {
  lab::RunningMean pairs, sets, points;
  std::size_t different = 0;  // pairs that the structure has and the sets have not, or the reverse
};

Hitting hit_at(const HitScenes& kind, int n, std::uint64_t seed, int times,
               const std::function<bool()>& go_on, lab::StudyResult& study) {
  Scene scene = lab::generate_scene(kind.workload, {.n = n, .seed = seed}, kHitDiscs);
  enlarge(scene, kind.factor);
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
    result.points.add(static_cast<double>(greedy_points(sets, pairs, discs.size())));
  }
  lab::check_run(*simulator, scene.name, study);
  return result;
}

// Of the means of scenes.
Hitting hit(const HitScenes& kind, int n, int scenes, int times, const std::function<bool()>& go_on,
            lab::StudyResult& study) {
  Hitting result;
  for (int seed = 1; seed <= scenes && go_on(); ++seed) {
    const Hitting one = hit_at(kind, n, static_cast<std::uint64_t>(seed), times, go_on, study);
    result.pairs.add(one.pairs.mean());
    result.sets.add(one.sets.mean());
    result.points.add(one.points.mean());
    result.different += one.different;
  }
  return result;
}

// Columns of the study's table.
constexpr std::size_t kScenes = 0, kDiscs = 1, kPairs = 4, kSets = 5, kPoints = 6, kError = 7,
                      kDifferent = 8;

// The least of the points over the maximal sets, of the sizes that have sets.
double least_share(const lab::StudyResult& result, std::string_view title) {
  double least = 1;
  for (const std::vector<std::string>& row : result.table.rows) {
    const double sets = std::stod(row[kSets]);
    if (row[kScenes] == title && sets > 0) least = std::min(least, std::stod(row[kPoints]) / sets);
  }
  return least;
}

// The points over the column `under`.
std::vector<lab::FitPoint> points_of(const lab::StudyResult& result, std::string_view title,
                                     std::size_t under) {
  std::vector<lab::FitPoint> points;
  for (const std::vector<std::string>& row : result.table.rows) {
    if (row[kScenes] != title) continue;
    points.push_back({std::stod(row[under]), std::stod(row[kPoints]), std::stod(row[kError])});
  }
  return points;
}

// What the two fits and the share of the sets that were chosen tell.
std::string hitting_text(const HitScenes& kind, const lab::StudyResult& result,
                         std::size_t different) {
  const std::vector<lab::FitPoint> over_discs = points_of(result, kind.title, kDiscs);
  const std::vector<lab::FitPoint> over_pairs = points_of(result, kind.title, kPairs);
  const std::optional<lab::Fit> by_discs = lab::fit_power(over_discs);
  std::optional<lab::Fit> by_pairs = lab::fit_power(over_pairs);
  if (by_pairs) by_pairs->law = "a p^b";
  const lab::FitPoint &first = over_pairs.front(), &last = over_pairs.back();
  const double percent = std::floor(100 * least_share(result, kind.title));
  std::string text =
      (by_discs ? lab::fit_text(*by_discs) : "too few sizes") +
      "; over the number p of pairs: " + (by_pairs ? lab::fit_text(*by_pairs) : "too few sizes") +
      fmt::format("; p = {:.1f} at n = {:.0f}, {:.1f} at n = {:.0f}; {} pairs otherwise than in {}",
                  first.n, over_discs.front().n, last.n, over_discs.back().n, different, kHitDiscs);
  text += percent < 100
              ? fmt::format(
                    ". At least {:.0f} % of the maximal sets were chosen; a set is skipped if the "
                    "others cover its pairs",
                    percent)
              : ". All maximal sets were chosen";
  if (percent >= 95) text += ". The exponent is then nearly that of the number of these sets";
  text += kind.is_dense
              ? fmt::format(". The points grow {}, and {}",
                            lab::careful_growth_words(by_discs, 4.0 / 3, "n^(4/3)"),
                            lab::careful_growth_words(by_discs, 5.0 / 3, "n^(5/3)"))
              : fmt::format(". The points grow {}", lab::careful_growth_words(by_discs, 1, "n"));
  text += fmt::format("; over the pairs they grow {}", lab::careful_growth_words(by_pairs, 1, "p"));
  if (last.count > 0) {
    text += fmt::format(". At n = {:.0f} there are {:.1f} pairs for each point",
                        over_discs.back().n, last.n / last.count);
  }
  return text +
         ". The exponents are of these scenes, and say little about the bounds of the worst case";
}

std::string hitting_question(const HitScenes& kind) {
  if (!kind.is_dense) {
    return "How many points hit all pairs of n discs that meet, if the pairs grow like n?";
  }
  return fmt::format(
      "How many points hit all pairs of n discs that meet, if the pairs grow like n^2{}? (The "
      "report: O(n^(5/3)) suffice, Omega(n^(4/3)) may be needed.)",
      kind.factor == 1 ? "" : fmt::format(", and the radii are {} times as large", kind.factor));
}

// The points over the number of pairs.
lab::Figure pairs_figure(const lab::StudyResult& result) {
  std::vector<lab::Curve> curves;
  for (const HitScenes& kind : kHitScenes) {
    lab::Curve curve{kind.title, points_of(result, kind.title, kPairs), ""};
    if (const auto fit = lab::fit_power(curve.points)) curve.value = lab::power_value(*fit, "p");
    curves.push_back(std::move(curve));
  }
  lab::Figure figure;
  figure.title = "Points that hit all pairs of discs that meet, over the number of pairs";
  figure.caption =
      "A greedy choice at rational times; means of scenes with bars of two standard errors of the "
      "points, and the power of the number p of pairs that fits, with its 95 % interval.";
  lab::set_curves(figure, {"pairs p that meet", "points", true, true, {2.0 / 3, 1}}, curves);
  return figure;
}

}  // namespace

lab::StudyResult study_hitting_sets(bool quick, const std::function<bool()>& go_on) {
  lab::StudyResult result;
  result.name = "section-7-hitting";
  result.table.title = "points that hit all pairs of discs that meet";
  result.table.header = {"scenes",       "discs",  "seeds",          "times",    "pairs",
                         "maximal sets", "points", "standard error", "different"};
  result.table.note =
      "radii x 3, x 6: the scenes with radii that are so many times as large; means of the means "
      "of "
      "scenes over the times; a maximal set: discs with a common point, to which none can be "
      "added; "
      "different: pairs that meet in disc_pairs_all and are in no set, or the reverse";
  const int scenes = quick ? 4 : 8, times = 5;
  for (const HitScenes& kind : kHitScenes) {
    for (const int n : {12, 17, 24, 34, 48, 68, 96}) {
      if (n > (quick ? kind.largest_quick : kind.largest)) continue;
      const Hitting found = hit(kind, n, scenes, times, go_on, result);
      if (!go_on()) return result;
      result.table.rows.push_back(
          {kind.title, std::to_string(n), std::to_string(scenes), std::to_string(times),
           fmt::format("{:.4f}", found.pairs.mean()), fmt::format("{:.4f}", found.sets.mean()),
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
  for (const HitScenes& kind : kHitScenes) {
    const std::vector<lab::FitPoint> points = points_of(result, kind.title, kDiscs);
    if (points.empty()) continue;
    lab::PaperClaim claim =
        open_question(kind.id, hitting_question(kind), hitting_text(kind, result, different),
                      {kHitDiscs, kind.workload});
    claim.place = "section 7";
    claim.command = command;
    claim.assumptions = {
        "a greedy choice among the maximal sets of discs with a common point, which is at most 1 + "
        "log(pairs) times the smallest one",
        "crossings of circles are compared by square roots of our own, not by those of CGAL",
        "over the pairs: points and pairs of the same scenes; the errors are those of the points",
        "random scenes, which say nothing of the worst case"};
    if (kind.factor > 1) {
      claim.assumptions.push_back(
          "the second program is given the scenes with their own radii, which are smaller");
    }
    claim.small_run = lab::small_run(std::move(claim.small_run));
    if (different > 0) claim.verdict = lab::Verdict::kRefuted;
    lab::refute_by_checks(result, claim);
    report.claims.push_back(std::move(claim));
    curves.push_back({kind.title, points, ""});
  }
  if (curves.empty()) return report;
  report.figures.push_back(
      growth_figure("Points that hit all pairs of discs that meet",
                    "A greedy choice at rational times; means of scenes with bars of two standard "
                    "errors, and the power of n that fits, "
                    "with its 95 % interval.",
                    "points", {1, 4.0 / 3, 5.0 / 3}, std::move(curves)));
  report.figures.push_back(pairs_figure(result));
  report.figure_names = {"section-7-hitting", "section-7-hitting-pairs"};
  report.tables = lab::markdown(result.table);
  return report;
}

}  // namespace kinex::families
