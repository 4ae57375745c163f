// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "experiments/lab/result_table.h"
#include "experiments/peers/tables.h"
#include "experiments/peers/worker.h"

namespace kinex::peers {

namespace {

constexpr int kMostLevels = 14;  // 2^14 steps

struct Family {
  std::string name;
  std::vector<PeerQuestion> questions;  // that overlap
};

Family overlaps(PeerQuestions& questions, std::string name, const std::vector<PeerCase>& cases) {
  Family family{std::move(name), {}};
  for (const PeerCase& one : cases) {
    const PeerQuestion& question = questions.of(one);
    if (question.truth.kind == TruthKind::kOverlap &&
        question.truth_single.kind == TruthKind::kOverlap) {
      family.questions.push_back(question);
    }
  }
  return family;
}

}  // namespace

std::vector<lab::Figure> sample_tables(const lab::BenchOptions& options, PeerQuestions& questions) {
  const bool quick = options.smoke;
  std::vector<Family> families;
  std::vector<PeerCase> cases;
  const std::vector<int> sizes =
      quick ? std::vector<int>{8} : std::vector<int>{8, 16, 64, 200, 255};
  for (const double depth : {1e-1, 1e-2, 1e-3, 1e-4}) {
    cases.clear();
    for (const int n : sizes) cases.push_back(line_case(n, -depth));
    char name[40];
    std::snprintf(name, sizeof name, "line, depth %.0e", depth);
    families.push_back(overlaps(questions, name, cases));
  }
  cases.clear();
  for (int seed = 1; seed <= (quick ? 2 : 30); ++seed) cases.push_back(random_case(8, seed));
  families.push_back(overlaps(questions, "random, n=8", cases));
  lab::ResultTable table(
      options, "peers_samples",
      "Fixed steps: of the questions of a family that overlap, how many are missed with 2^k steps; "
      "the first row of 0 is the largest step that misses nothing there. us: microseconds a "
      "question, for all that are asked.",
      {{"family", lab::ResultTable::kText, 18},
       {"library", lab::ResultTable::kText, 10},
       {"steps", 0},
       {"overlaps", 0},
       {"missed", 0},
       {"other", 0},
       {"us", 1}});
  std::vector<PeerCurve> curves;
  for (const Family& family : families) {
    for (const char* module : {"box2d", "bullet64", "fcl", "libccd"}) {
      if (!has_module(module)) continue;
      PeerCurve curve{family.name, {}};
      cases.clear();
      for (const PeerQuestion& question : family.questions) cases.push_back(question.exact);
      for (int level = 0; level <= (quick ? 4 : kMostLevels); ++level) {
        const PeerMethod method = steps_method(module, 1 << level);
        const std::vector<PeerAnswer> answers = ask_all(method, cases, {20, 1e-6});
        PeerTally tally;
        double microseconds = 0;
        for (std::size_t i = 0; i < answers.size(); ++i) {
          tally.add(judge(method, family.questions[i], answers[i]));
          microseconds += 1e6 * answers[i].seconds;
        }
        const double asked = static_cast<double>(answers.size());
        if (level % 2 == 0 || tally.missed == 0) {
          table.row({family.name, module, method.steps, tally.asked, tally.missed,
                     tally.asked - tally.right - tally.missed, microseconds / asked});
        }
        curve.points.push_back({static_cast<double>(method.steps), 100 * tally.missed / asked});
        if (tally.missed == 0) break;
      }
      if (std::string(module) == "bullet64") curves.push_back(std::move(curve));
    }
  }
  return {figure_of("Overlaps missed by fixed steps",
                    "The share of overlaps that is missed, by the number of steps (bullet64; for "
                    "the other libraries it is the same up to a step). A curve ends at the "
                    "first number of steps that finds all.",
                    "steps", "overlaps missed, %", curves, false)};
}

}  // namespace kinex::peers
