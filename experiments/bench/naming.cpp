// SPDX-License-Identifier: GPL-3.0-or-later
// Question: what is the cost of reporting a run: of naming an instant exactly where doubles already
//   enclose it, of making the digest, of writing the log?
// Workload: uniform-square. For each structure and degree, alternating: runs without a sink; with a
//   sink that requests no name of the instant, an interval, a name, and the name as text; with the
//   digest and with the whole log (to the null device), as `kinex run` has them for --summary and
//   --events; the best of each; thread CPU time.
// Counted: microseconds per instant beyond the sink that requests no name; ratios of whole runs.
// Output: see result_table.h; options: see options.h.
#include <algorithm>
#include <array>
#include <optional>
#include <string>

#include "core/engine/event.h"
#include "core/engine/simulator.h"
#include "experiments/bench/options.h"
#include "experiments/bench/result_table.h"
#include "experiments/formats/event_log.h"
#include "experiments/formats/file_io.h"
#include "experiments/lab/cpu_clock.h"
#include "experiments/lab/workload.h"
#include "structures/plan.h"

namespace {

using namespace kinex;

struct Contest {
  const char* structure;
  int degree;
  int n;
};

enum Asked { kNothing, kInterval, kName, kWords, kAlone, kDigest, kLog, kWays };

class Namer final : public EventSink {
 public:
  explicit Namer(Asked asked) : asked_(asked) {}
  void event(const Event&, Arithmetic& arithmetic) override {
    if (asked_ == kNothing) return;
    const InstantName& name =
        arithmetic.name_now(asked_ == kInterval ? InstantDetail::kInterval : InstantDetail::kName);
    if (name.number == last_) return;
    last_ = name.number;
    ++instants;
    if (asked_ == kWords) characters += to_text(name).lower.size();
  }
  std::uint64_t instants = 0, characters = 0;

 private:
  Asked asked_;
  std::uint64_t last_ = 0;
};

double run_once(const Scene& scene, Asked asked, std::uint64_t& instants) {
  SimulatorOptions options;
  options.audit = AuditLevel::kNone;
  Simulator simulator(scene, planned_arithmetic("exact", scene), options);
  add_structures(simulator, scene);
  Namer namer(asked);
  std::optional<formats::OutputFile> file;
  std::optional<formats::EventLog> log;
  if (asked == kDigest || asked == kLog) {
    if (asked == kLog) file.emplace("/dev/null", true);
    log.emplace(simulator, "", file ? &*file : nullptr);
    if (!file) log->charge_to(simulator.clock());
    simulator.set_sink(&*log, file.has_value());
  } else if (asked != kAlone) {
    simulator.set_sink(&namer);
  }
  simulator.start();
  const double begin = lab::cpu_seconds();
  const RunStatus status = simulator.run_until(scene.end);
  if (log) log->finish(status);
  instants = std::max(instants, namer.instants);
  return lab::cpu_seconds() - begin;
}

// `least_seconds`: of all runs of one way together.
void run_contest(const Contest& contest, int rounds, double least_seconds, ResultTable& table) {
  lab::WorkloadParameters parameters;
  parameters.n = contest.n;
  parameters.degree = contest.degree;
  Scene scene = lab::generate_scene(*lab::find_workload("uniform-square"), parameters);
  scene.maintain = {{contest.structure, contest.structure, {}}};
  std::array<double, kWays> seconds{};
  std::uint64_t instants = 0;
  double spent = 0;
  for (int round = 0; round < rounds || spent < least_seconds; ++round) {
    for (int way = 0; way < kWays; ++way) {
      const double now = run_once(scene, static_cast<Asked>(way), instants);
      if (way == kAlone) spent += now;
      double& best = seconds[static_cast<std::size_t>(way)];
      best = round == 0 ? now : std::min(best, now);
    }
  }
  const auto each = [&](Asked asked) {
    return (seconds[asked] - seconds[kNothing]) * 1e6 / static_cast<double>(instants);
  };
  table.row({contest.structure, contest.degree, contest.n, instants, seconds[kNothing],
             each(kInterval), each(kName), each(kWords), seconds[kName] / seconds[kNothing],
             seconds[kDigest] / seconds[kAlone], seconds[kLog] / seconds[kAlone]});
}

}  // namespace

int main(int argc, char** argv) {
  const auto options = bench_options(argc, argv);
  if (!options) return 2;
  ResultTable table(
      *options, "naming",
      "Microseconds for an interval around an instant, for its exact name, and for the "
      "name in words, beyond a run that asks for none; time of a run with names over that; time of "
      "a run with its digest, and with its log, over that of the run alone.",
      {{"structure", ResultTable::kText, 19},
       {"degree", 0},
       {"n", 0, 6},
       {"instants", 0},
       {"seconds", 3},
       {"interval", 3},
       {"name", 3},
       {"words", 3},
       {"named_over_plain", 3},
       {"digest_over_none", 3},
       {"log_over_none", 3}});
  const bool smoke = options->smoke;
  for (const Contest& contest : std::initializer_list<Contest>{{"sorted_list", 1, 600},
                                                               {"sorted_list", 2, 400},
                                                               {"convex_hull_2", 1, 1000},
                                                               {"delaunay_2", 1, 1000},
                                                               {"delaunay_2", 2, 400},
                                                               {"delaunay_2", 3, 200}}) {
    Contest one = contest;
    if (smoke) one.n = 20;
    run_contest(one, smoke ? 1 : 3, smoke ? 0 : 0.5, table);
  }
  return 0;
}
