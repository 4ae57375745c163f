// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/trade/runner.h"

#include <cmath>
#include <utility>

#include "experiments/lab/run_in_order.h"
#include "experiments/trade/case_record.h"

namespace kinex {

namespace {

constexpr double kMostBits = 1000;

std::string describe(const TradeCase& which) {
  return which.structure + ", " + which.name + ", n = " + std::to_string(which.parameters.n);
}

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

// As `run`, except that finished work is not run again.
template <class Result, class Run, class Read, class Record>
std::optional<Result> find_or_run(FinishedWork* finished, const std::string& key, const Read& read,
                                  const Record& record, const Run& run) {
  if (finished != nullptr) {
    if (const std::optional<std::string> found = finished->find(key)) {
      if (std::optional<Result> result = read(*found)) return result;
    }
  }
  std::optional<Result> result = run();
  if (result && finished != nullptr) finished->add(key, record(*result));
  return result;
}

std::optional<Fit> fit(const std::vector<const BitsResult*>& family,
                       RunningMean BitsResult::*bits) {
  std::vector<FitPoint> points;
  for (const BitsResult* size : family) {
    const RunningMean& mean = size->*bits;
    if (mean.count() == 0) continue;
    if (mean.mean() > kMostBits) return std::nullopt;
    const double value = std::exp2(mean.mean());
    points.push_back({static_cast<double>(size->which.parameters.n), value,
                      value * std::log(2.0) * mean.standard_error()});
  }
  return fit_power(points);
}

}  // namespace

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
  auto cases = run_in_order<CaseResult>(
      count, options.jobs,
      [&](std::size_t i) {
        const TradeCase& which = catalogue.cases[i];
        return find_or_run<CaseResult>(
            options.finished, case_key(which, options),
            [&](const std::string& record) { return read_case_record(record, which); }, case_record,
            [&] {
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
  auto bits = run_in_order<BitsResult>(
      catalogue.bits.size(), options.jobs,
      [&](std::size_t i) {
        const BitsCase& which = catalogue.bits[i];
        if (watch.on_work) {
          watch.on_work(count + i, which.structure + ", bits, " + which.family +
                                       ", n = " + std::to_string(which.parameters.n));
        }
        return find_or_run<BitsResult>(
            options.finished, bits_key(which),
            [&](const std::string& record) { return read_bits_record(record, which); }, bits_record,
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

}  // namespace kinex
