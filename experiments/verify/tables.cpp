// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/verify/tables.h"

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <utility>

#include "experiments/lab/family.h"

namespace kinex::verify {

namespace {

std::string left_text(bool weighted, const lab::Fit& fit, double scatter) {
  if (weighted) return fmt::format("chi^2 = {:.1f} on {}", fit.chi_square, fit.degrees);
  return fmt::format("scatter {:.2g} %", 100 * scatter);
}

std::string standing_text(const lab::Neighbours& neighbours, const lab::Neighbours::Rival& rival) {
  const char* const standing = rival.better == lab::BetterFit::kFirst    ? "beaten"
                               : rival.better == lab::BetterFit::kSecond ? "fits better"
                                                                         : "cannot be excluded";
  const bool small = std::fabs(rival.lead) < 100;
  if (!neighbours.weighted) {
    return fmt::format("{}: {:.{}f} times the scatter", standing, rival.lead, small ? 1 : 0);
  }
  return fmt::format("{}: {:+.{}f} chi^2", standing, rival.lead, small ? 1 : 0);
}

}  // namespace

std::vector<lab::Table> measures_tables(const std::vector<lab::CellResult>& cells) {
  std::vector<lab::Table> tables;
  for (const lab::FamilyExperiments& family : lab::experiment_families()) {
    if (family.tables == nullptr) continue;
    for (lab::Table& table : family.tables(cells)) tables.push_back(std::move(table));
  }
  for (lab::Table& table : lab::comparison_tables(cells)) tables.push_back(std::move(table));
  return tables;
}

std::vector<lab::Table> neighbours_tables(const std::vector<lab::GrowthResult>& growths) {
  lab::Table table;
  table.title = "Laws against their neighbours";
  table.header = {"family", "sizes", "law", "left by a + b law", "against the claimed law"};
  table.note =
      "Each law has two numbers, a + b law, and a power a n^b; they are fitted to the same means. "
      "With "
      "standard errors a neighbour is beaten if it leaves 9 more of chi^2 (times what the better "
      "one "
      "leaves for each degree of freedom, if that is more than 1); without, if it scatters twice "
      "as "
      "much.";
  for (const lab::GrowthResult& growth : growths) {
    if (!growth.neighbours) continue;
    const lab::Neighbours& neighbours = *growth.neighbours;
    const auto add = [&](const std::string& law, std::string left, std::string standing) {
      table.rows.push_back({growth.claim.structure + ", " + growth.claim.family,
                            std::to_string(growth.points.size()), law, std::move(left),
                            std::move(standing)});
    };
    add(neighbours.law, left_text(neighbours.weighted, neighbours.claimed, neighbours.scatter),
        neighbours.is_beaten() ? "claimed" : "claimed; the counts are consistent with it");
    for (const lab::Neighbours::Rival& rival : neighbours.rivals) {
      add(rival.law, left_text(neighbours.weighted, rival.fit, rival.scatter),
          standing_text(neighbours, rival));
    }
  }
  if (table.rows.empty()) return {};
  return {std::move(table)};
}

}  // namespace kinex::verify
