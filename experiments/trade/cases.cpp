// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/trade/cases.h"

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "core/numbers/near_names.h"
#include "experiments/formats/input_error.h"
#include "experiments/formats/scene_reader.h"
#include "experiments/lab/family.h"
#include "structures/registry.h"

namespace kinex::trade {

namespace {

constexpr long kDoubleBits = 53;

// Of all families.
std::vector<lab::TradePlan> plans() {
  std::vector<lab::TradePlan> all;
  for (const lab::FamilyExperiments& family : lab::experiment_families()) {
    all.insert(all.end(), family.trade.begin(), family.trade.end());
  }
  return all;
}

lab::WorkloadParameters parameters_of(const std::string& workload, int n, int degree, int dimension) {
  lab::WorkloadParameters parameters;
  parameters.n = n;
  parameters.degree = degree;
  const int own = lab::find_workload(workload)->default_dimension;
  parameters.dimension = dimension == own ? 0 : dimension;
  return parameters;
}

// Tells scenes in space from others of a structure that has both.
std::string axes_of(const lab::TradePlan& plan) {
  const bool both = plan.dimension == 3 && find_structure_info(plan.structure)->min_dimension < 3;
  return both ? ", 3 axes" : "";
}

void add_case(TradeCatalogue& catalogue, const lab::TradePlan& plan, lab::Extent extent,
              const std::string& workload, int n, int degree, double cost) {
  TradeCase one;
  one.structure = plan.structure;
  one.workload = workload;
  one.parameters = parameters_of(workload, n, degree, plan.dimension);
  one.name = workload + axes_of(plan) + (degree == 1 ? "" : ", degree " + std::to_string(degree));
  one.cost = cost;
  if (extent == lab::Extent::kQuick) one.enough_seconds = 0.01;
  catalogue.cases.push_back(std::move(one));
}

void add_plan(TradeCatalogue& catalogue, const lab::TradePlan& plan, lab::Extent extent) {
  const std::size_t size = extent == lab::Extent::kQuick ? 0 : 1;
  const int largest = find_structure_info(plan.structure)->largest_degree;
  for (int degree = 1; degree <= std::min(3, largest); ++degree) {
    add_case(catalogue, plan, extent, "uniform-square", plan.uniform[size], degree, degree);
  }
  add_case(catalogue, plan, extent, std::string(plan.worst), plan.worst_n[size], 1, 1);
  add_case(catalogue, plan, extent, "grid", plan.grid[size], 1, 1);
  add_case(catalogue, plan, extent, "near-one-point", plan.near[size], 1, 1);
  for (int degree = 1; degree <= std::min(3, largest); ++degree) {
    for (const int n : plan.bits[size]) {
      BitsCase one;
      one.structure = plan.structure;
      one.workload = "uniform-square";
      one.parameters = parameters_of(one.workload, n, degree, plan.dimension);
      one.seeds = size == 0 ? 4 : 8;
      one.family = "uniform-square" + axes_of(plan) + ", degree " + std::to_string(degree);
      one.cost = 0.001 * n;
      catalogue.bits.push_back(std::move(one));
    }
  }
}

void add_file(TradeCatalogue& catalogue, const std::string& file) {
  const Scene scene = formats::read_scene(file);
  if (scene.maintain.empty()) {
    throw formats::InputError(file, "/maintain", "nothing is to be maintained",
                     "fill \"maintain\" in the scene");
  }
  for (const Request& request : scene.maintain) {
    TradeCase one;
    one.structure = request.label;
    one.name = scene.name.empty() ? file : scene.name;
    auto given = std::make_shared<Scene>(scene);
    given->maintain = {request};
    one.given = std::move(given);
    one.parameters.n = static_cast<int>(scene.objects.size());
    one.cost = 1;
    catalogue.cases.push_back(std::move(one));
  }
}

[[noreturn]] void refuse(const std::string& name) {
  if (find_structure_info(name) != nullptr) {
    throw formats::InputError("trade", "", name + " has no scenes of its own here",
                              "name a scene that maintains it: kinex explain " + name +
                                  " has an example");
  }
  std::vector<std::string> choices{"all"};
  for (const lab::TradePlan& plan : plans()) choices.emplace_back(plan.structure);
  throw formats::InputError(
      "trade", "", show_text(name) + " is neither a file nor a structure",
      did_you_mean(name, choices,
                            "name a scene, or one of kinex list structures, or all"));
}

bool is_file(const std::string& name) {
  std::error_code error;
  return name == "-" || std::filesystem::exists(name, error);
}

}  // namespace

Scene TradeCase::scene() const {
  if (given != nullptr) return *given;
  return lab::generate_scene(workload, parameters, structure);
}

TradeCatalogue make_trade_catalogue(const std::vector<std::string>& what, lab::Extent extent) {
  TradeCatalogue catalogue;
  for (const std::string& name : what.empty() ? std::vector<std::string>{"all"} : what) {
    bool known = false;
    for (const lab::TradePlan& plan : plans()) {
      if (name != "all" && name != plan.structure) continue;
      known = true;
      add_plan(catalogue, plan, extent);
    }
    if (known) continue;
    if (!is_file(name)) refuse(name);
    add_file(catalogue, name);
  }
  return catalogue;
}

const std::vector<std::string>& trade_arithmetics() {
  static const std::vector<std::string> kNames{"exact",    "sturm",   "double",  "gsl",
                                               "mpfr:24",  "mpfr:53", "mpfr:64", "mpfr:100",
                                               "mpfr:200", "mpfr:400"};
  return kNames;
}

long bits_of_arithmetic(std::string_view name) {
  if (name == "exact" || name == "sturm") return 0;
  if (name.rfind("mpfr:", 0) == 0) return std::stol(std::string(name.substr(5)));
  return kDoubleBits;
}

}  // namespace kinex::trade
