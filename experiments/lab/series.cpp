// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/lab/series.h"

#include <optional>
#include <stdexcept>
#include <utility>

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

namespace {

bool is_precise(const SeriesResult& result) {
  const int runs = static_cast<int>(result.runs.size());
  if (runs < result.point.min_seeds) return false;
  const RunningMean mean = result.mean(result.point.precise);
  return runs >= result.point.max_seeds ||
         mean.standard_error() <= result.point.relative_error * mean.mean();
}

struct Runs {
  std::vector<RunRecord> records;
};

template <class Archive>
void fields(Archive& archive, Runs& value) {
  archive(value.records);
}

}  // namespace

// Structured bindings name all members: one that is added must be added here too.
template <class Archive>
void fields(Archive& archive, RunRecord& value) {
  auto& [key, processed, external, max_live, max_per_object, signs, solved, kinds, peak_bytes,
         seconds_setup, seconds, clean, trouble] = value;
  archive(key, processed, external, max_live, max_per_object, signs, solved, kinds, peak_bytes,
          clean, trouble);
  archive.times(seconds_setup, seconds);
}

std::optional<SeriesResult> run_point(const SeriesPoint& point, const SeriesOptions& options) {
  SeriesResult result;
  result.point = point;
  for (std::uint64_t seed = 1; !is_precise(result); ++seed) {
    if (!options.go_on()) return std::nullopt;
    RunKey key = point.key;
    key.parameters.seed = seed;
    std::optional<RunRecord> record = run_record(key, options.go_on, options.interrupt);
    if (!record) return std::nullopt;
    result.runs.push_back(*std::move(record));
  }
  return result;
}

Fields runs_fields(const std::vector<RunRecord>& runs) { return to_fields(Runs{runs}); }

std::optional<std::vector<RunRecord>> runs_of(const Fields& fields) {
  std::optional<Runs> runs = from_fields<Runs>(fields);
  if (!runs) return std::nullopt;
  return std::move(runs->records);
}

}  // namespace kinex::lab
