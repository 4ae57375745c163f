// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/lab/scene_command.h"

#include <fmt/format.h>

namespace kinex::lab {

std::string scene_commands(const std::string& workload, const WorkloadParameters& parameters,
                           const std::string& structure) {
  const Workload* known = find_workload(workload);
  std::string text = fmt::format("kinex gen {} --n {}", workload, parameters.n);
  if (parameters.m != 0) text += fmt::format(" --m {}", parameters.m);
  if (known == nullptr || known->random) text += fmt::format(" --seed {}", parameters.seed);
  if (parameters.degree != 1) text += fmt::format(" --degree {}", parameters.degree);
  if (parameters.dimension != 0) text += fmt::format(" --dimension {}", parameters.dimension);
  if (parameters.separation) text += " --separation " + parameters.separation->to_string();
  if (parameters.turns != -1) text += fmt::format(" --turns {}", parameters.turns);
  text += " --maintain " + structure + " -o scene.json\n";
  return text +
         "kinex run scene.json --events scene.jsonl --summary summary.json\n"
         "kinex view scene.json -o view.html\n";
}

}  // namespace kinex::lab
