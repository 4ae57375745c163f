// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/trade/runner.h"

#include <cmath>
#include <utility>

#include "experiments/lab/run_in_order.h"
#include "experiments/trade/planned.h"

namespace kinex::trade {

namespace {

constexpr double kMostBits = 1000;

std::string describe(const TradeCase& which) {
  return which.structure + ", " + which.name + ", n = " + std::to_string(which.parameters.n);
}

// From its record. A scene of a file is run here: its cell is of no plan.
std::optional<CaseResult> recorded_case(const TradeCase& which, const TradeOptions& options) {
  sweep::CellSource source = options.source;
  if (which.given != nullptr) source.program.clear();
  const auto record =
      source.record_of(planned(which, options), [&]() -> std::optional<sweep::CellReport> {
        const std::optional<CaseResult> result = run_case(which, options);
        if (!result) return std::nullopt;
        return report_of(*result);
      });
  if (!record) return std::nullopt;
  return result_of(*record, which);
}

std::optional<BitsResult> recorded_bits(const BitsCase& which, const TradeOptions& options) {
  const auto record = options.source.record_of(
      planned(which, options), [&]() -> std::optional<sweep::CellReport> {
        return report_of(run_bits(which, options));  // after an interruption nothing is recorded
      });
  if (!record) return std::nullopt;
  return result_of(*record, which);
}

std::optional<lab::Fit> fit(const std::vector<const BitsResult*>& family,
                       lab::RunningMean BitsResult::*bits) {
  std::vector<lab::FitPoint> points;
  for (const BitsResult* size : family) {
    const lab::RunningMean& mean = size->*bits;
    if (mean.count() == 0) continue;
    if (mean.mean() > kMostBits) return std::nullopt;
    const double value = std::exp2(mean.mean());
    points.push_back({static_cast<double>(size->which.parameters.n), value,
                      value * std::log(2.0) * mean.standard_error()});
  }
  return lab::fit_power(points);
}

}  // namespace

std::optional<BitsResult> run_bits(const BitsCase& which, const TradeOptions& options) {
  BitsResult result;
  result.which = which;
  TradeCase one;
  one.structure = which.structure;
  one.workload = which.workload;
  one.parameters = which.parameters;
  for (int k = 0; k < which.seeds; ++k) {
    if (!options.source.go_on()) return std::nullopt;
    const std::optional<BitsNeeded> bits = bits_of_scene(one.scene(), options);
    if (!bits) return std::nullopt;
    ++one.parameters.seed;
    if (bits->pairs == 0) continue;  // no instants
    result.most.add(static_cast<double>(bits->most));
    result.percentile_99.add(static_cast<double>(bits->percentile_99));
    result.instants.add(static_cast<double>(bits->instants));
  }
  return result;
}

bool TradeResult::gave_up() const {
  for (const CaseResult& one : cases) {
    if (one.gave_up) return true;
    for (const TradeRun& run : one.runs) {
      if (run.ending == Ending::kGaveUp && bits_of_arithmetic(run.arithmetic) == 0) return true;
    }
  }
  return false;
}

std::vector<std::string> TradeResult::faults() const {
  std::vector<std::string> result;
  for (const CaseResult& one : cases) {
    for (const std::string& fault : one.faults()) {
      result.push_back(describe(one.which) + ": " + fault);
    }
  }
  return result;
}

std::vector<BitsGrowth> fit_bits(const std::vector<BitsResult>& bits) {
  std::vector<BitsGrowth> result;
  for (std::size_t begin = 0; begin < bits.size();) {
    const BitsCase& first = bits[begin].which;
    std::vector<const BitsResult*> family;
    for (; begin < bits.size() && bits[begin].which.structure == first.structure &&
           bits[begin].which.family == first.family;
         ++begin) {
      family.push_back(&bits[begin]);
    }
    BitsGrowth growth{first.structure, first.family, fit(family, &BitsResult::most),
                      fit(family, &BitsResult::percentile_99)};
    if (growth.most) result.push_back(std::move(growth));
  }
  return result;
}

TradeResult run_trade(const TradeCatalogue& catalogue, const TradeOptions& options,
                      const TradeWatch& watch) {
  const std::size_t count = catalogue.cases.size();
  TradeResult result;
  auto cases = lab::run_in_order<CaseResult>(
      count, options.jobs,
      [&](std::size_t i) {
        const TradeCase& which = catalogue.cases[i];
        if (watch.on_work) watch.on_work(i, describe(which));
        return recorded_case(which, options);
      },
      [&](std::size_t i, const CaseResult& one) {
        if (watch.on_finished) watch.on_finished(i);
        if (watch.on_case) watch.on_case(one);
      });
  result.cases = std::move(cases.finished);
  result.interrupted = cases.interrupted;
  if (result.interrupted) return result;
  auto bits = lab::run_in_order<BitsResult>(
      catalogue.bits.size(), options.jobs,
      [&](std::size_t i) {
        const BitsCase& which = catalogue.bits[i];
        if (watch.on_work) {
          watch.on_work(count + i, which.structure + ", bits, " + which.family +
                                       ", n = " + std::to_string(which.parameters.n));
        }
        return recorded_bits(which, options);
      },
      [&](std::size_t i, const BitsResult& one) {
        if (watch.on_finished) watch.on_finished(count + i);
        if (watch.on_bits) watch.on_bits(one);
      });
  result.bits = std::move(bits.finished);
  result.interrupted = bits.interrupted;
  result.growths = fit_bits(result.bits);
  return result;
}

}  // namespace kinex::trade
