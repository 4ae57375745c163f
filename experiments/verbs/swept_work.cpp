// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/verbs/swept_work.h"

#include "experiments/formats/counted.h"
#include "experiments/formats/input_error.h"
#include "experiments/verbs/experiments.h"
#include "experiments/verbs/option_values.h"

namespace kinex::verbs {

namespace {

// All settled records of the folders; throws InputError for a conflict, or if a cell has none.
std::vector<sweep::Attempt> complete_attempts(const std::vector<std::string>& folders,
                                              const sweep::Selection& selection) {
  std::vector<sweep::Attempt> attempts = sweep::read_attempts(folders);
  refuse_other_program(attempts);
  if (const auto conflict = sweep::find_conflict(attempts)) {
    throw formats::InputError(conflict->place_a, "", "it does not agree with " + conflict->place_b,
                              "kinex sweep merge prints both");
  }
  const sweep::Settled settled = sweep::settle(attempts);
  const sweep::Plan plan = sweep::plan_of(selection, experiments());
  const sweep::Tally tally = sweep::tally(plan.cells, settled);
  const std::size_t missing = tally.missing + tally.of(sweep::Outcome::kKilled);
  if (missing > 0) {
    throw formats::InputError(
        folders.front(), "",
        formats::counted(missing, "cell", "cells") + " of " + std::to_string(tally.cells()) +
            " are missing",
        "run kinex sweep run " + selection.command() + " -o " + folders.front());
  }
  return attempts;
}

}  // namespace

void refuse_other_program(const std::vector<sweep::Attempt>& attempts) {
  if (attempts.empty() || attempts.front().provenance.program == lab::program_identity()) return;
  throw formats::InputError(attempts.front().path, "line 1",
                            "its records are of another commit, " +
                                lab::commit_text(attempts.front().provenance.build) +
                                "; this program is of " + lab::commit_text(lab::build_facts()),
                            "give another folder with -o: records of two commits are not mixed");
}

void keep_attempts(const char* option, const std::string& output,
                   const std::vector<std::string>& folders) {
  for (const std::string& file : sweep::attempt_files(folders)) keep_input(option, output, file);
}

sweep::Journal journal_of(const std::vector<std::string>& folders, const std::string& file,
                          const sweep::Selection& selection, sweep::Leftover leftover) {
  if (!folders.empty()) return sweep::Journal(complete_attempts(folders, selection));
  return sweep::Journal(
      file,
      sweep::provenance_of(sweep::plan_text(selection), "kinex " + selection.command(), "0/1"),
      leftover);
}

}  // namespace kinex::verbs
