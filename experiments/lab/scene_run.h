// SPDX-License-Identifier: GPL-3.0-or-later
// Runs a scene with all its structures: samples during the run, bounds at its end.
#ifndef KINEX_EXPERIMENTS_LAB_SCENE_RUN_H
#define KINEX_EXPERIMENTS_LAB_SCENE_RUN_H

#include <memory>
#include <string>
#include <vector>

#include "core/engine/simulator.h"
#include "experiments/formats/run_outcome.h"

namespace kinex::lab {

// The arithmetic that an option --arithmetic names. Throws InputError for an unknown one.
std::unique_ptr<Arithmetic> arithmetic_option(const std::string& name, const Scene& scene);

// A simulator with every structure that scene.maintain names, not started. The scene must
// outlive it. Throws InputError for an unknown arithmetic.
// Throws Stopped if it takes longer than the options allow.
std::unique_ptr<Simulator> make_simulator(const Scene& scene, const std::string& arithmetic,
                                          SimulatorOptions options);

// Starts the simulator, runs it to the end of its scene, and takes a sample at each of `times`
// and of the scene's queries (within the scene's time). Audits according to the simulator's options; a run that
// stops at a limit is not audited at its end.
formats::RunOutcome run_scene(Simulator& simulator, const std::vector<Rational>& times);

}  // namespace kinex::lab

#endif
