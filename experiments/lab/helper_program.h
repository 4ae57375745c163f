// SPDX-License-Identifier: GPL-3.0-or-later
// Runs another program that helps this one: gnuplot, kinex-logcheck.
#ifndef KINEX_EXPERIMENTS_LAB_HELPER_PROGRAM_H
#define KINEX_EXPERIMENTS_LAB_HELPER_PROGRAM_H

#include <functional>
#include <string>
#include <vector>

namespace kinex {

struct HelperEnd {
  enum class How {
    kExited,
    kNotFound,  // there is no such program, or what it runs in (a script's interpreter) is absent
    kSignal,    // ended by a signal of other origin
    kStopped,   // `go_on` returned false, and it was ended
  };
  How how = How::kExited;
  int code = 0;  // of kExited; the signal of kSignal
};

// Runs `program` (looked for in PATH if it has no slash) without a shell and waits for it. Its
// standard input is empty, what it prints goes to the files `out` and `err`, which may be one. It
// has a process group of its own, so a Ctrl-C reaches it through `go_on` alone, which is called a
// hundred times a second; when it returns false the whole group is killed.
HelperEnd run_helper(const std::string& program, const std::vector<std::string>& arguments,
                     const std::string& out, const std::string& err,
                     const std::function<bool()>& go_on);

}  // namespace kinex

#endif
