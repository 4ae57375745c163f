// SPDX-License-Identifier: GPL-3.0-or-later
// Question: are the events of separation_hysteresis at most as many as balls that cover the motion,
//   each of radius 0.103 of the separation at its centre (ball_cover.h)?
// Sources: the property is that of Erickson, Guibas, Stolfi, Zhang (1999), introduction; metric and
//   constant: structures/collision/separation_hysteresis.h.
// Parameters: B6 of collision_cells.cpp: trembling, random walks with kinks, an approach by halves;
//   and, turning, a square whose corners pass over the edge of another one, and gears. Each with
//   either body as the first.
// Expected: the bound in all of them.
// Cost: a second, 3 s in full.
#include <fmt/format.h>

#include <cmath>
#include <exception>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "experiments/families/collision/ball_cover.h"
#include "experiments/families/collision/experiments.h"
#include "experiments/families/collision/polygons.h"
#include "experiments/formats/angles.h"
#include "experiments/lab/scene_run.h"
#include "structures/collision/collision_pairs.h"
#include "structures/collision/separation_hysteresis.h"

namespace kinex::families {
namespace {

struct Family {
  const char* name;
  std::vector<Scene> scenes;
};

Scene path(const char* workload, int n, int m = 0, std::uint64_t seed = 1,
           std::optional<Rational> separation = std::nullopt) {
  lab::WorkloadParameters parameters;
  parameters.n = n;
  parameters.m = m;
  parameters.seed = seed;
  parameters.separation = std::move(separation);
  return lab::generate_scene(*lab::find_workload(workload), parameters);
}

// A square of side 2 turns once beside one at rest; its corners come as near as `separation`, to
// 2^-40.
Scene corners(const Rational& separation) {
  const std::vector<Vertex2> square{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  Scene scene;
  scene.name = "corners over an edge, separation " + separation.to_string();
  scene.dimension = 2;
  scene.start = 0;
  scene.end = Rational(2);
  add_turning_body(scene, "turning", square, 0, 0, half_turns(2, 2));
  const Rational root =
      Rational(2) * formats::rounded(formats::approximate_root(Rational(Integer(1), Integer(2))), 40);
  add_body(scene, "resting", square, {Rational(1) + root + separation}, {0});
  return scene;
}

std::vector<Family> families(bool quick) {
  std::vector<Family> all{{"trembling", {}}, {"kinks", {}}, {"approach", {}}, {"turning", {}}};
  for (const int m : {16, 64}) all[0].scenes.push_back(path("polygon-jitter", 16, m));
  const Rational tenth(Integer(1), Integer(10));
  for (const int m : {20, 80}) {
    for (std::uint64_t seed = 1; seed <= (quick ? 2 : 8); ++seed) {
      all[1].scenes.push_back(path("polygon-kinks", 16, m, seed, tenth));
    }
  }
  for (unsigned long k = 2; k <= (quick ? 18 : 22); k += 4) {
    const Rational separation(Integer(1), Integer::power_of_two(k));
    all[2].scenes.push_back(path("polygon-approach", 16, 0, 1, separation));
  }
  for (unsigned long k = 3; k <= (quick ? 6 : 9); k += 3) {
    const Rational separation(Integer(1), Integer::power_of_two(k));
    all[3].scenes.push_back(corners(separation));
    all[3].scenes.push_back(path("polygon-gears", 12, 9, 1, separation));
  }
  return all;
}

struct Outcome {
  std::uint64_t events = 0;
  double displacement = 0;
  bool clean = false;
};

Outcome run(Scene& scene) {
  Request request;
  request.structure = request.label = "separation_hysteresis";
  scene.maintain = {request};
  const auto simulator = lab::make_simulator(scene, "exact", {});
  const bool clean = lab::run_scene(*simulator, {}).clean(*simulator);
  const auto& structure = proof_of<SeparationHysteresis>(simulator->structure(0));
  return {simulator->ledger(0).processed, structure.search().least_displacement(), clean};
}

}  // namespace

lab::StudyResult study_wedge_cover(bool quick, const std::function<bool()>& go_on) {
  lab::StudyResult result;
  result.name = "wedge_cover";
  result.table.title = "collision: wedges, against balls that cover the motion";
  result.table.header = {"family", "scene", "first body", "events", "balls", "least displacement",
                         "verdict"};
  for (Family& family : families(quick)) {
    int right = 0, runs = 0;
    double most = 0;
    std::string first_wrong;
    for (Scene& scene : family.scenes) {
      for (int order = 0; order < 2 && go_on(); ++order) {
        const std::string first = scene.objects[0].id;
        const std::uint64_t balls = ball_cover(scene);
        const Outcome seen = run(scene);
        const bool holds = seen.clean && seen.events <= balls;
        ++runs;
        right += holds ? 1 : 0;
        most = std::max(most, static_cast<double>(seen.events) / static_cast<double>(balls));
        if (!holds && first_wrong.empty()) {
          first_wrong = fmt::format("; first in {}, {} first: {} events, {} balls", scene.name,
                                    first, seen.events, balls);
        }
        result.table.rows.push_back(
            {family.name, scene.name, first, std::to_string(seen.events), std::to_string(balls),
             // Of no event there is none.
             std::isfinite(seen.displacement) ? fmt::format("{:.3f}", seen.displacement) : "-",
             std::string(lab::check_word(holds ? lab::Verdict::kConfirmed : lab::Verdict::kRefuted))});
        std::swap(scene.objects[0], scene.objects[1]);
      }
    }
    result.checks.push_back(
        {std::string("hysteresis.cover.") + family.name, "at most", "processed",
         "events <= balls that cover the motion",
         fmt::format("in {} of {} runs, at most {:.3f} of them{}", right, runs, most, first_wrong),
         "each ball: radius 0.103 of the separation at its centre",
         right == runs ? lab::Verdict::kConfirmed : lab::Verdict::kRefuted, std::nullopt});
  }
  return result;
}

}  // namespace kinex::families
