// SPDX-License-Identifier: GPL-3.0-or-later
// Judge: compares the counts of a cell's runs with the expectations.
#ifndef KINEX_EXPERIMENTS_LAB_JUDGE_H
#define KINEX_EXPERIMENTS_LAB_JUDGE_H

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "experiments/lab/cell.h"
#include "experiments/lab/contest.h"
#include "experiments/lab/measurement.h"
#include "experiments/lab/statistics.h"
#include "experiments/lab/table.h"
#include "experiments/lab/verdict.h"

namespace kinex::lab {

struct Check {
  std::string claim;     // of an expectation, or the id of a hard bound, "bounded", "audit",
                         // "run", "error"
  std::string kind;      // "exact", "witness", "mean", "bound", "audit", "run", "growth"
  std::string quantity;  // what was counted; empty for bounds and audits
  std::string expected;
  std::string observed;
  std::string source;
  Verdict verdict = Verdict::kConfirmed;
  std::optional<std::size_t> trial;  // the deciding run, if there is one
  int seeds_needed = 0;  // an estimate of enough, if the scenes are too few to decide; else 0
};

// One scene of a cell.
struct Trial {
  Measurement measurement;
  std::vector<Integer> witnessed;  // by expectation; 0 where it is not kWitness
};

struct CellResult {
  Cell cell;
  std::vector<Trial> trials;
  std::optional<SpeedContest> contest;  // on the first scene
  std::vector<Check> checks;
  std::vector<std::string> kept;  // files: scenes that failed
  double seconds = 0;             // all of it, wall clock

  Verdict verdict() const;
};

RunningMean mean_of(const std::vector<Trial>& trials, const Quantity& quantity);

// True if the cell has the seeds it needs.
bool precise_enough(const Cell& cell, const std::vector<Trial>& trials);
// Of the scenes, from the first, those that the cell asks for: the fewest that are precise enough. 0 if
// all of them are too few.
std::size_t scenes_asked_for(const Cell& cell, const std::vector<Trial>& trials);
// An estimate of the seeds that the cell needs, from the spread so far: at least min_seeds.
int seeds_needed(const Cell& cell, const std::vector<Trial>& trials);

// All expectations, then all hard bounds of the structure (each over all trials: the trial that
// comes nearest to the bound, or breaks it), then the audits. Requires at least one trial.
std::vector<Check> judge(const Cell& cell, const std::vector<Trial>& trials);

// The hard bound on the number of events, by its id (FamilyExperiments::event_bounds). nullptr if the
// run has none.
const BoundCheck* event_bound(const Measurement& measurement);
// The hard bound on all processed events of the run: of one structure, or the sum of those of what it
// reads. nullopt if what was held to bounds is not all of them.
std::optional<Integer> bound_on_processed(const Measurement& measurement);

struct StudyResult {
  std::string name;
  Table table;
  std::vector<Check> checks;

  Verdict verdict() const;
};

// A readable number: integers whole, others with about `digits` significant digits.
std::string number_text(double value, int digits);
// Of a number that may be absent; databases have exact numbers as such texts.
std::optional<std::string> number_text(const std::optional<double>& value, int digits);
// The text; nullopt if it is empty.
std::optional<std::string> unless_empty(const std::string& text);
// "586 +-6": the error with two digits, the mean to the same place.
std::string mean_text(double mean, double error);

}  // namespace kinex::lab

#endif
