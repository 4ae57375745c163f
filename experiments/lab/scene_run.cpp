// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/lab/scene_run.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

#include "core/numbers/near_names.h"
#include "experiments/formats/input_error.h"
#include "experiments/lab/arithmetics.h"
#include "experiments/lab/gmp_memory.h"
#include "structures/plan.h"
#include "structures/parts/range_search.h"

namespace kinex::lab {

std::unique_ptr<Arithmetic> arithmetic_option(const std::string& name, const Scene& scene) {
  try {
    return planned_arithmetic(name, scene);
  } catch (const std::invalid_argument& error) {
    // "PROBLEM; CHOICES"
    const std::string message = error.what();
    const std::size_t end = message.find("; ");
    if (end == std::string::npos) throw formats::InputError("--arithmetic", "", message, "write exact");
    if (name.starts_with("mpfr")) {
      throw formats::InputError("--arithmetic", "",
                                show_text(name) + " is not mpfr:P for P from 2 to 100000 bits",
                                "write such a number of bits, as mpfr:100");
    }
    std::vector<std::string> names;
    for (const ArithmeticInfo& info : arithmetic_infos()) names.emplace_back(info.name);
    throw formats::InputError("--arithmetic", "", message.substr(0, end),
                              did_you_mean(name, names, message.substr(end + 2)));
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

namespace {

// Asks the queries of the scene. Their corners are constants, which are made when they are needed:
// runs without constants are faster.
class Questions {
 public:
  explicit Questions(Simulator& simulator) : simulator_(simulator) {}

  // Those at the time of the sample.
  void ask(formats::Sample& sample) {
    for (const BoxQuery& query : simulator_.scene().queries) {
      if (query.at != sample.t) continue;
      place_corners(query);
      sample.queries.push_back({query.box, {}});
      for (StructureId id = 0; id < simulator_.structures(); ++id) {
        auto* const tree = dynamic_cast<RangeSearch*>(&simulator_.structure(id));
        if (tree == nullptr || simulator_.ledger(id).corrupt) continue;
        formats::BoxAnswer::OfStructure answer{id, {}, {}};
        tree->report(low_, high_, answer.ids, answer.counts);
        std::sort(answer.ids.begin(), answer.ids.end());
        sample.queries.back().answers.push_back(std::move(answer));
      }
    }
  }

 private:
  void place_corners(const BoxQuery& query) {
    std::array<std::vector<Rational>, 2> corners;
    for (const auto& side : query.box) {
      corners[0].push_back(side[0]);
      corners[1].push_back(side[1]);
    }
    Kernel& kernel = simulator_.kernel();
    if (low_ == kNoObject) {
      low_ = kernel.constant("low corner", corners[0]);
      high_ = kernel.constant("high corner", corners[1]);
    } else {
      kernel.redefine(low_, "low corner", corners[0]);
      kernel.redefine(high_, "high corner", corners[1]);
    }
  }

  Simulator& simulator_;
  ObjectId low_ = kNoObject, high_ = kNoObject;
};

}  // namespace

formats::RunOutcome run_scene(Simulator& simulator, const std::vector<Rational>& asked) {
  formats::RunOutcome outcome;
  std::vector<Rational> times = asked;
  for (const BoxQuery& query : simulator.scene().queries) times.push_back(query.at);
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  Questions questions(simulator);
  const GmpGuard guard(&simulator.deadline());
  simulator.start();
  for (const Rational& t : times) {
    outcome.status = simulator.run_until(t);
    if (outcome.status != RunStatus::kDone) break;
    formats::Sample sample{t, {}, {}};
    for (StructureId id = 0; id < simulator.structures(); ++id) {
      sample.values.push_back(formats::value_now(simulator, id));
    }
    questions.ask(sample);
    outcome.samples.push_back(std::move(sample));
  }
  if (outcome.status == RunStatus::kDone) outcome.status = simulator.run_until(std::nullopt);
  for (StructureId id = 0; id < simulator.structures(); ++id) {
    outcome.bounds.push_back(simulator.bounds(id));
  }
  return outcome;
}

}  // namespace kinex::lab
