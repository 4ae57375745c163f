// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/trade/case_run.h"

#include <algorithm>
#include <chrono>
#include <exception>
#include <memory>
#include <utility>

#include "experiments/formats/scene_writer.h"
#include "experiments/lab/binary_scale.h"
#include "experiments/lab/cpu_clock.h"
#include "experiments/lab/gmp_memory.h"
#include "experiments/lab/scene_run.h"
#include "experiments/trade/checkpoints.h"
#include "experiments/trade/trace.h"
#include "structures/plan.h"

namespace kinex::trade {

namespace {

constexpr double kOnceIsEnough = 0.2;  // seconds of a round that is not repeated
constexpr double kMeasurable = 20e-6;  // seconds of one round
constexpr int kMostRounds = 50;
// The beginning of the reasons given by guards: "no end of repairs", "no end of rebuilds".
constexpr std::string_view kGuardText = "no end of ";

SimulatorOptions simulator_options(const TradeOptions& options, std::uint64_t max_events) {
  SimulatorOptions result;
  result.audit = AuditLevel::kNone;
  result.max_events = max_events;
  result.max_seconds = options.max_seconds;
  result.interrupt = options.interrupt;
  result.progress = [go_on = options.source.go_on](const Simulator&) { return go_on(); };
  return result;
}

// The structure whose states are compared, and the objects that it is built from.
struct Asked {
  explicit Asked(const Scene& scene)
      : id(asked_structure(scene)), members(plan_structures(scene)[id].members) {}

  StructureId id;
  std::vector<bool> members;  // as in the plan
};

// Compares the state right now with an independent exact computation at t; the violation, or empty.
std::string audit_at(const Simulator& simulator, const Asked& asked, const Rational& t) {
  AuditReport report;
  const Structure& structure = simulator.structure(asked.id);
  structure.check_invariants(report);
  structure.audit(simulator.snapshot(t).of(asked.members), report);
  return report.violations.empty() ? "" : report.violations.front();
}

// Why the run is corrupt: the reason of the first corrupt structure; its readers give none.
std::string corruption_of(const Simulator& simulator) {
  StructureId id = 0;
  while (!simulator.ledger(id).corrupt) ++id;
  return simulator.ledger(id).corruption;
}

void note_wrong(TradeRun& run, const Rational& time, const std::string& what) {
  if (run.first_wrong) return;
  run.first_wrong = time;
  run.violation = what;
}

// Runs to the end with stops at the checkpoints. False if it was interrupted.
bool run_with_checkpoints(Simulator& simulator, const std::vector<Rational>& checkpoints,
                          std::uint64_t max_events, TradeRun& run) {
  run.checkpoints = static_cast<int>(checkpoints.size()) + 1;
  const Asked asked(simulator.scene());
  const StructureLedger& ledger = simulator.ledger(asked.id);
  RunStatus status = RunStatus::kDone;
  simulator.start();
  for (const Rational& t : checkpoints) {
    status = simulator.run_until(t);
    if (status != RunStatus::kDone || ledger.corrupt) {
      note_wrong(run, t, "");
      break;
    }
    const std::string violation = audit_at(simulator, asked, t);
    run.valid += violation.empty() ? 1 : 0;
    if (!violation.empty()) note_wrong(run, t, violation);
  }
  if (status == RunStatus::kDone && !ledger.corrupt) {
    status = simulator.run_until(std::nullopt);  // with the simulator's audit
    run.valid_at_end =
        status == RunStatus::kDone && !ledger.corrupt && ledger.audit_violations == 0;
    run.valid += run.valid_at_end ? 1 : 0;
    if (!run.valid_at_end) {
      note_wrong(run, *simulator.scene().end,
                 simulator.violations().empty() ? "" : simulator.violations().front());
    }
  }
  run.peak_bytes = simulator.ledger().peak_bytes;
  if (ledger.corrupt) {
    run.ending = Ending::kCorrupt;
    run.trouble = corruption_of(simulator);
    run.guard_fired = run.trouble.rfind(kGuardText, 0) == 0;
  } else if (status == RunStatus::kLimit) {
    run.ending = max_events != 0 && simulator.ledger().events >= max_events ? Ending::kEndless
                                                                            : Ending::kGaveUp;
  }
  return status != RunStatus::kInterrupted;
}

// The exact run and its events. A scene without an end gets one, after the last of them.
struct Exact {
  Scene scene;
  ExactTrace trace;
  RunStatus status = RunStatus::kDone;
  std::vector<Rational> checkpoints;
};

Exact exact_run(Scene scene, EventNames& names, const TradeOptions& options) {
  Exact exact;
  exact.scene = std::move(scene);
  const auto simulator = lab::make_simulator(exact.scene, "exact", simulator_options(options, 0));
  ExactRecorder recorder(names);
  simulator->set_sink(&recorder);
  const lab::GmpGuard guard(&simulator->deadline());
  simulator->start();
  exact.status = simulator->run_until(std::nullopt);
  exact.trace = std::move(recorder.trace);
  if (!exact.scene.end) {
    Rational last = exact.scene.start;
    if (exact.trace.size() > 0) last = std::max(last, exact.trace.times.back().upper());
    exact.scene.end = Rational(floor_divide(last.numerator(), last.denominator())) + Rational(1);
  }
  if (exact.status == RunStatus::kDone) {
    exact.checkpoints = checkpoints_of(exact.trace, exact.scene.start, *exact.scene.end);
  }
  return exact;
}

// nullopt if it was interrupted.
std::optional<TradeRun> compared_run(Exact& exact, EventNames& names, const std::string& arithmetic,
                                     const TradeOptions& options) {
  TradeRun run;
  run.arithmetic = arithmetic;
  const long bits = bits_of_arithmetic(arithmetic);
  const std::uint64_t budget =
      bits == 0 ? 0 : options.events_factor * exact.trace.size() + options.events_more;
  ExactRecorder exact_recorder(names);
  InexactRecorder inexact_recorder(names);
  try {
    SimulatorOptions simulating = simulator_options(options, budget);
    simulating.audit = AuditLevel::kEnd;
    const auto simulator = lab::make_simulator(exact.scene, arithmetic, std::move(simulating));
    const lab::GmpGuard guard(&simulator->deadline());
    simulator->set_sink(bits == 0 ? static_cast<EventSink*>(&exact_recorder) : &inexact_recorder);
    if (!run_with_checkpoints(*simulator, exact.checkpoints, budget, run)) return std::nullopt;
    if (run.ending == Ending::kEnded)
      run.seconds = simulator->seconds_setup() + simulator->seconds_simulate();
  } catch (const Stopped&) {
    if (!options.source.go_on()) return std::nullopt;
    run.ending = Ending::kGaveUp;
  } catch (const std::exception& error) {
    run.ending = Ending::kThrew;
    run.trouble = error.what();
  }
  if (bits == 0) {
    run.events = exact_recorder.trace.size();
    run.deviation.matched = run.events;
    if (run.ending == Ending::kEnded && !equal(exact.trace, exact_recorder.trace)) {
      run.differs = true;
    }
  } else {
    run.events = inexact_recorder.trace.size();
    run.deviation = deviation_of(exact.trace, inexact_recorder.trace);
  }
  return run;
}

// The compared run, without its audits and reports, is the first round; a long one the only one. Further
// rounds in all arithmetics alternate. False if it was interrupted.
bool measure_times(const TradeCase& which, const Scene& scene, std::vector<TradeRun>& runs,
                   const TradeOptions& options) {
  std::vector<double> total;
  for (const TradeRun& run : runs) total.push_back(run.seconds.value_or(0));
  for (int round = 1; round < kMostRounds; ++round) {
    bool measured = false;
    for (std::size_t i = 0; i < runs.size(); ++i) {
      TradeRun& run = runs[i];
      const double enough = round < 2 ? kOnceIsEnough : which.enough_seconds;
      if (run.ending != Ending::kEnded || total[i] > enough) continue;
      const double begin = lab::cpu_seconds();
      const auto simulator = lab::make_simulator(scene, run.arithmetic, simulator_options(options, 0));
      const lab::GmpGuard guard(&simulator->deadline());
      simulator->start();
      const RunStatus status = simulator->run_until(std::nullopt);
      const double seconds = lab::cpu_seconds() - begin;
      if (status == RunStatus::kInterrupted || !options.source.go_on()) return false;
      run.seconds = run.seconds ? std::min(*run.seconds, seconds) : seconds;
      total[i] += seconds;
      measured = true;
    }
    if (!measured) break;
  }
  return true;
}

// `exact` and `double` first and second, the others in their order, without repetitions.
std::vector<std::string> in_order(const std::vector<std::string>& arithmetics) {
  std::vector<std::string> result{"exact", "double"};
  for (const std::string& name : arithmetics) {
    if (std::find(result.begin(), result.end(), name) == result.end()) result.push_back(name);
  }
  return result;
}

}  // namespace

std::string_view ending_name(Ending ending) {
  switch (ending) {
    case Ending::kEnded:
      return "ended";
    case Ending::kCorrupt:
      return "corrupt";
    case Ending::kEndless:
      return "endless";
    case Ending::kGaveUp:
      return "gave up";
    case Ending::kThrew:
      return "threw";
  }
  return "";
}

Standing TradeRun::standing() const {
  if (ending != Ending::kEnded || valid != checkpoints || differs) return Standing::kWrong;
  return deviation.same_events() ? Standing::kSame : Standing::kValid;
}

const TradeRun* CaseResult::run_in(std::string_view arithmetic) const {
  for (const TradeRun& run : runs) {
    if (run.arithmetic == arithmetic) return &run;
  }
  return nullptr;
}

std::optional<double> CaseResult::time_ratio(const TradeRun& run) const {
  const TradeRun* rival = run_in("double");
  if (rival == nullptr || !rival->seconds || !run.seconds || *rival->seconds < kMeasurable) {
    return std::nullopt;
  }
  return *run.seconds / *rival->seconds;
}

std::optional<double> CaseResult::memory_ratio(const TradeRun& run) const {
  const TradeRun* rival = run_in("double");
  if (rival == nullptr || rival->ending != Ending::kEnded || run.ending != Ending::kEnded ||
      rival->peak_bytes == 0) {
    return std::nullopt;
  }
  return static_cast<double>(run.peak_bytes) / static_cast<double>(rival->peak_bytes);
}

std::vector<std::string> CaseResult::faults() const {
  std::vector<std::string> result;
  if (!problem.empty() && !gave_up) result.push_back(problem);
  for (const TradeRun& run : runs) {
    const bool exact = bits_of_arithmetic(run.arithmetic) == 0;
    if (run.ending == Ending::kThrew) {
      result.push_back(run.arithmetic + " threw: " + run.trouble);
    } else if (exact && run.differs) {
      result.push_back(run.arithmetic + " does not give the events of exact");
    } else if (exact && run.ending == Ending::kEnded && run.valid != run.checkpoints) {
      const std::string when = run.first_wrong ? " at t = " + time_decimal(*run.first_wrong) : "";
      result.push_back(run.arithmetic + " is wrong" + when + ": " + run.violation);
    }
  }
  return result;
}

std::optional<CaseResult> run_case(const TradeCase& which, const TradeOptions& options) {
  const auto begin = std::chrono::steady_clock::now();
  CaseResult result;
  result.which = which;
  const auto finish = [&] {
    result.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return result;
  };
  Scene scene = which.scene();
  result.scene_name = scene.name;
  result.scene_hash = formats::scene_hash(scene);
  result.objects = scene.objects.size();
  EventNames names;
  Exact exact;
  try {
    exact = exact_run(std::move(scene), names, options);
  } catch (const Stopped&) {
    exact.status = options.source.go_on() ? RunStatus::kLimit : RunStatus::kInterrupted;
  } catch (const std::exception& error) {
    result.problem = std::string("exact threw: ") + error.what();
    return finish();
  }
  if (exact.status == RunStatus::kInterrupted || !options.source.go_on()) return std::nullopt;
  if (exact.status == RunStatus::kLimit) {
    result.gave_up = true;
    result.problem = "the exact run takes too long: nothing to compare with";
    return finish();
  }
  result.events = exact.trace.size();
  result.bits = bits_needed(exact.trace, *exact.scene.end);
  for (const std::string& arithmetic : in_order(options.arithmetics)) {
    std::optional<TradeRun> run = compared_run(exact, names, arithmetic, options);
    if (!run || !options.source.go_on()) return std::nullopt;
    result.runs.push_back(*std::move(run));
  }
  if (!measure_times(which, exact.scene, result.runs, options)) return std::nullopt;
  return finish();
}

std::optional<BitsNeeded> bits_of_scene(const Scene& scene, const TradeOptions& options) {
  EventNames names;
  Exact exact = exact_run(scene, names, options);
  if (exact.status != RunStatus::kDone) return std::nullopt;
  return bits_needed(exact.trace, *exact.scene.end);
}

}  // namespace kinex::trade
