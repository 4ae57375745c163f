// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "experiments/lab/result_table.h"
#include "experiments/peers/tables.h"
#include "experiments/peers/worker.h"

namespace kinex::peers {

namespace {

constexpr double kLeastGap = 1e-3;  // below it tolerances are no error

// Poses of random pairs that are apart.
std::vector<PeerCase> poses(int n, int pairs, int looks) {
  std::vector<PeerCase> cases;
  for (int seed = 1; seed <= pairs; ++seed) {
    const PeerCase pair = random_case(n, seed);
    for (int i = 0; i <= looks; ++i) {
      PeerCase pose = pair;
      pose.frames = {pair.at(static_cast<double>(i) / looks)};
      if (signed_distance(pose, pose.frames[0]) > kLeastGap) cases.push_back(std::move(pose));
    }
  }
  return cases;
}

}  // namespace

void distance_table(const lab::BenchOptions& options) {
  const bool quick = options.smoke;
  lab::ResultTable table(
      options, "peers_distances",
      "Distances of random pairs in poses that are more than 1e-3 apart, against the "
      "distance over all vertices and edges: how many are off by more than 1e-6, "
      "1e-4 and 1e-2; the largest excess, which lets conservative advancement jump "
      "over a contact, and the largest shortfall.",
      {{"solver", lab::ResultTable::kText, 14},
       {"n", 0},
       {"poses", 0},
       {"off_1e-6", 0},
       {"off_1e-4", 0},
       {"off_1e-2", 0},
       {"no_number", 0},
       {"excess", 9},
       {"shortfall", 9}});
  struct Solver {
    const char* name;
    const char* module;
    int variant;
    bool single;
  };
  for (const int n : {8, 64}) {
    const std::vector<PeerCase> cases = poses(n, quick ? 2 : 60, quick ? 10 : 100);
    for (const Solver& solver :
         {Solver{"box2d", "box2d", 0, true}, Solver{"bullet", "bullet", 0, true},
          Solver{"bullet64", "bullet64", 0, false}, Solver{"fcl libccd", "fcl", 0, false},
          Solver{"fcl indep", "fcl", 1, false}}) {
      if (!has_module(solver.module)) continue;
      PeerMethod method;
      method.name = solver.name;
      method.module = solver.module;
      method.kind = PeerMethod::Kind::kDistance;
      method.variant = solver.variant;
      method.single = solver.single;
      const std::vector<PeerAnswer> answers = ask_all(method, cases);
      int off6 = 0, off4 = 0, off2 = 0, none = 0;
      double excess = 0, shortfall = 0;
      for (std::size_t i = 0; i < answers.size(); ++i) {
        if (answers[i].reply != PeerReply::kHit) {
          ++none;
          continue;
        }
        const PeerCase asked = solver.single ? cases[i].as_float() : cases[i];
        const double off = answers[i].time - signed_distance(asked, asked.frames[0]);
        off6 += std::abs(off) > 1e-6 ? 1 : 0;
        off4 += std::abs(off) > 1e-4 ? 1 : 0;
        off2 += std::abs(off) > 1e-2 ? 1 : 0;
        excess = std::max(excess, off);
        shortfall = std::max(shortfall, -off);
      }
      table.row({solver.name, n, static_cast<std::uint64_t>(answers.size()), off6, off4, off2, none,
                 excess, shortfall});
    }
  }
}

}  // namespace kinex::peers
