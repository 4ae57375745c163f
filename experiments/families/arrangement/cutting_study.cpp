// SPDX-License-Identifier: GPL-3.0-or-later
// Question: how large are the proofs of incidences by a cutting, and how many events do they have, over
//   the number r of sample lines?
// Source: Guibas, Kinetic data structures: a state of the art report (1998), section 7, names proofs of
//   size O(n^(5/3)). structures/arrangement/incidences_cutting.h: O(r^2 + n r + (n^2 / r) log n) are
//   expected. If lines and points go to other trapezoids about n r^2 times, as often as n lines meet the
//   corners of r^2 trapezoids, r = n^(1/2) costs no more events than there are changes, and gives n^(3/2).
// Scenes: n random chords of the unit square and n points in it, linear motion.
// Expected: the changes of incidences_all, in every run. Certificates and events as they are.
// Cost: some seconds; minutes in full.
#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "core/engine/simulator.h"
#include "experiments/families/arrangement/experiments.h"
#include "experiments/lab/scene_run.h"
#include "experiments/lab/study_runs.h"
#include "experiments/lab/workload.h"
#include "structures/plan.h"

namespace kinex::families {
namespace {

struct Outcome {
  std::uint64_t certificates = 0;  // the most at one time, of all structures of the run
  std::uint64_t moves = 0;         // to other trapezoids
  std::uint64_t changes = 0;
  std::uint64_t sample = 0;  // failures of the sample's arrangement and of its trapezoids
};

Outcome outcome_of(Scene scene, const std::string& structure, int r, lab::StudyResult& study) {
  Request request{structure, structure, {}};
  if (r > 0) request.parameters = {{"r", Rational(r)}};
  scene.maintain = {std::move(request)};
  SimulatorOptions options;
  options.audit = AuditLevel::kNone;
  const auto simulator = lab::make_simulator(scene, "exact", options);
  const StructureId asked = asked_structure(scene);
  simulator->start();
  simulator->run_until(std::nullopt);
  lab::check_run(*simulator, structure + ", " + scene.name, study);
  Outcome outcome;
  for (StructureId id = 0; id < simulator->structures(); ++id) {
    const StructureLedger& ledger = simulator->ledger(id);
    outcome.certificates += ledger.max_live;
    if (id != asked) outcome.sample += ledger.failures;
  }
  const StructureLedger& ledger = simulator->ledger(asked);
  outcome.changes = ledger.external;
  outcome.moves = ledger.failures - ledger.external;
  return outcome;
}

std::string ratio(std::uint64_t count, double to) {
  return fmt::format("{:.2f}", static_cast<double>(count) / to);
}

}  // namespace

lab::StudyResult study_cuttings(bool quick, const std::function<bool()>& go_on) {
  lab::StudyResult result;
  result.name = "incidences_cutting";
  result.table.title =
      "incidences_cutting: certificates and events over the number of sample lines";
  result.table.header = {"n",         "r",       "certificates", "/ n^2",     "/ n^(5/3)",
                         "/ n^(3/2)", "changes", "moves",        "/ (n r^2)", "sample"};
  result.table.note =
      "n lines and n points; r: about n^(1/3), and n^(1/2). certificates: the most at one time, of "
      "the "
      "trapezoids of the sample, too; n^2 for incidences_all. moves: failures that take a line or "
      "a point "
      "to other trapezoids; sample: failures of the sample's arrangement and trapezoids";
  for (const int n : {27, 64, 125, 216, 343}) {
    if (quick && n > 64) continue;
    lab::WorkloadParameters parameters{.n = 2 * n, .seed = 1};
    const Scene scene =
        lab::generate_scene("random-lines-and-points", parameters, "incidences_all");
    if (!go_on()) return result;
    const Outcome all = outcome_of(scene, "incidences_all", 0, result);
    for (const double power : {1.0 / 3, 1.0 / 2}) {
      if (!go_on()) return result;
      const int r = static_cast<int>(std::lround(std::pow(n, power)));
      const Outcome cutting = outcome_of(scene, "incidences_cutting", r, result);
      result.table.rows.push_back(
          {std::to_string(n), std::to_string(r), std::to_string(cutting.certificates),
           ratio(cutting.certificates, n * n), ratio(cutting.certificates, std::pow(n, 5.0 / 3)),
           ratio(cutting.certificates, std::pow(n, 1.5)), std::to_string(cutting.changes),
           std::to_string(cutting.moves), ratio(cutting.moves, double(n) * r * r),
           std::to_string(cutting.sample)});
      result.checks.push_back(
          {fmt::format("incidences_cutting.changes.{}.{}", n, r), "exactly", "",
           std::to_string(all.changes), std::to_string(cutting.changes),
           "the changes of incidences_all on the same scene",
           cutting.changes == all.changes ? lab::Verdict::kConfirmed : lab::Verdict::kRefuted,
           std::nullopt});
    }
  }
  return result;
}

}  // namespace kinex::families
