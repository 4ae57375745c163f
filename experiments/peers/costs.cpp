// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "experiments/lab/result_table.h"
#include "experiments/peers/tables.h"
#include "experiments/peers/worker.h"

namespace kinex::peers {

namespace {

struct Group {
  std::string name;
  std::vector<PeerQuestion> questions;
  bool orbit = false;  // kinex runs it with one rotor a quarter turn
};

Group group_of(PeerQuestions& questions, std::string name, const std::vector<PeerCase>& cases,
               bool orbit = false) {
  Group group{std::move(name), {}, orbit};
  for (const PeerCase& one : cases) group.questions.push_back(questions.of(one));
  return group;
}

struct Cost {
  double run = 0, build = 0;  // microseconds
  double steps = 0, iterations = 0, supports = 0;
  double events = 0, polynomials = 0, roots = 0, signs = 0;
};

Cost our_cost(const Group& group, const std::string& structure, const std::string& arithmetic,
              int rounds, PeerTally& tally) {
  Cost cost;
  for (const PeerQuestion& question : group.questions) {
    const Scene scene = group.orbit ? orbit_scene(question.exact) : scene_of(question.exact);
    std::vector<std::pair<double, double>> times;
    OurRun run;
    for (int i = 0; i < rounds; ++i) {
      run = run_ours(scene, structure, arithmetic);
      times.emplace_back(run.build_seconds + run.run_seconds, run.build_seconds);
    }
    std::sort(times.begin(), times.end());
    const auto& [total, build] = times[times.size() / 2];
    cost.run += 1e6 * (total - build);
    cost.build += 1e6 * build;
    cost.events += static_cast<double>(run.events);
    cost.polynomials += static_cast<double>(run.polynomials);
    cost.roots += static_cast<double>(run.roots);
    cost.signs += static_cast<double>(run.signs);
    ++tally.asked;
    const bool overlap = question.truth.kind == TruthKind::kOverlap;
    if (question.truth.kind == TruthKind::kUnknown) {
      ++tally.unknown;
    } else if (overlap == run.contact.has_value()) {
      ++tally.right;
    }
  }
  return cost;
}

Cost peer_cost(const Group& group, const PeerMethod& method, const WorkerLimits& limits,
               PeerTally& tally) {
  std::vector<PeerCase> cases;
  for (const PeerQuestion& question : group.questions) cases.push_back(question.exact);
  const std::vector<PeerAnswer> answers = ask_all(method, cases, limits);
  Cost cost;
  for (std::size_t i = 0; i < answers.size(); ++i) {
    const PeerAnswer& answer = answers[i];
    tally.add(judge(method, group.questions[i], answer));
    cost.run += 1e6 * answer.seconds;
    cost.build += 1e6 * answer.load_seconds;
    cost.steps += static_cast<double>(answer.work.steps);
    cost.iterations += static_cast<double>(answer.work.iterations);
    cost.supports += static_cast<double>(answer.work.supports);
  }
  return cost;
}

}  // namespace

void cost_table(const lab::BenchOptions& options, PeerQuestions& questions) {
  const bool quick = options.smoke;
  std::vector<Group> groups;
  if (quick) {
    groups.push_back(group_of(questions, "line, n=8, gap 1e-3", {line_case(8, 1e-3)}));
  } else {
    groups.push_back(group_of(questions, "line, n=64, gap 1e-3", {line_case(64, 1e-3)}));
    groups.push_back(group_of(questions, "line, n=64, overlap 1e-3", {line_case(64, -1e-3)}));
    groups.push_back(group_of(questions, "line, n=64, gap 1e-9", {line_case(64, 1e-9)}));
    groups.push_back(group_of(questions, "orbit, n=64, gap 1e-1", {orbit_case(64, 1e-1)}, true));
    groups.push_back(group_of(questions, "orbit, n=64, gap 1e-2", {orbit_case(64, 1e-2)}, true));
    groups.push_back(group_of(questions, "orbit, n=200, gap 1e-4", {orbit_case(200, 1e-4)}, true));
    groups.push_back(group_of(questions, "spin, n=64", {spin_case(64, 4)}));
    std::vector<PeerCase> small, large;
    for (int seed = 1; seed <= 12; ++seed) {
      small.push_back(random_case(8, seed));
      large.push_back(random_case(64, seed));
    }
    groups.push_back(group_of(questions, "random, n=8", small));
    groups.push_back(group_of(questions, "random, n=64", large));
  }
  lab::ResultTable table(
      options, "peers_costs",
      "Cost of one question, means over the group. Microseconds of CPU time, medians of repeats; "
      "us build: making the library's shapes, or kinex's hierarchies and first proof. GJK's "
      "iterations and support calls where they can be counted (0: they cannot); each support call "
      "of Box2D, Bullet and libccd looks at all vertices. kinex: events, polynomials solved, roots "
      "found, signs. right: of the questions asked; t: contacts within the tolerance, ?: truth not "
      "known; a fast answer that is wrong is no answer. In "
      "spin and random kinex has a flight plan a tenth of a radian, to follow the peers' angle.",
      {{"group", lab::ResultTable::kText, 24},
       {"method", lab::ResultTable::kText, 30},
       {"right", lab::ResultTable::kText, 7},
       {"us_query", 2},
       {"us_build", 2},
       {"us_total", 2},
       {"steps", 1},
       {"iterations", 1},
       {"supports", 1},
       {"events", 1},
       {"polynomials", 1},
       {"roots", 1},
       {"signs", 1}});
  const auto row = [&](const Group& group, const std::string& name, const Cost& cost,
                       const PeerTally& tally) {
    const double n = static_cast<double>(group.questions.size());
    std::string right = std::to_string(tally.right);
    if (tally.tolerated > 0) right += "+" + std::to_string(tally.tolerated) + "t";
    if (tally.unknown > 0) right += "+" + std::to_string(tally.unknown) + "?";
    table.row({group.name, name, right + "/" + std::to_string(tally.asked), cost.run / n,
               cost.build / n, (cost.run + cost.build) / n, cost.steps / n, cost.iterations / n,
               cost.supports / n, cost.events / n, cost.polynomials / n, cost.roots / n,
               cost.signs / n});
  };
  const int rounds = quick ? 1 : 5;
  const WorkerLimits limits{20, quick ? 0.001 : 0.01};
  for (const Group& group : groups) {
    std::vector<std::pair<std::string, std::string>> ours{{"separation_mixed", "exact"},
                                                          {"separation_mixed", "double"}};
    if (!group.questions.front().exact.turns()) ours.push_back({"separation_minkowski", "exact"});
    ours.push_back({"separation_hysteresis", "exact"});
    for (const auto& [structure, arithmetic] : ours) {
      PeerTally tally;
      const Cost cost = our_cost(group, structure, arithmetic, rounds, tally);
      row(group, "kinex " + structure + " " + arithmetic, cost, tally);
    }
    for (const PeerMethod& method : peer_methods()) {
      PeerTally tally;
      const Cost cost = peer_cost(group, method, limits, tally);
      row(group, method.name, cost, tally);
    }
  }
}

}  // namespace kinex::peers
