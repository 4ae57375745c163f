// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/lab/measures.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

namespace kinex::lab {

namespace {

std::string count_text(double mean) {
  return mean == static_cast<double>(static_cast<std::int64_t>(mean)) ? fmt::format("{:.0f}", mean)
                                                                      : fmt::format("{:.1f}", mean);
}

}  // namespace

Measures measures_of(const CellResult& cell) { return measures_of(cell, cell.trials.size()); }

Measures measures_of(const CellResult& cell, std::size_t trials) {
  const std::vector<Trial> first(
      cell.trials.begin(),
      cell.trials.begin() + static_cast<std::ptrdiff_t>(std::min(trials, cell.trials.size())));
  Measures result;
  std::uint64_t changed = 0, events = 0, scene_changes = 0, asked_by_scene = 0, signs = 0;
  double seconds = 0;
  for (const Trial& trial : first) {
    const StructureLedger& ledger = trial.measurement.costs;
    scene_changes += trial.measurement.scene_changes();
    asked_by_scene += trial.measurement.asked_by_scene();
    signs += trial.measurement.signs();
    seconds += trial.measurement.seconds;
    // The largest numbers of both, which need not belong to one event, but do wherever every
    // certificate that goes is replaced.
    result.most_changed = std::max(result.most_changed,
                                   ledger.created_per_event.max + ledger.retracted_per_event.max);
    changed += ledger.created_per_event.total + ledger.retracted_per_event.total;
    events += ledger.created_per_event.events;
    result.per_object = std::max(result.per_object, ledger.max_per_object);
    result.certificates = std::max(result.certificates, ledger.max_live);
  }
  result.events = mean_of(first, "processed").mean();
  result.external = mean_of(first, "external").mean();
  result.internal = mean_of(first, "internal").mean();
  if (events > 0) result.mean_changed = static_cast<double>(changed) / static_cast<double>(events);
  if (scene_changes > 0) {
    result.asked_by_scene =
        static_cast<double>(asked_by_scene) / static_cast<double>(scene_changes);
  }
  const double asked =
      result.events * static_cast<double>(first.size()) + static_cast<double>(scene_changes);
  if (cell.cell.audit == AuditLevel::kEvents) return result;
  if (asked > 0) result.signs = static_cast<double>(signs) / asked;
  if (!first.empty()) result.seconds = seconds / static_cast<double>(first.size());
  return result;
}

std::vector<Table> comparison_tables(const std::vector<CellResult>& cells) {
  // By comparison, then by scenes; structures stay in their order.
  std::map<std::string, std::vector<const CellResult*>> comparisons;
  for (const CellResult& cell : cells) {
    if (cell.cell.comparison.empty() || cell.trials.empty()) continue;
    comparisons[cell.cell.comparison].push_back(&cell);
  }
  std::vector<Table> tables;
  for (auto& [comparison, rows] : comparisons) {
    const auto place = [](const CellResult* c) {
      return std::tuple(c->cell.workload, c->cell.parameters.degree, c->cell.parameters.n,
                        c->cell.workload_text());
    };
    std::stable_sort(rows.begin(), rows.end(),
                     [&](const CellResult* a, const CellResult* b) { return place(a) < place(b); });
    std::map<decltype(place(nullptr)), std::size_t> seeds;  // those that all have
    for (const CellResult* cell : rows) {
      std::size_t& fewest = seeds.try_emplace(place(cell), cell->trials.size()).first->second;
      fewest = std::min(fewest, cell->trials.size());
    }
    Table table;
    table.title = comparison + ": responsiveness, locality, compactness and efficiency";
    table.header = {"workload",
                    "n",
                    "structure",
                    "scenes",
                    "events",
                    "external",
                    "certificates changed per event: most",
                    "mean",
                    "failure times by a change of the scene",
                    "signs per event or change",
                    "certificates per object",
                    "certificates",
                    "internal per external",
                    "CPU seconds"};
    for (const CellResult* cell : rows) {
      const std::size_t scenes = seeds.at(place(cell));
      const Measures m = measures_of(*cell, scenes);
      table.rows.push_back(
          {cell->cell.workload_text(), std::to_string(cell->cell.parameters.n),
           cell->cell.structure, std::to_string(scenes), count_text(m.events),
           count_text(m.external), std::to_string(m.most_changed),
           fmt::format("{:.1f}", m.mean_changed),
           m.asked_by_scene < 0 ? "-" : fmt::format("{:.1f}", m.asked_by_scene),
           m.signs < 0 ? "-" : fmt::format("{:.1f}", m.signs), std::to_string(m.per_object),
           std::to_string(m.certificates),
           m.internal_per_external() < 0 ? "-" : fmt::format("{:.2f}", m.internal_per_external()),
           m.seconds < 0 ? "-" : fmt::format("{:.4f}", m.seconds)});
    }
    table.note =
        "Events are means over the runs; certificates are the most that any run had. Created and "
        "retracted certificates both count as changed.";
    tables.push_back(std::move(table));
  }
  return tables;
}

}  // namespace kinex::lab
