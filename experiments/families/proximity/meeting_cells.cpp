// SPDX-License-Identifier: GPL-3.0-or-later
// Questions: do moving discs and boxes meet and part exactly as often as counted by hand, or by brute
//   force? Do the structures for discs agree? Do they keep their bounds in random motion?
// Sources: extents.cpp; the changes of small integers were counted by brute force over exact
//   positions between all critical times, by another program.
// Expected: the integers below, in every run; every hard bound, and every audit.
// Cost: about 10 s.
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include "experiments/families/proximity/experiments.h"
#include "experiments/lab/cell_parts.h"

namespace kinex::families {
namespace {

constexpr int kAuditedFan = 12;  // the largest fan of which every event is audited

constexpr const char* kMeetings[] = {"disc_pairs_all", "disc_pairs_boxes", "disc_pairs_grid",
                                      "box_pairs"};

std::string scenes_for(std::string_view structure, const char* discs, const char* boxes) {
  return structure == "box_pairs" ? boxes : discs;
}

void add_exactly(lab::Catalogue& catalogue, lab::Cell cell, std::string claim, int count,
                 std::string source) {
  cell.expectations.push_back(
      lab::expect_exactly(std::move(claim), "external", Integer(count), std::move(source)));
  catalogue.cells.push_back(std::move(cell));
}

void add_small_extents(lab::Catalogue& catalogue) {
  struct Counted {
    int n, dimension;
    std::uint64_t seed;
    int discs, boxes;
  };
  for (const Counted& one : {Counted{8, 2, 1, 4 + 6, 8 + 10},
                             {10, 2, 2, 5 + 8, 12 + 13},
                             {16, 2, 4, 15 + 21, 19 + 25 + 1},  // two boxes begin to meet at the end
                             {10, 3, 2, 3 + 4, 1 + 1}}) {
    for (const char* const structure : kMeetings) {
      const bool boxes = std::string_view(structure) == "box_pairs";
      lab::Cell cell = lab::worst_case_cell(
          structure, scenes_for(structure, "small-discs", "small-boxes"), one.n, 1, 0.1);
      cell.parameters.seed = one.seed;
      if (one.dimension != 2) cell.parameters.dimension = one.dimension;
      add_exactly(catalogue, std::move(cell),
                  boxes ? "box_pairs.small_integers" : "disc_pairs.small_integers",
                  boxes ? one.boxes : one.discs, "counted by brute force over exact positions");
    }
  }
}

}  // namespace

void add_meeting_cells(lab::Catalogue& catalogue, lab::Extent extent) {
  for (const char* const structure : kMeetings) {
    for (const int n : {3, 4, 5, 6, 8, 12, 24, 48}) {
      if (n > 6 && extent == lab::Extent::kQuick) continue;
      lab::Cell cell =
          lab::worst_case_cell(structure, scenes_for(structure, "fan-of-discs", "fan-of-boxes"), n,
                               1, n > kAuditedFan ? 0.5 : 0.1);
      if (n > kAuditedFan) cell.audit = AuditLevel::kEnd;
      add_exactly(catalogue, std::move(cell),
                  std::string_view(structure) == "box_pairs" ? "box_pairs.fan" : "disc_pairs.fan",
                  n * (n - 1), "each two meet once and part once: n(n-1)");
    }
  }
  add_small_extents(catalogue);
  for (const char* const structure : kMeetings) {
    for (const int n : {16, 64, 256}) {
      const bool all = std::string_view(structure) == "disc_pairs_all";
      if (n > 64 && extent == lab::Extent::kQuick) continue;
      lab::Cell cell;
      cell.question = "Do the hard bounds hold?";
      cell.structure = structure;
      cell.workload = scenes_for(structure, "random-discs", "random-boxes");
      cell.parameters.n = n;
      cell.family = cell.workload;
      cell.random = true;
      cell.min_seeds = cell.max_seeds = 4;
      cell.audit = n <= 16 ? AuditLevel::kEvents : AuditLevel::kEnd;
      cell.cost = all ? n * n / 4000.0 + 0.1 : n / 50.0;
      if (cell.workload == "random-discs") cell.comparison = "disc_pairs";
      catalogue.cells.push_back(std::move(cell));
    }
  }
}

}  // namespace kinex::families
