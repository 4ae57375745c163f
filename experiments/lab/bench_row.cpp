// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/lab/bench_row.h"

#include <stdexcept>
#include <utility>

#include "experiments/lab/family.h"
#include "structures/registry.h"

namespace kinex::lab {

std::string BenchRow::text() const {
  return std::string(structure) + " " + std::string(workload) + " " +
         std::to_string(parameters.degree) + " " + std::to_string(parameters.n);
}

BenchRow speed_row(std::string_view structure, std::string_view workload, int degree, int n,
                   std::vector<std::string_view> arithmetics) {
  BenchRow row{"speed", structure, workload};
  row.parameters.degree = degree;
  row.parameters.n = n;
  row.arithmetics = std::move(arithmetics);
  return row;
}

std::vector<BenchRow> bench_rows(std::string_view benchmark, const BenchOptions& options) {
  std::vector<BenchRow> rows;
  for (const FamilyExperiments& family : experiment_families()) {
    if (family.bench_rows == nullptr) continue;
    for (BenchRow& row : family.bench_rows(options.scale())) {
      if (row.benchmark != benchmark || row.text().find(options.rows) == std::string::npos)
        continue;
      row.rounds = options.rounds(row.rounds);
      rows.push_back(std::move(row));
    }
  }
  return rows;
}

Scene scene_of(const BenchRow& row) {
  const Workload* const workload = find_workload(row.workload);
  if (workload == nullptr) throw std::invalid_argument("no workload " + std::string(row.workload));
  WorkloadParameters parameters = row.parameters;
  const StructureInfo* const info = find_structure_info(row.structure);
  if (info != nullptr && parameters.dimension == 0 && !workload->bodies) {
    const int least = info->min_dimension;
    if (least == 1 && workload->min_dimension == 1) parameters.dimension = 1;
    if (least == 3) parameters.dimension = 3;
  }
  Scene scene = info == nullptr ? generate_scene(*workload, parameters)
                                : generate_scene(row.workload, parameters, row.structure);
  if (!row.maintain.empty()) scene.maintain = row.maintain;
  return scene;
}

}  // namespace kinex::lab
