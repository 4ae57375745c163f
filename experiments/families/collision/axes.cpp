// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/families/collision/axes.h"

#include <algorithm>
#include <cmath>

namespace kinex::families {

std::optional<double> known_separation(const std::string& workload,
                                    const lab::WorkloadParameters& parameters) {
  if (parameters.separation) return parameters.separation->to_double();
  const lab::Workload* known = lab::find_workload(workload);
  if (known == nullptr || !known->separation) return std::nullopt;
  return known->separation->to_double();
}

std::optional<double> known_mu(const std::string& workload, const lab::WorkloadParameters& parameters) {
  const std::optional<double> separation = known_separation(workload, parameters);
  if (!separation) return std::nullopt;
  const int usual = lab::find_workload(workload)->default_m;
  const int other = parameters.m != 0 ? parameters.m : usual != 0 ? usual : parameters.n;
  return std::min<double>(parameters.n + other, std::sqrt(2 / *separation));
}

lab::Axis vertices_axis(const lab::Cell& cell) {
  return {kVerticesAxis, static_cast<double>(cell.parameters.n)};
}

lab::Axis mu_axis(const lab::Cell& cell) {
  return {kMuAxis, known_mu(cell.workload, cell.parameters).value()};
}

lab::Axis nearness_axis(const lab::Cell& cell) {
  return {"4 / separation", 4 / known_separation(cell.workload, cell.parameters).value()};
}

}  // namespace kinex::families
