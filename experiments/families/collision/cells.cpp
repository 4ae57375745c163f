// SPDX-License-Identifier: GPL-3.0-or-later
// Question: how many events do the methods of following two convex polygons cost, against their
//   vertices n and against mu = min(n, sqrt(D / sigma)), D their diameter, sigma their separation?
// Sources: Erickson, Guibas, Stolfi, Zhang, Separation-sensitive collision detection for convex
//   objects (1999), introduction, for the laws; counts and constants are worked out for the scenes
//   (polygon_*.cpp) or, where stated, measured.
// Parameters: nearly regular polygons of radius 1, D = 2.
//   B1      one moves around the other once, without turning
//   B2      it passes by on a line, in 8 directions
//   B3      it moves around mu times while it turns once
//   B4, B5  it turns in front of a fan of edges
//   B6      it trembles, moves along a path with kinks, or approaches
//   separation_minkowski is for bodies that do not turn against each other.
// Expected: lower bounds for convex certificates, exact counts, and exponents below. The bound
//   O(log mu) holds on a straight line only: on a circle, a convex curve, every method needs
//   Omega(mu).
// Cost: some minutes; kinex verify tells the time of every cell.
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "experiments/families/collision/axes.h"
#include "experiments/families/collision/experiments.h"
#include "experiments/families/collision/story.h"
#include "experiments/families/collision/turned_scene.h"
#include "structures/registry.h"

namespace kinex::families {
namespace {

constexpr const char* kPaper = "Erickson, Guibas, Stolfi, Zhang 1999, introduction";
constexpr const char* kOurs = "worked out for the scene";
constexpr int kDirections = 8;
constexpr int kFewTiles = 40;  // measured: 4

struct Method {
  const char* name;
  bool turning;  // bodies may turn against each other
  bool convex;   // a proof holds for a convex set of positions
};

constexpr Method kMethods[] = {
    {"separation_mixed", true, true},      {"separation_minkowski", false, true},
    {"separation_hysteresis", true, true}, {"closest_features", true, false},
    {"inner_tangents", true, false},       {"bounding_volumes", true, false},
};

Rational power(int exponent) {
  return Rational(Integer(1), Integer::power_of_two(static_cast<unsigned long>(exponent)));
}

// `row`: of the tables of all methods (story.h).
lab::Cell scene(const Method& method, const char* row, const char* workload, int n) {
  lab::Cell cell;
  cell.question = "How many events does it cost to follow two polygons?";
  cell.structure = method.name;
  cell.workload = workload;
  cell.parameters.n = n;
  cell.family_row = row;
  cell.axis = vertices_axis(cell);
  cell.cost = 0.5;
  return cell;
}

void expect(lab::Cell& cell, lab::ExpectationKind kind, const char* claim, std::int64_t count,
            std::string source) {
  lab::Expectation expectation;
  expectation.claim = claim;
  expectation.kind = kind;
  expectation.quantity = "processed";
  expectation.exact = Integer(count);
  expectation.source = std::move(source);
  cell.expectations.push_back(std::move(expectation));
}

// Over the axis of the family's cells, of which `cell` is one.
lab::GrowthClaim growth(const lab::Cell& cell, const char* claim, double exponent, double tolerance,
                        bool at_most, const char* source = kPaper) {
  lab::GrowthClaim growth;
  growth.claim = claim;
  growth.structure = cell.structure;
  growth.family = cell.family;
  growth.quantity = "processed";
  growth.exponent = exponent;
  growth.tolerance = tolerance;
  growth.at_most = at_most;
  growth.source = source;
  return growth;
}

// That of the paper's claims (separation_paper.cpp). The sizes of --quick have wider intervals: six of
// rigid.mu from 1.62 to 2.21, those of round.mu of separation_minkowski from 0.87 to 1.05.
double mu_tolerance(lab::Extent extent, double quick) {
  return extent == lab::Extent::kQuick ? quick : 0.1;
}

// Certificates for one round: see polygon_orbits.cpp.
std::int64_t fewest_certificates(int n, double separation) {
  const double rho = 2 * std::cos(std::numbers::pi / n), radius = 2 + separation;
  return static_cast<std::int64_t>(std::ceil(std::numbers::pi / std::acos(rho / radius) - 1e-9));
}

void add_round(lab::Catalogue& catalogue, const Method& method, int n, int exponent) {
  lab::Cell cell = scene(method, "B1 round", "polygon-orbit", n);
  cell.parameters.separation = power(exponent);
  cell.family = "B1 round, n = " + std::to_string(n);
  cell.axis = mu_axis(cell);
  if (exponent == 6) cell.comparison = "collision";
  if (method.convex) {
    expect(cell, lab::ExpectationKind::kAtLeast, "collision.lower_bound",
           fewest_certificates(n, cell.parameters.separation->to_double()) - 1,
           "certificates that prove convex sets of positions: ceil(pi / arccos(rho / R))");
  }
  catalogue.cells.push_back(std::move(cell));
}

void add_rounds(lab::Catalogue& catalogue, const Method& method, lab::Extent extent) {
  const int n = extent == lab::Extent::kQuick ? 256 : 1024;
  const int last = extent == lab::Extent::kQuick ? 12 : 16;
  for (int k = 3; k <= last; ++k) add_round(catalogue, method, n, k);
  if (method.convex) {
    if (std::string_view(method.name) == "separation_hysteresis") {
      // Wedges come down to the polygon's own sides sooner than tiles, and are then no more than n:
      // the law is that of a larger n.
      for (int k = 3; k <= last; ++k) {
        add_round(catalogue, method, 4 * n, k);
        catalogue.cells.back().family = "B1 wedges, n = " + std::to_string(4 * n);
        catalogue.cells.back().family_row.clear();
        catalogue.cells.back().comparison.clear();
      }
    }
    catalogue.growths.push_back(
        growth(catalogue.cells.back(), "collision.round.mu", 1, mu_tolerance(extent, 0.15), false));
  }
  if (std::string_view(method.name) == "bounding_volumes") return;  // discs prove most of these
  for (const int size : {16, 32, 64, 128}) {
    lab::Cell cell = scene(method, "B1 round", "polygon-orbit", size);
    cell.parameters.separation = Rational(Integer(1), Integer(10));
    cell.family = "B1 round, separation 1/10";
    if (std::string_view(method.name) == "closest_features") {
      expect(cell, lab::ExpectationKind::kExact, "closest_features.round", 4 * size,
             "every edge of the sum of two alike polygons and every vertex, for n a multiple of 4");
    }
    catalogue.cells.push_back(std::move(cell));
  }
  if (!method.convex) {
    catalogue.growths.push_back(
        growth(catalogue.cells.back(), "collision.round.n", 1, 0.1, false, kOurs));
  }
}

void add_lines(lab::Catalogue& catalogue, const Method& method, lab::Extent extent) {
  const int n = extent == lab::Extent::kQuick ? 128 : 1024;
  const int last = extent == lab::Extent::kQuick ? 14 : 20;
  // The method with a law for lines is tested at more sizes.
  const bool has_law = std::string_view(method.name) == "separation_minkowski";
  for (int k = 2; k <= last; k += has_law ? 1 : 2) {
    lab::Cell cell = scene(method, "B2 line", "polygon-line", n);
    cell.parameters.separation = power(k);
    cell.family = "B2 line";
    cell.axis = mu_axis(cell);
    cell.change = &kTurned;
    cell.random = true;
    cell.min_seeds = cell.max_seeds = kDirections;
    cell.cost = 2;
    if (k == 6) cell.comparison = "collision";
    catalogue.cells.push_back(std::move(cell));
  }
  if (!has_law) return;
  lab::GrowthClaim law =
      growth(catalogue.cells.back(), "collision.line.log_mu", 0, 0.1, true);
  law.logs = 1;
  catalogue.growths.push_back(std::move(law));
}

// Separation 2 / mu^2, and as many rounds as mu.
void add_spins(lab::Catalogue& catalogue, const Method& method, lab::Extent extent) {
  for (const int mu : {2, 3, 4, 6, 8, 12, 16, 24, 32}) {
    if (mu > 12 && extent == lab::Extent::kQuick) continue;
    lab::Cell cell = scene(method, "B3 rounds while turning", "polygon-spin-orbit", 64);
    cell.parameters.separation = Rational(2) / Rational(mu * mu);
    cell.parameters.turns = mu;
    cell.family = "B3 mu rounds in a turn";
    cell.axis = mu_axis(cell);
    cell.cost = mu * 0.2;
    if (mu == 8) cell.comparison = "collision";
    catalogue.cells.push_back(std::move(cell));
  }
  if (std::string_view(method.name) != "separation_mixed") return;
  catalogue.growths.push_back(
      growth(catalogue.cells.back(), "collision.rigid.mu", 2, mu_tolerance(extent, 0.25), true));
}

void add_fans(lab::Catalogue& catalogue, const Method& method, lab::Extent extent) {
  const std::string_view name = method.name;
  for (const bool tangents : {false, true}) {
    // n (3n + 2) is no power: more sizes where an exponent is fitted.
    const bool is_fitted = name == (tangents ? "inner_tangents" : "closest_features");
    for (const int n : {8, 12, 16, 24, 32, 48, 64, 96, 128}) {
      const bool power_of_two = (n & (n - 1)) == 0;
      if (!is_fitted && (!power_of_two || (n > 64 && extent == lab::Extent::kQuick))) continue;
      lab::Cell cell = scene(method, tangents ? "B5 tangent fan" : "B4 fan",
                        tangents ? "polygon-tangents" : "polygon-fan", n);
      cell.parameters.separation = Rational(2);
      cell.family = tangents ? "B5 turn before a tangent fan" : "B4 turn before a fan";
      if (n == 32) cell.comparison = "collision";
      if (name == "closest_features" && !tangents) {
        expect(cell, lab::ExpectationKind::kExact, "closest_features.fan", n * (3 * n + 2),
               "n (3m + 2) changes a turn, at any separation");
      } else if (name == "inner_tangents" && tangents) {
        expect(
            cell, lab::ExpectationKind::kExact, "inner_tangents.fan", n * (2 * n + 2),
            "n (2m + 1) changes of the fan's tangent a turn, n of the other one; each apart in the "
            "study of them");
      } else if (method.convex) {
        expect(cell, lab::ExpectationKind::kAtMost, "collision.fan", kFewTiles,
               "far apart tiles are large, whatever n is; measured: 4 tiles, 12 wedges");
      }
      catalogue.cells.push_back(std::move(cell));
    }
    if (is_fitted) {
      catalogue.growths.push_back(growth(catalogue.cells.back(),
                                         tangents ? "collision.tangents.n" : "collision.fan.n", 2,
                                         0.06, false));
    }
  }
}

void add_paths(lab::Catalogue& catalogue, const Method& method, lab::Extent extent) {
  const std::string_view name = method.name;
  for (const int m : {16, 64}) {
    lab::Cell cell = scene(method, "B6 trembling", "polygon-jitter", 16);
    cell.parameters.m = m;
    cell.family = "B6 trembling";
    if (m == 64) cell.comparison = "collision";
    if (name == "separation_hysteresis") {
      expect(cell, lab::ExpectationKind::kExact, "hysteresis.trembling", 0,
             "a wedge withstands 0.23 of the separation");
    } else if (name == "separation_mixed") {
      expect(cell, lab::ExpectationKind::kExact, "mixed.trembling", 2 * m,
             "the path crosses the side of a tile twice each time");
    }
    catalogue.cells.push_back(std::move(cell));
  }
  for (const int m : {20, 80}) {
    lab::Cell cell = scene(method, "B6 kinks", "polygon-kinks", 16);
    cell.parameters.m = m;
    cell.family = "B6 kinks";
    cell.random = true;
    cell.min_seeds = cell.max_seeds = 4;
    if (m == 80) cell.comparison = "collision";
    catalogue.cells.push_back(std::move(cell));
  }
  // As of lines: the method with a law is tested at more sizes.
  const bool has_law = name == "separation_hysteresis";
  for (int k = 2; k <= (extent == lab::Extent::kQuick ? 22 : 24); k += has_law ? 1 : 4) {
    lab::Cell cell = scene(method, "B6 approach", "polygon-approach", 64);
    cell.parameters.separation = power(k);
    cell.family = "B6 approach";
    if (k == 10) cell.comparison = "collision";
    cell.axis = nearness_axis(cell);
    catalogue.cells.push_back(std::move(cell));
  }
  if (!has_law) return;
  // An event each time the distance is halved or so: O(log(1 / separation)).
  lab::GrowthClaim law =
      growth(catalogue.cells.back(), "hysteresis.approach", 0, 0.1, true, kOurs);
  law.logs = 1;
  catalogue.growths.push_back(std::move(law));
}

// The mean over a run is at most what the hard bound of every failure allows.
void expect_few_signs(lab::Catalogue& catalogue, std::size_t first) {
  for (std::size_t i = first; i < catalogue.cells.size(); ++i) {
    lab::Cell& cell = catalogue.cells[i];
    const std::optional<double> limit = signs_limit(cell);
    if (!limit) continue;
    expect(cell, lab::ExpectationKind::kAtMost, "collision.signs",
           static_cast<std::int64_t>(std::floor(*limit)),
           "4 log2 mu + 45, from 2 (l + 1) + 33 a failure: levels l <= 2 log2 mu + 5 of tiles at a "
           "distance");
    cell.expectations.back().quantity = "signs_per_event";
  }
}

}  // namespace

void add_collision_cells(lab::Catalogue& catalogue, lab::Extent extent) {
  const std::size_t first = catalogue.cells.size();
  for (const Method& method : kMethods) {
    if (find_structure_info(method.name) == nullptr) continue;
    add_rounds(catalogue, method, extent);
    add_lines(catalogue, method, extent);
    if (method.turning) {
      add_spins(catalogue, method, extent);
      add_fans(catalogue, method, extent);
    }
    add_paths(catalogue, method, extent);
  }
  expect_few_signs(catalogue, first);
}

}  // namespace kinex::families
