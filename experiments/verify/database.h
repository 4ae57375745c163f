// SPDX-License-Identifier: GPL-3.0-or-later
// The results as a SQLite database.
//
// STRICT tables, foreign keys: exact values are TEXT, counts INTEGER, and REAL is for seconds only.
//   build, machine   what made the results: one row each
//   cell             one experiment: structure, workload, parameters, verdict
//   run              one simulated scene in one arithmetic (number_mode)
//   counter          run_id, name, stage, value: every count of the ledger that is not 0; `stage`
//                    is the stage that answered, the degree of the polynomials, or empty
//   extreme          run_id, name, value_text: largest values
//   claim_result     expectation and result of a claim on a cell; run_id: the run that decided
//   growth           fitted exponents, without and, where it is needed, with a term of lower order
//   neighbour        laws that were fitted beside a claimed one, and that one itself
//   study            checks made without a run
// Unique keys make a second insertion of the same result impossible.
#ifndef KINEX_EXPERIMENTS_VERIFY_DATABASE_H
#define KINEX_EXPERIMENTS_VERIFY_DATABASE_H

#include <string>

#include "experiments/lab/machine.h"
#include "experiments/verify/runner.h"

namespace kinex::verify {

// The bytes of the database file.
std::string verify_database(const VerifyResult& result, const lab::BuildFacts& build,
                            const lab::MachineFacts& machine);

}  // namespace kinex::verify

#endif
