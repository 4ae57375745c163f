// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/trade/runner.h"

#include <chrono>
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

// As `run`, except that a cell of the journal is not run again.
template <class Result, class Which, class Run>
std::optional<Result> find_or_run(const sweep::Cell& key, const Which& which,
                                  const TradeOptions& options, const Run& run) {
  if (options.journal != nullptr) {
    if (const sweep::Record* record = options.journal->find(key.key)) {
      return result_of(*record, which);
    }
  }
  const auto begin = std::chrono::steady_clock::now();
  std::optional<Result> result = run();
  if (result && options.journal != nullptr) {
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
    options.journal->add(sweep::record_of(key, report_of(*result), seconds.count()));
  }
  return result;
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
    if (!options.go_on()) return std::nullopt;
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
        return find_or_run<CaseResult>(planned(which, options), which, options, [&] {
          return run_case(which, options, [&](const std::string& arithmetic) {
            if (watch.on_work) watch.on_work(i, describe(which) + ": " + arithmetic);
          });
        });
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
        return find_or_run<BitsResult>(planned(which, options), which, options,
                                       [&] { return run_bits(which, options); });
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
