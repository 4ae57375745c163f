// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/lab/series.h"

#include <optional>
#include <stdexcept>
#include <utility>

#include "experiments/lab/run_in_order.h"

namespace kinex::lab {

double quantity_of(const RunRecord& record, const std::string& quantity) {
  if (quantity == "processed") return static_cast<double>(record.processed);
  if (quantity == "external") return static_cast<double>(record.external);
  if (quantity == "max_live") return static_cast<double>(record.max_live);
  if (quantity == "signs") return static_cast<double>(record.signs);
  if (quantity == "max_per_object") return static_cast<double>(record.max_per_object);
  if (quantity.rfind("kind.", 0) == 0) {
    const auto found = record.kinds.find(quantity.substr(5));
    return found == record.kinds.end() ? 0 : static_cast<double>(found->second);
  }
  if (quantity.rfind("solved.", 0) == 0) {
    const std::size_t degree = std::stoul(quantity.substr(7));
    return degree < record.solved.size() ? static_cast<double>(record.solved[degree]) : 0;
  }
  throw std::invalid_argument("no quantity " + quantity);
}

RunningMean SeriesResult::mean(const std::string& quantity) const {
  RunningMean mean;
  for (const RunRecord& run : runs) mean.add(quantity_of(run, quantity));
  return mean;
}

SeriesRun run_series(const std::vector<SeriesPoint>& points, RecordStore& store,
                     const SeriesOptions& options) {
  const auto enough = [](const SeriesResult& result) {
    const RunningMean mean = result.mean(result.point.precise);
    const int runs = static_cast<int>(result.runs.size());
    if (runs < result.point.min_seeds) return false;
    return runs >= result.point.max_seeds ||
           mean.standard_error() <= result.point.relative_error * mean.mean();
  };
  const auto work = [&](std::size_t i) -> std::optional<SeriesResult> {
    SeriesResult result;
    result.point = points[i];
    for (std::uint64_t seed = 1; !enough(result); ++seed) {
      if (!options.go_on()) return std::nullopt;
      RunKey key = points[i].key;
      key.seed = seed;
      const RunRecord* known = store.find(key.text());
      if (known == nullptr) {
        if (options.on_run) options.on_run(i, key.text());
        std::optional<RunRecord> record = run_record(key, options.go_on, options.interrupt);
        if (!record) return std::nullopt;
        known = &store.add(*record);
      }
      result.runs.push_back(*known);
    }
    return result;
  };
  InOrder<SeriesResult> done =
      run_in_order<SeriesResult>(points.size(), options.jobs, work, options.on_point);
  SeriesRun run;
  run.interrupted = done.interrupted;
  run.results = std::move(done.finished);
  for (const SeriesResult& result : run.results) {
    for (const RunRecord& record : result.runs) {
      if (!record.clean) run.troubles.push_back(record.key + ": " + record.trouble);
    }
  }
  return run;
}

}  // namespace kinex::lab
