// SPDX-License-Identifier: GPL-3.0-or-later
// Starts another program, by posix_spawn.
#ifndef KINEX_EXPERIMENTS_LAB_START_PROGRAM_H
#define KINEX_EXPERIMENTS_LAB_START_PROGRAM_H

#include <sys/types.h>

#include <string>
#include <vector>

namespace kinex::lab {

enum class ProgramName {
  kPath,      // the path of a file
  kSearched,  // searched in PATH if it has no slash
};

// Starts `program` without a shell and returns 0, and its process in `child`; or an errno, where it
// cannot be started. Its standard input is empty; its outputs go to the file descriptors `out` and
// `err`, which stay open here. It has its own process group, so a Ctrl-C does not reach it. All
// signals that this program handles or ignores have their default actions in it, and none is blocked.
// It inherits no other descriptor that has O_CLOEXEC. The caller waits for it.
int start_program(pid_t& child, const std::string& program, ProgramName name,
                  const std::vector<std::string>& arguments, int out, int err);

}  // namespace kinex::lab

#endif
