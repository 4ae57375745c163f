// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/families/collision/story.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <tuple>
#include <utility>

#include "experiments/families/collision/axes.h"
#include "experiments/lab/curves.h"
#include "structures/collision/separation_mixed.h"
#include "structures/registry.h"

namespace kinex::families {
namespace {

using SceneKey = std::tuple<std::string, int, double, std::string>;  // row, n, mu, workload

// 0: not known.
double mu_of(const lab::Cell& cell) { return known_mu(cell.workload, cell.parameters).value_or(0); }

std::vector<std::string> methods_of(const std::vector<lab::CellResult>& cells) {
  std::vector<std::string> methods;
  for (const StructureInfo& info : structure_infos()) {
    if (std::any_of(cells.begin(), cells.end(), [&](const lab::CellResult& cell) {
          return !cell.cell.family_row.empty() && cell.cell.structure == info.name;
        })) {
      methods.emplace_back(info.name);
    }
  }
  return methods;
}

std::string count_text(double mean) {
  return mean == std::floor(mean) ? fmt::format("{:.0f}", mean) : fmt::format("{:.1f}", mean);
}

double events_of(const lab::CellResult& cell) { return lab::mean_of(cell.trials, "processed").mean(); }

struct Curve {
  std::string method;
  std::vector<std::pair<double, double>> points;
};

std::vector<Curve> curves_of(const std::vector<lab::CellResult>& cells, const std::string& family,
                             std::string_view axis) {
  std::map<std::string, Curve> curves;
  for (const lab::CellResult& cell : cells) {
    if (cell.trials.empty() || cell.cell.family_row.empty()) continue;
    if (cell.cell.family.compare(0, family.size(), family) != 0) continue;
    if (cell.cell.axis.name != axis) continue;
    Curve& curve = curves[cell.cell.structure];
    curve.method = cell.cell.structure;
    curve.points.emplace_back(cell.cell.axis.value, events_of(cell));
  }
  std::vector<Curve> result;
  for (const std::string& method : methods_of(cells)) {
    const auto found = curves.find(method);
    if (found == curves.end() || found->second.points.size() < 3) continue;
    std::sort(found->second.points.begin(), found->second.points.end());
    result.push_back(std::move(found->second));
  }
  return result;
}

// One picture: a curve by method, of the method's own look in all pictures.
lab::Figure panel(lab::Figure figure, const std::vector<lab::CellResult>& cells,
                  const lab::CurvesPicture& picture, const std::vector<Curve>& curves) {
  const std::vector<std::string> methods = methods_of(cells);
  std::vector<lab::Curve> drawn;
  for (const Curve& curve : curves) {
    lab::Curve one{curve.method, {}, ""};
    for (const auto& [x, y] : curve.points) one.points.push_back({x, y, 0});
    const auto found = std::find(methods.begin(), methods.end(), curve.method);
    one.is_bound = found == methods.end();
    one.look = static_cast<std::size_t>(found - methods.begin());
    if (const std::optional<lab::Fit> fit = lab::fit_power(one.points); fit && !one.is_bound) {
      one.value = lab::power_value(*fit, picture.x.substr(0, picture.x.find(' ')));
    }
    drawn.push_back(std::move(one));
  }
  lab::set_curves(figure, picture, drawn);
  return figure;
}

}  // namespace

std::optional<lab::Table> events_table(const std::vector<lab::CellResult>& cells) {
  const std::vector<std::string> methods = methods_of(cells);
  if (methods.empty()) return std::nullopt;
  std::map<SceneKey, std::map<std::string, std::string>> rows;
  for (const lab::CellResult& cell : cells) {
    if (cell.cell.family_row.empty() || cell.trials.empty()) continue;
    rows[{cell.cell.family_row, cell.cell.parameters.n, mu_of(cell.cell), cell.cell.workload_text()}]
        [cell.cell.structure] = count_text(events_of(cell));
  }
  lab::Table table;
  table.title = "collision: events of every method on the same scenes";
  table.note = "Means over the scenes of a row.";
  table.header = {"scene", "n", "workload", "mu"};
  table.header.insert(table.header.end(), methods.begin(), methods.end());
  for (const auto& [scene, counts] : rows) {
    const auto& [name, n, mu, workload] = scene;
    std::vector<std::string> row{name, std::to_string(n), workload,
                                 mu > 0 ? fmt::format("{:.1f}", mu) : "-"};
    for (const std::string& method : methods) {
      const auto found = counts.find(method);
      row.push_back(found == counts.end() ? "-" : found->second);
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

std::optional<double> signs_limit(const lab::Cell& cell) {
  constexpr double kPerLevel = SeparationMixed::kSignsPerLevel, kRest = SeparationMixed::kSigns;
  if (cell.structure != "separation_mixed" && cell.structure != "separation_minkowski") return {};
  const double mu = cell.family_row.empty() ? 0 : mu_of(cell);
  if (!(mu > 0)) return {};
  return kPerLevel * (2 * std::max(0.0, std::log2(mu)) + 6) + kRest;
}

std::optional<lab::Table> signs_table(const std::vector<lab::CellResult>& cells) {
  const std::vector<std::string> methods = methods_of(cells);
  if (methods.empty()) return std::nullopt;
  lab::Table table;
  table.title = "collision: signs asked for per event or change of the scene";
  table.note =
      "Signs and events are of all scenes of a row together; their quotient is compared with the "
      "limit, c log2 mu + c0 with mu = min(n, sqrt(D / s)).";
  table.header = {"scene", "n",      "workload",      "log2 mu", "scenes",  "events and changes",
                  "signs", "method", "signs / event", "limit",   "verdict", "over 1 + log2 mu"};
  std::map<std::string, double> most;
  for (const lab::CellResult& cell : cells) {
    if (cell.cell.comparison.empty() && cell.cell.axis.name != kMuAxis) continue;
    if (cell.cell.family_row.empty() || cell.trials.empty() || !(mu_of(cell.cell) > 0)) continue;
    double signs = 0, events = 0;
    for (const lab::Trial& trial : cell.trials) {
      signs += static_cast<double>(trial.measurement.signs());
      events += static_cast<double>(trial.measurement.costs.processed +
                                    trial.measurement.scene_changes());
    }
    if (events < 8) continue;
    const double depth = std::max(0.0, std::log2(mu_of(cell.cell)));
    const double constant = signs / events / (1 + depth);
    double& largest = most[cell.cell.structure];
    largest = std::max(largest, constant);
    const std::optional<double> limit = signs_limit(cell.cell);
    const bool holds = !limit || signs <= *limit * events;
    if (cell.cell.comparison.empty() && holds) continue;
    table.rows.push_back(
        {cell.cell.family_row, std::to_string(cell.cell.parameters.n), cell.cell.workload_text(),
         fmt::format("{:.1f}", depth), std::to_string(cell.trials.size()), count_text(events),
         count_text(signs), cell.cell.structure, fmt::format("{:.1f}", signs / events),
         limit ? fmt::format("<= {:.1f}", *limit) : "-",
         limit ? std::string(lab::check_word(holds ? lab::Verdict::kConfirmed
                                                   : lab::Verdict::kRefuted))
               : "-",
         fmt::format("{:.2f}", constant)});
  }
  for (const std::string& method : methods) {
    if (most.count(method) == 0) continue;
    table.rows.push_back({"the largest of all", "-", "-", "-", "-", "-", "-", method, "-", "-", "-",
                          fmt::format("{:.2f}", most[method])});
  }
  return table;
}

std::vector<lab::Table> collision_tables(const std::vector<lab::CellResult>& cells) {
  std::vector<lab::Table> tables;
  for (auto table : {events_table(cells), signs_table(cells)}) {
    if (table) tables.push_back(*std::move(table));
  }
  return tables;
}

std::vector<lab::Figure> collision_figures(const std::vector<lab::CellResult>& cells) {
  std::vector<Curve> mu = curves_of(cells, "B1 round", kMuAxis);
  const std::vector<Curve> fan = curves_of(cells, "B4 turn", kVerticesAxis);
  const std::vector<Curve> tangents = curves_of(cells, "B5 turn", kVerticesAxis);
  std::map<double, double> least;
  for (const lab::CellResult& cell : cells) {
    if (cell.cell.family.rfind("B1 round", 0) != 0) continue;
    if (cell.cell.axis.name != kMuAxis) continue;
    for (const lab::Expectation& expectation : cell.cell.expectations) {
      if (expectation.kind != lab::ExpectationKind::kAtLeast) continue;
      least[cell.cell.axis.value] = expectation.exact.to_double() + 1;
    }
  }
  mu.push_back({"lower bound", {least.begin(), least.end()}});
  if (mu.size() == 1 || fan.empty() || tangents.empty()) return {};
  lab::Figure figure;
  figure.title = kStoryTitle;
  figure.caption =
      "B1: one polygon goes once round another at falling separation; lower bound: the least "
      "number "
      "of certificates for convex sets of positions. B4 and B5: a regular polygon of n vertices "
      "turns once before a fan of n edges, two radii away: the closest features (B4) change "
      "n(3n + 2) times, the inner tangents (B5) n(2n + 2) times. The legend has the powers that "
      "fit, with their 95 % intervals.";
  figure.width = 440;
  const std::vector<double> sizes{8, 16, 32, 64, 128};
  std::vector<lab::Figure> figures;
  figures.push_back(panel(
      figure, cells,
      {"mu = min(n, sqrt(D / separation))", "events", true, true, {1}, {}, "B1: once round (polygon-orbit)"}, mu));
  figure.joins = true;
  figures.push_back(
      panel(figure, cells,
            {"n vertices", "events", true, true, {1, 2}, sizes, "B4: a turn before a fan (polygon-fan)"}, fan));
  figures.push_back(
      panel(figure, cells,
            {"n vertices", "events", true, true, {1, 2}, sizes, "B5: a turn before a tangent fan (polygon-tangents)"},
            tangents));
  return figures;
}

}  // namespace kinex::families
