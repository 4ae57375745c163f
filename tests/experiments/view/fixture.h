// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes and plain runs for the tests of `kinex view`.
#ifndef KINEX_TESTS_EXPERIMENTS_VIEW_FIXTURE_H
#define KINEX_TESTS_EXPERIMENTS_VIEW_FIXTURE_H

#include <string>
#include <vector>

#include "experiments/formats/event_log.h"
#include "experiments/formats/scene_reader.h"
#include "experiments/formats/scene_writer.h"
#include "experiments/lab/scene_run.h"
#include "experiments/lab/workload.h"
#include "experiments/view/recorder.h"

namespace kinex::test {

inline Scene workload(const char* name, int n, const std::string& maintain, int dimension = 0,
                      int degree = 1) {
  lab::WorkloadParameters parameters;
  parameters.n = n;
  parameters.seed = 5;
  parameters.dimension = dimension;
  parameters.degree = degree;
  Scene scene = lab::generate_scene(*lab::find_workload(name), parameters);
  formats::set_maintain(scene, {maintain});
  return scene;
}

inline view::RecordedRun record(const Scene& scene, const std::string& arithmetic = "exact") {
  view::RecordOptions options;
  options.arithmetic = arithmetic;
  return view::record_run(scene, options);
}

// A scene in which objects come, go, jump and change their motion.
inline Scene busy_scene(const std::string& maintain) {
  Scene scene = formats::parse_scene(R"({"kinex": 1, "name": "busy", "dimension": 2, "jumps": true,
    "time": {"start": 0, "end": 4},
    "objects": [
      {"id": "a", "motion": [[0, 1], [0, "1/3"]]},
      {"id": "b", "motion": [[4, -1], [1]]},
      {"id": "c", "motion": [{"from": 1, "to": 3, "coordinates": [[2], [3, -1]]}]},
      {"id": "d", "motion": [{"from": 0, "to": 2, "coordinates": [[1, "1/2"], [4, -2]]},
                             {"from": 2, "to": 4, "coordinates": [[0, 1], [4, -2]]}]},
      {"id": "e", "motion": [{"from": 0, "to": 2, "coordinates": [[3], [-1]]},
                             {"from": 2, "to": 4, "coordinates": [["1/2", "1/7"], [5, -1]]}]},
      {"id": "f", "motion": [["7/2", "-3/5"], [2, "1/9"]]}]})",
                            "busy");
  formats::set_maintain(scene, {maintain});
  return scene;
}

// The events before each of the times, by a run without a recorder.
struct PlainSample {
  std::uint64_t events = 0;
  std::vector<Attribute> values;
};
struct PlainRun {
  std::vector<PlainSample> samples;
  std::string digest;
};
inline PlainRun plain_run(const Scene& scene, const std::string& arithmetic,
                          const std::vector<Rational>& times) {
  SimulatorOptions options;
  options.audit = AuditLevel::kNone;
  const auto simulator = lab::make_simulator(scene, arithmetic, options);
  formats::EventLog log(*simulator, "", nullptr);
  simulator->set_sink(&log);
  simulator->start();
  PlainRun run;
  for (const Rational& t : times) {
    simulator->run_until(t);
    PlainSample& sample = run.samples.emplace_back();
    sample.events = log.records();
    for (StructureId id = 0; id < simulator->structures(); ++id) {
      sample.values.push_back(formats::value_now(*simulator, id));
    }
  }
  simulator->run_until(std::nullopt);
  run.digest = log.digest();
  return run;
}

}  // namespace kinex::test

#endif
