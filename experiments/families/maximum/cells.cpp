// SPDX-License-Identifier: GPL-3.0-or-later
// Questions: are the largest possible event counts of tournaments and heaps reached exactly, and
//   never exceeded? How many events does random motion cause, and how do they grow with n?
// Sources: Guibas, "Kinetic data structures: a state of the art report" (1998), section 5
//   for the bounds, section 9 for the laws of growth; uniform_lines.h for the expectations.
// Parameters: see each family. Minima run on the mirror images of the scenes for maxima, so their
//   counts must be those of maxima. Changes of a maximum, which are few, are known to 5 %.
// Expected: the integers below, in every run; in random motion also the exact number of changes in
//   every single scene.
// Cost: about 20 s.
#include <utility>

#include "experiments/families/maximum/envelope_witness.h"
#include "experiments/families/maximum/experiments.h"
#include "experiments/families/points/random_motion.h"
#include "experiments/families/points/reference_means.h"
#include "experiments/families/points/uniform_lines.h"
#include "experiments/lab/cell_parts.h"

namespace kinex::families {

namespace {

// n = 2^k lines in bit-reversed order: at every node the two sides win alternately.
void add_tournament(lab::Catalogue& catalogue, std::string structure, bool mirrored, int n,
                    double cost) {
  lab::Cell cell = lab::worst_case_cell(std::move(structure), "tournament-worst", n, 1, cost);
  cell.mirrored = mirrored;
  int levels = 0;
  while ((1 << levels) < n) ++levels;
  cell.expectations.push_back(lab::expect_exactly(
      "tournament.worst_case", "processed", Integer(n * levels - n + 1),
      "sum over nodes with m leaves of m - 1 changes: n log2 n - n + 1; Guibas 1998, section 5"));
  cell.expectations.push_back(
      lab::expect_exactly("maximum.worst_case", "external", Integer(n - 1),
                     "all lines are on the envelope: n - 1; Guibas 1998, section 5"));
  catalogue.cells.push_back(std::move(cell));
}

// Every item rises from its place to the root after all smaller ones are done.
void add_heap(lab::Catalogue& catalogue, std::string structure, bool mirrored, int n, double cost) {
  lab::Cell cell = lab::worst_case_cell(std::move(structure), "heap-worst", n, 1, cost);
  cell.mirrored = mirrored;
  int depths = 0;
  for (int j = 1; j <= n; ++j) {
    for (int half = j / 2; half > 0; half /= 2) ++depths;
  }
  cell.expectations.push_back(
      lab::expect_exactly("heap.worst_case", "processed", Integer(depths),
                     "sum of the depths: (ancestor, descendant) pairs; Guibas 1998, section 5"));
  cell.expectations.push_back(
      lab::expect_exactly("maximum.worst_case", "external", Integer(n - 1),
                     "the root changes n - 1 times; Guibas 1998, section 5"));
  catalogue.cells.push_back(std::move(cell));
}

void add_random_motion(lab::Catalogue& catalogue, bool minimum, bool heap, lab::Extent extent) {
  const std::string structure =
      std::string(minimum ? "minimum_" : "maximum_") + (heap ? "heap" : "tournament");
  for (const int n : {16, 64, 128, 256, 512, 1024, 4096}) {
    if (n > 1024 && extent == lab::Extent::kQuick && minimum) continue;
    lab::Cell cell = uniform_cell(structure, n, 1);
    cell.mirrored = minimum;
    cell.precise.push_back({"external", kChangesError});
    if (const ReferenceMean reference = reference_mean("heap", n); heap && reference.seeds > 0) {
      cell.expectations.push_back(
          lab::expect_mean("heap.uniform", "processed", reference.mean, reference.source()));
      cell.expectations.back().reference_error = reference.error;
    } else if (!heap) {
      cell.expectations.push_back(
          lab::expect_mean("tournament.uniform", "processed", expected_tournament_failures(n),
                      "sum over nodes of expected changes, by an integral"));
    }
    cell.expectations.push_back(lab::expect_mean("maximum.uniform", "external",
                                            expected_envelope_changes(n),
                                            "expected changes of the envelope, by an integral"));
    cell.expectations.push_back(lab::expect_witness(
        "maximum.envelope", "external", minimum ? lower_envelope_changes : upper_envelope_changes,
        "breakpoints of the envelope, from the lines sorted by slope"));
    cell.cost = 0.1 + n * 1.2e-3;
    catalogue.cells.push_back(std::move(cell));
  }
  if (!heap) {
    add_uniform_growth(catalogue, "tournament.uniform.growth", structure, 64, 1,
                       "Theta(n) events in expectation; Guibas 1998, section 9");
  }
}

}  // namespace

void add_maximum_cells(lab::Catalogue& catalogue, lab::Extent extent) {
  for (const bool minimum : {false, true}) {
    const std::string which = minimum ? "minimum_" : "maximum_";
    for (const int n : {4, 8, 16, 64, 256}) {
      add_tournament(catalogue, which + "tournament", minimum, n, 0.05);
    }
    for (const int n : {7, 15, 31, 63}) add_heap(catalogue, which + "heap", minimum, n, 0.05);
    if (extent == lab::Extent::kQuick) continue;
    for (const int n : {512, 1024}) {
      add_tournament(catalogue, which + "tournament", minimum, n, 1);
    }
    for (const int n : {100, 127, 255}) add_heap(catalogue, which + "heap", minimum, n, 1);
  }
  for (const bool minimum : {false, true}) {
    add_random_motion(catalogue, minimum, false, extent);
    add_random_motion(catalogue, minimum, true, extent);
  }
}

}  // namespace kinex::families
