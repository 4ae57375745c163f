// SPDX-License-Identifier: GPL-3.0-or-later
// The results as a SQLite database with the tables of schemas/verify.sql.
//
// Exact values are TEXT, counts INTEGER, and REAL is for seconds only. Unique keys make a second
// insertion of the same result impossible.
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
