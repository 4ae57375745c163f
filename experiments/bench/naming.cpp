// SPDX-License-Identifier: GPL-3.0-or-later
// Question: what is the cost of reporting a run: of naming an instant exactly where doubles already
//   enclose it, of making the digest, of writing the log?
// Workload: random motion. For each structure and degree, alternating: runs without a sink; with a
//   sink that requests no name of the instant, an interval, a name, and the name as text; with the
//   digest and with the whole log (to the null device), as `kinex run` has them for --summary and
//   --events; the best of each; thread CPU time.
// Counted: microseconds per instant beyond the sink that requests no name; ratios of whole runs.
// Output: see result_table.h; options: see bench_options.h.
#include <algorithm>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/engine/event.h"
#include "core/engine/simulator.h"
#include "experiments/formats/event_log.h"
#include "experiments/formats/file_io.h"
#include "experiments/lab/bench_row.h"
#include "experiments/lab/bench_run.h"
#include "experiments/lab/result_table.h"

namespace {

using namespace kinex;

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

lab::BenchRun run_once(const Scene& scene, Asked asked, std::uint64_t& instants) {
  Namer namer(asked);
  std::optional<formats::OutputFile> file;
  std::optional<formats::EventLog> log;
  lab::BenchWay way;
  way.prepare = [&](Simulator& simulator) {
    if (asked == kDigest || asked == kLog) {
      if (asked == kLog) file.emplace("/dev/null", true);
      log.emplace(simulator, "", file ? &*file : nullptr);
      if (!file) log->charge_to(simulator.clock());
      simulator.set_sink(&*log, file.has_value());
    } else if (asked != kAlone) {
      simulator.set_sink(&namer);
    }
  };
  way.finish = [&](RunStatus status) {
    if (log) log->finish(status);
  };
  // The log refers to the simulator.
  way.inspect = [&](const Simulator&) { log.reset(); };
  const lab::BenchRun run = lab::run_once(scene, way);
  instants = std::max(instants, namer.instants);
  return run;
}

// `least_seconds`: of all runs of one way in a round.
void add_row(const lab::BenchRow& row, double least_seconds, lab::ResultTable& table) {
  const Scene scene = lab::scene_of(row);
  std::uint64_t instants = 0;
  std::vector<std::function<lab::BenchRun()>> ways;
  for (int way = 0; way < kWays; ++way) {
    ways.emplace_back([&, way] { return run_once(scene, static_cast<Asked>(way), instants); });
  }
  const std::vector<lab::BenchRun> best =
      lab::best_of_rounds(ways, {.count = row.rounds, .least_seconds = least_seconds});
  const auto over = [&](Asked one, Asked other) { return best[one].seconds / best[other].seconds; };
  const auto each = [&](Asked asked) {
    return (best[asked].seconds - best[kNothing].seconds) * 1e6 / static_cast<double>(instants);
  };
  table.row({row.structure, row.parameters.degree, row.parameters.n, instants,
             best[kNothing].seconds, each(kInterval), each(kName), each(kWords),
             over(kName, kNothing), over(kDigest, kAlone), over(kLog, kAlone)});
}

void naming(const lab::BenchOptions& options) {
  lab::ResultTable table(
      options, "naming",
      "Microseconds for an interval around an instant, for its exact name, and for the "
      "name in words, beyond a run that asks for none; time of a run with names over that; time of "
      "a run with its digest, and with its log, over that of the run alone.",
      {{"structure", lab::ResultTable::kText, 19},
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
  for (const lab::BenchRow& row : lab::bench_rows("naming", options)) {
    add_row(row, options.smoke ? 0 : 0.2, table);
  }
}

}  // namespace

int main(int argc, char** argv) { return kinex::lab::bench_main(argc, argv, naming); }
