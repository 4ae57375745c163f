// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/verify/measures.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

#include "experiments/verify/collision_story.h"

namespace kinex {

namespace {

std::string count_text(double mean) {
  return mean == static_cast<double>(static_cast<std::int64_t>(mean)) ? fmt::format("{:.0f}", mean)
                                                                      : fmt::format("{:.1f}", mean);
}

}  // namespace

Measures measures_of(const CellResult& cell) {
  Measures result;
  std::uint64_t changed = 0, events = 0;
  for (const Trial& trial : cell.trials) {
    const StructureLedger& ledger = trial.measurement.costs;
    // The largest numbers of both, which need not be of the same event, but are wherever every
    // certificate that goes is replaced.
    result.most_changed = std::max(result.most_changed,
                                   ledger.created_per_event.max + ledger.retracted_per_event.max);
    changed += ledger.created_per_event.total + ledger.retracted_per_event.total;
    events += ledger.created_per_event.events;
    result.per_object = std::max(result.per_object, ledger.max_per_object);
    result.certificates = std::max(result.certificates, ledger.max_live);
  }
  result.events = mean_of(cell.trials, "processed").mean();
  result.external = mean_of(cell.trials, "external").mean();
  result.internal = mean_of(cell.trials, "internal").mean();
  if (events > 0) result.mean_changed = static_cast<double>(changed) / static_cast<double>(events);
  return result;
}

std::vector<MeasuresTable> measures_tables(const std::vector<CellResult>& cells) {
  // By comparison, then by scenes; structures stay in their order.
  std::map<std::string, std::vector<const CellResult*>> comparisons;
  for (const CellResult& cell : cells) {
    if (cell.cell.comparison.empty() || cell.trials.empty()) continue;
    comparisons[cell.cell.comparison].push_back(&cell);
  }
  std::vector<MeasuresTable> tables;
  for (auto table : {collision_table(cells), signs_table(cells)}) {
    if (table) tables.push_back(*std::move(table));
  }
  for (auto& [comparison, rows] : comparisons) {
    std::stable_sort(rows.begin(), rows.end(), [](const CellResult* a, const CellResult* b) {
      const auto place = [](const CellResult* c) {
        return std::tuple(c->cell.workload, c->cell.parameters.degree, c->cell.parameters.n,
                          c->cell.workload_text());
      };
      return place(a) < place(b);
    });
    MeasuresTable table;
    table.title = comparison + ": responsiveness, locality, compactness and efficiency";
    table.header = {"workload",     "n",
                    "structure",    "events",
                    "external",     "certificates changed per event: most",
                    "mean",         "certificates per object",
                    "certificates", "internal per external"};
    for (const CellResult* cell : rows) {
      const Measures m = measures_of(*cell);
      table.rows.push_back(
          {cell->cell.workload_text(), std::to_string(cell->cell.parameters.n),
           cell->cell.structure, count_text(m.events), count_text(m.external),
           std::to_string(m.most_changed), fmt::format("{:.1f}", m.mean_changed),
           std::to_string(m.per_object), std::to_string(m.certificates),
           m.internal_per_external() < 0 ? "-" : fmt::format("{:.2f}", m.internal_per_external())});
    }
    tables.push_back(std::move(table));
  }
  return tables;
}

MeasuresTable study_table(const StudyResult& study) {
  return {study.title, study.header, study.rows};
}

std::string measures_text(const MeasuresTable& table) {
  std::string text = "\n## " + table.title + "\n\n|";
  for (const std::string& cell : table.header) text += " " + cell + " |";
  text += "\n|";
  for (std::size_t i = 0; i < table.header.size(); ++i) {
    text += i == 0 || i == 2 ? " --- |" : " ---: |";
  }
  text += "\n";
  for (const auto& row : table.rows) {
    text += "|";
    for (const std::string& cell : row) text += " " + cell + " |";
    text += "\n";
  }
  return text;
}

}  // namespace kinex
