// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/lab/scene_run.h"

#include <stdexcept>
#include <utility>

#include "experiments/formats/input_error.h"
#include "experiments/formats/near_names.h"
#include "experiments/lab/arithmetics.h"
#include "experiments/lab/gmp_memory.h"
#include "structures/plan.h"

namespace kinex::lab {

std::unique_ptr<Arithmetic> arithmetic_option(const std::string& name, const Scene& scene) {
  try {
    return planned_arithmetic(name, scene);
  } catch (const std::invalid_argument& error) {
    // "PROBLEM; CHOICES"
    const std::string message = error.what();
    const std::size_t end = message.find("; ");
    if (end == std::string::npos) throw formats::InputError("--arithmetic", "", message, "write exact");
    std::vector<std::string> names;
    for (const ArithmeticInfo& info : arithmetic_infos()) names.emplace_back(info.name);
    throw formats::InputError("--arithmetic", "", message.substr(0, end),
                              formats::did_you_mean(name, names, message.substr(end + 2)));
  }
}

std::unique_ptr<Simulator> make_simulator(const Scene& scene, const std::string& arithmetic,
                                          SimulatorOptions options) {
  Deadline setup(options.max_seconds, options.interrupt);
  const GmpGuard guard(&setup);
  auto simulator =
      std::make_unique<Simulator>(scene, arithmetic_option(arithmetic, scene), std::move(options));
  add_structures(*simulator, scene);
  return simulator;
}

formats::RunOutcome run_scene(Simulator& simulator, const std::vector<Rational>& times) {
  formats::RunOutcome outcome;
  const GmpGuard guard(&simulator.deadline());
  simulator.start();
  for (const Rational& t : times) {
    outcome.status = simulator.run_until(t);
    if (outcome.status != RunStatus::kDone) break;
    formats::Sample sample{t, {}};
    for (StructureId id = 0; id < simulator.structures(); ++id) {
      sample.values.push_back(formats::value_now(simulator, id));
    }
    outcome.samples.push_back(std::move(sample));
  }
  if (outcome.status == RunStatus::kDone) outcome.status = simulator.run_until(std::nullopt);
  for (StructureId id = 0; id < simulator.structures(); ++id) {
    outcome.bounds.push_back(simulator.bounds(id));
  }
  return outcome;
}

}  // namespace kinex::lab
