// SPDX-License-Identifier: GPL-3.0-or-later
// Question: how many events does random motion cause, and how do they grow with n?
// Motion: origin and destination independent and uniform in the unit square (interval), t in
//   [0, 1].
// Sources: Guibas, "Kinetic data structures: a state of the art report" (1998), section 9, for the
//   laws of growth; uniform_lines.h for the expectations of maxima; n(n-1)/4 for sorting, since the
//   orders at 0 and at 1 are independent; for Delaunay triangulations means of an independent Monte
//   Carlo simulation in doubles, with their standard errors.
// Parameters: n below; seeds 1, 2, .. until the standard error of the mean number of events is
//   below 2 % (1 % for sorting, 5 % for changes of a maximum, which are few), at least 8. Minima
//   run on mirrored scenes, so their counts must be those of maxima.
// Expected: means within two standard errors of the difference, all sizes of a family together (see
//   allowed_errors); exponents within 0.03; on the line also the exact count of every single scene.
// Cost: about 40 s.
#include <utility>

#include "experiments/verify/catalogue.h"
#include "experiments/verify/uniform_lines.h"
#include "experiments/verify/witness.h"

namespace kinex {

namespace {

constexpr int kFewestSeeds = 8;
constexpr int kMostSeeds = 1000;
constexpr double kRelativeError = 0.02;
constexpr double kSortingError = 0.01;
constexpr double kChangesError = 0.05;

Cell uniform(std::string structure, int n, int dimension) {
  Cell cell;
  cell.question = "How many events does random motion cause?";
  cell.structure = std::move(structure);
  cell.workload = "uniform-square";
  cell.parameters.n = n;
  cell.parameters.dimension = dimension;
  cell.family = "uniform";
  cell.bounded = true;
  cell.random = true;
  cell.min_seeds = kFewestSeeds;
  cell.max_seeds = kMostSeeds;
  cell.precise = {{"processed", kRelativeError}};
  return cell;
}

Expectation mean(std::string claim, Quantity quantity, double reference, std::string source) {
  Expectation expectation;
  expectation.claim = std::move(claim);
  expectation.kind = ExpectationKind::kMean;
  expectation.quantity = std::move(quantity);
  expectation.reference = reference;
  expectation.source = std::move(source);
  return expectation;
}

Expectation witness(std::string claim, Quantity quantity, Integer (*count)(const Scene&),
                    std::string source) {
  Expectation expectation;
  expectation.claim = std::move(claim);
  expectation.kind = ExpectationKind::kWitness;
  expectation.quantity = std::move(quantity);
  expectation.witness = count;
  expectation.source = std::move(source);
  return expectation;
}

void add_growth(Catalogue& catalogue, std::string claim, std::string structure, double smallest,
                double exponent, std::string source) {
  GrowthClaim growth;
  growth.claim = std::move(claim);
  growth.structure = std::move(structure);
  growth.family = "uniform";
  growth.quantity = "processed";
  growth.smallest = smallest;
  growth.exponent = exponent;
  growth.source = std::move(source);
  catalogue.growths.push_back(std::move(growth));
}

void add_sorting(Catalogue& catalogue, Extent extent) {
  for (const int n : {16, 32, 64, 128, 256, 512, 1024}) {
    if (n > 512 && extent == Extent::kQuick) continue;
    Cell cell = uniform("sorted_list", n, 1);
    cell.precise = {{"processed", kSortingError}};
    cell.expectations.push_back(mean("sorted_list.uniform", "processed", n * (n - 1) / 4.0,
                                     "E = n(n-1)/4: independent orders; Guibas 1998, section 9"));
    cell.expectations.push_back(witness("sorted_list.inversions", "processed", inversions,
                                        "inversions between the first and the last order"));
    cell.cost = 0.3;
    catalogue.cells.push_back(std::move(cell));
  }
  add_growth(catalogue, "sorted_list.uniform.growth", "sorted_list", 16, 2,
             "Theta(n^2) swaps even in expectation; Guibas 1998, section 9");
}

void add_maximum(Catalogue& catalogue, bool minimum, bool heap, Extent extent) {
  const std::string structure =
      std::string(minimum ? "minimum_" : "maximum_") + (heap ? "heap" : "tournament");
  for (const int n : {16, 64, 128, 256, 512, 1024, 4096}) {
    if (n > 1024 && extent == Extent::kQuick && minimum) continue;
    Cell cell = uniform(structure, n, 1);
    cell.mirrored = minimum;
    cell.precise.push_back({"external", kChangesError});
    if (heap && n == 4096) {
      Expectation expectation = mean("heap.uniform", "processed", 1.05 * n,
                                     "about 1.05 n: an independent simulation in doubles, which "
                                     "does not say how its heap is built at the start");
      expectation.tolerance = 0.02 * n;
      cell.expectations.push_back(std::move(expectation));
    } else if (!heap) {
      cell.expectations.push_back(mean("tournament.uniform", "processed",
                                       expected_tournament_failures(n),
                                       "sum over nodes of expected changes, by an integral"));
    }
    cell.expectations.push_back(mean("maximum.uniform", "external", expected_envelope_changes(n),
                                     "expected changes of the envelope, by an integral"));
    cell.expectations.push_back(witness(
        "maximum.envelope", "external", minimum ? lower_envelope_changes : upper_envelope_changes,
        "breakpoints of the envelope, from the lines sorted by slope"));
    cell.cost = 0.1 + n * 1.2e-3;
    catalogue.cells.push_back(std::move(cell));
  }
  if (!heap) {
    add_growth(catalogue, "tournament.uniform.growth", structure, 64, 1,
               "Theta(n) events in expectation; Guibas 1998, section 9");
  }
}

struct Reference {
  int n;
  double mean;
  double error;
  double cost;
};

void add_delaunay(Catalogue& catalogue) {
  static constexpr Reference kReferences[] = {
      {10, 37.5, 0.9, 0.1},   {50, 586, 6, 0.2},      {100, 1731, 19, 0.2},   {200, 5061, 43, 0.2},
      {400, 14487, 125, 0.5}, {800, 41184, 331, 1.5}, {1600, 116962, 832, 4},
  };
  for (const Reference& reference : kReferences) {
    Cell cell = uniform("delaunay_2", reference.n, 2);
    cell.expectations.push_back(
        mean("delaunay_2.uniform", "processed", reference.mean,
             "independent Monte Carlo in doubles; Guibas 1998, section 9: Theta(n^1.5)"));
    cell.expectations.back().reference_error = reference.error;
    cell.cost = reference.cost;
    catalogue.cells.push_back(std::move(cell));
  }
  add_growth(catalogue, "delaunay_2.uniform.growth", "delaunay_2", 50, 1.5,
             "Theta(n^1.5) events in expectation; Guibas 1998, section 9");
}

void add_hull(Catalogue& catalogue, Extent extent) {
  static constexpr Reference kReferences[] = {
      {10, 10.2, 0.2, 0.1}, {100, 45.7, 0.5, 0.3}, {200, 0, 0, 0.5},
      {500, 0, 0, 1},       {1000, 106.9, 0.9, 2}, {1500, 0, 0, 2},
      {2000, 0, 0, 3},      {3000, 145, 2, 5},     {10000, 194, 4, 15}};
  for (const Reference& reference : kReferences) {
    if (reference.n > 3000 && extent == Extent::kQuick) continue;
    Cell cell = uniform("convex_hull_2", reference.n, 2);
    cell.bounded = false;  // its bounds are on events by kind
    cell.precise = {{"external", kChangesError}};
    if (reference.mean > 0) {
      cell.expectations.push_back(
          mean("convex_hull_2.uniform", "external", reference.mean,
               "independent Monte Carlo in doubles; Guibas 1998, section 9: Theta(log^2 n)"));
      cell.expectations.back().reference_error = reference.error;
    }
    cell.cost = reference.cost;
    catalogue.cells.push_back(std::move(cell));
  }
  // About 10 n - 200 events: the law shows where 200 are few.
  add_growth(catalogue, "convex_hull_2.uniform.growth", "convex_hull_2", 500, 1,
             "Theta(n) events in expectation; Guibas 1998, section 9");
  catalogue.growths.back().tolerance = 0.05;
}

}  // namespace

void add_random_motion(Catalogue& catalogue, Extent extent) {
  add_sorting(catalogue, extent);
  for (const bool minimum : {false, true}) {
    add_maximum(catalogue, minimum, false, extent);
    add_maximum(catalogue, minimum, true, extent);
  }
  add_delaunay(catalogue);
  add_hull(catalogue, extent);
}

}  // namespace kinex
