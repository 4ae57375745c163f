// SPDX-License-Identifier: GPL-3.0-or-later
// Cell: one experiment as data: structure, scenes and expectations.
#ifndef KINEX_EXPERIMENTS_LAB_CELL_H
#define KINEX_EXPERIMENTS_LAB_CELL_H

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/engine/simulator.h"
#include "core/motion/scene.h"
#include "core/numbers/integer.h"
#include "experiments/lab/scene_change.h"
#include "experiments/lab/workload.h"

namespace kinex::lab {

// A quantity is a count of a run by name:
//   external         changes of the attribute
//   processed        all events, including those of a structure that is read (Measurement::costs)
//   internal         processed less external
//   kind.NAME        events of the kind; "kind.enter+kind.leave": a sum
//   signs_per_event  signs computed while the scene ran, over events and changes of the scene,
//                    rounded up
using Quantity = std::string;

enum class ExpectationKind {
  kExact,    // every run counts exactly this
  kWitness,  // every run counts exactly what `witness` finds in its scene, without simulating it
  kMean,     // the mean over seeds agrees with a reference mean
  kAtLeast,  // no run counts less than this
  kAtMost,   // or more
};

// Where a cell is in its family: what its counts are said to grow with, and its value here. The
// cells of one family have one name.
struct Axis {
  std::string name;  // empty: the objects of the scene, which are counted when it runs
  double value = 0;

  bool is_objects() const { return name.empty(); }
};

struct Expectation {
  std::string claim;  // stable id, for example "sorted_list.worst_case"
  ExpectationKind kind = ExpectationKind::kExact;
  Quantity quantity;
  Integer exact;                                     // kExact, kAtLeast, kAtMost
  Integer (*witness)(const Scene& scene) = nullptr;  // kWitness
  // kMean: |mean - reference| <= z sqrt(se^2 + reference_error^2) + tolerance; see allowed_errors.
  double reference = 0;
  double reference_error = 0;  // standard error of the reference; 0 if it is a proven expectation
  double tolerance = 0;        // of a reference that is known to a few digits only
  int comparisons = 1;  // the number of means compared under this claim: the sizes of a family
  std::string source;
};

struct Cell {
  std::string question;
  std::string structure;
  std::string workload;
  WorkloadParameters parameters;  // its seed is the first; scene k has seed + k
  const SceneChange* change = nullptr;  // nullptr: none
  bool mirrored = false;                // all coordinates negated
  std::string family;                   // the curve it is a point of, for plots and growth claims
  Axis axis;                            // of that curve
  bool random = false;
  std::string comparison;  // the table of measures with a row for it; empty: none
  std::string family_row;  // the row of its family's own tables (family.h) that it is in; empty: none
  // Random families: seeds are added until the standard error of the mean of every quantity in
  // `precise` is below its relative error times the mean, from min_seeds to max_seeds.
  int min_seeds = 1;
  int max_seeds = 1;
  struct Precise {
    Quantity quantity;
    double relative_error;
  };
  std::vector<Precise> precise;
  AuditLevel audit = AuditLevel::kEnd;
  bool bounded = false;      // a hard bound on the events is known and must have been checked
  double max_seconds = 600;  // a run that takes longer gives up
  double cost = 0.01;        // expected seconds of the whole cell, for progress
  std::vector<Expectation> expectations;

  // "worst-case family, degree 2": the workload and its parameters that are not defaults, without
  // n.
  std::string workload_text() const;
  // "mirrored turned": what `kinex gen` does not do; empty: nothing.
  std::string changes_text() const;
};

// The counts of the cells of one family of a structure grow like x^exponent, x the value of their axis.
struct GrowthClaim {
  std::string claim;
  std::string structure;
  std::string family;
  Quantity quantity;
  double smallest = 1;  // the smallest x at which the law is expected to hold
  double exponent = 1;
  double tolerance = 0.03;
  std::string source;
  bool at_most = false;  // or slower
  // The law is a + b x^exponent log^logs x, and `tolerance` is of its bend (law_verdict.h).
  int logs = 0;
  double lower_order = 1;  // ClaimedPower (power_verdict.h)
  std::size_t sizes = 0;   // cells that the family has; 0: not known
  // Cells that it has in the full experiments; more than `sizes` if these are a part, as --quick is.
  std::size_t full_sizes = 0;
};

// An experiment that is not a run of one structure: a table and its checks.
struct StudyResult;
struct Study {
  std::string name;
  StudyResult (*run)(bool quick, const std::function<bool()>& go_on);
  bool quick = false;
};

// How much of the experiments is run.
enum class Extent { kQuick, kFull };

struct Catalogue {
  std::vector<Cell> cells;
  std::vector<GrowthClaim> growths;
  std::vector<Study> studies;
};

// The scene of a cell for its k-th seed, maintaining the cell's structure only.
Scene scene_of(const Cell& cell, int k);

}  // namespace kinex::lab

#endif
