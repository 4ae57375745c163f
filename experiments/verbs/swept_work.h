// SPDX-License-Identifier: GPL-3.0-or-later
// Common parts of verbs that use the attempts of a sweep.
#ifndef KINEX_EXPERIMENTS_VERBS_SWEPT_WORK_H
#define KINEX_EXPERIMENTS_VERBS_SWEPT_WORK_H

#include <string>
#include <vector>

#include "experiments/sweep/journal.h"

namespace kinex::verbs {

// What children are started as. posix_spawn finds the program under it even if its file has been replaced.
inline constexpr const char* kThisProgram = "/proc/self/exe";

// Throws InputError if they are of another program than this one.
void refuse_other_program(const std::vector<sweep::Attempt>& attempts);

// Refuses an output that is one of the attempt files in the folders, as keep_input does.
void keep_attempts(const char* option, const std::string& output,
                   const std::vector<std::string>& folders);

// Where an experiment's records are: in the folders of a sweep that ran it, of which none may be
// missing; or, without folders, in its own file, to which what is missing is added.
sweep::Journal journal_of(const std::vector<std::string>& folders, const std::string& file,
                          const sweep::Selection& selection, sweep::Leftover leftover);

}  // namespace kinex::verbs

#endif
